// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace pellucid::python {

/// Each adds a function, and the class of its result, to the module.
///@{
void define_trace(pybind11::module_& module);
void define_compare(pybind11::module_& module);
void define_study(pybind11::module_& module);
///@}

}  // namespace pellucid::python
