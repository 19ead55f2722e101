#include "tumble/golden/report.h"

#include <nlohmann/json.hpp>

#include "golden/report/html.h"
#include "golden/report/junit.h"
#include "golden/report/report_json.h"
#include "golden/report/report_place.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {

Status write_reports(const SuiteResult& result, const std::filesystem::path& folder,
                     const std::filesystem::path& junit) {
  const std::string json = report_json(result).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  if (Status ok = write_file(folder / "report.json", std::string_view(json)); !ok.ok()) return ok;
  const std::filesystem::path junit_path = junit_file(folder, junit);
  if (Status ok = write_file(junit_path, std::string_view(report_junit(result))); !ok.ok()) return ok;
  return write_file(folder / "index.html", std::string_view(report_html(result, folder)));
}

}  // namespace tumble::golden
