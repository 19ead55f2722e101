#include "replay/measure/start_warnings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "replay/measure/measure_overlap.h"
#include "replay/measure/start_loads.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

using sim::BoxFrame;

constexpr double kDeep = 0.1;                  // of the shortest edge: much more than any stack needs
constexpr double kTouching = 0.01;             // m
constexpr std::size_t kShown = 3;              // of a kind; the others are counted
constexpr std::size_t kTestsMax = 10'000'000;  // a fraction of a second
constexpr double kUsualSubsteps = 8;

struct Overlap {
  std::size_t a, b;
  double depth;
  bool same_place;
};

double shortest_edge(const BoxFrame& box) { return 2 * box.half_extent.minCoeff(); }

// dt and gravity from a step on.
struct Pace {
  std::uint64_t step = 1;
  double dt = 0;                                                         // s
  double gravity = 0;                                                    // m/s²
  [[nodiscard]] double fall() const { return 0.5 * gravity * dt * dt; }  // m, in a step
};

std::string beginning_at(std::uint64_t step) { return step == 1 ? "" : "from step " + std::to_string(step) + " on "; }

// A body that gets a velocity, at the start or by an input.
struct Launch {
  sim::BodyId id = 0;
  std::uint64_t step = 1;
  double speed = 0, edge = 0;  // m/s; m, the shortest
};

