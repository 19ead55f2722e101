// The header of a log, and what it says of bodies.
#include <string>

#include "python/binding/arrays.h"
#include "python/binding/log_file.h"
#include "python/binding/values.h"

namespace tumble::python {
namespace {

py::dict world_of(const sim::WorldDef& world) {
  py::dict fields;
  fields["method"] = name_of(world.method);
  fields["dt"] = world.dt;
  fields["substeps"] = world.substeps;
  fields["split_collisions"] = world.split_collisions;
  fields["gravity"] = tuple_of(world.gravity);
  fields["ground"] = world.ground;
  fields["freezing"] = world.freezing;
  fields["freeze_energy"] = world.freeze_energy;
  fields["freeze_time"] = world.freeze_time;
  fields["slip_speed"] = world.slip_speed;
  fields["air_drag"] = world.air_drag;
  return fields;
}

py::object engine_of(const replay::LogHeader& header) {
  if (!header.engine) return py::none();
  py::dict fields;
  fields["name"] = text_of_bytes(header.engine->name);
  fields["version"] = text_of_bytes(header.engine->version);
  fields["precision_bits"] = header.engine->precision_bits;
  return fields;
}

py::object goes_on_of(const replay::LogHeader& header) {
  if (!header.goes_on) return py::none();
  py::dict fields;
  fields["log"] = text_of_bytes(header.goes_on->log);
  fields["step"] = header.goes_on->step;
  return fields;
}

/// (index in the log, name, kind, scope, unit), in the order of lists for people.
py::list channels_of(const replay::Declared& declared) {
  py::list channels;
  for (const std::size_t index : listed_order(declared.channels)) {
    const replay::Channel& channel = declared.channels[index];
    channels.append(py::make_tuple(index, text_of_bytes(channel.name), name_of(channel.type.kind),
                                   name_of(channel.type.scope), text_of_bytes(channel.unit)));
  }
  return channels;
}

py::list missing_of(const replay::LogHeader& header) {
  py::list runs;
  for (const replay::MissingSteps& run : header.missing()) runs.append(py::make_tuple(run.first_step, run.step_count));
  return runs;
}

}  // namespace

py::dict header_dict(const LogFile& log) {
  const replay::LogHeader& header = log.header();
  py::dict fields;
  fields["format"] = std::to_string(header.format_major) + "." + std::to_string(header.format_minor);
  fields["tool_version"] = text_of_bytes(header.tool_version);
  fields["tool_build"] = text_of_bytes(header.tool_build);
  fields["method"] = text_of_bytes(header.method);
  fields["method_version"] = header.method_version;
  fields["scene"] = text_of_bytes(header.scene.name);
  fields["title"] = text_of_bytes(header.scene.title);
  fields["scene_text"] = text_of_bytes(header.scene_text);
  py::list overrides;
  for (const std::string& text : header.overrides) overrides.append(text_of_bytes(text));
  fields["overrides"] = overrides;
  fields["planned_steps"] = header.scene.steps;
  fields["world"] = world_of(header.scene.world);
  fields["transform"] = to_string(header.transform);
  fields["engine"] = engine_of(header);
  fields["goes_on"] = goes_on_of(header);
  fields["axes"] = to_string(header.axes());
  fields["channels"] = channels_of(header.declared);
  fields["missing"] = missing_of(header);
  fields["cut_short"] = text_of_bytes(header.declared.cut_short);
  fields["states"] = to_string(header.states);
  fields["hashes"] = to_string(header.hashes);
  py::list phases;
  for (const std::string& phase : header.phases) phases.append(text_of_bytes(phase));
  fields["phases"] = phases;
  return fields;
}

py::dict bodies_dict(LogFile& log) {
  const replay::BodyTable table = log.read([](replay::LogReader& reader) { return reader.bodies(); });
  py::dict bodies;
  const auto add = [&](const sim::BoxDef& box) {
    const py::int_ id(box.id);
    if (bodies.contains(id)) return;
    py::dict fields = dict_of(box);
    fields["name"] = text_of_bytes(table.name(box.id));
    const replay::Shape* shape = table.shape(box.id);
    fields["shape"] = shape == nullptr ? py::object(py::none()) : py::object(dict_of(*shape));
    bodies[id] = fields;
  };
  for (const sim::BoxDef& box : log.header().scene.boxes) add(box);
  for (const py::handle& input : read_inputs(log)) {
    py::dict fields = py::reinterpret_borrow<py::dict>(input);
    if (std::string(py::str(fields["kind"])) != "throw") continue;
    const py::dict box = py::reinterpret_steal<py::dict>(PyDict_Copy(fields.ptr()));
    PyDict_DelItemString(box.ptr(), "kind");
    PyDict_DelItemString(box.ptr(), "step");
    add(box_of(box));
  }
  return bodies;
}

}  // namespace tumble::python
