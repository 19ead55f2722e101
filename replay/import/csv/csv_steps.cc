#include "replay/import/csv/csv_steps.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "replay/format/not_finite.h"
#include "replay/import/shape_text.h"
#include "src/base/text.h"
#include "src/model/camera.h"
#include "src/world/edit_bodies.h"
#include "tumble/replay/body_table.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kNone = CsvColumns::kNone;

/// The deviation of the length of a quaternion from 1 that seven digits or fewer explain.
constexpr double kRoughRotation = 1e-5;

sim::Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

Result<CsvSteps> CsvSteps::open(std::string_view text, const std::string& name, const TableOptions& options) {
  const std::optional<SessionLike>& like = options.like;
  Result<CsvReader> table = CsvReader::open(text, name);
  if (!table.ok()) return table.error();
  if (Status ok = rename_columns(options.map, *table); !ok.ok()) return ok.error();
  const Result<CsvColumns> columns = find_columns(*table, options.map.others_are_channels);
  if (!columns.ok()) return columns.error();
  CsvSettings start;
  start.scene.name = "session";
  start.scene.camera.focus = sim::focus_on_target(start.scene.camera);
  if (like) start.scene = like->scene;
  const bool tells_dt = columns->time != kNone || columns->dt != kNone;
  if (like && !tells_dt && !like->dt_varies) start.dt = like->scene.world.dt;
  Result<CsvSettings> read = read_settings(*table, options.settings, std::move(start));
  if (!read.ok()) return read.error();
  CsvSteps steps(*std::move(table), *std::move(read), *columns);
  if (!tells_dt && !steps.settings_.dt) {
    const std::string of_like = like ? ", because the steps of the session to be like differ in length" : "";
    return steps.at_line(steps.table_.line(),
                         "found neither a column time or dt nor a line \"# dt: …\"; wanted one" + of_like);
  }
  if (const std::size_t kinds = steps.settings_.kinds.size(); kinds > 0 && kinds != columns->channels.size()) {
    return steps.at_line(
        steps.table_.line(),
        "kinds: " + found_wanted(count_text(kinds, "kind"), count_text(columns->channels.size(), "kind") +
                                                                ", one for each column channel.NAME and world.NAME"));
  }
  if (like) {
    for (const sim::BoxDef& box : like->boxes) steps.like_.emplace(box.id, box);
  }
  steps.first_reading_ = options.kinds.empty();
  steps.plausible_.set_scalar_last(options.scalar_last);
  steps.channels_.set_kinds(options.kinds);
  if (Status ok = check_channels(steps.channels_.channels()); !ok.ok()) {
    return steps.at_line(steps.table_.line(), ok.error().message + "; --map channel.NAME=COLUMN gives another name");
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
  const Result<double> dt = clock_.begin_step(table_);
  if (!dt.ok()) return dt.error();
  step.dt = *dt;
  if (step.values.channels() != channels_.channels()) step.values = StepValues(channels_.channels());
  channels_.begin_step();
  for (bool same = true; same;) {
    if (Status ok = take_row(step); !ok.ok()) return ok.error();
    const Result<bool> more = next_row();
    if (!more.ok()) return more.error();
    same = *more && clock_.in_step();
  }
  std::ranges::sort(step.rows, {}, &TableStep::Row::first);
  const auto twice = std::ranges::adjacent_find(step.rows, {}, &TableStep::Row::first);
  if (twice != step.rows.end()) {
    const std::string& name = infos_.at(twice->first).name;
    return at_line(step.line, "found body " + (name.empty() ? std::to_string(twice->first) : in_quotes(name)) +
                                  " twice in the step that begins here; wanted one row for each body and step");
  }
  ++steps_;
  return true;
}

/// Moves to the next row and reads its step number and time.
Result<bool> CsvSteps::next_row() {
  Result<bool> more = table_.next();
  if (!more.ok()) return more;
  has_row_ = *more;
  for (const CsvSetting& setting : table_.passed_over()) {
    if (!is_setting(setting.key)) continue;  // a remark with a colon
    return at_line(setting.line, "found the key \"" + setting.key +
                                     "\" below the names of the columns, wanted it above them; move the line up");
  }
  if (!has_row_) return false;
  if (Status ok = clock_.read_row(table_); !ok.ok()) return ok.error();
  return true;
}

template <std::size_t N>
Status CsvSteps::read_numbers(const std::array<std::size_t, N>& columns, std::array<double, N>& out) const {
  const bool is_single = single();
  for (std::size_t k = 0; k < N; ++k) {
    const Result<double> value = is_single ? table_.single(columns[k]) : table_.number(columns[k]);
    if (!value.ok()) return value.error();
    out[k] = *value;
  }
  return {};
}

/// A body whose id is 0 or a text gets an id made of that text, the same in every table, so that two sessions can be
/// compared whatever the order of their rows.
Result<sim::BodyId> CsvSteps::read_id() {
  const std::string_view cell = table_.cell(columns_.id);
  if (const auto known = ids_.find(cell); known != ids_.end()) return known->second;
  const Result<std::uint64_t> whole = table_.whole(columns_.id);
  if (whole.ok() && *whole > 0 && *whole <= sim::kBodyIdMax) return *whole;
  if (!whole.ok() && parse_exact(cell)) return whole.error();
  const std::string text(cell);
  if (text.empty()) return table_.at(columns_.id, "id: found nothing, wanted a number or a name");
  const std::uint64_t hash = hash_bytes(std::as_bytes(std::span(cell))).low;
  const sim::BodyId id = kIdsOfNames | (hash & (kIdsOfNames - 1));
  if (infos_.contains(id)) {
    const auto same = std::ranges::find(ids_, id, [](const auto& entry) { return entry.second; });
    const std::string other = same != ids_.end() ? in_quotes(same->first) : std::to_string(id);
    return table_.at(columns_.id,
                     "found ids " + in_quotes(cell) + " and " + other + ", which get one number; wanted other names");
  }
  BodyInfo info = {id, text, {}};
  if (Status ok = check_body_info(info); !ok.ok()) return table_.at(columns_.id, ok.error().message);
  ids_.emplace(text, id);
  infos_.emplace(id, std::move(info));
  return id;
}

Result<sim::Quat> CsvSteps::read_orientation() {
  if (columns_.euler[0] == kNone) {
    std::array<double, 4> q{};
    if (Status ok = read_numbers(columns_.orientation, q); !ok.ok()) return ok.error();
    return sim::Quat{q[0], q[1], q[2], q[3]};
  }
  constexpr double kDegrees = 57.295779513082323;  // of a radian
  std::array<double, 3> angles{};
  if (Status ok = read_numbers(columns_.euler, angles); !ok.ok()) return ok.error();
  if (settings_.radians) {
    for (double& angle : angles) angle *= kDegrees;
  }
  return orientation_of(settings_.euler, angles);
}

Result<EngineState> CsvSteps::read_state(sim::BodyId id, double dt) {
  std::array<double, 3> x{}, v{}, w{};
  if (Status ok = read_numbers(columns_.position, x); !ok.ok()) return ok.error();
  const Result<sim::Quat> turn = read_orientation();
  if (!turn.ok()) return turn.error();
  const std::array<double, 4> q = {turn->w, turn->x, turn->y, turn->z};
  if (columns_.has_velocity()) {
    if (Status ok = read_numbers(columns_.velocity, v); !ok.ok()) return ok.error();
  }
  if (columns_.has_spin()) {
    if (Status ok = read_numbers(columns_.spin, w); !ok.ok()) return ok.error();
  }
  if (Status ok = check_state(id, q); !ok.ok()) return ok.error();
  look_for_lost(id, kPosition, columns_.position, x);
  if (columns_.euler[0] == kNone) look_for_lost(id, kOrientation, columns_.orientation, q);
  if (columns_.has_velocity()) look_for_lost(id, kVelocity, columns_.velocity, v);
  if (columns_.has_spin()) look_for_lost(id, kSpin, columns_.spin, w);
  const Result<bool> frozen = columns_.frozen == kNone ? Result<bool>(false) : table_.flag(columns_.frozen);
  if (!frozen.ok()) return frozen.error();
  const EngineAxes& axes = settings_.axes;
  EngineState state = {axes.length(vector_of(x)), axes.turn(*turn), axes.length(vector_of(v)), axes.axial(vector_of(w)),
                       *frozen};
  const bool without_velocity = !columns_.has_velocity(), without_spin = !columns_.has_spin();
  if (without_velocity || without_spin) motion_.derive(id, steps_, dt, without_velocity, without_spin, state);
  return state;
}

Status CsvSteps::take_row(TableStep& step) {
  const Result<sim::BodyId> id = read_id();
  if (!id.ok()) return id.error();
  const Result<EngineState> state = read_state(*id, step.dt);
  if (!state.ok()) return state.error();
  if (Status ok = meet(*id, *state); !ok.ok()) return ok;
  plausible_.set_gravity(settings_.scene.world.gravity);
  const bool by_angles = columns_.euler[0] != kNone;
  plausible_.add(*id, steps_, step.dt, *state, {columns_.has_velocity(), columns_.has_spin(), !by_angles},
                 boxes_.at(*id).size.maxCoeff(), settings_.axes);
  step.rows.emplace_back(*id, *state);
  if (!first_reading_) return channels_.take(table_, *id, step.values);
  channels_.look(table_);
  return {};
}

/// An orientation that is far from a rotation would be measured and drawn wrongly. One that is not finite is left to
/// look_for_lost().
Status CsvSteps::check_state(sim::BodyId id, const std::array<double, 4>& q) {
  const double length = std::sqrt(sim::squared_length({q[0], q[1], q[2], q[3]}));
  if (std::ranges::any_of(q, [](double number) { return !std::isfinite(number); })) return {};
  const double off = std::fabs(length - 1);
  const std::size_t column = columns_.orientation[0] == kNone ? columns_.euler[0] : columns_.orientation[0];
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

/// Makes the box of a new body. A body may return after steps without it.
Status CsvSteps::meet(sim::BodyId id, const EngineState& state) {
  const auto known = met_.find(id);
  if (known != met_.end()) {
    if (known->second.last_step + 1 < steps_) notes_.came_back(table_.at(columns_.id, "").message, id, steps_);
    known->second.last_step = steps_;
    if (Status ok = check_description(id, known->second); !ok.ok()) return ok;
    return bodies_.check_later(table_, known->second.first);
  }
  const auto like = like_.find(id);
  sim::BoxDef box = like != like_.end() ? like->second : settings_.box;
  box.id = id;
  Result<CsvBodies::FirstRow> first = bodies_.read_first(table_, box);
  if (!first.ok()) return first.error();
  Met met = {steps_, *std::move(first), ""};
  if (columns_.shape != kNone) met.shape = table_.cell(columns_.shape);
  met_.emplace(id, std::move(met));
  box.position = state.position;
  box.orientation = state.orientation;
  box.velocity = state.velocity;
  box.spin = state.spin;
  box.frozen = state.frozen && !box.is_static;
  if (const Status ok = sim::check_box(box); !ok.ok()) return table_.at(columns_.id, ok.error().message);
  const sim::Vec3 size = box.size;
  boxes_.emplace(id, std::move(box));
  return describe(id, size);
}

/// Name and shape of a new body.
Status CsvSteps::describe(sim::BodyId id, const sim::Vec3& size) {
  BodyInfo& info = infos_.emplace(id, BodyInfo{id, "", {}}).first->second;
  const std::string_view name = columns_.name == kNone ? std::string_view() : table_.cell(columns_.name);
  const std::string place = columns_.name == kNone ? "" : table_.at(columns_.name, "").message;
  if (!name.empty() && !info.name.empty() && name != info.name) notes_.called_twice(place, id, info.name, name);
  if (!name.empty()) info.name = name;
  if (Status ok = check_body_info(info); !ok.ok()) return table_.at(columns_.name, ok.error().message);
  if (columns_.name != kNone && !info.name.empty()) notes_.named(place, id, info.name);
  if (columns_.shape == kNone) return {};
  Result<std::optional<Shape>> shape = parse_shape(table_.cell(columns_.shape), size, settings_.axes, table_.name());
  if (!shape.ok()) return table_.at(columns_.shape, shape.error().message);
  if (!*shape) return {};
  info.shape = hash_of(**shape);
  shapes_.emplace(id, **std::move(shape));
  return {};
}

/// A log has one name and one shape of a body. An empty cell says nothing.
Status CsvSteps::check_description(sim::BodyId id, const Met& met) {
  if (columns_.name != kNone && !ids_.contains(table_.cell(columns_.id))) {
    const std::string_view name = table_.cell(columns_.name);
    const std::string& kept = infos_.at(id).name;
    if (!name.empty() && name != kept) notes_.renamed(table_.at(columns_.name, "").message, id, kept, name);
  }
  if (columns_.shape == kNone) return {};
  const std::string_view shape = table_.cell(columns_.shape);
  if (shape.empty() || shape == met.shape) return {};
  return table_.at(columns_.shape, "shape: " + found_wanted(in_quotes(shape), in_quotes(met.shape)) + " as in line " +
                                       std::to_string(met.first.line) +
                                       ": a body keeps the value that it first appears with");
}

const Shape* CsvSteps::shape(sim::BodyId id) const {
  const auto shape = shapes_.find(id);
  return shape == shapes_.end() ? nullptr : &shape->second;
}

}  // namespace tumble::replay
