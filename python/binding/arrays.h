#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tumble/sim/ids.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

/// Memory of C++ seen as arrays of numpy, and numbers of Python read as doubles.
namespace tumble::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// A read-only array over `data`, which lives as long as `owner`; the array keeps the owner alive. Copies nothing.
template <class T, class Owner>
py::array view_of(std::shared_ptr<Owner> owner, const T* data, Shape shape) {
  auto* held = new std::shared_ptr<Owner>(std::move(owner));
  const py::capsule base(held, [](void* pointer) { delete static_cast<std::shared_ptr<Owner>*>(pointer); });
  py::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// A read-only array that takes over a vector's memory.
template <class T>
py::array array_of(std::vector<T> values, Shape shape) {
  auto owner = std::make_shared<const std::vector<T>>(std::move(values));
  const T* data = owner->data();
  return view_of(std::move(owner), data, std::move(shape));
}
template <class T>
py::array array_of(std::vector<T> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {size});
}

/// Rows of numbers from anything that numpy takes for an array: of rows × columns doubles, row by row. Any strides, any
/// kind of number whose values are exactly doubles. name: for errors. Raises tumble.BadInput: another shape, another
/// kind of value, an integer that is no double.
std::vector<double> doubles_of(const py::handle& value, const std::string& name, std::size_t rows, std::size_t columns);

double double_of(const py::handle& value, const std::string& name);
sim::Vec3 vec3_of(const py::handle& value, const std::string& name);
sim::Quat quat_of(const py::handle& value, const std::string& name);
/// Ids of bodies, of one dimension.
std::vector<sim::BodyId> ids_of(const py::handle& value, const std::string& name);
std::uint64_t whole_of(const py::handle& value, const std::string& name);
bool flag_of(const py::handle& value, const std::string& name);
std::string text_of(const py::handle& value, const std::string& name);

py::tuple tuple_of(const sim::Vec3& v);
py::tuple tuple_of(const sim::Quat& q);

/// Text of a log as Python's text, whatever its bytes are.
py::str text_of_bytes(const std::string& bytes);

}  // namespace tumble::python
