#include "golden/report.h"

namespace tumble::golden {

std::string report_html(const SuiteResult& result) { return "<!doctype html><title>" + headline(result) + "</title>"; }

}  // namespace tumble::golden
