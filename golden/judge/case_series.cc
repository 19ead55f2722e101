#include "golden/judge/case_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "golden/judge/channel_series.h"
#include "replay/measure/measure.h"
#include "replay/measure/measure_state.h"
#include "replay/session/state_source.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr std::uint64_t kRowsMax = 1000;  // more than a screen has columns

using Boxes = std::map<sim::BodyId, sim::BoxDef>;

/// Six digits are more than a plot shows, and a third of the text.
double six_digits(double value) { return std::strtod(significant(value, 6).c_str(), nullptr); }

/// Another engine's log may hold anything; a value without a place stays null.
Json whole(double value) {
  return std::fabs(value) < 1e15 ? Json(static_cast<std::int64_t>(std::round(value))) : Json(nullptr);
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(six_digits(*value)) : Json(nullptr); }

replay::BodyStates states_of(const TrackPoint& point) {
  replay::BodyStates states;
  states.id = point.id;
  const std::size_t n = point.id.size();
  const auto metres = [](const std::vector<std::int32_t>& mm) {
    std::vector<double> out(mm.size());
    std::ranges::transform(mm, out.begin(), [](std::int32_t value) { return value / 1000.0; });
    return out;
  };
  states.position = {metres(point.x), metres(point.y), metres(point.z)};
  const std::vector<double> zero(n, 0.0);
  states.orientation = {std::vector<double>(n, 1.0), zero, zero, zero};
  states.velocity = {zero, zero, zero};
  states.spin = {zero, zero, zero};
  states.frozen.assign(n, 0);
  return states;
}

void add_places(Json& columns, const replay::StateMeasures& state) {
  columns["lateral_max"].push_back(state.of_start > 0 ? Json(six_digits(state.lateral_max)) : Json());
  columns["column_spread"].push_back(number_or_null(state.column_spread));
  columns["height_max"].push_back(six_digits(state.height_max));
  columns["height_mean"].push_back(six_digits(state.height_mean));
}

void add_energies(Json& columns, double kinetic, double potential) {
  columns["kinetic"].push_back(six_digits(kinetic));
  columns["potential"].push_back(six_digits(potential));
  columns["total"].push_back(six_digits(kinetic + potential));
}

/// Measures the states that a golden has against its own first one: a body at rest reads 0 in spite of millimetres.
class ExpectedMeter {
 public:
  ExpectedMeter(const sim::SceneDef& scene, replay::BodyTable shapes)
      : scene_(scene), shapes_(std::move(shapes)), gravity_(scene.world.gravity) {
    for (const sim::BoxDef& box : scene.boxes) boxes_[box.id] = box;
  }

  void apply(const sim::Command& input) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input)) boxes_[thrown->box.id] = thrown->box;
    if (const auto* changed = std::get_if<sim::SetGravity>(&input)) gravity_ = changed->gravity;
    if (track_) track_->apply(input);
    if (states_) states_->apply(input);
  }

  void add_track(const TrackPoint& point, Json& columns) {
    const replay::BodyStates states = states_of(point);
    if (!track_) track_.emplace(scene_, states);
    columns["step"].push_back(point.step);
    columns["potential"].push_back(six_digits(potential(states)));
    add_places(columns, track_->measure(states));
  }

  void add_state(const KeyState& key, Json& columns) {
    if (!states_) states_.emplace(scene_, key.states, replay::MeasureOptions(), shapes_);
    const replay::StateMeasures measured = states_->measure(key.states);
    columns["step"].push_back(key.step);
    add_energies(columns, measured.kinetic_linear + measured.kinetic_rotational, potential(key.states));
  }

  [[nodiscard]] const Boxes& boxes() const { return boxes_; }

 private:
  [[nodiscard]] double potential(const replay::BodyStates& states) const {
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto box = boxes_.find(states.id[i]);
      if (box == boxes_.end() || box->second.is_static) continue;
      const sim::Vec3 place = {states.position.x[i], states.position.y[i], states.position.z[i]};
      sum -= box->second.mass * sim::dot(gravity_, place);
    }
    return sum;
  }

  const sim::SceneDef& scene_;
  replay::BodyTable shapes_;
  sim::Vec3 gravity_;
  Boxes boxes_;  // all there ever were
  std::optional<replay::StateMeter> track_, states_;
};

/// A place in the list of all bodies for each id.
using Rows = std::map<sim::BodyId, std::size_t>;

Json place_row(const std::vector<sim::BodyId>& ids, const Rows& rows, const auto& component, std::size_t width) {
  Json out(std::vector<Json>(rows.size() * width));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::size_t at = rows.at(ids[i]) * width;
    for (std::size_t c = 0; c < width; ++c) out[at + c] = component(i, c);
  }
  return out;
}

