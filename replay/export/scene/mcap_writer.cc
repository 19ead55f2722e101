#include "replay/export/scene/mcap_writer.h"

#include <foxglove.pb.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <tumble.pb.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "replay/export/plan/utf8_text.h"
#include "replay/export/scene/foxglove_scene.h"
#include "replay/export/scene/mcap_file.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

using google::protobuf::FileDescriptor;
using google::protobuf::Message;

constexpr double kNanoseconds = 1e9;

void add_file(const FileDescriptor& file, std::set<std::string>& done, google::protobuf::FileDescriptorSet& set) {
  if (!done.insert(file.name()).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) add_file(*file.dependency(i), done, set);
  file.CopyTo(set.add_file());
}

/// The schema of a message with everything that it refers to.
std::string schema_of(const Message& message) {
  google::protobuf::FileDescriptorSet set;
  std::set<std::string> done;
  add_file(*message.GetDescriptor()->file(), done, set);
  return set.SerializeAsString();
}

class McapWriter : public ExportWriter {
 public:
  explicit McapWriter(files::OutputFile& file) : mcap_(file) {}

  Status begin(const ExportPlan& plan) override {
    plan_ = &plan;
    left_out_ = {"inputs, phase hashes, counters, contacts, notes and snapshots",
                 "title, category, camera, light and text of the scene, and the method and its parameters",
                 "textures: bodies have mean colours"};
    frames_ = frame_names(plan);
    const LogHeader& header = plan.header;
    const std::string engine =
        header.engine ? header.engine->name + ' ' + header.engine->version : "Tumble " + header.tool_version;
    if (Status ok = mcap_.begin("tumble", {{"scene", header.scene.name}, {"engine", engine}}); !ok.ok()) return ok;
    scene_channel_ = add_channel(foxglove::SceneUpdate(), "/scene");
    frames_channel_ = add_channel(transforms_, "/tf");
    poses_channel_ = add_channel(poses_, "/poses");
    bodies_channel_ = add_channel(bodies_, "/bodies");
    const std::vector<Channel>& channels = header.declared.channels;
    if (channels.empty()) return {};
    const std::uint16_t schema = mcap_.add_schema(values_.GetTypeName(), schema_of(values_));
    for (const Channel& channel : channels) {
      channels_.push_back(mcap_.add_channel(
          schema, "/channel/" + channel.name,
          {{"unit", channel.unit}, {"kind", name_of(channel.type.kind)}, {"of", name_of(channel.type.scope)}}));
    }
    return {};
  }

