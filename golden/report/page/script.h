#pragma once

#include <string_view>
#include <vector>

namespace tumble::golden {

/// The script of index.html, golden/report/page/bundle.js, in pieces to be joined. The build makes this function.
std::vector<std::string_view> report_script_pieces();

}  // namespace tumble::golden
