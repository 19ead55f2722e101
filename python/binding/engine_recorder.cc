#include "python/binding/engine_recorder.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "python/binding/arrays.h"
#include "python/binding/values.h"
#include "replay/import/declared_bodies.h"
#include "src/base/text.h"
#include "src/files/output_guard.h"

namespace tumble::python {
namespace {

py::object get(const py::dict& fields, const char* key) {
  return fields.contains(key) ? py::object(fields[key]) : py::object(py::none());
}

replay::ChannelKind kind_named(const std::string& word) {
  for (const auto kind : {replay::ChannelKind::kFloat64, replay::ChannelKind::kFloat32, replay::ChannelKind::kInt64,
                          replay::ChannelKind::kUint64, replay::ChannelKind::kBytes, replay::ChannelKind::kText}) {
    if (word == name_of(kind)) return kind;
  }
  raise(bad_input("channel: type: " + found_wanted(in_quotes(word), "float64, float32, int64, uint64, bytes or text")));
}

replay::ChannelScope scope_named(const std::string& word) {
  for (const auto scope : {replay::ChannelScope::kWorld, replay::ChannelScope::kBody, replay::ChannelScope::kPair}) {
    if (word == name_of(scope)) return scope;
  }
  raise(bad_input("channel: scope: " + found_wanted(in_quotes(word), "world, body or pair")));
}

/// [(name, kind, scope, unit), …], ascending by name.
std::vector<replay::Channel> channels_of(const py::handle& rows) {
  std::vector<replay::Channel> channels;
  for (const py::handle& row : rows) {
    const auto words = row.cast<std::vector<std::string>>();
    channels.push_back({words.at(0), {kind_named(words.at(1)), scope_named(words.at(2))}, words.at(3)});
  }
  std::ranges::sort(channels, {}, &replay::Channel::name);
  return channels;
}

/// The name and the shape of a body, which a scene does not hold; taken out of `fields`.
struct Description {
  std::string name;
  std::optional<replay::Shape> shape;
};
/// A body has the edge lengths of its shape, but for roundings in the computation of them.
void check_size(const sim::Vec3& given, const sim::Vec3& of_shape) {
  constexpr double kRounding = 1e-9;
  if ((given - of_shape).cwiseAbs().maxCoeff() <= kRounding * of_shape.cwiseAbs().maxCoeff()) return;
  const auto text = [](const sim::Vec3& v) { return exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()); };
  raise(bad_input("size: found " + text(given) + " m, wanted " + text(of_shape) +
                  " m, which the shape has; it need not be given"));
}

Description take_description(py::dict& fields) {
  Description found;
  if (const py::object name = get(fields, "name"); !name.is_none()) found.name = text_of(name, "name");
  if (const py::object shape = get(fields, "shape"); !shape.is_none()) {
    if (!py::isinstance<py::dict>(shape)) raise(bad_input("shape: wanted a dictionary, as tumble.sphere() makes one"));
    found.shape = shape_of(shape);
    check(check_shape(*found.shape));
    const sim::Vec3 size = size_of(*found.shape);
    if (!fields.contains("size")) {
      fields["size"] = tuple_of(size);
    } else {
      check_size(vec3_of(fields["size"], "size"), size);
    }
  }
  for (const char* key : {"name", "shape"}) {
    if (fields.contains(key)) PyDict_DelItemString(fields.ptr(), key);
  }
  return found;
}

py::dict copy_of(const py::handle& fields, const char* what) {
  if (!py::isinstance<py::dict>(fields)) raise(bad_input(std::string(what) + ": wanted a dictionary of its fields"));
  return py::reinterpret_steal<py::dict>(PyDict_Copy(fields.ptr()));
}

void add_body(const py::handle& row, sim::SceneDef& start, replay::DeclaredBodies& bodies, replay::Declared& declared) {
  py::dict fields = copy_of(row, "body");
  Description description = take_description(fields);
  const sim::BoxDef box = box_of(fields);
  start.boxes.push_back(box);
  if (description.name.empty() && !description.shape) return;
  replay::BodyInfo info{box.id, std::move(description.name), {}};
  if (description.shape) info.shape = hash_of(*description.shape);
  bodies.add(std::move(info), description.shape ? &*description.shape : nullptr, declared);
}

}  // namespace

