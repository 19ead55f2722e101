// The module tumble._tumble: the plain interface that the package tumble is made of.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "python/binding/engine_recorder.h"
#include "python/binding/log_file.h"
#include "python/binding/raise.h"
#include "python/binding/world.h"

PYBIND11_MODULE(_tumble, module) {
  module.attr("version") = TUMBLE_VERSION;
  tumble::python::add_step(module);
  tumble::python::add_log(module);
  tumble::python::add_world(module);
  tumble::python::add_engine_recorder(module);
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(&tumble::python::end_calls));
}
