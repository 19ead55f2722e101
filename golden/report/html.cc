#include "golden/report/html.h"

#include <string>

#include "golden/report/case_section.h"
#include "golden/report/files.h"
#include "golden/report/html_parts.h"
#include "golden/report/html_text.h"
#include "golden/report/page/style.h"
#include "golden/report/summary_section.h"

namespace tumble::golden {
namespace {

Html cases_section(const SuiteResult& result, bool passed, Html::Markup heading, ReportFiles& files) {
  Html blocks;
  for (const CaseResult& one : result.cases) {
    if (one.passed() == passed) blocks << case_section(one, result.suite, files);
  }
  return blocks.empty() ? Html() : Html(heading) << blocks;
}

/// Nothing but the page's own script runs, known by its hash: no other script, no handler in an attribute, no address
/// that begins with "javascript:". Nothing is loaded but pictures, from the page itself or its folder.
Html policy(bool has_script) {
  Html out("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src ");
  if (has_script) {
    out << "'sha256-" << script_hash() << "'";
  } else {
    out << "'none'";
  }
  return out << "; style-src 'unsafe-inline'; img-src data: file: 'self'; base-uri 'none'; form-action 'none'\">\n";
}

}  // namespace

std::string report_html(const SuiteResult& result, const std::filesystem::path& folder) {
  ReportFiles files(folder);
  const Html glance = overview(result);
  Html body;
  body << "<body>\n<main>\n" << banner(result) << tiles(result) << glance;
  body << cases_section(result, false, "<h2>Failed cases in full</h2>\n", files)
       << cases_section(result, true, "<h2>Passed cases</h2>\n", files);
  body << "<h2>The check itself</h2>\n" << canary_list(result) << "</main>\n";
  const bool has_script = files.is_drawn() || !glance.empty();
  if (has_script) body << script_section();
  body << "</body>\n</html>\n";

  Html page("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
  page << policy(has_script) << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
       << element("<title>", title_of(result), "</title>\n") << "<style>" << script_of_this_program(kReportStyle)
       << "</style>\n</head>\n"
       << body;
  return page.bytes();
}

}  // namespace tumble::golden
