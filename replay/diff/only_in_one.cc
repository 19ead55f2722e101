#include "replay/diff/only_in_one.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// What `one` declares and `other` does not.
std::vector<std::string> lacking(const LogHeader& one, const LogHeader& other) {
  std::vector<std::string> parts;
  for (const Channel& channel : one.declared.channels) {
    const std::vector<Channel>& there = other.declared.channels;
    if (other.declared.find(channel.name) == there.size()) parts.push_back("channel " + channel.name);
  }
  if (!one.engine || !other.engine) return parts;  // phases of ours change with the version of their hashes
  for (const std::string& phase : one.phases) {
    if (std::ranges::find(other.phases, phase) == other.phases.end()) parts.push_back("phase hashes of " + phase);
  }
  return parts;
}

void say(const std::vector<std::string>& parts, const std::string& name, std::string& text) {
  if (parts.empty()) return;
  constexpr std::size_t kShown = 6;
  text += (text.empty() ? "only " : "; only ") + name + " has ";
  for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) text += (i == 0 ? "" : ", ") + parts[i];
  if (parts.size() > kShown) text += " and " + std::to_string(parts.size() - kShown) + " more";
}

}  // namespace

OnlyInOne only_in_one(const LogHeader& a, const LogHeader& b) { return {lacking(a, b), lacking(b, a)}; }

std::string OnlyInOne::text(const std::string& name_a, const std::string& name_b) const {
  std::string words;
  say(a, name_a, words);
  say(b, name_b, words);
  return words;
}

std::string DiffReport::though() const {
  const auto acting = std::ranges::count_if(headers, &HeaderDifference::acts);
  if (first || acting == 0) return "";
  return "though the headers differ in " + count_text(static_cast<std::uint64_t>(acting), "value") +
         " that a step depends on: see the header lines";
}

std::string DiffReport::unequal(const std::string& name_a, const std::string& name_b) const {
  if (first) return "";
  std::string text;
  if (last_a != last_b) {
    text = "another number of steps, " + std::to_string(last_a) + " and " + std::to_string(last_b);
  }
  const std::string parts = only_in.text(name_a, name_b);
  return text + (text.empty() || parts.empty() ? "" : "; ") + parts;
}

}  // namespace tumble::replay
