#include "golden/run/failed_case_files.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "golden/judge/case_series.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

/// In the axes and the unit of the engine.
std::string track_csv(const Expected& expected, const replay::EngineAxes& axes) {
  const std::string unit = axes.unit();
  std::string text = axes.ours() ? "" : "# axes: " + to_string(axes) + '\n';
  text += "step,id,x_" + unit + ",y_" + unit + ",z_" + unit + '\n';
  for (const TrackPoint& point : expected.track) {
    for (std::size_t i = 0; i < point.id.size(); ++i) {
      text += std::to_string(point.step) + ',' + std::to_string(point.id[i]);
      const sim::Vec3 place = axes.their_length({point.x[i] / 1000.0, point.y[i] / 1000.0, point.z[i] / 1000.0});
      for (int k = 0; k < 3; ++k) text += ',' + std::to_string(place[k]);
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
  if (expected && !expected->track.empty())
    leave(kTrackFile, std::string_view(track_csv(*expected, log.header().axes())));
  const Result<Json> series = case_series(log, expected ? &*expected : nullptr);
  if (series.ok()) {
    leave(kSeriesFile, std::string_view(series->dump()));
  } else {
    result.notes.push_back("nothing to draw: " + series.error().message);
  }
}

}  // namespace tumble::golden