EngineRecorder::EngineRecorder(const std::string& path, const py::dict& about) : path_(path) {
  files::OutputGuard guard;
  check(guard.claim("log", path));
  replay::EngineDef def;
  def.engine = {text_of(get(about, "engine"), "engine"), text_of(get(about, "version"), "version"),
                static_cast<std::uint32_t>(whole_of(get(about, "precision_bits"), "precision"))};
  for (const py::handle& phase : get(about, "phases")) def.phases.push_back(text_of(phase, "phases"));
  sim::SceneDef start;
  start.name = text_of(get(about, "scene"), "scene");
  start.title = text_of(get(about, "title"), "title");
  start.steps = whole_of(get(about, "planned_steps"), "planned_steps");
  start.world.dt = double_of(get(about, "dt"), "dt");
  start.world.gravity = vec3_of(get(about, "gravity"), "gravity");
  start.world.ground = flag_of(get(about, "ground"), "ground");
  def.declared.channels = channels_of(get(about, "channels"));
  channels_ = def.declared.channels;
  replay::DeclaredBodies bodies;
  for (const py::handle& row : get(about, "bodies")) add_body(row, start, bodies, def.declared);
  std::ranges::sort(start.boxes, {}, &sim::BoxDef::id);
  std::ranges::sort(def.declared.bodies, {}, &replay::BodyInfo::id);
  log_ = take(released([&] { return replay::EngineLog::create(path, def, start); }));
}

void EngineRecorder::refuse_if_busy() const {
  if (busy_) raise(bad_input(path_ + ": another thread is recording a step"));
}

replay::EngineLog& EngineRecorder::open() const {
  refuse_if_busy();
  if (finished_) raise(bad_input(path_ + ": the log is finished and takes no more steps"));
  if (failed_) raise(bad_input(path_ + ": an error ended this log before; the steps up to then can be read"));
  return *log_;
}

void EngineRecorder::guard(const Status& status) {
  failed_ = failed_ || !status.ok();
  check(status);
}

void EngineRecorder::input(const py::dict& fields) {
  replay::EngineLog& log = open();
  const Busy busy(busy_);
  py::dict own = copy_of(fields, "input");
  Description description = take_description(own);
  const sim::Command command = command_of(own);
  guard(log.input(command));
  if (const auto* gone = std::get_if<sim::Remove>(&command)) removed_.push_back(gone->id);
  const auto* thrown = std::get_if<sim::Throw>(&command);
  if (thrown == nullptr || (description.name.empty() && !description.shape)) return;
  replay::BodyInfo info{thrown->box.id, std::move(description.name), {}};
  if (description.shape) info.shape = hash_of(*description.shape);
  guard(log.describe_body(info, description.shape ? &*description.shape : nullptr));
}

std::uint64_t EngineRecorder::coming_step() const {
  refuse_if_busy();
  return log_->step();
}

py::array EngineRecorder::ids() const {
  refuse_if_busy();
  return ids_now();
}

py::array EngineRecorder::ids_now() const {
  std::vector<std::uint64_t> ids;
  const sim::Bodies& bodies = log_->bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.is_static[i] == 0) ids.push_back(bodies.id[i]);
  }
  return array_of(std::move(ids));
}

replay::LogSummary EngineRecorder::finish(const std::string& why) {
  refuse_if_busy();
  if (finished_) raise(bad_input(path_ + ": the log is finished already"));
  finished_ = true;
  if (failed_ || !why.empty()) log_->drop_step();
  const Result<replay::LogSummary> summary = released([&] { return log_->finish(why); });
  return take(summary);
}

}  // namespace tumble::python
