#include <bit>
#include <limits>
#include <string>

#include "python/binding/arrays.h"
#include "python/binding/raise.h"
#include "python/binding/values.h"
#include "src/base/text.h"

namespace tumble::python {
namespace {

using replay::ChannelKind;

[[noreturn]] void refuse(const replay::Channel& channel, const py::handle& value) {
  raise(bad_input("channel " + in_quotes(channel.name) + ": " +
                  found_wanted(shortened(py::repr(value).cast<std::string>()),
                               std::string("a value of ") + name_of(channel.type.kind))));
}

std::int64_t signed_of(const py::handle& value, const replay::Channel& channel) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const std::int64_t whole = index ? PyLong_AsLongLong(index.ptr()) : 0;
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(channel, value);
  }
  return whole;
}

/// Exactly as a float of 32 bits; a float32 of numpy comes with its own bits.
float single_of(const py::handle& value, const replay::Channel& channel) {
  const double wide = double_of(value, "channel " + in_quotes(channel.name));
  const auto narrow = static_cast<float>(wide);
  if (static_cast<double>(narrow) != wide && wide == wide) {
    raise(bad_input("channel " + in_quotes(channel.name) + ": " +
                    found_wanted(exact(wide), "a value of float32; round it, or declare the channel as float64")));
  }
  return narrow;
}

}  // namespace

py::object object_of(const replay::ChannelValue& value, ChannelKind kind) {
  if (const auto* bytes = std::get_if<std::string>(&value)) {
    if (kind == ChannelKind::kBytes) return py::bytes(*bytes);
    return text_of_bytes(*bytes);
  }
  return std::visit(
      [](const auto& number) -> py::object {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(number)>>) return py::cast(number);
        return py::none();
      },
      value);
}

replay::ChannelValue channel_value_of(const py::handle& value, const replay::Channel& channel) {
  switch (channel.type.kind) {
    case ChannelKind::kFloat64:
      return double_of(value, "channel " + in_quotes(channel.name));
    case ChannelKind::kFloat32:
      return single_of(value, channel);
    case ChannelKind::kInt64:
      return signed_of(value, channel);
    case ChannelKind::kUint64:
      return whole_of(value, "channel " + in_quotes(channel.name));
    case ChannelKind::kBytes: {
      if (!PyBytes_Check(value.ptr())) refuse(channel, value);
      return std::string(PyBytes_AS_STRING(value.ptr()), static_cast<std::size_t>(PyBytes_GET_SIZE(value.ptr())));
    }
    case ChannelKind::kText:
      return text_of(value, "channel " + in_quotes(channel.name));
  }
  refuse(channel, value);
}

}  // namespace tumble::python
