#include "tumble/replay/header_difference.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "replay/diff/parameters.h"
#include "replay/log/hashes_only.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kIdsNamed = 4;
constexpr std::size_t kGroupsMax = 200;  // of bodies or inputs that differ in one way

/// Whether two values of a scene make one world: a world has one zero (plus_zero), a scene may hold two.
bool makes_the_same(const FieldValue& a, const FieldValue& b) {
  const auto* in_a = std::get_if<double>(&a);
  const auto* in_b = std::get_if<double>(&b);
  return same_bits(a, b) || (in_a != nullptr && in_b != nullptr && *in_a == *in_b);
}

/// "gravity, dt"; "none" where there is no word.
std::string listed(const std::vector<std::string>& words) {
  const std::string text = joined(words, ", ");
  return text.empty() ? "none" : text;
}

std::string vector_text(const sim::Vec3& v) { return exact(v.x()) + ' ' + exact(v.y()) + ' ' + exact(v.z()); }

std::string ids_text(const std::vector<sim::BodyId>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), kIdsNamed); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  if (ids.size() > kIdsNamed) text += " and " + std::to_string(ids.size() - kIdsNamed) + " more";
  return text.empty() ? "none" : text;
}

class Differences {
 public:
  explicit Differences(const Tolerances& tolerances) : tolerances_(tolerances) {}

  void add(std::string key, FieldValue a, FieldValue b, bool acts) {
    if (!makes_the_same(a, b)) say(std::move(key), std::move(a), std::move(b), acts);
  }
  void say(std::string key, FieldValue a, FieldValue b, bool acts) {
    list_.push_back({std::move(key), std::move(a), std::move(b), acts, false});
  }
  void look(const char* key, const std::string& a, const std::string& b) { add(key, a, b, false); }

  /// field: the name that a tolerance has, where the key has another one.
  void add_field(const std::string& key, const std::string& field, const FieldValue& a, const FieldValue& b,
                 bool acts) {
    const std::size_t before = list_.size();
    add(key, a, b, acts);
    const auto* in_a = std::get_if<double>(&a);
    const auto* in_b = std::get_if<double>(&b);
    if (list_.size() == before || in_a == nullptr || in_b == nullptr) return;
    list_.back().excused = tolerances_.excuses(field, *in_a, *in_b);
  }

  std::vector<HeaderDifference> take() {
    std::stable_partition(list_.begin(), list_.end(), [](const HeaderDifference& d) { return !d.acts; });
    return std::move(list_);
  }

 private:
  const Tolerances& tolerances_;
  std::vector<HeaderDifference> list_;
};

/// Bodies that differ in one field by the same two values stand in one line: a material of the scene is that of all.
struct Group {
  std::string field;
  FieldValue a;
  FieldValue b;
  std::vector<sim::BodyId> ids;
};

void add_to(std::vector<Group>& groups, const std::string& field, const FieldValue& a, const FieldValue& b,
            sim::BodyId id) {
  const auto known = std::ranges::find_if(groups, [&](const Group& group) {
    return group.field == field && same_bits(group.a, a) && same_bits(group.b, b);
  });
  if (known != groups.end()) {
    known->ids.push_back(id);
  } else if (groups.size() < kGroupsMax) {
    groups.push_back({field, a, b, {id}});
  } else {
    const std::string unlisted = "not listed";
    if (groups.size() == kGroupsMax) groups.push_back({"further values", unlisted, unlisted, {}});
    std::vector<sim::BodyId>& ids = groups.back().ids;
    if (ids.empty() || ids.back() != id) ids.push_back(id);  // ids ascend
  }
}

void add_bodies(const sim::SceneDef& a, const sim::SceneDef& b, Differences& found) {
  std::vector<sim::BodyId> only_a, only_b;
  std::vector<Group> groups;
  for (std::size_t i = 0, j = 0; i < a.boxes.size() || j < b.boxes.size();) {
    const bool in_a = i < a.boxes.size() && (j == b.boxes.size() || a.boxes[i].id <= b.boxes[j].id);
    const bool in_b = j < b.boxes.size() && (i == a.boxes.size() || b.boxes[j].id <= a.boxes[i].id);
    if (in_a && in_b && !(a.boxes[i] == b.boxes[j])) {
      const NamedValues one = values_of(a.boxes[i]), other = values_of(b.boxes[j]);
      for (std::size_t k = 0; k < one.size(); ++k) {
        if (!makes_the_same(one[k].second, other[k].second)) {
          add_to(groups, one[k].first, one[k].second, other[k].second, a.boxes[i].id);
        }
      }
    }
    if (in_a != in_b) (in_a ? only_a : only_b).push_back(in_a ? a.boxes[i].id : b.boxes[j].id);
    if (in_a) ++i;
    if (in_b) ++j;
  }
  found.add("bodies at the start", std::uint64_t{a.boxes.size()}, std::uint64_t{b.boxes.size()}, true);
  if (!only_a.empty() || !only_b.empty())
    found.add("bodies on one side only", ids_text(only_a), ids_text(only_b), true);
  for (const Group& group : groups) {
    const std::string key = group.ids.size() == 1 ? "body " + std::to_string(group.ids[0]) + ' ' + group.field
                                                  : group.field + " of bodies " + ids_text(group.ids);
    found.say(key, group.a, group.b, true);
  }
}

