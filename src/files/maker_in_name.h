#pragma once

#include <sys/types.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <optional>
#include <string_view>
#include <system_error>

namespace tumble::files {

/// What a name STEM PROCESS-REST says.
struct MakerInName {
  pid_t process = 0;
  std::string_view rest;
};

/// None for another name.
inline std::optional<MakerInName> maker_in(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem)) return std::nullopt;
  name.remove_prefix(stem.size());
  pid_t process = 0;
  const char* const end = name.data() + name.size();
  const auto [dash, wrong] = std::from_chars(name.data(), end, process);
  if (wrong != std::errc() || process <= 0 || dash == end || *dash != '-') return std::nullopt;
  return MakerInName{process, name.substr(static_cast<std::size_t>(dash + 1 - name.data()))};
}

/// Whether there is no such process; one of another user is there.
inline bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace tumble::files
