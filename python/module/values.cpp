// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/values.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"

namespace pellucid::python {
namespace {

/// A JSON file may not be nested more deeply either.
constexpr int most_levels = 100;

std::string kind_of(const py::handle& value) {
  return py::str(py::type::handle_of(value).attr("__name__"));
}

[[noreturn]] void refuse(std::string_view what, const py::handle& value,
                         std::string_view accepted) {
  throw InputError(
      fmt::format("{}: a value of type {}; accepted: {}", what, kind_of(value), accepted));
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

/// UTF-8 of a str; lone surrogates have none.
std::string utf8_of(const py::handle& text, std::string_view what) {
  py::ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes) return {bytes, std::size_t(size)};
  PyErr_Clear();
  throw InputError(fmt::format("{}: a text that is no Unicode; accepted: text", what));
}

/// NumPy's numbers and arrays as Python's own.
py::object plain(const py::handle& value) {
  const bool is_numpy = py::isinstance<py::array>(value) ||
                        py::isinstance(value, py::module_::import("numpy").attr("generic"));
  return is_numpy ? value.attr("tolist")() : py::reinterpret_borrow<py::object>(value);
}

class JsonMaker {
 public:
  JsonMaker(std::string_view what, const std::function<std::string(const py::handle&)>& on_other)
      : what_(what), on_other_(on_other) {}

  nlohmann::json make(const py::handle& given, const std::string& place, int level = 0) const {
    const std::string here =
        place.empty() ? std::string(what_) : fmt::format("{}: {}", what_, place);
    if (level > most_levels) throw InputError(here + ": nested too deeply");
    if (on_other_)
      if (std::string text = on_other_(given); !text.empty()) return text;
    refuse_masked(given, here);
    const py::object value = plain(given);
    if (value.is_none()) return nullptr;
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::int_>(value)) return integer_of(value, here);
    if (py::isinstance<py::float_>(value)) return number_of(value, here);
    if (is_mapping(value)) return object(value, place, level);
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
      return array(value, place, level);
    return path_of(value, here);
  }

 private:
  nlohmann::json object(const py::handle& value, const std::string& place, int level) const {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [key, item] : py::dict(py::reinterpret_borrow<py::object>(value))) {
      const std::string name = text_of(key, fmt::format("{}: {}: a key", what_, place));
      json[name] = make(item, place.empty() ? name : place + '.' + name, level + 1);
    }
    return json;
  }

  nlohmann::json array(const py::handle& value, const std::string& place, int level) const {
    nlohmann::json json = nlohmann::json::array();
    for (const py::handle& item : py::reinterpret_borrow<py::sequence>(value))
      json.push_back(make(item, fmt::format("{}[{}]", place, json.size()), level + 1));
    return json;
  }

  std::string_view what_;
  const std::function<std::string(const py::handle&)>& on_other_;
};

/// An array of any kind; what NumPy cannot make one of is refused.
py::array any_array(const py::handle& value, std::string_view what) {
  refuse_masked(value, what);
  py::array array = py::array::ensure(value);
  if (!array) refuse(what, value, "an array of numbers");
  return array;
}

void check_kind(const py::array& array, std::string_view kinds, std::string_view accepted,
                std::string_view what) {
  if (kinds.find(array.dtype().kind()) == std::string_view::npos)
    throw InputError(fmt::format("{}: an array of type {}; accepted: {}", what,
                                 std::string(py::str(array.dtype())), accepted));
}

void check_shape(const py::array& array, py::ssize_t columns, std::string_view what) {
  const bool fits =
      columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (fits) return;
  throw InputError(fmt::format("{}: an array of shape {}; accepted: {}", what, shape_text(array),
                               columns == 0 ? "(N,)" : fmt::format("(N, {})", columns)));
}

/// What is beyond would come out negative.
void check_signed(const py::array& array, std::string_view what) {
  constexpr auto most = std::uint64_t(std::numeric_limits<std::int64_t>::max());
  const auto numbers =
      py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  for (py::ssize_t i = 0; i < numbers.size(); ++i)
    if (numbers.data()[i] > most)
      throw InputError(fmt::format("{}: {}; accepted: at most {}", what, numbers.data()[i], most));
}

}  // namespace

bool is_mapping(const py::handle& value) {
  return py::isinstance<py::dict>(value) ||
         py::isinstance(value, py::module_::import("collections.abc").attr("Mapping"));
}

void refuse_masked(const py::handle& value, std::string_view what) {
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
    for (const py::handle& item : py::reinterpret_borrow<py::sequence>(value))
      if (py::isinstance<py::array>(item)) refuse_masked(item, what);  // NumPy drops a row's mask
  if (!py::isinstance<py::array>(value)) return;
  if (!py::module_::import("numpy.ma").attr("is_masked")(value).cast<bool>()) return;
  throw InputError(fmt::format(
      "{}: a masked array, some of whose values are masked; accepted: an array without a mask, "
      "such as its .filled(0)",
      what));
}

std::string text_of(const py::handle& value, std::string_view what) {
  if (!py::isinstance<py::str>(value)) refuse(what, value, "text");
  return utf8_of(value, what);
}