std::string when(const sim::TimedCommand& input) {
  return std::string(sim::name_of(input.command)) + " before step " + std::to_string(input.step);
}

void add_inputs(const sim::SceneDef& a, const sim::SceneDef& b, Differences& found) {
  found.add("inputs", std::uint64_t{a.inputs.size()}, std::uint64_t{b.inputs.size()}, true);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < std::min(a.inputs.size(), b.inputs.size()) && shown < kGroupsMax; ++i) {
    const std::string key = "input " + std::to_string(i + 1);
    if (a.inputs[i] == b.inputs[i]) continue;
    ++shown;
    if (when(a.inputs[i]) != when(b.inputs[i])) {
      found.add(key, when(a.inputs[i]), when(b.inputs[i]), true);
      continue;
    }
    const NamedValues one = values_of(a.inputs[i].command), other = values_of(b.inputs[i].command);
    for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
      std::string field = sim::name_of(a.inputs[i].command);
      field.append(".").append(one[k].first);
      std::string name = key;
      name.append(" ").append(field);
      found.add_field(name, field, one[k].second, other[k].second, true);
    }
  }
}

void add_looks(const sim::SceneDef& a, const sim::SceneDef& b, Differences& found) {
  found.look("title", a.title, b.title);
  found.look("category", a.category, b.category);
  found.look("camera.position", vector_text(a.camera.position), vector_text(b.camera.position));
  found.look("camera.target", vector_text(a.camera.target), vector_text(b.camera.target));
  found.add("camera.fov", a.camera.fov, b.camera.fov, false);
  found.add("camera.focus", a.camera.focus, b.camera.focus, false);
  found.add("camera.blur", a.camera.blur, b.camera.blur, false);
  found.look("light.position", vector_text(a.light.position), vector_text(b.light.position));
  found.look("light.target", vector_text(a.light.target), vector_text(b.light.target));
}

/// Whether another engine's log tells of the parameter; the others have their defaults there.
bool is_of_any_engine(const std::string& name) {
  return name == "world.dt" || name == "world.ground" || name.starts_with("world.gravity.");
}

/// imported: one scene at least is that of another engine's log.
void add_scene(const sim::SceneDef& a, const sim::SceneDef& b, bool imported, Differences& found) {
  add_looks(a, b, found);
  const NamedValues one = parameters_of(a.world), other = parameters_of(b.world);
  for (std::size_t k = 0; k < one.size(); ++k) {
    const std::string& name = one[k].first;
    found.add_field(name, name, one[k].second, other[k].second, !imported || is_of_any_engine(name));
  }
  add_bodies(a, b, found);
  add_inputs(a, b, found);
}

std::string text_of(const FieldValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? exact(*number) : to_string(value);
}

std::string start_of(const LogHeader& header) {
  return header.goes_on ? "step " + std::to_string(header.goes_on->step) + " of another session" : "state 0";
}

std::vector<std::string> passed_over(const LogHeader& header) {
  return header.table ? header.table->passed_over : std::vector<std::string>();
}

std::string engine_of(const LogHeader& header) { return header.engine ? to_string(*header.engine) : "tumble"; }

std::uint64_t bits_of_engine(const LogHeader& header) {
  return header.engine ? header.engine->precision_bits : kBinary64Bits;
}

/// What `one` declares and `other` does not.
std::vector<std::string> lacking(const LogHeader& one, const LogHeader& other) {
  std::vector<std::string> parts;
  if (one_holds_hashes_only(one, other))
    return {holds_hashes_only(one) ? "hashes of each step" : "values of each step"};
  for (const std::size_t c : listed_order(one.declared.channels)) {
    const std::string& name = one.declared.channels[c].name;
    if (other.declared.find(name) == other.declared.channels.size()) parts.push_back("channel " + name);
  }
  const std::vector<BodyInfo>& bodies = other.declared.bodies;
  for (const BodyInfo& body : one.declared.bodies) {
    const auto its = std::ranges::lower_bound(bodies, body.id, {}, &BodyInfo::id);
    const bool same = its != bodies.end() && its->id == body.id && its->shape == body.shape;
    if (body.shape != Hash128() && !same) parts.push_back("this shape of body " + std::to_string(body.id));
  }
  if (!one.engine || !other.engine) return parts;  // phases of ours change with the version of their hashes
  for (const std::string& phase : one.phases) {
    if (std::ranges::find(other.phases, phase) == other.phases.end()) parts.push_back("phase hashes of " + phase);
  }
  if (!match_phases(one, other).in_order) parts.emplace_back("this order of phases");
  return parts;
}