/// Reads a log once and collects the numbers to draw.
class Collector {
 public:
  Collector(replay::LogReader& log, const Expected* expected)
      : log_(log),
        expected_(expected),
        measurer_(log.header(), {.overlap_every = 0}),
        meter_(log.header().scene, log.bodies()) {
    const auto steps = log.step_count();
    stride_ = steps / kRowsMax + 1;
    if (expected != nullptr) {
      for (const TrackPoint& point : expected->track) frames_.push_back(point.step);
    }
    if (frames_.empty()) frames_ = choose_milestones(steps, log.header().scene.boxes.size()).track;
  }

  Result<Json> run() {
    replay::StateSource source(log_);
    for (std::uint64_t k = 0; k <= log_.step_count(); ++k) {
      const Result<const replay::StepRecord*> record = source.read(k);
      if (!record.ok()) return record.error();
      add(**record);
    }
    json_["actual"] = std::move(actual_);
    json_["expected"] = {{"track", std::move(track_)}, {"states", std::move(states_)}};
    add_channels(log_.header().declared.channels, expected_, json_);
    add_frames();
    return std::move(json_);
  }

 private:
  void add(const replay::StepRecord& record) {
    for (const sim::Command& input : record.inputs) meter_.apply(input);
    measurer_.add(record);
    if (record.step % stride_ == 0 || record.step == log_.step_count()) {
      const replay::SeriesRow& row = measurer_.row();
      actual_["step"].push_back(row.step);
      add_energies(actual_, row.kinetic, row.potential);
      add_places(actual_, row.state);
      add_channel_values(log_.header().declared.channels, row.channels, actual_);
    }
    if (std::ranges::binary_search(frames_, record.step)) seen_.emplace_back(record.step, record.states);
    if (expected_ == nullptr) return;
    for (const TrackPoint& point : expected_->track) {
      if (point.step == record.step) meter_.add_track(point, track_);
    }
    for (const KeyState& key : expected_->states) {
      if (key.step == record.step) meter_.add_state(key, states_);
    }
  }

  /// Every body that any frame shows.
  Rows rows() const {
    Rows rows;
    for (const auto& [step, states] : seen_) {
      for (const sim::BodyId id : states.id) rows[id] = 0;
    }
    if (expected_ != nullptr) {
      for (const TrackPoint& point : expected_->track) {
        for (const sim::BodyId id : point.id) rows[id] = 0;
      }
    }
    std::size_t next = 0;
    for (auto& [id, row] : rows) row = next++;
    return rows;
  }

  void add_frames() {
    const Rows rows = this->rows();
    Json bodies = {{"id", Json::array()}, {"size", Json::array()}};
    for (const auto& [id, row] : rows) {
      const auto box = meter_.boxes().find(id);
      const sim::Vec3 size = box == meter_.boxes().end() ? sim::Vec3{0, 0, 0} : box->second.size;
      bodies["id"].push_back(id);
      for (const double edge : {size.x(), size.y(), size.z()}) bodies["size"].push_back(six_digits(edge));
    }
    Json frames = {{"step", Json::array()},
                   {"expected_mm", Json::array()},
                   {"actual_mm", Json::array()},
                   {"actual_turn", Json::array()}};
    for (const auto& [step, states] : seen_) {
      const sim::Vec3Column& x = states.position;
      const sim::QuatColumn& q = states.orientation;
      frames["step"].push_back(step);
      frames["actual_mm"].push_back(place_row(
          states.id, rows,
          [&](std::size_t i, std::size_t c) { return whole(1000 * x[i][static_cast<Eigen::Index>(c)]); }, 3));
      frames["actual_turn"].push_back(place_row(
          states.id, rows,
          [&](std::size_t i, std::size_t c) {
            return Json(six_digits(std::round(1000 * std::array{q.w[i], q.x[i], q.y[i], q.z[i]}[c]) / 1000));
          },
          4));
      frames["expected_mm"].push_back(expected_row(step, rows));
    }
    json_["bodies"] = std::move(bodies);
    json_["frames"] = std::move(frames);
  }

  [[nodiscard]] Json expected_row(std::uint64_t step, const Rows& rows) const {
    if (expected_ == nullptr) return nullptr;
    const auto point = std::ranges::find(expected_->track, step, &TrackPoint::step);
    if (point == expected_->track.end()) return nullptr;
    return place_row(
        point->id, rows,
        [&](std::size_t i, std::size_t c) {
          return Json(std::array{point->x[i], point->y[i], point->z[i]}[c]);
        },
        3);
  }

  replay::LogReader& log_;
  const Expected* expected_;
  replay::Measurer measurer_;
  ExpectedMeter meter_;
  std::uint64_t stride_ = 1;
  std::vector<std::uint64_t> frames_;  // ascending
  std::vector<std::pair<std::uint64_t, replay::BodyStates>> seen_;
  Json json_, actual_, track_, states_;
};

}  // namespace

Result<Json> case_series(replay::LogReader& log, const Expected* expected) { return Collector(log, expected).run(); }

}  // namespace tumble::golden
