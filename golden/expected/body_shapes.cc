#include <algorithm>
#include <map>

#include "src/base/text.h"
#include "tumble/golden/expected_extras.h"

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

}  // namespace

ShapesKeeper::ShapesKeeper(const replay::LogHeader& header) : is_engine_(header.engine.has_value()) {
  bodies_.add(header.declared.bodies, header.declared.shapes);
}

void ShapesKeeper::add(const replay::StepRecord& record) { bodies_.add(record.extras.bodies, record.extras.shapes); }

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

std::vector<std::string> other_shapes(const std::vector<BodyShape>& expected, const std::vector<BodyShape>& actual) {
  std::map<sim::BodyId, std::pair<const BodyShape*, const BodyShape*>> bodies;
  for (const BodyShape& body : expected) bodies[body.id].first = &body;
  for (const BodyShape& body : actual) bodies[body.id].second = &body;
  std::vector<std::string> sentences;
  std::size_t count = 0;
  for (const auto& [id, both] : bodies) {
    const auto [before, now] = both;
    if (before != nullptr && now != nullptr && before->shape == now->shape) continue;
    if (++count > kShapesNamed) continue;
    sentences.push_back("body " + std::to_string(id) + ": " + both_shapes(before, now));
  }
  if (count > kShapesNamed) sentences.push_back("another shape of " + count_text(count - kShapesNamed, "further body"));
  return sentences;
}

}  // namespace tumble::golden
