#include "replay/export/scene/gltf_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "replay/export/plan/little_bytes.h"
#include "replay/export/scene/gltf_buffer.h"
#include "replay/export/scene/gltf_scene.h"
#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::uint64_t kFileMax = std::numeric_limits<std::uint32_t>::max();  // lengths have four bytes
constexpr std::size_t kBlockBytes = std::size_t{48} << 20U;                    // of states, before they are written
constexpr std::size_t kStateFloats = 7;

/// The floats of some steps of one accessor each body: body after body, so that each body's part is one write.
class Block {
 public:
  void begin(const GltfRoom& room, std::size_t bodies, std::size_t steps) {
    room_ = room;
    steps_ = std::max<std::size_t>(steps, 1);
    floats_.resize(bodies * steps_ * room.width);
  }
  void set(std::size_t body, std::size_t item, std::size_t component, double value) {
    floats_[(body * steps_ + item) * room_.width + component] = static_cast<float>(value);
  }
  [[nodiscard]] std::size_t steps() const { return steps_; }

  /// Writes the first `count` steps of the block as steps `first`, … of the session.
  Status write(files::OutputFile& file, std::uint64_t buffer_at, std::size_t first, std::size_t count) const {
    std::string bytes;
    for (std::size_t body = 0; body * steps_ * room_.width < floats_.size(); ++body) {
      const float* from = floats_.data() + body * steps_ * room_.width;
      const std::size_t size = count * room_.width;
      bytes.resize(4 * size);
      if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(bytes.data(), from, bytes.size());
      } else {
        bytes.clear();
        for (std::size_t i = 0; i < size; ++i) append_little(std::bit_cast<std::uint32_t>(from[i]), 4, bytes);
      }
      if (Status ok = file.write_at(buffer_at + room_.place(body, first), bytes); !ok.ok()) return ok;
    }
    return {};
  }

 private:
  GltfRoom room_;
  std::size_t steps_ = 1;
  std::vector<float> floats_;
};

bool is_of_pose(std::string_view field) { return field.starts_with("position") || field.starts_with("orientation"); }

class GltfWriter : public ExportWriter {
 public:
  explicit GltfWriter(files::OutputFile& file) : file_(file) {}

  Status begin(const ExportPlan& plan) override {
    plan_ = &plan;
    left_out_ = {"channels, velocities, inputs, phase hashes, counters, contacts, notes and snapshots",
                 "title, category and text of the scene, and the method and its parameters",
                 "digits: numbers are floats"};
    GltfJson json;
    json["asset"] = {{"version", "2.0"}, {"generator", "Tumble"}};
    if (Status ok = add_gltf_scene(plan, buffer_, json); !ok.ok()) return ok;
    if (!plan.bodies.empty()) {
      if (Status ok = add_animation(json); !ok.ok()) return ok;
    }
    buffer_.describe(json);
    std::string text = json.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    return write_head(text);
  }

  Status add(const ExportStep& step) override {
    const BodyStates& states = step.record.states;
    for (std::size_t i = 0; i < step.rows.size(); ++i) {
      const std::uint32_t row = step.rows[i];
      if (row == ExportStep::kAbsent) {
        set_state(i, {0, 0, 0}, {});
        continue;
      }
      if (Status ok = check(states, row, i, step.record.step); !ok.ok()) return ok;
      set_state(
          i, states.position[row],
          {states.orientation.w[row], states.orientation.x[row], states.orientation.y[row], states.orientation.z[row]});
    }
    return ++filled_ < translations_.steps() ? Status() : flush();
  }

  Status finish() override { return flush(); }

 private:
  /// Errors: a number that is no float, an orientation that no rotation comes of.
  [[nodiscard]] Status check(const BodyStates& states, std::size_t row, std::size_t body, std::uint64_t step) const {
    // Poses come first, and velocities have no place in the file.
    if (std::optional<NotFinite> lost = not_finite(states, row, step); lost && is_of_pose(lost->field)) {
      const NotFinite shown = in_axes(plan_->header.axes(), *lost);
      return bad_input(plan_->place(body, step) + ": " + shown.field + " is " + exact(shown.value) +
                       ", which glTF cannot hold; export the steps before (--steps), other bodies (--bodies), or to "
                       ".npz");
    }
    const double norm =
        states.orientation.w[row] * states.orientation.w[row] + states.orientation.x[row] * states.orientation.x[row] +
        states.orientation.y[row] * states.orientation.y[row] + states.orientation.z[row] * states.orientation.z[row];
    const sim::Vec3 at = states.position[row];
    const double far = std::max({std::fabs(at.x()), std::fabs(at.y()), std::fabs(at.z())});
    if (norm > 0 && std::isfinite(norm) && far <= static_cast<double>(std::numeric_limits<float>::max())) return {};
    return bad_input(plan_->place(body, step) +
                     ": found a pose that no floats hold, wanted a rotation and a place in " +
                     "their range; choose other --steps or --bodies, or export to .npz");
  }

  void set_state(std::size_t body, const sim::Vec3& at, const sim::Quat& q) {
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    const double numbers[] = {at.x(), at.y(), at.z(), q.x / length, q.y / length, q.z / length, q.w / length};
    for (std::size_t c = 0; c < kStateFloats; ++c) {
      if (c < 3) translations_.set(body, filled_, c, numbers[c]);
      if (c >= 3) rotations_.set(body, filled_, c - 3, numbers[c]);
    }
  }

