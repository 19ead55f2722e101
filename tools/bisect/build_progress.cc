#include "tools/bisect/build_progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <utility>

namespace tumble::tools::bisect {
namespace {

constexpr std::chrono::milliseconds kOnTerminal{500};
constexpr std::chrono::minutes kElsewhere{1};
constexpr std::streamoff kBytesRead = 16384;  // the end of a log: some hundred lines of ninja

std::string end_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return "";
  const std::streamoff size = file.tellg();
  if (size < 0) return "";
  std::string text(static_cast<std::size_t>(std::min(size, kBytesRead)), ' ');
  file.seekg(size - static_cast<std::streamoff>(text.size()));
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

/// "[12/260]" of a line that begins so; empty if it does not.
std::string_view counter_of(std::string_view line) {
  const std::size_t close = line.find(']');
  if (!line.starts_with('[') || close == std::string_view::npos) return {};
  const std::string_view inside = line.substr(1, close - 1);
  const bool is_counter = inside.find_first_not_of("0123456789/% ") == std::string_view::npos &&
                          inside.find_first_of("/%") != std::string_view::npos;
  return is_counter ? line.substr(0, close + 1) : std::string_view();
}

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
}

/// What compilers, linkers, make and cargo begin a reason with; ninja's "FAILED: a.o" is none.
bool is_error(std::string_view line) {
  constexpr std::array kSigns = {"error: ", "error:\t", "Error: ", "undefined reference to", "error["};
  return std::ranges::any_of(kSigns, [&](const char* sign) { return line.find(sign) != std::string_view::npos; });
}

}  // namespace

std::string failure_in(std::string_view output) {
  std::string_view last, cmake;
  while (!output.empty()) {
    const std::size_t end = output.find('\n');
    const std::string_view line = trimmed(output.substr(0, end));
    if (line.starts_with("CMake Error") && cmake.empty()) {
      cmake = line;
    } else if (!line.empty()) {
      if (!cmake.empty()) return std::string(cmake) + ' ' + std::string(line);
      if (is_error(line)) return std::string(line);
      last = line;
    }
    if (end == std::string_view::npos) break;
    output.remove_prefix(end + 1);
  }
  return std::string(cmake.empty() ? last : cmake);
}

std::string last_counter(std::string_view output) {
  std::string_view last;
  while (!output.empty()) {
    const std::size_t end = output.find('\n');
    if (const std::string_view counter = counter_of(output.substr(0, end)); !counter.empty()) last = counter;
    if (end == std::string_view::npos) break;
    output.remove_prefix(end + 1);
  }
  return std::string(last);
}

std::string elapsed_text(std::chrono::seconds elapsed) {
  const auto seconds = elapsed.count();
  return (seconds >= 60 ? std::to_string(seconds / 60) + " min " : "") + std::to_string(seconds % 60) + " s";
}

BuildProgress::Display BuildProgress::on_stderr() {
  const bool is_terminal = ::isatty(STDERR_FILENO) != 0;
  return {std::clog, is_terminal, is_terminal ? Clock::duration(kOnTerminal) : Clock::duration(kElsewhere)};
}

BuildProgress::BuildProgress(std::string log, const Display& display)
    : log_(std::move(log)), display_(display), next_(begin_ + display.interval) {}

void BuildProgress::show() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + display_.interval;
  const std::string counter = last_counter(end_of(log_));
  const std::string line = "      building" + (counter.empty() ? "" : ' ' + counter) + ", " +
                           elapsed_text(std::chrono::duration_cast<std::chrono::seconds>(now - begin_)) + " so far";
  if (display_.is_terminal) {
    display_.out << '\r' << line << "\033[K" << std::flush;
    is_shown_ = true;
  } else {
    display_.out << line << std::endl;
  }
}

void BuildProgress::finish() {
  if (is_shown_) display_.out << "\r\033[K" << std::flush;
  is_shown_ = false;
}

}  // namespace tumble::tools::bisect
