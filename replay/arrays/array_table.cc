#include "replay/arrays/array_table.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "replay/arrays/array_joints.h"
#include "replay/arrays/array_pairs.h"
#include "replay/arrays/array_rows.h"
#include "replay/arrays/known_arrays.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

class ArrayTable {
 public:
  ArrayTable(const std::vector<Array>& arrays, const std::string& name, const ArrayOptions& options)
      : arrays_(arrays), name_(name), options_(options) {}

  Result<std::string> text() {
    if (Status ok = find_sizes(); !ok.ok()) return ok.error();
    if (steps_ == 0 || bodies_ == 0) {  // a shape of 0 says nothing of how large the others may be
      return wrong(found_wanted(count_text(steps_, "step") + " of " + count_text(bodies_, "body"), "one of each"));
    }
    if (Status ok = add_clock(); !ok.ok()) return ok.error();
    if (Status ok = find_present(); !ok.ok()) return ok.error();
    if (options_.warn) {
      for (const std::string& part : odd_parts(arrays_, present_)) options_.warn(name_ + ": " + part);
    }
    add_ids();
    for (const KnownArray& known : kMoving) {
      if (Status ok = add_moving(known); !ok.ok()) return ok.error();
    }
    for (const KnownArray& known : kSteady) {
      if (Status ok = add_steady(known); !ok.ok()) return ok.error();
    }
    if (Status ok = add_joints(); !ok.ok()) return ok.error();
    for (const Array& array : arrays_) {
      if (Status ok = add_rest(array); !ok.ok()) return ok.error();
    }
    header_ += kinds_line(columns_, kinds_);
    return print_rows(header_, columns_, steps_, bodies_, present_);
  }

 private:
  [[nodiscard]] Error wrong(const std::string& message) const { return bad_input(name_ + ": " + message); }
  [[nodiscard]] Error wrong_shape(const Array& array, const std::string& wanted) const {
    return wrong("array " + array.name + ": found the shape " + shape_text(array.shape) + ", wanted " + wanted);
  }

  const Array* find(const ArrayNames& names) const {
    for (const std::string_view name : names) {
      if (name.empty()) break;
      if (const Array* found = find_array(arrays_, name); found != nullptr) return found;
    }
    return nullptr;
  }

  void use(const Array& array) { used_.push_back(&array); }

  /// Steps and bodies, from the positions, or from qpos and the model.
  Status find_sizes() {
    const Array* position = find(kPositions);
    if (position != nullptr) {
      const std::vector<std::size_t>& shape = position->shape;
      if (shape.size() < 2 || shape.size() > 3 || shape.back() != 3 || !position->is_number()) {
        return wrong_shape(*position, "(steps, bodies, 3), or (steps, 3) of one body");
      }
      steps_ = shape[0];
      bodies_ = shape.size() == 3 ? shape[1] : 1;
      return {};
    }
    const Array* qpos = find({"qpos"});
    free_ = free_joints(options_.joints);
    if (qpos == nullptr || free_.empty() || qpos->shape.size() != 2) {
      return wrong(
          "found no positions of bodies: wanted an array position or xpos of shape (steps, bodies, 3), or qpos "
          "of shape (steps, positions) and --model FILE.xml with free joints");
    }
    steps_ = qpos->shape[0];
    bodies_ = free_.size();
    return {};
  }

  Status add_clock() {
    const Array* step = find(kStepNames);
    const Array* time = find(kTimeNames);
    const Array* dt = find({"dt"});
    if (dt != nullptr && dt->shape.empty()) dt = nullptr;  // a line of the header
    for (const Array* array : {step, time, dt}) {
      if (array == nullptr) continue;
      if (array->shape != std::vector<std::size_t>{steps_}) {
        return wrong_shape(*array, "(" + std::to_string(steps_) + "), one number a step");
      }
      use(*array);
      const char* name = array == step ? "step" : (array == time ? "time" : "dt");
      columns_.push_back({name, [array](std::size_t k, std::size_t) { return array->cell({k}); }});
    }
    if (step == nullptr && time == nullptr) {
      columns_.push_back({"step", [](std::size_t k, std::size_t) { return std::to_string(k); }});
    }
    return {};
  }

