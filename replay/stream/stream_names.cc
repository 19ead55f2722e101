#include "replay/stream/stream_names.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::replay {

std::string name_for_log(const std::string& name, std::size_t bytes_max) {
  std::string kept = printable(name);
  while (kept.size() > bytes_max || printable(kept) != kept) kept.pop_back();  // never within a character
  return kept;
}

std::vector<std::string> phase_names(const std::vector<std::string>& theirs, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const std::string& called : theirs) {
    const std::string wanted = called.empty() ? "unnamed" : called;
    std::string name = name_for_log(wanted);
    for (std::size_t n = 2; std::ranges::find(names, name) != names.end(); ++n) {
      const std::string behind = '#' + std::to_string(n);
      name = name_for_log(wanted, kStreamNameBytesMax - behind.size()) + behind;
    }
    names.push_back(name);
    if (name == called) continue;
    notes.push_back("phase " + std::to_string(names.size()) + ", " + in_quotes(called) + ", is logged as " +
                    in_quotes(name) + ", for a log has each name of a phase once, in 1 to " +
                    std::to_string(kStreamNameBytesMax) + " bytes of text");
  }
  return names;
}

}  // namespace tumble::replay
