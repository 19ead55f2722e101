#include "replay/import/csv_steps.h"

#include <algorithm>
#include <cmath>

#include "replay/format/not_finite.h"
#include "src/base/text.h"
#include "src/model/camera.h"
#include "src/world/edit_bodies.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kNone = CsvColumns::kNone;

/// The deviation of the length of a quaternion from 1 that seven digits or fewer explain.
constexpr double kRoughRotation = 1e-5;

sim::Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::string text_of(double value) { return significant(value, 17); }

}  // namespace

Result<CsvSteps> CsvSteps::open(std::string_view text, const std::string& name, std::span<const std::string> settings,
                                const std::optional<SessionLike>& like) {
  Result<CsvReader> table = CsvReader::open(text, name);
  if (!table.ok()) return table.error();
  const Result<CsvColumns> columns = find_columns(*table);
  if (!columns.ok()) return columns.error();
  CsvSettings start;
  start.scene.name = "session";
  start.scene.camera.focus = sim::focus_on_target(start.scene.camera);
  if (like) start.scene = like->scene;
  if (like && columns->time == kNone) start.dt = like->scene.world.dt;
  Result<CsvSettings> read = read_settings(*table, settings, std::move(start));
  if (!read.ok()) return read.error();
  CsvSteps steps(*std::move(table), *std::move(read), *columns);
  if (columns->time == kNone && !steps.settings_.dt) {
    return steps.at_line(steps.table_.line(), "found neither a column time nor a line \"# dt: …\"; wanted one");
  }
  if (like) {
    for (const sim::BoxDef& box : like->boxes) steps.like_.emplace(box.id, box);
  }
  if (const Result<bool> more = steps.next_row(); !more.ok()) return more.error();
  return steps;
}

std::optional<ImportedTable> CsvSteps::facts() const {
  ImportedTable facts = {settings_.axes, columns_.passed_over};
  if (facts == ImportedTable{}) return std::nullopt;
  return facts;
}

Result<bool> CsvSteps::next(TableStep& step) {
  if (!has_row_) return false;
  step.rows.clear();
  step.line = table_.line();
  const Result<double> dt = begin_step();
  if (!dt.ok()) return dt.error();
  step.dt = *dt;
  for (bool same = true; same;) {
    if (Status ok = take_row(step); !ok.ok()) return ok.error();
    const Result<bool> more = next_row();
    if (!more.ok()) return more.error();
    same = *more && cell_key_ == key_;
  }
  std::ranges::sort(step.rows, {}, &TableStep::Row::first);
  const auto twice = std::ranges::adjacent_find(step.rows, {}, &TableStep::Row::first);
  if (twice != step.rows.end()) {
    return at_line(step.line, "found body " + std::to_string(twice->first) + " twice in the step that begins here");
  }
  ++steps_;
  return true;
}

/// Moves to the next row and reads its step number and time.
Result<bool> CsvSteps::next_row() {
  Result<bool> more = table_.next();
  if (!more.ok()) return more;
  has_row_ = *more;
  if (!has_row_) return false;
  if (columns_.time != kNone) {
    const Result<double> time = table_.number(columns_.time);
    if (!time.ok()) return time.error();
    cell_key_ = cell_time_ = *time;
  }
  if (columns_.step != kNone) {
    const Result<std::uint64_t> step = table_.whole(columns_.step);
    if (!step.ok()) return step.error();
    if (*step > sim::kStepsMax) {
      return table_.at(columns_.step, "step: found a number beyond " + std::to_string(sim::kStepsMax));
    }
    cell_key_ = static_cast<double>(*step);
  }
  return true;
}

/// Checks that the step follows the step before, and returns its dt.
Result<double> CsvSteps::begin_step() {
  const double before = std::exchange(key_, cell_key_);
  const double time_before = std::exchange(time_, cell_time_);
  if (steps_ == 0) return 0.0;
  const bool by_time = columns_.step == kNone;
  const auto wrong = [&](const std::string& wanted) {
    return table_.at(by_time ? columns_.time : columns_.step, std::string(by_time ? "time" : "step") + ": found " +
                                                                  text_of(key_) + " after " + text_of(before) +
                                                                  ", wanted " + wanted);
  };
  const double apart = key_ - before;
  if (!(apart > 0)) return wrong("a later one: steps in order, and all rows of a step together");
  if (steps_ == 1) stride_ = apart;
  if (by_time) return settings_.dt.value_or(apart);
  if (apart != stride_) return wrong(text_of(before + stride_));
  return settings_.dt ? *settings_.dt * stride_ : time_ - time_before;
}

template <std::size_t N>
Status CsvSteps::read_numbers(const std::array<std::size_t, N>& columns, std::array<double, N>& out) const {
  const bool is_single = settings_.engine.precision_bits == kBinary32Bits;
  for (std::size_t k = 0; k < N; ++k) {
    const Result<double> value = is_single ? table_.single(columns[k]) : table_.number(columns[k]);
    if (!value.ok()) return value.error();
    out[k] = *value;
  }
  return {};
}

