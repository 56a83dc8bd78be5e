// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/pictures/faults/given_faults.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/mask.h"
#include "compare/results/result_row.h"
#include "core/error.h"
#include "module/module.h"
#include "module/scene.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

/// The picture that Python names: a Rendering, an array, or a file.
compare::PictureRead picture_of(const py::object& value, std::string_view what) {
  if (py::isinstance<Rendering>(value)) return {*value.cast<Rendering&>().image};
  const bool is_file = py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__");
  if (!is_file) {
    std::vector<py::ssize_t> shape;
    Image image = image_of(value, what, &shape);
    return {std::move(image), shape.size() == 3 && shape[2] == 4};
  }
  const std::string file = path_of(value, what);
  return result_unlocked([&](const Progress&) { return compare::read_picture(file); });
}

/// JSON has no infinity, which a metric of equal pictures may be.
py::dict metrics_dict(const nlohmann::json& json, const compare::Metrics& metrics) {
  py::dict dict = python_of(json);
  for (std::size_t row = 0; row < compare::metrics().size(); ++row) {
    const compare::MetricRow& metric = compare::metrics()[row];
    if (json.contains(metric.name) && metrics[row])
      dict[py::str(std::string(metric.name))] = *metrics[row];
  }
  return dict;
}

/// Lists of lists, and arrays of one channel, as arrays of two dimensions; what is else as it is.
py::object flat_array(py::object value) {
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    value = py::array::ensure(value);
    if (!value) throw InputError("compare: mask: accepted: truth values or real numbers, (H, W)");
  }
  if (!py::isinstance<py::array>(value)) return value;
  const auto array = value.cast<py::array>();
  return array.ndim() == 3 && array.shape(2) == 1 ? value.attr("squeeze")(2) : value;
}

/// An array of two dimensions counts where it is not 0; a picture where it is at least half white.
std::optional<compare::Mask> mask_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  const py::object value = flat_array(given);
  const bool is_flat = py::isinstance<py::array>(value) && value.cast<py::array>().ndim() == 2;
  if (!is_flat) return compare::mask_of(picture_of(value, "compare: mask").image);
  refuse_masked(value, "compare: mask");
  if (std::string_view("biuf").find(value.cast<py::array>().dtype().kind()) ==
      std::string_view::npos)
    throw InputError("compare: mask: accepted: truth values or real numbers");
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (std::any_of(numbers.data(), numbers.data() + numbers.size(),
                  [](double x) { return std::isnan(x); }))
    throw InputError("compare: mask: not a number; accepted: truth values or real numbers");
  compare::Mask mask(int(numbers.shape(1)), int(numbers.shape(0)));
  std::transform(numbers.data(), numbers.data() + numbers.size(), mask.pixels.begin(),
                 [](double x) { return std::uint8_t(x != 0); });
  return mask;
}

/// The layers that a Rendering has counted.
const CountImage* layers_of(const py::object& value) {
  if (!py::isinstance<Rendering>(value)) return nullptr;
  const CountImage* layers = value.cast<Rendering&>().layers.get();
  return layers && !layers->pixels.empty() ? layers : nullptr;
}

py::dict compare_pictures(const py::object& reference, const py::object& test,
                          const py::object& where) {
  const compare::PictureRead a_read = picture_of(reference, "compare: a");
  const compare::PictureRead b_read = picture_of(test, "compare: b");
  const Image &a = a_read.image, &b = b_read.image;
  const std::optional<compare::Mask> mask = mask_of(where);
  const compare::PairRegions regions{mask ? &*mask : nullptr, layers_of(reference),
                                     layers_of(test)};
  const compare::Comparison comparison =
      result_unlocked([&](const Progress&) { return compare::compare_images(a, b, regions); });
  const nlohmann::json json = compare::to_json(comparison);
  py::dict dict = metrics_dict(json, comparison.linear);
  if (a_read.has_alpha && b_read.has_alpha)
    dict["max_alpha_error"] = compare::max_alpha_error(a, b);
  dict["displayed"] = metrics_dict(json.at("displayed"), comparison.displayed);
  const compare::PairFaults faults = result_unlocked([&](const Progress&) {
    return compare::pair_faults(a, b, a_read.has_alpha && b_read.has_alpha);
  });
  // Who asks for some pixels gets these alone.
  const std::vector<std::string> none;
  dict["faults"] = python_of(mask ? none : faults.of_test);
  dict["reference_faults"] = python_of(mask ? none : faults.of_reference);
  if (faults.straight) dict["note"] = *faults.straight;
  return dict;
}

constexpr const char* compare_doc = R"(Says how far picture b is from the reference a.

a, b: a Rendering, an array (H, W, 3) or (H, W, 4) of floats or of uint8 as n/255, or a picture's file.
mask: the pixels that count: an array (H, W), where it is not 0, or a picture, where it is at least half
white; all without one. Of a Rendering the layers tell covered pixels ('rmse_covered') and those with
equal layers ('rmse_equal').
Returns a dict of the numbers of `pellucid list metrics`, of the float values, and under 'displayed' of
the 8-bit values. None: the pictures are too small for it. 'faults' and 'reference_faults' say in words
what looks wrong with b, or with a, as a whole: turned, shifted, another background, a curve. Raises InputError for other sizes and for
values that are not finite.)";

}  // namespace

void define_compare(py::module_& module) {
  module.def("compare", compare_pictures, py::arg("a"), py::arg("b"), py::arg("mask") = py::none(),
             compare_doc);
}

}  // namespace pellucid::python