std::string path_of(const py::handle& value, std::string_view what) {
  if (py::isinstance<py::str>(value)) return utf8_of(value, what);
  if (!py::hasattr(value, "__fspath__")) refuse(what, value, "text or a path");
  const py::object path = value.attr("__fspath__")();
  return py::isinstance<py::bytes>(path) ? path.cast<std::string>() : text_of(path, what);
}

std::vector<std::string> texts_of(const py::handle& value, std::string_view what) {
  if (py::isinstance<py::str>(value)) return {utf8_of(value, what)};
  if (!py::isinstance<py::sequence>(value)) refuse(what, value, "texts, as a list or a tuple");
  std::vector<std::string> texts;
  for (const py::handle& item : py::reinterpret_borrow<py::sequence>(value))
    texts.push_back(text_of(item, what));
  return texts;
}

double number_of(const py::handle& value, std::string_view what) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred()) {
    PyErr_Clear();
    refuse(what, value, "a number");
  }
  if (!std::isfinite(number))
    throw InputError(fmt::format("{}: {}; accepted: a finite number", what, number));
  return number;
}

long long integer_of(const py::handle& value, std::string_view what) {
  if (!PyIndex_Check(value.ptr())) refuse(what, value, "a whole number");
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const long long number = index ? PyLong_AsLongLong(index.ptr()) : -1;
  if (number != -1 || !PyErr_Occurred()) return number;
  PyErr_Clear();
  throw InputError(fmt::format("{}: a number that is too large; accepted: one of 64 bits", what));
}

nlohmann::json json_of(const py::handle& value, std::string_view what,
                       const std::function<std::string(const py::handle&)>& on_other) {
  return JsonMaker(what, on_other).make(value, "");
}

py::object python_of(const nlohmann::json& json) {
  if (json.is_null()) return py::none();
  if (json.is_boolean()) return py::bool_(json.get<bool>());
  if (json.is_number_unsigned()) return py::int_(json.get<std::uint64_t>());
  if (json.is_number_integer()) return py::int_(json.get<std::int64_t>());
  if (json.is_number()) return py::float_(json.get<double>());
  if (json.is_string()) return py::str(json.get_ref<const std::string&>());
  if (json.is_array()) {
    py::list list;
    for (const nlohmann::json& item : json) list.append(python_of(item));
    return list;
  }
  py::dict dict;
  for (const auto& [key, item] : json.items()) dict[py::str(key)] = python_of(item);
  return dict;
}

py::array_t<double, py::array::c_style> numbers_of(const py::handle& value, py::ssize_t columns,
                                                   std::string_view what) {
  const py::array array = any_array(value, what);
  check_kind(array, "fiu", "real numbers", what);
  check_shape(array, columns, what);
  return py::array_t<double, py::array::c_style | py::array::forcecast>(array);
}

py::array_t<std::int64_t, py::array::c_style> integers_of(const py::handle& value,
                                                          py::ssize_t columns,
                                                          std::string_view what) {
  const py::array array = any_array(value, what);
  check_kind(array, "iu", "whole numbers", what);
  check_shape(array, columns, what);
  if (array.dtype().kind() == 'u' && array.itemsize() == 8) check_signed(array, what);
  return py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
}

std::vector<Vec3> vectors_of(const py::handle& value, std::string_view what) {
  const auto array = numbers_of(value, 3, what);
  std::vector<Vec3> vectors(std::size_t(array.shape(0)));
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  std::memcpy(vectors.data(), array.data(), vectors.size() * sizeof(Vec3));
  return vectors;
}

std::vector<Rgba> colors_of(const py::handle& value, py::ssize_t dimensions, std::string_view what,
                            std::vector<py::ssize_t>* shape) {
  const py::array given = any_array(value, what);
  check_kind(given, "fu", "real numbers, or bytes", what);
  const bool bytes = given.dtype().kind() == 'u';
  const py::ssize_t channels = given.ndim() == dimensions ? given.shape(dimensions - 1) : 0;
  if ((channels != 3 && channels != 4) || (bytes && given.itemsize() != 1))
    throw InputError(
        fmt::format("{}: an array of type {} and shape {}; accepted: {} of floats, or of "
                    "uint8 as n/255",
                    what, std::string(py::str(given.dtype())), shape_text(given),
                    dimensions == 3 ? "(H, W, 3) or (H, W, 4)" : "(N, 3) or (N, 4)"));
  if (shape) shape->assign(given.shape(), given.shape() + dimensions);
  const py::array_t<float, py::array::c_style | py::array::forcecast> array(given);
  std::vector<Rgba> colors(std::size_t(array.size() / channels));
  const float* values = array.data();
  for (Rgba& color : colors) {
    for (int c = 0; c < int(channels); ++c) color[c] = bytes ? values[c] / 255 : values[c];
    if (channels == 3) color.a = 1;
    values += channels;
  }
  return colors;
}

Image image_of(const py::handle& value, std::string_view what,
               std::vector<py::ssize_t>* shape_of_array) {
  std::vector<py::ssize_t>& shape = *shape_of_array;
  Image image;
  image.pixels = colors_of(value, 3, what, &shape);
  constexpr py::ssize_t most = 1 << 28;
  if (shape[0] > most || shape[1] > most || shape[0] * shape[1] > most)
    throw InputError(fmt::format("{}: a picture of more than 2^28 pixels", what));
  image.height = int(shape[0]);
  image.width = int(shape[1]);
  return image;
}

}  // namespace pellucid::python
