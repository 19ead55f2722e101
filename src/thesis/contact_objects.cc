#include "src/thesis/contact_objects.h"

#include <algorithm>
#include <limits>

#include "src/base/check.h"

namespace tumble::sim {
namespace {

constexpr double kGroundHeight = -std::numeric_limits<double>::infinity();

// Whether `object` may carry `body`, and the height of its centre over the body's, times gravity. push: direction from
// object to body.
struct Support {
  bool carries = false;
  double height = 0;
};
Support support_of(const WorldState& state, BodyIndex body, BodyIndex object, const Vec3& push) {
  const Vec3& gravity = state.def.gravity;
  if (object == kGround) return {gravity.z() < 0, kGroundHeight};
  const Bodies& bodies = state.bodies;
  const double height = -dot(gravity, bodies.position[object] - bodies.position[body]);
  const bool ramp = bodies.is_static[object] != 0 && dot(gravity, push) < 0;
  return {height < 0 || ramp, height};
}

// Calls visit(body, object, push) for both sides of every contact.
template <class Visit>
void for_each_touch(const Contacts& contacts, Visit visit) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const Vec3 normal = contacts.normal[k];
    visit(a, b, Vec3(-normal));
    if (b != kGround) visit(b, a, normal);
  }
}

}  // namespace

void collect_contact_objects(const WorldState& state, const Contacts& contacts, FreezeScratch& freezing) {
  std::vector<FreezeCandidate>& candidates = freezing.candidates;
  SIM_CHECK(candidates.size() == state.bodies.size(), candidates.size(), state.bodies.size());
  for_each_touch(contacts, [&](BodyIndex body, BodyIndex object, const Vec3& push) {
    if (!candidates[body].ready) return;
    const Support support = support_of(state, body, object, push);
    if (support.carries) candidates[body].lowest = std::min(candidates[body].lowest, support.height);
  });
  std::vector<std::pair<BodyIndex, BodyIndex>>& carriers = freezing.carriers;
  carriers.clear();
  for_each_touch(contacts, [&](BodyIndex body, BodyIndex object, const Vec3& push) {
    if (!candidates[body].ready) return;
    const Support support = support_of(state, body, object, push);
    if (support.carries && support.height == candidates[body].lowest) carriers.emplace_back(body, object);
  });
  std::sort(carriers.begin(), carriers.end());
  carriers.erase(std::unique(carriers.begin(), carriers.end()), carriers.end());
  freezing.found.clear();
  for (const auto& [body, object] : carriers) freezing.found.push_back(body, object);
}

}  // namespace tumble::sim
