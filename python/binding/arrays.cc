#include "python/binding/arrays.h"

#include <cmath>

#include "python/binding/raise.h"
#include "src/base/text.h"

namespace tumble::python {
namespace {

constexpr double kExactWhole = 9007199254740992;  // 2⁵³: integers up to it are doubles

std::string found_in(const py::handle& value) {
  constexpr std::size_t kShown = 60;
  std::string text = py::repr(value).cast<std::string>();
  if (text.size() > kShown) text = text.substr(0, kShown) + " …";
  return printable(text);
}

[[noreturn]] void refuse(const std::string& name, const std::string& found, const std::string& wanted) {
  raise(bad_input(name + ": " + found_wanted(found, wanted)));
}

std::string shape_text(const py::array& array) {
  std::string text = "shape (";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");  // as Python writes it
}

py::array any_array(const py::handle& value, const std::string& name) {
  if (py::hasattr(value, "mask")) refuse(name, "a masked array", "an array with every value");
  py::array array;
  try {
    array = py::array::ensure(value);
  } catch (const py::error_already_set&) {
    array = {};
  }
  if (!array) {
    PyErr_Clear();
    refuse(name, found_in(value), "numbers");
  }
  return array;
}

/// As doubles, C-contiguous. Integers must survive the way there and back.
py::array_t<double> exact_doubles(const py::handle& value, const std::string& name) {
  const py::array array = any_array(value, name);
  const char kind = array.dtype().kind();
  const bool is_real = kind == 'f' && array.itemsize() <= static_cast<py::ssize_t>(sizeof(double));
  if (!is_real && kind != 'i' && kind != 'u') {
    const std::string type = py::str(array.dtype()).cast<std::string>();
    refuse(name, "values of type " + type, "float64, float32 or integers");
  }
  auto doubles = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!doubles) {
    PyErr_Clear();
    refuse(name, found_in(value), "numbers");
  }
  if (kind == 'f') return doubles;
  for (py::ssize_t i = 0; i < doubles.size(); ++i) {
    if (std::fabs(doubles.data()[i]) >= kExactWhole)
      refuse(name, "an integer beyond 2^53", "numbers that a double holds");
  }
  return doubles;
}

}  // namespace

std::vector<double> doubles_of(const py::handle& value, const std::string& name, std::size_t rows,
                               std::size_t columns) {
  const py::array_t<double> array = exact_doubles(value, name);
  const auto is = [](py::ssize_t found, std::size_t wanted) { return static_cast<std::size_t>(found) == wanted; };
  const bool one_row = rows == 1 && array.ndim() == 1 && is(array.shape(0), columns);
  const bool one_column = columns == 1 && array.ndim() == 1 && is(array.shape(0), rows);
  const bool table = array.ndim() == 2 && is(array.shape(0), rows) && is(array.shape(1), columns);
  if (!one_row && !one_column && !table) {
    if (rows == 1 && columns > 1) refuse(name, found_in(value), std::to_string(columns) + " numbers");
    const std::string wanted = columns == 1 ? "(" + std::to_string(rows) + ",)"
                                            : "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")";
    refuse(name, shape_text(array), "shape " + wanted);
  }
  return {array.data(), array.data() + array.size()};
}

double double_of(const py::handle& value, const std::string& name) {
  const py::array_t<double> array = exact_doubles(value, name);
  if (array.ndim() != 0) refuse(name, shape_text(array), "one number");
  return *array.data();
}

sim::Vec3 vec3_of(const py::handle& value, const std::string& name) {
  const std::vector<double> v = doubles_of(value, name, 1, 3);
  return {v[0], v[1], v[2]};
}

sim::Quat quat_of(const py::handle& value, const std::string& name) {
  const std::vector<double> q = doubles_of(value, name, 1, 4);
  return {q[0], q[1], q[2], q[3]};
}

std::vector<sim::BodyId> ids_of(const py::handle& value, const std::string& name) {
  const py::array array = any_array(value, name);
  const char kind = array.dtype().kind();
  if (array.size() == 0 && array.ndim() == 1) return {};
  if ((kind != 'i' && kind != 'u') || array.ndim() != 1) refuse(name, found_in(value), "a list of ids of bodies");
  if (kind == 'i' && array.attr("min")().cast<std::int64_t>() < 0) refuse(name, "an id below 0", "ids of bodies");
  const auto whole = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!whole) throw py::error_already_set();
  return {whole.data(), whole.data() + whole.size()};
}

std::uint64_t whole_of(const py::handle& value, const std::string& name) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index || PyBool_Check(value.ptr())) {
    PyErr_Clear();
    refuse(name, found_in(value), "a whole number");
  }
  const std::uint64_t whole = PyLong_AsUnsignedLongLong(index.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    refuse(name, found_in(value), "a whole number from 0 to 2^64 - 1");
  }
  return whole;
}

bool flag_of(const py::handle& value, const std::string& name) {
  const int flag = PyObject_IsTrue(value.ptr());
  const bool is_flag = PyBool_Check(value.ptr()) != 0 || py::hasattr(value, "dtype");
  if (flag < 0 || !is_flag) {
    PyErr_Clear();
    refuse(name, found_in(value), "True or False");
  }
  return flag == 1;
}

std::string text_of(const py::handle& value, const std::string& name) {
  Py_ssize_t size = 0;
  const char* text = PyUnicode_Check(value.ptr()) ? PyUnicode_AsUTF8AndSize(value.ptr(), &size) : nullptr;
  if (text == nullptr) {
    PyErr_Clear();
    refuse(name, found_in(value), "text");
  }
  return {text, static_cast<std::size_t>(size)};
}

py::tuple tuple_of(const sim::Vec3& v) { return py::make_tuple(v.x(), v.y(), v.z()); }
py::tuple tuple_of(const sim::Quat& q) { return py::make_tuple(q.w, q.x, q.y, q.z); }

py::str text_of_bytes(const std::string& bytes) {
  auto text = py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "backslashreplace"));
  if (!text) throw py::error_already_set();
  return text;
}

}  // namespace tumble::python
