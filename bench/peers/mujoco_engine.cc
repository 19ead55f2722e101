// MuJoCo with its defaults (Newton, Euler, pyramidal cones). A model is fixed once it is compiled, so bodies come
// before the first step; contacts are soft, so restitution is not asked for.
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "bench/peers/engine.h"
#include "src/base/text.h"
#include "tumble/sim/rotation.h"

namespace tumble::peers {
namespace {

constexpr std::size_t kBodiesMax = 1000;  // its constraint matrix grows with the square
constexpr std::size_t kContactsEach = 12;

// MuJoCo warns of events that spoil a result, such as contacts left out for lack of memory, and would write to a file.
std::string last_warning;
void keep_warning(const char* text) { last_warning = text; }

std::string text_of(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "" : " ") + exact(value);
  }
  return '"' + text + '"';
}

std::string friction_of(const sim::Material& material) {
  return " friction=" + text_of({material.friction, 0.005, 0.0001});
}

class MujocoEngine : public Engine {
 public:
  explicit MujocoEngine(const sim::SceneDef& scene) : scene_(scene) {}
  ~MujocoEngine() override {
    if (data_ != nullptr) mj_deleteData(data_);
    if (model_ != nullptr) mj_deleteModel(model_);
  }
  MujocoEngine(const MujocoEngine&) = delete;
  MujocoEngine& operator=(const MujocoEngine&) = delete;

  Status add(const sim::BoxDef& box) override {
    if (model_ != nullptr)
      return bad_input("found a new body after the first step, wanted all before: a model is fixed");
    if (boxes_.size() == kBodiesMax) {
      return cannot_finish("found more than " + std::to_string(kBodiesMax) + " bodies, which it has no memory for");
    }
    if (box.is_static) return bad_input("found a static box, which this adapter leaves out");
    boxes_.push_back(box);
    return {};
  }

  Status ready() override {
    mju_user_warning = keep_warning;
    const std::string xml = model_text();
    std::vector<mjVFS> files(1);  // large, so not on the stack
    mj_defaultVFS(files.data());
    mj_makeEmptyFileVFS(files.data(), "scene.xml", static_cast<int>(xml.size()));
    std::memcpy(files[0].filedata[0], xml.data(), xml.size());
    std::array<char, 500> problem{};
    model_ = mj_loadXML("scene.xml", files.data(), problem.data(), static_cast<int>(problem.size()));
    mj_deleteVFS(files.data());
    if (model_ == nullptr) return cannot_finish(problem.data());
    data_ = mj_makeData(model_);
    if (data_ == nullptr)
      return cannot_finish("no memory for the data of " + std::to_string(boxes_.size()) + " bodies");
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const sim::Vec3& v = boxes_[i].velocity;
      const sim::Vec3 w = to_body(sim::axes_of(boxes_[i].orientation), boxes_[i].spin);
      mjtNum* out = data_->qvel + 6 * i;
      for (int k = 0; k < 3; ++k) {
        out[k] = v[k];
        out[3 + k] = w[k];
      }
    }
    return {};
  }

  Status set_gravity(const sim::Vec3& gravity) override {
    if (model_ == nullptr) return bad_input("found set_gravity before step 1, wanted it later");
    for (int k = 0; k < 3; ++k) model_->opt.gravity[k] = gravity[k];
    return {};
  }

  Status step(double dt_s) override {
    model_->opt.timestep = dt_s;
    mj_step(model_, data_);
    return last_warning.empty() ? Status() : cannot_finish("it warns: " + last_warning);
  }

  [[nodiscard]] BodyState read(std::size_t row) const override {
    const mjtNum* q = data_->qpos + 7 * row;
    const mjtNum* v = data_->qvel + 6 * row;
    const sim::Quat turn = {q[3], q[4], q[5], q[6]};
    return {{q[0], q[1], q[2]}, turn, {v[0], v[1], v[2]}, sim::to_world(sim::axes_of(turn), {v[3], v[4], v[5]}), false};
  }

 private:
  [[nodiscard]] std::string model_text() const {
    const sim::Vec3& g = scene_.world.gravity;
    const std::size_t contacts = 100 + kContactsEach * boxes_.size();
    std::string xml = "<mujoco><option timestep=" + text_of({scene_.world.dt}) +
                      " gravity=" + text_of({g.x(), g.y(), g.z()}) + "/><size nconmax=\"" + std::to_string(contacts) +
                      "\" njmax=\"" + std::to_string(4 * contacts) + "\"/><worldbody>";
    if (scene_.world.ground) {
      xml += "<geom type=\"plane\" size=\"0 0 1\"" + friction_of(scene_.world.ground_material) + "/>";
    }
    for (const sim::BoxDef& box : boxes_) {
      const sim::Quat& q = box.orientation;
      xml += "<body pos=" + text_of({box.position.x(), box.position.y(), box.position.z()}) +
             " quat=" + text_of({q.w, q.x, q.y, q.z}) +
             "><freejoint/><geom type=\"box\" size=" + text_of({box.size.x() / 2, box.size.y() / 2, box.size.z() / 2}) +
             " mass=" + text_of({box.mass}) + friction_of(box.material) + "/></body>";
    }
    return xml + "</worldbody></mujoco>";
  }

  sim::SceneDef scene_;
  std::vector<sim::BoxDef> boxes_;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

}  // namespace

replay::EngineName engine_name() { return {"MuJoCo", mj_versionString(), replay::kBinary64Bits}; }

std::unique_ptr<Engine> make_engine(const sim::SceneDef& scene) { return std::make_unique<MujocoEngine>(scene); }

}  // namespace tumble::peers