  Status flush() {
    if (filled_ == 0 || plan_->bodies.empty()) return {};
    for (const Block* block : {&translations_, &rotations_}) {
      if (Status ok = block->write(file_, buffer_at_, written_, filled_); !ok.ok()) return ok;
    }
    written_ += std::exchange(filled_, 0);
    return {};
  }

  /// Times of keyframes. Errors: two steps at one time.
  Result<std::size_t> add_times() {
    std::vector<float> times;
    for (std::size_t i = 0; i < plan_->times.size(); ++i) {
      times.push_back(static_cast<float>(plan_->times[i] - plan_->times.front()));
      if (i == 0 || times[i] > times[i - 1]) continue;
      return bad_input("steps " + std::to_string(plan_->steps[i - 1]) + " and " + std::to_string(plan_->steps[i]) +
                       ": found times that are one as floats, wanted later ones: choose --every or --steps");
    }
    return buffer_.add(times, 1, true);
  }

  /// A scale of 1 where a body is there, else 0; none for a body that always is.
  void add_scale(std::size_t body, GltfJson& animation) {
    const ExportBody& about = plan_->bodies[body];
    if (about.runs.size() == 1 && about.runs.front().end - about.runs.front().begin == plan_->steps.size()) return;
    std::vector<float> times, scales;
    const auto add_key = [&](std::size_t index, float scale) {
      times.push_back(static_cast<float>(plan_->times[index] - plan_->times.front()));
      scales.insert(scales.end(), 3, scale);
    };
    if (about.runs.front().begin > 0) add_key(0, 0);
    for (const ExportRun& run : about.runs) {
      add_key(run.begin, 1);
      if (run.end < plan_->steps.size()) add_key(run.end, 0);
    }
    animation["samplers"].push_back(
        {{"input", buffer_.add(times, 1, true)}, {"output", buffer_.add(scales, 3, false)}, {"interpolation", "STEP"}});
    add_channel(body, "scale", animation);
  }

  static void add_channel(std::size_t body, const char* path, GltfJson& animation) {
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", body}, {"path", path}}}});
  }

  Status add_animation(GltfJson& json) {
    const std::size_t bodies = plan_->bodies.size(), steps = plan_->steps.size();
    GltfJson animation = {{"name", "session"}, {"samplers", GltfJson::array()}, {"channels", GltfJson::array()}};
    const Result<std::size_t> times = add_times();
    if (!times.ok()) return times.error();
    for (std::size_t i = 0; i < bodies; ++i) add_scale(i, animation);
    const std::size_t block = std::min(steps, std::max<std::size_t>(kBlockBytes / (bodies * kStateFloats * 4), 1));
    const GltfRoom translations = buffer_.reserve(bodies, steps, 3), rotations = buffer_.reserve(bodies, steps, 4);
    translations_.begin(translations, bodies, block);
    rotations_.begin(rotations, bodies, block);
    const std::pair<const char*, GltfRoom> paths[] = {{"translation", translations}, {"rotation", rotations}};
    for (const auto& [path, room] : paths) {
      for (std::size_t i = 0; i < bodies; ++i) {
        animation["samplers"].push_back({{"input", *times}, {"output", room.accessor + i}});
        add_channel(i, path, animation);
      }
    }
    json["animations"] = GltfJson::array({std::move(animation)});
    return {};
  }

  Status write_head(const std::string& text) {
    constexpr std::uint64_t kHeads = 12 + 8 + 8;
    const std::uint64_t binary = buffer_.size() + (4 - buffer_.size() % 4) % 4;
    const std::uint64_t size = kHeads + text.size() + binary;
    if (size > kFileMax) {
      return bad_input("found a file of " + bytes_text(size) +
                       ", wanted at most 4 GiB, which is all that .glb can be: "
                       "choose --every, --steps or --bodies");
    }
    std::string head;
    append_little(0x46546c67, 4, head);  // "glTF"
    append_little(2, 4, head);
    append_little(size, 4, head);
    append_little(text.size(), 4, head);
    append_little(0x4e4f534a, 4, head);  // "JSON"
    head += text;
    append_little(binary, 4, head);
    append_little(0x004e4942, 4, head);  // "BIN"
    buffer_at_ = head.size();
    head += buffer_.bytes();
    if (Status ok = file_.write_at(0, head); !ok.ok() || binary == buffer_.bytes().size()) return ok;
    return file_.write_at(size - 1, std::string(1, '\0'));  // the file has its size from the start
  }

  files::OutputFile& file_;
  const ExportPlan* plan_ = nullptr;
  GltfBuffer buffer_;
  std::uint64_t buffer_at_ = 0;  // in the file
  Block translations_, rotations_;
  std::size_t filled_ = 0;   // steps in the blocks
  std::size_t written_ = 0;  // before them
};

}  // namespace

std::unique_ptr<ExportWriter> make_gltf_writer(files::OutputFile& file) { return std::make_unique<GltfWriter>(file); }

}  // namespace tumble::replay
