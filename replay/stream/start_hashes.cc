#include "replay/stream/start_hashes.h"

#include <algorithm>

#include "replay/format/step_values.h"
#include "replay/log/hashes_only.h"
#include "tumble/sim/hash.h"

namespace tumble::replay {

Status declare_start_hashes(const StreamStep& start, Declared& declared) {
  if (start.hashes.empty()) return {};
  for (const std::string_view hashed_class : kHashedClasses) {
    declared.channels.push_back({start_channel(hashed_class), {ChannelKind::kText, ChannelScope::kWorld}, {}});
  }
  std::ranges::sort(declared.channels, {}, &Channel::name);
  StepValues values(declared.channels);
  for (std::size_t k = 0; k < start.hashes.size(); ++k) {
    const std::string digits = to_string(Hash128{0, start.hashes[k]}).substr(16);
    if (Status ok = values.set(declared.find(start_channel(kHashedClasses[k])), digits, {}); !ok.ok()) return ok;
  }
  values.move_to(declared.start);
  return {};
}

}  // namespace tumble::replay
