#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "src/base/text.h"
#include "tumble/golden/expected.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kShapesNamed = 6;

std::string shape_words(const BodyShape* body) { return body == nullptr ? "box" : body->text; }

/// The two in words; of two surfaces of one size also their hashes.
std::string both_shapes(const BodyShape* before, const BodyShape* now) {
  std::string expected = shape_words(before), actual = shape_words(now);
  if (expected == actual && before != nullptr && now != nullptr) {
    expected += " (" + to_string(before->shape) + ')';
    actual += " (" + to_string(now->shape) + ')';
  }
  return "expected " + expected + ", actual " + actual;
}

/// Whether any state that a golden keeps has a body, or an input that it keeps brings it.
bool golden_has(const Expected& expected, sim::BodyId id) {
  const auto has = [id](const std::vector<sim::BodyId>& ids) { return std::ranges::binary_search(ids, id); };
  const auto brings = [id](const sim::Command& input) {
    const auto* thrown = std::get_if<sim::Throw>(&input);
    return thrown != nullptr && thrown->box.id == id;
  };
  const auto any_brings = [&](const StepSetup& step) { return std::ranges::any_of(step.inputs, brings); };
  return std::ranges::any_of(expected.body_hashes, [&](const BodyHashes& kept) { return has(kept.id); }) ||
         std::ranges::any_of(expected.states, [&](const KeyState& kept) { return has(kept.states.id); }) ||
         std::ranges::any_of(expected.track, [&](const TrackPoint& kept) { return has(kept.id); }) ||
         (expected.setup && std::ranges::any_of(expected.setup->steps, any_brings));
}

}  // namespace

ShapesKeeper::ShapesKeeper(const replay::LogHeader& header) : is_engine_(header.engine.has_value()) {
  bodies_.add(header.declared.bodies, header.declared.shapes);
}

void ShapesKeeper::add(const replay::StepRecord& record) {
  bodies_.add(record.extras.bodies, record.extras.shapes);
  if (!is_engine_ || record.states.id == last_) return;
  last_ = record.states.id;
  ids_.insert(last_.begin(), last_.end());
}

std::optional<std::vector<BodyShape>> ShapesKeeper::shapes() const {
  if (!is_engine_) return std::nullopt;
  std::vector<BodyShape> shapes;
  for (const auto& [id, body] : bodies_.bodies()) {
    if (body.shape == Hash128()) continue;
    const replay::Shape* shape = bodies_.shape(id);
    shapes.push_back({id, body.shape, shape == nullptr ? "a shape" : to_string(*shape)});
  }
  return shapes;
}

std::vector<std::string> other_shapes(const Expected& expected, const ShapesKeeper& actual) {
  const std::optional<std::vector<BodyShape>> shapes = actual.shapes();
  if (!expected.shapes || !shapes) return {};
  std::map<sim::BodyId, std::pair<const BodyShape*, const BodyShape*>> bodies;
  for (const BodyShape& body : *expected.shapes) bodies[body.id].first = &body;
  for (const BodyShape& body : *shapes) bodies[body.id].second = &body;
  std::vector<std::string> sentences;
  std::size_t count = 0;
  for (const auto& [id, both] : bodies) {
    const auto [before, now] = both;
    if (before != nullptr && now != nullptr && before->shape == now->shape) continue;
    if (++count > kShapesNamed) continue;
    const std::string body = actual.names().text(id);
    if (before == nullptr && !golden_has(expected, id)) {
      sentences.push_back(body + " is not in the golden");
    } else if (now == nullptr && !actual.ids().contains(id)) {
      sentences.push_back(body + " is in the golden and not in the session");
    } else {
      sentences.push_back("another shape: " + body + ": " + both_shapes(before, now));
    }
  }
  if (count > kShapesNamed) {
    sentences.push_back(count_text(count - kShapesNamed, "further body") +
                        " of another shape, or in one of the two alone");
  }
  return sentences;
}

}  // namespace tumble::golden
