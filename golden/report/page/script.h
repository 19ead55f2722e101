#pragma once

#include <string_view>
#include <vector>

namespace tumble::golden {

/// The script of index.html, golden/report/page/bundle.js, in pieces to be joined. The build makes this function.
std::vector<std::string_view> report_script_pieces();

/// Its SHA-256, in hexadecimal digits: the page's policy lets nothing else run.
std::string_view report_script_sha256();

}  // namespace tumble::golden