  /// Ids; else names, also of the bodies of free joints; else 1, 2, ….
  void add_ids() {
    const Array* id = find(kIdNames);
    const Array* names = find(kNameNames);
    const std::vector<std::size_t> of_bodies = {bodies_};
    const bool has_id = id != nullptr && id->shape == of_bodies;
    const bool has_names = names != nullptr && names->shape == of_bodies;
    const auto cell_of = [](const Array* array) {
      return [array](std::size_t, std::size_t body) { return array->cell({body}); };
    };
    if (has_id) use(*id);
    if (has_names) use(*names);
    if (has_id) {
      columns_.push_back({"id", cell_of(id)});
      if (has_names) columns_.push_back({"name", cell_of(names)});
    } else if (has_names) {
      columns_.push_back({"id", cell_of(names)});
    } else if (!free_.empty()) {
      columns_.push_back({"id", [this](std::size_t, std::size_t body) {
                            const MujocoJoint& joint = options_.joints[free_[body].first];
                            return joint.body.empty() ? joint.name : joint.body;
                          }});
    } else {
      columns_.push_back({"id", [](std::size_t, std::size_t body) { return std::to_string(body + 1); }});
    }
  }

  Status add_moving(const KnownArray& known) {
    const Array* array = find(known.names);
    if (array == nullptr) return {};
    std::vector<std::size_t> wanted = {steps_, bodies_}, of_one = {steps_};
    for (std::vector<std::size_t>* shape : {&wanted, &of_one}) {
      if (!known.letters.empty()) shape->push_back(known.letters.size());
    }
    const bool one = bodies_ == 1 && array->shape == of_one;
    if (array->shape != wanted && !one) return wrong_shape(*array, shape_text(wanted));
    use(*array);
    const auto index = [one](std::size_t k, std::size_t body) {
      return one ? std::vector<std::size_t>{k} : std::vector<std::size_t>{k, body};
    };
    if (known.letters.empty()) {
      columns_.push_back({std::string(known.field),
                          [array, index](std::size_t k, std::size_t body) { return array->cell(index(k, body)); }});
      return {};
    }
    const bool turned = options_.scalar_last && known.letters.size() == 4;
    for (std::size_t c = 0; c < known.letters.size(); ++c) {
      const std::size_t from = turned ? (c + 3) % 4 : c;
      columns_.push_back(
          {std::string(known.field) + '.' + known.letters[c], [array, index, from](std::size_t k, std::size_t body) {
             std::vector<std::size_t> at = index(k, body);
             at.push_back(from);
             return array->cell(at);
           }});
    }
    return {};
  }

  Status add_steady(const KnownArray& known) {
    const Array* array = find(known.names);
    if (array == nullptr) return {};
    std::vector<std::size_t> wanted = {bodies_};
    if (!known.letters.empty()) wanted.push_back(known.letters.size());
    if (array->shape != wanted) return {};  // a value of another meaning, which add_rest() takes
    use(*array);
    for (std::size_t c = 0; c < std::max<std::size_t>(known.letters.size(), 1); ++c) {
      const bool vector = !known.letters.empty();
      const std::string name = std::string(known.field) + (vector ? std::string(".") + known.letters[c] : "");
      columns_.push_back({name, [array, vector, c](std::size_t, std::size_t body) {
                            return vector ? array->cell({body, c}) : array->cell({body});
                          }});
    }
    return {};
  }

  Status add_joints() {
    if (options_.joints.empty()) return {};
    for (const char* name : {"qpos", "qvel"}) {
      if (const Array* array = find({name}); array != nullptr) use(*array);
    }
    Result<std::vector<TableColumn>> columns =
        joint_columns(options_.joints, {find({"qpos"}), find({"qvel"})}, steps_, find(kPositions) == nullptr);
    if (!columns.ok()) return wrong(columns.error().message);
    columns_.insert(columns_.end(), columns->begin(), columns->end());
    const std::string unnamed = unnamed_joints(options_.joints);
    if (options_.warn && !unnamed.empty()) options_.warn(name_ + ": " + unnamed);
    return {};
  }

