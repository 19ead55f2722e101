#include "golden/hunt/engine/judge_trace.h"

#include <cmath>
#include <string_view>

#include "golden/hunt/engine/engine_relations.h"
#include "src/base/check.h"

namespace tumble::hunt {
namespace {

bool is_lost(const sim::Bodies& bodies, sim::BodyIndex i) {
  const sim::Quat& q = bodies.orientation[i];
  return !bodies.position[i].allFinite() || !bodies.velocity[i].allFinite() || !bodies.spin[i].allFinite() ||
         !std::isfinite(q.w + q.x + q.y + q.z);
}

// No law holds of a session with a body that is nowhere, whatever its comparisons came to. `numbers` says so itself.
Judgement beside_lost(const std::string& law, const Trace& trace, const Judgement& judged) {
  if (judged.outcome == Outcome::kNotApplicable || law == "finishes" || law == "numbers") return judged;
  const std::size_t states = law == "start" ? 1 : trace.states.size();
  for (std::size_t k = 0; k < states; ++k) {
    const sim::Bodies& bodies = trace.states[k].bodies;
    for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
      if (!is_lost(bodies, i)) continue;
      const bool earlier = judged.outcome == Outcome::kBroken && judged.step < k;
      return earlier ? judged : broken(k, bodies.id[i], "a value of the body is no number");
    }
  }
  return judged;
}

}  // namespace

Judgement judge_trace(const std::string& name, const Trace& trace) {
  if (name == "start" && trace.other_bodies == std::uint64_t{0}) return broken(0, 0, trace.failure);
  if (!trace.failure.empty() && name != "finishes") {
    return not_applicable(trace.other_bodies ? "the session has other bodies than the scene"
                                             : "the session ends early");
  }
  const Relation* known = find_relation(name);
  SIM_CHECK(known != nullptr, std::string_view(name));
  if (trace.external && !known->is_law) return judge_engine(name, trace);
  const Judgement judged = known->judge(trace);
  return known->is_law && trace.external ? beside_lost(name, trace, judged) : judged;
}

}  // namespace tumble::hunt
