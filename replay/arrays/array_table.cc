#include "replay/arrays/array_table.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "replay/arrays/known_arrays.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// A column of the table: its name, and the cell of a step and a body.
struct TableColumn {
  std::string name;
  std::function<std::string(std::size_t step, std::size_t body)> cell;
};

class ArrayTable {
 public:
  ArrayTable(const std::vector<Array>& arrays, const std::string& name, const ArrayOptions& options)
      : arrays_(arrays), name_(name), options_(options) {}

  Result<std::string> text() {
    if (Status ok = find_sizes(); !ok.ok()) return ok.error();
    if (Status ok = add_clock(); !ok.ok()) return ok.error();
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
    return printed();
  }

 private:
  [[nodiscard]] Error wrong(const std::string& message) const { return bad_input(name_ + ": " + message); }

  static std::string shape_text(const std::vector<std::size_t>& shape) {
    std::string text = "(";
    for (const std::size_t n : shape) text += (text.size() == 1 ? "" : ", ") + std::to_string(n);
    return text + ")";
  }

  const Array* find(const ArrayNames& names) const {
    for (const std::string_view name : names) {
      if (name.empty()) break;
      const auto found = std::ranges::find(arrays_, name, &Array::name);
      if (found != arrays_.end()) return &*found;
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
        return wrong("array " + position->name + ": found the shape " + shape_text(position->shape) +
                     ", wanted (steps, bodies, 3), or (steps, 3) of one body");
      }
      steps_ = shape[0];
      bodies_ = shape.size() == 3 ? shape[1] : 1;
      return {};
    }
    const Array* qpos = find({"qpos"});
    for (std::size_t j = 0, at = 0; j < options_.joints.size(); at += options_.joints[j++].positions()) {
      if (options_.joints[j].kind == MujocoJoint::Kind::kFree) free_.emplace_back(j, at);
    }
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
    const Array* step = find({"step", "steps"});
    const Array* time = find({"time", "times", "t"});
    for (const Array* array : {step, time}) {
      if (array == nullptr) continue;
      if (array->shape != std::vector<std::size_t>{steps_}) {
        return wrong("array " + array->name + ": found the shape " + shape_text(array->shape) + ", wanted (" +
                     std::to_string(steps_) + "), one number a step");
      }
      use(*array);
      columns_.push_back(
          {array == step ? "step" : "time", [array](std::size_t k, std::size_t) { return array->cell({k}); }});
    }
    if (step == nullptr && time == nullptr) {
      columns_.push_back({"step", [](std::size_t k, std::size_t) { return std::to_string(k); }});
    }
    return {};
  }

  /// Ids; else names, also of the bodies of free joints; else 1, 2, ….
  void add_ids() {
    const Array* id = find({"id", "ids"});
    const Array* names = find({"name", "names", "body_names"});
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
    std::vector<std::size_t> wanted = {steps_, bodies_};
    if (!known.letters.empty()) wanted.push_back(known.letters.size());
    std::vector<std::size_t> of_one = {steps_};
    if (!known.letters.empty()) of_one.push_back(known.letters.size());
    const bool one = bodies_ == 1 && array->shape == of_one;
    if (array->shape != wanted && !one) {
      return wrong("array " + array->name + ": found the shape " + shape_text(array->shape) + ", wanted " +
                   shape_text(wanted));
    }
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

  /// qpos and qvel, number by number, with the names of the model's joints.
  Status add_joints() {
    if (options_.joints.empty()) return {};
    const std::initializer_list<std::pair<std::string_view, std::size_t (MujocoJoint::*)() const>> both = {
        {"qpos", &MujocoJoint::positions}, {"qvel", &MujocoJoint::velocities}};
    for (const auto& [field, count] : both) {
      const Array* array = find({field});
      if (array == nullptr) continue;
      std::size_t numbers = 0;
      for (const MujocoJoint& joint : options_.joints) numbers += (joint.*count)();
      if (array->shape != std::vector<std::size_t>{steps_, numbers}) {
        return wrong("array " + array->name + ": found the shape " + shape_text(array->shape) + ", wanted (" +
                     std::to_string(steps_) + ", " + std::to_string(numbers) +
                     "), as the joints of --model give; is it the model of this session?");
      }
      use(*array);
      std::size_t at = 0;
      for (const MujocoJoint& joint : options_.joints) {
        const std::size_t n = (joint.*count)();
        for (std::size_t c = 0; c < n; ++c, ++at) {
          const std::string name =
              std::string("world.") + std::string(field) + '.' + joint.name + (n > 1 ? '.' + std::to_string(c) : "");
          columns_.push_back({name, [array, at](std::size_t k, std::size_t) { return array->cell({k, at}); }});
        }
      }
    }
    if (find(kPositions) != nullptr) return {};
    const Array* qpos = find({"qpos"});
    const std::string_view parts[] = {"position.x",    "position.y",    "position.z",   "orientation.w",
                                      "orientation.x", "orientation.y", "orientation.z"};
    for (std::size_t c = 0; c < 7; ++c) {
      columns_.push_back({std::string(parts[c]), [this, qpos, c](std::size_t k, std::size_t body) {
                            return qpos->cell({k, free_[body].second + c});
                          }});
    }
    return {};
  }

  /// Every other array is a channel: of the step, or of bodies. A scalar is a line of the header, or a remark.
  Status add_rest(const Array& array) {
    if (std::ranges::find(used_, &array) != used_.end()) return {};
    const std::vector<std::size_t>& shape = array.shape;
    const bool passed = array.name.starts_with('_');
    if (shape.empty() && !passed) {
      header_ += "# " + array.name + ": " + array.cell({}) + "\n";
      return {};
    }
    if (passed) {
      columns_.push_back({array.name, [](std::size_t, std::size_t) { return std::string(); }});
      return {};
    }
    if (shape.empty() || shape[0] != steps_ || shape.size() > 3) {
      return wrong("array " + array.name + ": found the shape " + shape_text(array.shape) + ", wanted " +
                   std::to_string(steps_) +
                   " steps first; an array that is to be passed over has a name that begins with _");
    }
    const bool of_bodies = shape.size() >= 2 && shape[1] == bodies_ && (shape.size() == 3 || bodies_ > 1);
    const std::size_t fixed = of_bodies ? 2 : 1;
    if (shape.size() > fixed + 1) {
      return wrong("array " + array.name + ": found the shape " + shape_text(array.shape) + ", wanted (" +
                   std::to_string(steps_) + ", " + std::to_string(bodies_) + ", …)");
    }
    const bool many = shape.size() > fixed;
    for (std::size_t c = 0; c < (many ? shape[fixed] : 1); ++c) {
      const std::string name =
          (of_bodies ? "channel." : "world.") + array.name + (many ? '.' + std::to_string(c) : std::string());
      columns_.push_back({name, [&array, of_bodies, many, c](std::size_t k, std::size_t body) {
                            std::vector<std::size_t> at = {k};
                            if (of_bodies) at.push_back(body);
                            if (many) at.push_back(c);
                            return array.cell(at);
                          }});
    }
    return {};
  }

  [[nodiscard]] std::string printed() const {
    std::string text = header_;
    for (std::size_t i = 0; i < columns_.size(); ++i) text += (i == 0 ? "" : ",") + columns_[i].name;
    text += '\n';
    for (std::size_t k = 0; k < steps_; ++k) {
      for (std::size_t body = 0; body < bodies_; ++body) {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
          if (i > 0) text += ',';
          std::string cell = columns_[i].cell(k, body);
          std::ranges::replace(cell, ',', ';');  // cells have no quotes
          std::ranges::replace(cell, '\n', ' ');
          text += cell;
        }
        text += '\n';
      }
    }
    return text;
  }

  const std::vector<Array>& arrays_;
  const std::string& name_;
  const ArrayOptions& options_;
  std::size_t steps_ = 0, bodies_ = 0;
  std::vector<std::pair<std::size_t, std::size_t>> free_;  // free joints: number, and place in qpos
  std::vector<const Array*> used_;                         // arrays that were read
  std::vector<TableColumn> columns_;
  std::string header_;
};

}  // namespace

Result<std::string> table_of_arrays(const std::vector<Array>& arrays, const std::string& name,
                                    const ArrayOptions& options) {
  return ArrayTable(arrays, name, options).text();
}

}  // namespace tumble::replay
