// SPDX-License-Identifier: GPL-3.0-or-later
// The module `pellucid`: errors, and what the files beside this one define.

#include "module/module.h"

#include "core/error.h"
#include "core/machine/build_info.h"
#include "module/scene.h"
#include "module/shapes.h"

namespace py = pybind11;

PYBIND11_MODULE(_pellucid, module) {
  using namespace pellucid;
  module.attr("__version__") = build_version;
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError).doc() =
      "The caller's input or call is wrong: where, what was got, what is accepted.";
  py::register_exception<WorkError>(module, "WorkError", PyExc_RuntimeError).doc() =
      "The work itself failed: the disk is full, a driver lacks something.";
  python::define_shapes(module);
  python::define_scene(module);
  python::define_trace(module);
  python::define_compare(module);
  python::define_study(module);
}
