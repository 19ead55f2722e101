#include "golden/run/failed_case_files.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "golden/judge/case_series.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

std::string track_csv(const Expected& expected) {
  std::string text = "step,id,x_m,y_m,z_m\n";
  for (const TrackPoint& point : expected.track) {
    for (std::size_t i = 0; i < point.id.size(); ++i) {
      text += std::to_string(point.step) + ',' + std::to_string(point.id[i]);
      for (const std::int32_t mm : {point.x[i], point.y[i], point.z[i]}) text += ',' + std::to_string(mm / 1000.0);
      text += '\n';
    }
  }
  return text;
}

}  // namespace

void leave_case_files(CaseRun& run, const std::filesystem::path& report, const Session& session, replay::LogReader& log,
                      const std::optional<Expected>& expected) {
  if (report.empty()) return;
  CaseResult& result = run.result;
  const std::string folder = "cases/" + result.name + "/";
  const auto leave = [&](const std::string& name, const auto& content) {
    if (Status ok = write_file(report / (folder + name), content); !ok.ok()) {
      result.problems.push_back(ok.error().message);
    } else {
      result.artifacts.push_back(folder + name);
    }
  };
  leave(kLogFile, std::span<const std::byte>(*session.log));
  for (std::size_t k = 0; k < run.pictures.size(); ++k) {
    if (result.pictures[k].message.empty() || run.pictures[k].png.empty()) continue;
    for (const PictureFile& file : explaining_files(run.pictures[k])) {
      leave(file.name, std::span<const std::byte>(file.bytes));
    }
  }
  if (expected && !expected->track.empty()) leave(kTrackFile, std::string_view(track_csv(*expected)));
  const Result<Json> series = case_series(log, expected ? &*expected : nullptr);
  if (series.ok()) {
    leave(kSeriesFile, std::string_view(series->dump()));
  } else {
    result.notes.push_back("nothing to draw: " + series.error().message);
  }
}

}  // namespace tumble::golden
