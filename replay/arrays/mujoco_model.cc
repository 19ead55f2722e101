#include "replay/arrays/mujoco_model.h"

#include <algorithm>
#include <map>
#include <pugixml.hpp>

namespace tumble::replay {
namespace {

/// Deeper than any chain of bodies, and no more than the stack holds, for bodies are read within one another.
constexpr int kDepthMax = 1000;

/// Finds the first element that lies deeper.
struct DepthCheck : pugi::xml_tree_walker {
  pugi::xml_node deep;
  bool for_each(pugi::xml_node& node) override {
    if (depth() >= kDepthMax) deep = node;
    return !deep;
  }
};

/// "robot.xml:12: ".
std::string place_of(std::string_view xml, std::ptrdiff_t offset, const std::string& name) {
  const std::string_view before = xml.substr(0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  return name + ':' + std::to_string(std::ranges::count(before, '\n') + 1) + ": ";
}

/// Reads the bodies of a model in document order, and the types that its default classes give to joints.
class Model {
 public:
  explicit Model(const pugi::xml_node& root) {
    for (const pugi::xml_node& node : root.children("default")) read_defaults(node, "hinge");
  }

  void read_bodies(const pugi::xml_node& body, const std::string& outer_class) {
    const std::string own = body.attribute("childclass").as_string();
    const std::string& inherited = own.empty() ? outer_class : own;
    for (const pugi::xml_node& node : body.children()) {
      const std::string tag = node.name();
      if (tag == "joint" || tag == "freejoint") add_joint(node, tag, body, inherited);
    }
    for (const pugi::xml_node& inner : body.children()) {
      const std::string tag = inner.name();
      if (tag == "body" || tag == "frame") read_bodies(inner, inherited);
    }
  }

  [[nodiscard]] std::vector<MujocoJoint> joints() const { return joints_; }

 private:
  void read_defaults(const pugi::xml_node& node, std::string type) {
    type = node.child("joint").attribute("type").as_string(type.c_str());
    const std::string name = node.attribute("class").as_string();
    types_[name.empty() ? "main" : name] = type;
    for (const pugi::xml_node& inner : node.children("default")) read_defaults(inner, type);
  }

  void add_joint(const pugi::xml_node& node, const std::string& tag, const pugi::xml_node& body,
                 const std::string& inherited) {
    std::string group = node.attribute("class").as_string(inherited.c_str());
    if (group.empty()) group = "main";
    const auto known = types_.find(group);
    const std::string usual = known == types_.end() ? "hinge" : known->second;
    const std::string type = tag == "freejoint" ? "free" : node.attribute("type").as_string(usual.c_str());
    MujocoJoint joint;
    joint.name = node.attribute("name").as_string();
    joint.unnamed = joint.name.empty();
    if (joint.unnamed) joint.name = "joint " + std::to_string(joints_.size());
    joint.body = body.attribute("name").as_string();
    if (type == "free") joint.kind = MujocoJoint::Kind::kFree;
    if (type == "ball") joint.kind = MujocoJoint::Kind::kBall;
    if (type == "slide") joint.kind = MujocoJoint::Kind::kSlide;
    joints_.push_back(std::move(joint));
  }

  std::map<std::string, std::string> types_;  // of joints, by default class
  std::vector<MujocoJoint> joints_;
};

}  // namespace

Result<std::vector<MujocoJoint>> read_mujoco_joints(std::string_view xml, const std::string& name) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed) {
    return bad_input(place_of(xml, parsed.offset, name) +
                     "found no model in MJCF, MuJoCo's XML: " + parsed.description());
  }
  DepthCheck check;
  document.traverse(check);
  if (check.deep) {
    return bad_input(place_of(xml, check.deep.offset_debug(), name) + "found elements nested deeper than " +
                     std::to_string(kDepthMax) + ", wanted a model of fewer bodies within one another");
  }
  const pugi::xml_node root = document.child("mujoco");
  const pugi::xml_node world = root.child("worldbody");
  if (!world) return bad_input(name + ": found no <mujoco> with a <worldbody>, wanted a model in MJCF, MuJoCo's XML");
  if (root.child("include")) {
    return bad_input(name + ": found <include>, wanted one file; mj_saveLastXML() writes the whole model");
  }
  Model model(root);
  model.read_bodies(world, "");
  return model.joints();
}

}  // namespace tumble::replay