  /// Every other array is a channel: of the step, or of bodies. A scalar or a vector like gravity is a line of the
  /// header.
  Status add_rest(const Array& array) {
    if (std::ranges::find(used_, &array) != used_.end()) return {};
    const std::vector<std::size_t>& shape = array.shape;
    if (array.name.starts_with('_')) {
      columns_.push_back({array.name, [](std::size_t, std::size_t) { return std::string(); }});
      return {};
    }
    if (std::string line = header_line(array); !line.empty()) {
      header_ += line;
      return {};
    }
    if (array.name.starts_with("pair.")) return add_pairs(array);
    if (shape.empty() || shape[0] != steps_ || shape.size() > 3) {
      return wrong_shape(array, std::to_string(steps_) +
                                    " steps first; an array that is to be passed over has a name that begins with _");
    }
    const bool of_bodies = !array.name.starts_with("world.") && shape.size() >= 2 && shape[1] == bodies_ &&
                           (shape.size() == 3 || bodies_ > 1 || array.name.starts_with("channel."));
    const std::size_t fixed = of_bodies ? 2 : 1;
    if (shape.size() > fixed + 1) {
      return wrong_shape(array, "(" + std::to_string(steps_) + ", " + std::to_string(bodies_) + ", …)");
    }
    ChannelPart channel = {
        &array, find_exact("present." + array.name), find_exact("texts." + array.name), of_bodies, shape.size() > fixed,
        0};
    if (channel.present != nullptr && (channel.many || channel.present->shape != shape)) {
      return wrong_shape(*channel.present, "that of " + array.name + ", " + shape_text(shape));
    }
    if (channel.texts != nullptr && (channel.texts->shape.size() != 1 || !array.is_number())) {
      return wrong_shape(*channel.texts, "(texts), and numbers of its rows in " + array.name);
    }
    const std::string prefix = of_bodies ? "channel." : "world.";
    const std::string name = array.name.starts_with(prefix) ? array.name : prefix + array.name;
    for (std::size_t c = 0; c < (channel.many ? shape[fixed] : 1); ++c) {
      channel.part = c;
      columns_.push_back({name + (channel.many ? '.' + std::to_string(c) : std::string()) + unit_behind(arrays_, array),
                          [channel](std::size_t k, std::size_t body) { return channel.cell(k, body); }});
      if (array.name.starts_with(prefix)) kinds_.emplace_back(channel.kind());
    }
    return {};
  }

  /// Values of pairs, a row each, beside arrays of their steps and bodies.
  Status add_pairs(const Array& array) {
    const Array* steps = find(kStepNames);
    const Array* ids = find(kIdNames);
    const PairArrays pairs = {&array, find_exact("step." + array.name), find_exact("a." + array.name),
                              find_exact("b." + array.name), find_exact("texts." + array.name)};
    Result<PairCells> cells =
        pair_cells(pairs, {steps, ids, present_, steps_, bodies_, find(kNameNames) != nullptr || !free_.empty()});
    if (!cells.ok()) return wrong(cells.error().message);
    columns_.push_back(
        {array.name + unit_behind(arrays_, array), [all = *std::move(cells)](std::size_t k, std::size_t body) {
           const auto cell = all[k].find(body);
           return cell == all[k].end() ? std::string() : cell->second;
         }});
    kinds_.emplace_back(ChannelPart{&array, nullptr, pairs.texts}.kind());
    return {};
  }

  const Array* find_exact(const std::string& name) const { return find_array(arrays_, name); }

  /// The bodies that a step has, and what belongs to other arrays.
  Status find_present() {
    for (const Array& array : arrays_) {
      for (const std::string_view prefix : {"present.", "texts.", "unit.", "step.", "a.", "b."}) {
        if (!array.name.starts_with(prefix) || find_exact(array.name.substr(prefix.size())) == nullptr) continue;
        if (prefix == "unit." && !is_unit(array)) return wrong("array " + array.name + ": wanted one text on one line");
        use(array);
      }
    }
    const Array* present = find_exact("present");
    if (present == nullptr) return {};
    if (present->shape != std::vector<std::size_t>{steps_, bodies_}) {
      return wrong_shape(*present, shape_text({steps_, bodies_}));
    }
    use(*present);
    present_ = present;
    return {};
  }

  const std::vector<Array>& arrays_;
  const std::string& name_;
  const ArrayOptions& options_;
  std::size_t steps_ = 0, bodies_ = 0;
  std::vector<std::pair<std::size_t, std::size_t>> free_;  // free joints: number, and place in qpos
  std::vector<const Array*> used_;                         // arrays that were read
  std::vector<TableColumn> columns_;
  std::string header_;
  std::vector<std::string> kinds_;  // of channels
  const Array* present_ = nullptr;
};

}  // namespace

Result<std::string> table_of_arrays(const std::vector<Array>& arrays, const std::string& name,
                                    const ArrayOptions& options) {
  return ArrayTable(arrays, name, options).text();
}

}  // namespace tumble::replay
