#include "golden/report/files.h"

#include <algorithm>
#include <string_view>

#include "golden/judge/case_series.h"
#include "golden/report/page/script.h"
#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) : 0U;
    };
    const std::uint32_t word = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (const std::uint32_t shift : {18U, 12U, 6U, 0U}) out += kDigits[word >> shift & 63U];
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  out.replace(out.size() - missing, missing, missing, '=');
  return out;
}

}  // namespace

std::string ReportFiles::take(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(folder_ / path, error);
  if (error || size > kBytesMax - bytes_) return "";
  const Result<std::string> text = read_text(folder_ / path);
  if (!text.ok()) return "";
  bytes_ += size;
  is_drawn_ = true;
  return *text;
}

std::string ReportFiles::image_source(const std::string& path) {
  const std::string bytes = take(path);
  return bytes.empty() ? path : "data:image/png;base64," + base64(bytes);
}

std::string ReportFiles::json(const std::string& path) {
  std::string text = take(path);
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";  // no </script> can come of it
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string drawing_section(const CaseResult& result, ReportFiles& files) {
  const std::string path = "cases/" + result.name + "/" + kSeriesFile;
  if (std::ranges::find(result.artifacts, path) == result.artifacts.end()) return "";
  const std::string json = files.json(path);
  if (json.empty()) {
    return "<p class=\"soft\">Its plots are not in this page, which has enough of them; check the case alone.</p>\n";
  }
  const std::string first = result.difference ? " data-first=\"" + std::to_string(result.difference->step) + "\"" : "";
  return "<div class=\"drawing\"" + first +
         "><p class=\"soft\">Plots and trajectories need JavaScript.</p>"
         "<script type=\"application/json\">" +
         json + "</script></div>\n";
}

std::string script_section() {
  std::string out = "<script>\n";
  for (const std::string_view piece : report_script_pieces()) out += piece;
  return out + "</script>\n";
}

}  // namespace tumble::golden