Status CsvSteps::take_row(TableStep& step) {
  const Result<std::uint64_t> id = table_.whole(columns_.id);
  if (!id.ok()) return id.error();
  std::array<double, 3> x{}, v{}, w{};
  std::array<double, 4> q{};
  if (Status ok = read_numbers(columns_.position, x); !ok.ok()) return ok;
  if (Status ok = read_numbers(columns_.orientation, q); !ok.ok()) return ok;
  if (Status ok = read_numbers(columns_.velocity, v); !ok.ok()) return ok;
  if (Status ok = read_numbers(columns_.spin, w); !ok.ok()) return ok;
  if (Status ok = check_state(*id, q); !ok.ok()) return ok;
  look_for_lost(*id, kPosition, columns_.position, x);
  look_for_lost(*id, kOrientation, columns_.orientation, q);
  look_for_lost(*id, kVelocity, columns_.velocity, v);
  look_for_lost(*id, kSpin, columns_.spin, w);
  const Result<bool> frozen = flag(columns_.frozen, false);
  if (!frozen.ok()) return frozen.error();
  const EngineAxes& axes = settings_.axes;
  const EngineState state = {axes.length(vector_of(x)), axes.turn({q[0], q[1], q[2], q[3]}), axes.length(vector_of(v)),
                             axes.axial(vector_of(w)), *frozen};
  if (Status ok = meet(*id, state); !ok.ok()) return ok;
  step.rows.emplace_back(*id, state);
  return {};
}

/// An orientation that is far from a rotation would be measured and drawn wrongly. One that is not finite is left to
/// look_for_lost().
Status CsvSteps::check_state(sim::BodyId id, const std::array<double, 4>& q) {
  const double length = std::sqrt(sim::squared_length({q[0], q[1], q[2], q[3]}));
  if (std::ranges::any_of(q, [](double number) { return !std::isfinite(number); })) return {};
  const double off = std::fabs(length - 1);
  const std::size_t column = columns_.orientation[0];
  if (off > EngineState::kLengthOffMax) {
    return table_.at(column, "orientation: found a quaternion of length " + significant(length, 9) +
                                 ", wanted 1; divide its numbers by the length");
  }
  if (off > kRoughRotation) notes_.rough_rotation(table_.at(column, "").message, id, steps_, length);
  return {};
}

/// first: the number in kColumnNames of the first of the columns, whose names in the table are those.
void CsvSteps::look_for_lost(sim::BodyId id, std::size_t first, std::span<const std::size_t> columns,
                             std::span<const double> numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (std::isfinite(numbers[k])) continue;
    notes_.lost(table_.at(columns[k], "").message, {id, steps_, kColumnNames.at(first + k), numbers[k], 1});
    return;
  }
}

/// Makes the box of a new body. Refuses a body that returns after steps without it.
Status CsvSteps::meet(sim::BodyId id, const EngineState& state) {
  const auto known = last_seen_.find(id);
  if (known != last_seen_.end()) {
    if (known->second + 1 < steps_) {
      return table_.at(columns_.id,
                       "found body " + std::to_string(id) + " again after steps without it, wanted a new id");
    }
    known->second = steps_;
    return {};
  }
  last_seen_.emplace(id, steps_);
  const auto like = like_.find(id);
  sim::BoxDef box = like != like_.end() ? like->second : settings_.box;
  box.id = id;
  if (Status ok = read_box(box); !ok.ok()) return ok;
  box.position = state.position;
  box.orientation = state.orientation;
  box.velocity = state.velocity;
  box.spin = state.spin;
  box.frozen = state.frozen && !box.is_static;
  if (const Status ok = sim::check_box(box); !ok.ok()) return table_.at(columns_.id, ok.error().message);
  boxes_.emplace(id, std::move(box));
  return {};
}

/// Reads the columns of a body: size, mass, material, place in a grid.
Status CsvSteps::read_box(sim::BoxDef& box) const {
  if (columns_.size[0] != kNone) {
    std::array<double, 3> size{};
    if (Status ok = read_numbers(columns_.size, size); !ok.ok()) return ok;
    box.size = settings_.axes.extents(vector_of(size));
  }
  const std::array<std::pair<std::size_t, double*>, 3> plain = {{{columns_.mass, &box.mass},
                                                                 {columns_.friction, &box.material.friction},
                                                                 {columns_.restitution, &box.material.restitution}}};
  for (const auto& [column, out] : plain) {
    if (column == kNone) continue;
    const Result<double> value = table_.number(column);
    if (!value.ok()) return value.error();
    *out = *value;
  }
  if (columns_.friction != kNone) box.material.friction_dynamic = box.material.friction;
  const Result<bool> is_static = flag(columns_.is_static, box.is_static);
  if (!is_static.ok()) return is_static.error();
  box.is_static = *is_static;
  return read_origin(box.origin);
}

/// Reads row and column. The body counts as part of a grid, because metrics know rows and columns of grids.
Status CsvSteps::read_origin(sim::Origin& origin) const {
  const std::array<std::pair<std::size_t, std::uint32_t*>, 2> places = {
      {{columns_.row, &origin.row}, {columns_.column, &origin.column}}};
  for (const auto& [column, out] : places) {
    if (column == kNone) continue;
    const Result<std::uint64_t> value = table_.whole(column);
    if (!value.ok()) return value.error();
    if (*value > sim::kBodiesMax) return table_.at(column, "found more than " + std::to_string(sim::kBodiesMax));
    *out = static_cast<std::uint32_t>(*value);
    origin.kind = sim::Origin::Kind::kGrid;
  }
  return {};
}

Result<bool> CsvSteps::flag(std::size_t column, bool otherwise) const {
  if (column == kNone) return otherwise;
  const Result<std::uint64_t> value = table_.whole(column);
  if (!value.ok()) return value.error();
  if (*value <= 1) return *value == 1;
  return table_.at(column, table_.columns()[column] + ": found " + std::to_string(*value) + ", wanted 0 or 1");
}

}  // namespace tumble::replay
