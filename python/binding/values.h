#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "tumble/replay/channel.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/shape.h"
#include "tumble/sim/scene.h"

/// Inputs, bodies, shapes and values of channels as dictionaries, tuples and numbers of Python, and back.
namespace tumble::python {

namespace py = pybind11;

/// {"kind": "push", "id": 3, "impulse": (0, 0, 1), …}: the fields of src/model/command_fields.h; those of a thrown box
/// and of its material lie side by side.
py::dict dict_of(const sim::Command& command);
py::dict dict_of(const sim::BoxDef& box);
py::dict dict_of(const replay::Shape& shape);
py::dict dict_of(const replay::LogSummary& summary);

/// The other way. Keys that are missing keep their defaults. Raises tumble.BadInput: an unknown key, a value of another
/// kind. The ranges of the values are checked where they enter a world or a log.
sim::Command command_of(const py::dict& fields);
sim::BoxDef box_of(const py::dict& fields);
replay::Shape shape_of(const py::dict& fields);

/// A value of a channel: float, int, bytes or text. NaN keeps its bits.
py::object object_of(const replay::ChannelValue& value, replay::ChannelKind kind);
/// Raises tumble.BadInput: a value of another kind, or one that the kind does not hold exactly.
replay::ChannelValue channel_value_of(const py::handle& value, const replay::Channel& channel);

}  // namespace tumble::python