void say(const std::vector<std::string>& parts, const std::string& beginning, std::string& text) {
  if (parts.empty()) return;
  constexpr std::size_t kShown = 6;
  text += (text.empty() ? "" : "; ") + beginning;
  for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) text += (i == 0 ? "" : ", ") + parts[i];
  if (parts.size() > kShown) text += " and " + std::to_string(parts.size() - kShown) + " more";
}

}  // namespace

std::string describe(const HeaderDifference& difference) {
  return difference.key + ": " + text_of(difference.a) + " → " + text_of(difference.b) +
         (difference.excused ? " (excused)" : "");
}

std::vector<HeaderDifference> scene_differences(const sim::SceneDef& a, const sim::SceneDef& b,
                                                const Tolerances& tolerances) {
  Differences found(tolerances);
  add_scene(a, b, false, found);
  return found.take();
}

// Steps decide whether two sessions are equal; two logs of one session may well have other headers (another tool,
// another --states). The list tells people and programs where to look for the cause of a difference.
std::vector<HeaderDifference> header_differences(const LogHeader& a, const LogHeader& b, const Tolerances& tolerances) {
  Differences found(tolerances);
  found.look("engine", engine_of(a), engine_of(b));
  found.add("precision", bits_of_engine(a), bits_of_engine(b), false);
  const bool one_engine = a.engine.has_value() == b.engine.has_value();  // other engines have no methods
  if (a.scene.world.method == b.scene.world.method) found.add("method", a.method, b.method, one_engine);
  found.add("method version", std::uint64_t{a.method_version}, std::uint64_t{b.method_version}, one_engine);
  found.look("scene", a.scene.name, b.scene.name);
  found.look("transform", to_string(a.transform), to_string(b.transform));
  found.look("set", listed(a.overrides), listed(b.overrides));
  found.look("begins with", start_of(a), start_of(b));
  if ((a.scene.steps == 0) == (b.scene.steps == 0)) found.add("planned steps", a.scene.steps, b.scene.steps, false);
  found.look("states", to_string(a.states), to_string(b.states));
  found.look("hashes", to_string(a.hashes), to_string(b.hashes));
  found.look("written by", a.tool_version + ", " + a.tool_build, b.tool_version + ", " + b.tool_build);
  found.look("axes", to_string(a.axes()), to_string(b.axes()));
  found.look("columns passed over", listed(passed_over(a)), listed(passed_over(b)));
  found.look("numbers", a.float_format, b.float_format);
  if (a.phases != b.phases) {
    found.look("phases", listed(a.phases), listed(b.phases));
  } else {
    found.add("phase hashes", std::uint64_t{a.phase_hash_version}, std::uint64_t{b.phase_hash_version}, false);
  }
  const bool one_start = (a.goes_on ? a.goes_on->step : 0) == (b.goes_on ? b.goes_on->step : 0);
  if (one_start && !one_holds_hashes_only(a, b))
    add_scene(a.scene, b.scene, a.engine || b.engine, found);  // else the two scenes are those of different steps
  return found.take();
}

const HeaderDifference* first_cause(const std::vector<HeaderDifference>& differences) {
  const auto first = std::ranges::find_if(differences, [](const HeaderDifference& d) { return d.acts && !d.excused; });
  return first == differences.end() ? nullptr : &*first;
}

bool OnlyInOne::adds_input() const {
  return std::ranges::any_of(b, [](const std::string& part) { return part.starts_with("channel input."); });
}

OnlyInOne only_in_one(const LogHeader& a, const LogHeader& b) { return {lacking(a, b), lacking(b, a)}; }

std::string OnlyInOne::text(const std::string& name_a, const std::string& name_b) const {
  std::vector<std::string> in_a, in_both, in_b = b;  // what both have are shapes, others in each
  for (const std::string& part : a) (std::ranges::count(b, part) > 0 ? in_both : in_a).push_back(part);
  std::erase_if(in_b, [&](const std::string& part) { return std::ranges::count(a, part) > 0; });
  for (std::string& part : in_both) part.replace(0, std::string_view("this").size(), "the");
  std::string words;
  say(in_both, "the two differ in ", words);
  say(in_a, "only " + name_a + " has ", words);
  say(in_b, "only " + name_b + " has ", words);
  return words;
}

}  // namespace tumble::replay