class Start {
 public:
  explicit Start(const sim::WorldState& start)
      : bodies_(start.bodies), world_(start.def), group_(bodies_.size()), loads_(bodies_, boxes_, world_) {
    std::iota(group_.begin(), group_.end(), std::size_t{0});
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      boxes_.push_back({bodies_.position[i], sim::axes_of(bodies_.orientation[i]), bodies_.half_extent[i]});
    }
    look_at_pairs();
  }

  [[nodiscard]] std::vector<std::string> warnings(std::span<const sim::TimedCommand> inputs) {
    std::vector<std::string> out;
    add_overlaps(out);
    add_sunk(out);
    loads_.add_to(out);
    if (world_.ground || bodies_.size() + inputs.size() >= 2) {
      const std::vector<Launch> launches = launches_of(inputs);
      const std::vector<Pace> paces = paces_of(inputs);
      add_coarse(launches, paces, out);
      add_fast(launches, paces, out);
    }
    if (complete_) add_floating(out);
    return out;
  }

 private:
  [[nodiscard]] double low(std::size_t i, int axis) const {
    return boxes_[i].position[axis] - sim::reach_along(boxes_[i], axis);
  }
  [[nodiscard]] double high(std::size_t i, int axis) const {
    return boxes_[i].position[axis] + sim::reach_along(boxes_[i], axis);
  }
  [[nodiscard]] std::string name(std::size_t i) const { return std::to_string(bodies_.id[i]); }

  std::size_t group_of(std::size_t i) {
    while (group_[i] != i) i = group_[i] = group_[group_[i]];
    return i;
  }

  // A sweep along x: boxes whose intervals are apart by more than kTouching do not meet.
  void look_at_pairs() {
    std::vector<std::size_t> order(boxes_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return low(i, 0); });
    std::size_t tests = 0;
    for (std::size_t first = 0; first < order.size() && complete_; ++first) {
      const double end = high(order[first], 0) + kTouching;
      for (std::size_t second = first + 1; second < order.size() && low(order[second], 0) <= end; ++second) {
        complete_ = ++tests <= kTestsMax;
        if (!complete_) break;
        look_at(order[first], order[second]);
      }
    }
  }

  void look_at(std::size_t i, std::size_t j) {
    for (const int axis : {1, 2}) {
      if (low(i, axis) > high(j, axis) + kTouching || low(j, axis) > high(i, axis) + kTouching) return;
    }
    group_[group_of(i)] = group_of(j);
    if (bodies_.is_static[i] != 0 && bodies_.is_static[j] != 0) return;
    loads_.look_at(i, j);
    const double depth = overlap_depth(boxes_[i], boxes_[j]);
    if (depth <= kDeep * std::min(shortest_edge(boxes_[i]), shortest_edge(boxes_[j]))) return;
    overlaps_.push_back({std::min(i, j), std::max(i, j), depth, boxes_[i].position == boxes_[j].position});
  }

  void add_overlaps(std::vector<std::string>& out) {
    std::ranges::sort(overlaps_, [](const Overlap& x, const Overlap& y) {
      return x.depth != y.depth ? x.depth > y.depth : std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    for (std::size_t k = 0; k < overlaps_.size() && k < kShown; ++k) {
      const Overlap& pair = overlaps_[k];
      std::string& line = out.emplace_back("bodies ");
      line.append(name(pair.a)).append(" and ").append(name(pair.b));
      line.append(pair.same_place ? " are in one place and overlap by " : " overlap by ");
      line.append(rounded(pair.depth, "m")).append(" at the start");
      if (!pair.same_place) line.append(" and will be pushed apart");
    }
    if (overlaps_.size() > kShown) {
      out.push_back("and " + count_text(overlaps_.size() - kShown, "more pair") + " overlap deeply at the start");
    }
  }

  void add_sunk(std::vector<std::string>& out) const {
    if (!world_.ground) return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const double depth = ground_penetration(boxes_[i]);
      if (bodies_.is_static[i] != 0 || depth <= kDeep * shortest_edge(boxes_[i])) continue;
      if (++count > kShown) continue;
      out.push_back("body " + name(i) + " is " + rounded(depth, "m") + " deep in the ground at the start");
    }
    if (count > kShown) out.push_back("and " + count_text(count - kShown, "more body") + " deep in the ground");
  }

  // From step 1 on. Inputs of one step act together.
  [[nodiscard]] std::vector<Pace> paces_of(std::span<const sim::TimedCommand> inputs) const {
    std::vector<Pace> paces = {{1, world_.dt, sim::length(world_.gravity)}};
    for (const sim::TimedCommand& input : inputs) {
      const auto* dt = std::get_if<sim::SetDt>(&input.command);
      const auto* gravity = std::get_if<sim::SetGravity>(&input.command);
      if (dt == nullptr && gravity == nullptr) continue;
      if (paces.back().step != input.step) paces.push_back({input.step, paces.back().dt, paces.back().gravity});
      if (dt != nullptr) paces.back().dt = dt->dt;
      if (gravity != nullptr) paces.back().gravity = sim::length(gravity->gravity);
    }
    return paces;
  }

  // Of the bodies that are not static: at the start, thrown in, and where an input sets their velocity.
  [[nodiscard]] std::vector<Launch> launches_of(std::span<const sim::TimedCommand> inputs) const {
    std::vector<Launch> out;
    std::map<sim::BodyId, std::size_t> last;
    const auto launch = [&](sim::BodyId id, std::uint64_t step, const sim::Vec3& velocity, double edge) {
      last[id] = out.size();
      out.push_back({id, step, sim::length(velocity), edge});
    };
    for (sim::BodyIndex i = 0; i < bodies_.size(); ++i) {
      if (bodies_.is_static[i] == 0) launch(bodies_.id[i], 1, bodies_.velocity[i], shortest_edge(boxes_[i]));
    }
    for (const sim::TimedCommand& input : inputs) {
      const auto* thrown = std::get_if<sim::Throw>(&input.command);
      if (thrown != nullptr) launch(thrown->box.id, input.step, thrown->box.velocity, thrown->box.size.minCoeff());
      const auto* set = std::get_if<sim::SetVelocity>(&input.command);
      const auto known = set != nullptr ? last.find(set->id) : last.end();
      if (known == last.end()) continue;
      Launch& before = out[known->second];
      if (before.step == input.step) before.speed = sim::length(set->velocity);
      if (before.step != input.step) launch(set->id, input.step, set->velocity, before.edge);
    }
    return out;
  }

  // The way that gravity may move a body in a step, by its shortest edge. Measured on heaps, towers and plates of five
  // boxes with dt from 1/240 s to 1 s: with the usual substeps, boxes beyond one edge sink into one another or are
  // lost. In method layered n times as many substeps bear n times the way. In method thesis, whose impulses move bodies
  // by a substep of falling, n² times; but it finds collisions where a step ends, and misses what falls by more than an
  // edge.
  [[nodiscard]] double bearable_edges() const {
    if (world_.method == sim::Method::kLayered) return world_.substeps / kUsualSubsteps;
    const double parts = std::bit_floor(world_.substeps) / kUsualSubsteps;
    return std::min(1.0, parts * parts);
  }

  // The substeps that bear a way of so many edges; none if there are none.
  [[nodiscard]] std::optional<std::uint32_t> substeps_for(double edges) const {
    const bool layered = world_.method == sim::Method::kLayered;
    if (edges > (layered ? sim::kSubstepsMax / kUsualSubsteps : 1.0)) return std::nullopt;
    const auto wanted = static_cast<std::uint32_t>(std::ceil(kUsualSubsteps * (layered ? edges : std::sqrt(edges))));
    return layered ? wanted : std::bit_ceil(wanted);
  }

  // A step in which gravity alone moves bodies too far.
  void add_coarse(std::span<const Launch> launches, std::span<const Pace> paces, std::vector<std::string>& out) const {
    const auto smallest = std::ranges::min_element(launches, {}, &Launch::edge);
    const Pace& pace = *std::ranges::max_element(paces, {}, &Pace::fall);
    const double fall = pace.fall();
    if (smallest == launches.end() || fall <= bearable_edges() * smallest->edge) return;
    const double edge = smallest->edge, dt_most = std::sqrt(2 * bearable_edges() * edge / pace.gravity);
    std::string& line = out.emplace_back(beginning_at(pace.step));
    line.append("gravity moves a body by ");
    line.append(rounded(fall, "m")).append(" in a step of ").append(seconds_text(pace.dt)).append(" with ");
    line.append(count_text(world_.substeps, "substep")).append(", too far for body ");
    line.append(std::to_string(smallest->id)).append(" with its shortest edge of ").append(rounded(edge, "m"));
    line.append(": boxes that collide may sink into one another and pass through; take a dt of at most ");
    line.append(significant(0.99 * dt_most, 3)).append(" s");
    if (const auto substeps = substeps_for(fall / edge))
      line.append(" or substeps = ").append(std::to_string(*substeps));
  }

  // Method thesis finds collisions where a step ends: a body that moves by less than its shortest edge in a step cannot
  // jump over a thing. Method layered looks along the way. Bodies that gravity alone moves too far are add_coarse()'s.
  void add_fast(std::span<const Launch> launches, std::span<const Pace> paces, std::vector<std::string>& out) const {
    if (world_.method != sim::Method::kThesis) return;
    std::size_t count = 0;
    for (const auto& [id, step, speed, edge] : launches) {
      const Pace& pace = pace_of(paces, step);
      const double own = speed * pace.dt, fall = pace.fall(), way = own + fall;
      if (way <= edge || (fall > edge && own <= edge) || ++count > kShown) continue;
      std::string& line = out.emplace_back(beginning_at(step));
      line.append("body ").append(std::to_string(id)).append(" moves by ").append(rounded(way, "m"));
      line.append(" in a step of ").append(seconds_text(pace.dt)).append(", more than its shortest edge of ");
      line.append(rounded(edge, "m")).append(", and may pass through others");
    }
    if (count > kShown) out.push_back("and " + count_text(count - kShown, "more body") + " as fast");
  }

  // The pace of a step. paces: the first is that of step 1.
  static const Pace& pace_of(std::span<const Pace> paces, std::uint64_t step) {
    return *std::prev(std::ranges::upper_bound(paces, step, {}, &Pace::step));
  }

  // A group of bodies that touch is held where one of them is static or touches the ground.
  void add_floating(std::vector<std::string>& out) {
    if (world_.gravity == sim::Vec3(0, 0, 0)) return;
    std::vector<std::uint8_t> held(boxes_.size(), 0);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (bodies_.is_static[i] != 0 || (world_.ground && low(i, 2) <= kTouching)) held[group_of(i)] = 1;
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (bodies_.frozen[i] == 0 || bodies_.is_static[i] != 0 || held[group_of(i)] != 0) continue;
      if (++count > kShown) continue;
      out.push_back("body " + name(i) + " is frozen in mid-air, where it stays until something touches it");
    }
    if (count > kShown) out.push_back("and " + std::to_string(count - kShown) + " more are frozen in mid-air");
  }

  const sim::Bodies& bodies_;
  const sim::WorldDef& world_;
  std::vector<BoxFrame> boxes_;
  std::vector<std::size_t> group_;  // of bodies that touch, each pointing towards its group's first
  StartLoads loads_;
  std::vector<Overlap> overlaps_;
  bool complete_ = true;
};

}  // namespace

std::vector<std::string> start_warnings(const sim::WorldState& start, std::span<const sim::TimedCommand> inputs) {
  return Start(start).warnings(inputs);
}

}  // namespace tumble::replay
