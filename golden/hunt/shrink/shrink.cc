#include "golden/hunt/shrink/shrink.h"

#include <utility>

#include "golden/hunt/shrink/simplify.h"

namespace tumble::hunt {
namespace {

class Search {
 public:
  Search(const TextScene& scene, const Judgement& judgement, const Test& test, const Tracer& tracer,
         std::uint64_t tries_most, const std::function<bool()>& enough)
      : test_(test), tracer_(tracer), tries_most_(tries_most), enough_(enough) {
    best_.scene = scene;
    best_.judgement = judgement;
  }

  Shrunk run() {
    bool smaller = true;
    while (smaller && !spent()) {
      smaller = false;
      smaller |= take([](const sim::SceneDef& s) { return fewer_bodies(s); });
      smaller |= take([this](const sim::SceneDef& s) { return fewer_steps(s, best_.judgement.step); });
      smaller |= take([](const sim::SceneDef& s) { return fewer_inputs(s); });
      smaller |= take_later_start();
      smaller |= take([](const sim::SceneDef& s) { return plainer(s); });
      smaller |= take([](const sim::SceneDef& s) { return renumbered(s); });
      smaller |= take_fewer_digits();
    }
    best_.least = !spent();
    return std::move(best_);
  }

 private:
  [[nodiscard]] bool spent() const { return best_.tried >= tries_most_ || (enough_ && enough_()); }

  // Takes the candidate if it still breaks the relation.
  bool accept(const sim::SceneDef& candidate, bool shorter = false) {
    if (spent()) return false;
    ++best_.tried;
    Result<TextScene> text = settled(candidate);
    if (!text.ok() || text->text == best_.scene.text) return false;
    if (shorter && text->text.size() >= best_.scene.text.size()) return false;
    const Result<Trace> session = tracer_(text->scene);
    if (!session.ok()) return false;
    Judgement judgement = test_(*session, *text);
    if (judgement.outcome != Outcome::kBroken) return false;
    best_.scene = *std::move(text);
    best_.judgement = std::move(judgement);
    return true;
  }

  // Takes candidates until none is left that is accepted.
  template <class Make>
  bool take(Make make) {
    bool any = false;
    for (bool again = true; again && !spent();) {
      again = false;
      for (const sim::SceneDef& candidate : make(best_.scene.scene)) {
        if (!accept(candidate)) continue;
        again = any = true;
        break;
      }
    }
    return any;
  }

  bool take_later_start() {
    if (best_.judgement.step < 2) return false;
    const Result<Trace> session = tracer_(best_.scene.scene);
    if (!session.ok()) return false;
    for (const sim::SceneDef& candidate : later_starts(*session, best_.judgement.step)) {
      if (accept(candidate)) return true;
    }
    return false;
  }

  bool take_fewer_digits() {
    bool any = false;
    sim::SceneDef scene = best_.scene.scene;
    const std::size_t count = numbers_of(scene).size();
    for (std::size_t k = 0; k < count && !spent(); ++k) {
      scene = best_.scene.scene;
      const std::vector<double*> numbers = numbers_of(scene);
      const double before = *numbers[k];
      for (const double shorter : fewer_digits(before)) {
        *numbers[k] = shorter;
        if (!accept(scene, true)) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  const Test& test_;
  const Tracer& tracer_;
  std::uint64_t tries_most_;
  const std::function<bool()>& enough_;
  Shrunk best_;
};

}  // namespace

Shrunk shrink(const TextScene& scene, const Judgement& judgement, const Test& test, const Tracer& tracer,
              std::uint64_t tries_most, const std::function<bool()>& enough) {
  return Search(scene, judgement, test, tracer, tries_most, enough).run();
}

}  // namespace tumble::hunt
