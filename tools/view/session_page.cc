#include "tools/view/session_page.h"

#include "golden/report/files.h"
#include "golden/report/html_parts.h"
#include "golden/report/html_text.h"
#include "golden/report/page/style.h"
#include "tools/view/view_json.h"

namespace tumble::tools {
namespace {

using golden::Html;

Html data(std::size_t log, Html::Markup part, const std::string& bytes) {
  return Html("<script type=\"text/plain\" id=\"session-")
         << golden::text(std::to_string(log)) << part << "\">" << golden::base64_text(bytes) << "</script>\n";
}

std::string title_of(const Json& head) {
  std::string title;
  for (const Json& log : head["logs"]) {
    title += (title.empty() ? "" : " and ") + log["path"].get<std::string>();
  }
  return title + " · tumble view";
}

}  // namespace

std::string page_policy(bool served) {
  return "default-src 'none'; script-src 'sha256-" + golden::script_hash().bytes() +
         "'; style-src 'unsafe-inline'; img-src data:" + (served ? "; connect-src 'self'" : "") +
         "; base-uri 'none'; form-action 'none'";
}

std::string SessionPage::html() const {
  const bool served = packed.empty();
  Html page("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
  page << "<meta http-equiv=\"Content-Security-Policy\" content=\"" << golden::text(page_policy(served)) << "\">\n"
       << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
       << golden::element("<title>", title_of(head), "</title>\n") << "<style>"
       << golden::script_of_this_program(golden::kReportStyle) << "</style>\n</head>\n<body class=\"session\">\n"
       << "<main id=\"session\"><h1>" << golden::text(title_of(head))
       << "</h1><p>This page is drawn by its own script; a browser that runs none shows nothing more.</p></main>\n"
       << "<script type=\"application/json\" id=\"session-head\">" << golden::json_text(dumped(head)) << "</script>\n";
  for (std::size_t i = 0; i < packed.size(); ++i) {
    page << data(i, "-details", packed[i].details) << data(i, "-frames", packed[i].frames);
  }
  if (!difference.empty()) page << data(0, "-difference", difference);
  page << golden::script_section() << "</body>\n</html>\n";
  return page.bytes();
}

std::size_t empty_page_bytes() {
  static const std::size_t kBytes = [] {
    SessionPage page;
    page.head = {{"mode", "served"}, {"logs", Json::array()}};
    return page.html().size();
  }();
  return kBytes;
}

}  // namespace tumble::tools