  Status add(const ExportStep& step) override {
    time_ = static_cast<std::uint64_t>(std::llround(step.time * kNanoseconds));
    if (is_new_scene(step.rows)) {
      if (Status ok = send_scene(step); !ok.ok()) return ok;
    }
    if (Status ok = send_states(step); !ok.ok()) return ok;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (Status ok = send_values(step, i); !ok.ok()) return ok;
    }
    return {};
  }

  Status finish() override {
    if (raw_texts_ > 0) {
      left_out_.push_back("the kind of " + count_text(raw_texts_, "text") +
                          " in channels, no UTF-8: bytes in their place");
    }
    return mcap_.finish();
  }

 private:
  std::uint16_t add_channel(const Message& message, const std::string& topic) {
    return mcap_.add_channel(mcap_.add_schema(message.GetTypeName(), schema_of(message)), topic);
  }

  Status send(std::uint16_t channel, const Message& message) {
    bytes_.clear();
    if (message.ByteSizeLong() > kMessageMax || !message.AppendToString(&bytes_)) {
      return bad_input("found a step of more than 2 GB, wanted a smaller one: choose --bodies");
    }
    return mcap_.add_message(channel, time_, bytes_);
  }

  template <class Stamped>
  void stamp(Stamped& message) const {
    constexpr std::uint64_t kSecond = 1'000'000'000;
    message.mutable_timestamp()->set_seconds(static_cast<std::int64_t>(time_ / kSecond));
    message.mutable_timestamp()->set_nanos(static_cast<std::int32_t>(time_ % kSecond));
  }

  /// Whether other bodies are there than in the step before.
  bool is_new_scene(std::span<const std::uint32_t> rows) {
    std::vector<bool> there;
    there.reserve(rows.size());
    for (const std::uint32_t row : rows) there.push_back(row != ExportStep::kAbsent);
    const bool is_new = !scene_sent_ || there != there_;
    there_ = std::move(there);
    return is_new;
  }

  Status send_scene(const ExportStep& step) {
    scene_sent_ = true;
    foxglove::SceneUpdate scene = scene_at(*plan_, step.index, frames_);
    for (foxglove::SceneEntityDeletion& deletion : *scene.mutable_deletions()) stamp(deletion);
    for (foxglove::SceneEntity& entity : *scene.mutable_entities()) stamp(entity);
    return send(scene_channel_, scene);
  }

  static void set(const sim::Vec3& at, const sim::Quat& q, foxglove::Vector3& position, foxglove::Quaternion& turn) {
    position.set_x(at.x());
    position.set_y(at.y());
    position.set_z(at.z());
    turn.set_x(q.x);
    turn.set_y(q.y);
    turn.set_z(q.z);
    turn.set_w(q.w);
  }

  Status send_states(const ExportStep& step) {
    transforms_.Clear();  // keeps the memory of its parts
    poses_.Clear();
    bodies_.Clear();
    stamp(poses_);
    poses_.set_frame_id(kWorldFrame);
    stamp(bodies_);
    bodies_.set_step(step.record.step);
    const BodyStates& states = step.record.states;
    for (std::size_t i = 0; i < step.rows.size(); ++i) {
      const std::uint32_t row = step.rows[i];
      if (row == ExportStep::kAbsent) continue;
      const sim::Vec3 at = states.position[row], v = states.velocity[row], w = states.spin[row];
      const sim::Quat q = {states.orientation.w[row], states.orientation.x[row], states.orientation.y[row],
                           states.orientation.z[row]};
      foxglove::FrameTransform& transform = *transforms_.add_transforms();
      stamp(transform);
      transform.set_parent_frame_id(kWorldFrame);
      transform.set_child_frame_id(frames_[i]);
      set(at, q, *transform.mutable_translation(), *transform.mutable_rotation());
      foxglove::Pose& pose = *poses_.add_poses();
      set(at, q, *pose.mutable_position(), *pose.mutable_orientation());
      bodies_.add_id(states.id[row]);
      for (const double number : {v.x(), v.y(), v.z()}) bodies_.add_velocity(number);
      for (const double number : {w.x(), w.y(), w.z()}) bodies_.add_spin(number);
      bodies_.add_frozen(states.frozen[row] != 0);
    }
    if (Status ok = send(frames_channel_, transforms_); !ok.ok()) return ok;
    if (Status ok = send(poses_channel_, poses_); !ok.ok()) return ok;
    return send(bodies_channel_, bodies_);
  }

  [[nodiscard]] bool is_chosen(const ChannelKey& key) const {
    const auto there = [this](sim::BodyId id) {
      return id == 0 || std::ranges::binary_search(plan_->bodies, id, {}, [](const ExportBody& b) { return b.box.id; });
    };
    return !plan_->chosen || (there(key.a) && there(key.b));
  }

  Status send_values(const ExportStep& step, std::size_t channel) {
    const ChannelValues& values = step.record.extras.values(channel);
    const ChannelKind kind = plan_->header.declared.channels[channel].type.kind;
    values_.Clear();
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (!is_chosen(values.keys[row])) continue;
      Value& to = *values_.add_values();
      to.set_a(values.keys[row].a);
      to.set_b(values.keys[row].b);
      const ChannelValue value = values.value(row, kind);
      if (const auto* wide = std::get_if<double>(&value)) to.set_float64(*wide);
      if (const auto* narrow = std::get_if<float>(&value)) to.set_float32(*narrow);
      if (const auto* number = std::get_if<std::int64_t>(&value)) to.set_int64(*number);
      if (const auto* number = std::get_if<std::uint64_t>(&value)) to.set_uint64(*number);
      if (const auto* text = std::get_if<std::string>(&value)) {
        const bool as_text = kind == ChannelKind::kText && is_utf8(*text);  // a Protobuf string holds nothing else
        as_text ? to.set_text(*text) : to.set_bytes(*text);
        if (kind == ChannelKind::kText && !as_text) ++raw_texts_;
      }
    }
    if (values_.values_size() == 0) return {};
    stamp(values_);
    values_.set_step(step.record.step);
    return send(channels_[channel], values_);
  }

  static constexpr std::size_t kMessageMax = (std::size_t{1} << 31U) - 1;  // of Protobuf

  McapFile mcap_;
  const ExportPlan* plan_ = nullptr;
  std::vector<std::string> frames_;
  std::uint16_t scene_channel_ = 0, frames_channel_ = 0, poses_channel_ = 0, bodies_channel_ = 0;
  std::vector<std::uint16_t> channels_;  // by index in Declared::channels
  std::vector<bool> there_;              // the bodies of the step before
  bool scene_sent_ = false;
  std::uint64_t time_ = 0;       // ns
  std::uint64_t raw_texts_ = 0;  // that are no UTF-8
  foxglove::FrameTransforms transforms_;
  foxglove::PosesInFrame poses_;
  Bodies bodies_;
  Values values_;
  std::string bytes_;
};

}  // namespace

std::unique_ptr<ExportWriter> make_mcap_writer(files::OutputFile& file) { return std::make_unique<McapWriter>(file); }

}  // namespace tumble::replay
