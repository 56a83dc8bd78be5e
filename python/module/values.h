// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Python's values and ours. What comes from Python is checked; what goes there is not copied where
// it is an array.

#include <pybind11/numpy.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/raster.h"
#include "core/vec.h"

namespace pellucid::python {

namespace py = pybind11;

/// Returns the text that `value` is, or the path. Throws InputError that names it `what`.
///@{
std::string text_of(const py::handle& value, std::string_view what);
std::string path_of(const py::handle& value, std::string_view what);
///@}

/// Returns the texts that `value`, a list or the like, holds; one text is a list of it. Throws
/// InputError that names it `what`.
std::vector<std::string> texts_of(const py::handle& value, std::string_view what);

/// Returns the finite number, or the whole number, that `value` is. Throws InputError.
///@{
double number_of(const py::handle& value, std::string_view what);
long long integer_of(const py::handle& value, std::string_view what);
///@}

/// Returns whether `value` is a dict or another collections.abc.Mapping.
bool is_mapping(const py::handle& value);

/// Returns what a JSON file would hold for nested mappings, lists, tuples, NumPy's arrays and
/// numbers, texts and paths. `on_other` returns the text that stands for an object of another kind;
/// empty: there is none. Throws InputError.
nlohmann::json json_of(const py::handle& value, std::string_view what,
                       const std::function<std::string(const py::handle&)>& on_other = {});

/// Returns dicts, lists, texts and numbers.
py::object python_of(const nlohmann::json& json);

/// Throws InputError for an array of NumPy's that masks some of its values: nothing here knows what
/// stands in their place.
void refuse_masked(const py::handle& value, std::string_view what);

/// Returns numbers of `value`, an array or what NumPy makes one of, of the given number of columns;
/// 0: without columns. Throws InputError for other shapes and for what are no real numbers.
py::array_t<double, py::array::c_style> numbers_of(const py::handle& value, py::ssize_t columns,
                                                   std::string_view what);
/// Returns the same for whole numbers.
py::array_t<std::int64_t, py::array::c_style> integers_of(const py::handle& value,
                                                          py::ssize_t columns,
                                                          std::string_view what);
/// Returns rows of three numbers, such as positions.
std::vector<Vec3> vectors_of(const py::handle& value, std::string_view what);
/// Returns rows of three or four numbers in [0, 1] as they are, or bytes as n/255; opacity is 1
/// where it is not given. `shape` gets the array's, of three dimensions for a picture and of two
/// else.
std::vector<Rgba> colors_of(const py::handle& value, py::ssize_t dimensions, std::string_view what,
                            std::vector<py::ssize_t>* shape = nullptr);

/// Returns the array `value` of H × W × 3 or 4 numbers as a picture. `shape` gets the array's.
/// Throws InputError.
Image image_of(const py::handle& value, std::string_view what, std::vector<py::ssize_t>* shape);

/// Returns a NumPy array of the numbers at `data`, which `owner` keeps.
template <class T>
py::array array_over(std::shared_ptr<const void> owner, const T* data,
                     std::vector<py::ssize_t> shape, bool writable = false) {
  using Owner = std::shared_ptr<const void>;
  const py::capsule base(new Owner(std::move(owner)),
                         [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array_t<T> array(std::move(shape), data, base);
  if (!writable) array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Returns a NumPy array that keeps the numbers.
template <class T>
py::array array_of(std::vector<T> values) {
  const auto kept = std::make_shared<std::vector<T>>(std::move(values));
  return array_over(kept, kept->data(), {py::ssize_t(kept->size())}, true);
}

}  // namespace pellucid::python
