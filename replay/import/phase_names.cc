#include "replay/import/phase_names.h"

#include <set>

#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {

Status check_phase_names(const std::vector<std::string>& phases) {
  if (phases.size() > kPhasesMax) {
    return bad_input("found " + std::to_string(phases.size()) + " phases, wanted at most " +
                     std::to_string(kPhasesMax));
  }
  std::set<std::string> names;
  for (const std::string& name : phases) {
    if (name.empty()) {
      return bad_input("phase " + std::to_string(names.size() + 1) + " of " + std::to_string(phases.size()) +
                       ": found no name, wanted one");
    }
    if (!names.insert(name).second) {
      return bad_input("phase " + in_quotes(name) + ": found twice, wanted names that differ");
    }
  }
  return {};
}

}  // namespace tumble::replay
