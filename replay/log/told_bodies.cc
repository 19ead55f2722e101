#include "replay/log/told_bodies.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

class Known {
 public:
  Known(const sim::Bodies& bodies, std::span<const sim::Command> inputs) : bodies_(bodies), inputs_(inputs) {}

  [[nodiscard]] bool has(sim::BodyId id) const {
    if (bodies_.find(id)) return true;
    return std::ranges::any_of(inputs_, [id](const sim::Command& input) {
      const auto* removed = std::get_if<sim::Remove>(&input);
      return removed != nullptr && removed->id == id;
    });
  }

 private:
  const sim::Bodies& bodies_;
  std::span<const sim::Command> inputs_;
};

std::string no_such_body(const std::string& what, sim::BodyId id) {
  return "found " + what + " of body " + std::to_string(id) + ", wanted the id of a body that exists";
}

}  // namespace

Status check_bodies(const Extras& extras, const std::vector<Channel>& channels, const sim::Bodies& bodies,
                    std::span<const sim::Command> inputs) {
  const Known known(bodies, inputs);
  for (std::size_t i = 0; i < extras.channels.size(); ++i) {
    for (const ChannelKey& key : extras.channels[i].keys) {
      if (key.a == 0 || known.has(key.a)) continue;
      return bad_input(no_such_body("a value of channel " + in_quotes(channels[i].name), key.a));
    }
  }
  for (const EngineContact& contact : extras.contacts) {
    for (const sim::BodyId id : {contact.a, contact.b}) {
      if (id != 0 && !known.has(id)) return bad_input(no_such_body("a contact", id));
    }
  }
  return {};
}

Status check_rotation(sim::BodyId id, const sim::Quat& q, double off_max) {
  const double length = std::sqrt(sim::squared_length(q));
  if (!(std::fabs(length - 1) > off_max) || !std::isfinite(length)) return {};
  return bad_input("body " + std::to_string(id) + ": found an orientation of length " + significant(length, 9) +
                   ", wanted 1; divide its numbers by the length");
}

}  // namespace tumble::replay
