// SPDX-License-Identifier: GPL-3.0-or-later
// Every crossing of a pixel's ray, or of all, as flat arrays.

#include <fmt/format.h>

#include <array>

#include "core/error.h"
#include "groundtruth/sums/picture_sums.h"
#include "module/scene.h"
#include "module/values.h"
#include "module/work.h"

namespace pellucid::python {
namespace {

using groundtruth::RayLayer;
using groundtruth::RaySums;

/// A Layers object holds crossings one after another, front to back along each ray.
struct Layers {
  std::vector<double> depth, d, opacity, importance, transmittance, importance_sum, optical_depth;
  std::vector<std::uint32_t> object, primitive;
  std::vector<Vec3> color;

  void append(const RayLayer& layer) {
    for (const auto& [values, number] : {std::pair(&depth, layer.depth),
                                         {&d, layer.d},
                                         {&opacity, layer.opacity},
                                         {&importance, layer.importance},
                                         {&transmittance, layer.transmittance},
                                         {&importance_sum, layer.importance_sum},
                                         {&optical_depth, layer.optical_depth}})
      values->push_back(number);
    object.push_back(layer.object);
    primitive.push_back(layer.primitive);
    color.push_back(layer.color);
  }
};

/// Crossings are those of one ray.
struct Crossings {
  std::shared_ptr<Layers> layers;
  Vec3 color{0};
  double transmittance = 1;
};

/// A Deep is the crossings of all pixels.
struct Deep {
  std::shared_ptr<Layers> layers;
  std::shared_ptr<std::vector<std::uint64_t>> offsets;
  int width = 0, height = 0;
};

Crossings crossings_of(const RaySums& sums) {
  Crossings crossings{std::make_shared<Layers>(), sums.color, sums.transmittance};
  for (const RayLayer& layer : sums.layers) crossings.layers->append(layer);
  return crossings;
}

void check_pixel(const scene::Scene& scene, long long x, long long y) {
  if (x < 0 || x >= scene.width || y < 0 || y >= scene.height)
    throw InputError(fmt::format("crossings: pixel ({}, {}); accepted: from (0, 0) to ({}, {})", x,
                                 y, scene.width - 1, scene.height - 1));
}

Crossings crossings_at(Scene& scene, const py::object& column, const py::object& row) {
  const long long x = integer_of(column, "crossings: x"), y = integer_of(row, "crossings: y");
  return result_unlocked([&](const Progress&) {
    scene.with([&](const scene::Scene& s) { check_pixel(s, x, y); });
    return scene.with_probe([&](const scene::Scene&, const groundtruth::RayProbe& probe) {
      return crossings_of(probe.at(double(x) + 0.5, double(y) + 0.5));
    });
  });
}

Deep deep_of(const scene::Scene& scene, const groundtruth::RayProbe& probe,
             const Progress& progress) {
  if (!scene.samples.is_center())
    throw InputError(fmt::format("deep: the scene takes {}; accepted: samples 1",
                                 scene::describe(scene.samples)));
  Deep deep{std::make_shared<Layers>(), std::make_shared<std::vector<std::uint64_t>>(1, 0),
            scene.width, scene.height};
  for (int y = 0; y < scene.height; ++y) {
    report(progress, double(y) / scene.height, "deep picture");
    for (const RaySums& sums : groundtruth::row_sums(scene, probe, y)) {
      for (const RayLayer& layer : sums.layers) deep.layers->append(layer);
      deep.offsets->push_back(deep.layers->depth.size());
    }
  }
  return deep;
}

Deep deep(Scene& scene) {
  return result_unlocked([&](const Progress& progress) {
    return scene.with_probe([&](const scene::Scene& s, const groundtruth::RayProbe& probe) {
      return deep_of(s, probe, progress);
    });
  });
}

template <class T>
py::array flat(const std::shared_ptr<Layers>& layers, const std::vector<T>& values) {
  return array_over(layers, values.data(), {py::ssize_t(values.size())});
}

template <class Kind, class T>
void define_array(py::class_<Kind>& kind, const char* name, std::vector<T> Layers::*member,
                  const char* doc) {
  kind.def_property_readonly(
      name, [member](const Kind& k) { return flat(k.layers, (*k.layers).*member); }, doc);
}

template <class Kind>
void define_layers(py::class_<Kind>& kind) {
  define_array(kind, "depth", &Layers::depth, "View depth, world units: float64 (N,).");
  define_array(kind, "d", &Layers::d, "Depth in (0, 1) between the scene's ends: float64 (N,).");
  define_array(kind, "object", &Layers::object, "Index of the scene's object: uint32 (N,).");
  define_array(kind, "primitive", &Layers::primitive,
               "Index of the object's primitive: a triangle, of which a ribbon has two for each "
               "segment; a segment of a tube; a point; a cell: uint32 (N,).");
  define_array(kind, "opacity", &Layers::opacity, "α in [0, 1]: float64 (N,).");
  define_array(kind, "importance", &Layers::importance, "g in [0, 1]: float64 (N,).");
  define_array(kind, "transmittance", &Layers::transmittance,
               "Π (1 - α) of all that lies in front: float64 (N,).");
  define_array(kind, "importance_sum", &Layers::importance_sum,
               "G, the sum of g² up to and with this crossing: float64 (N,).");
  define_array(kind, "optical_depth", &Layers::optical_depth,
               "τ, the sum of -ln(1 - α) up to and with this crossing: float64 (N,).");
  kind.def_property_readonly(
      "color",
      [](const Kind& k) {
        return array_over(k.layers, reinterpret_cast<const double*>(k.layers->color.data()),
                          {py::ssize_t(k.layers->color.size()), 3});
      },
      "Straight red, green, blue, lit: float64 (N, 3).");
  kind.def("__len__", [](const Kind& k) { return k.layers->depth.size(); });
}

void define_crossings(py::module_& module) {
  py::class_<Crossings> kind(module, "Crossings",
                             "All crossings of one ray, front to back, up to and with the first "
                             "opaque one; arrays share their memory.");
  define_layers(kind);
  kind.def_property_readonly(
          "pixel_color",
          [](const Crossings& c) { return py::make_tuple(c.color.x, c.color.y, c.color.z); },
          "The exact composite over the background: red, green, blue.")
      .def_property_readonly(
          "pixel_transmittance", [](const Crossings& c) { return c.transmittance; },
          "Transmittance of all layers, in [0, 1].")
      .def("__repr__", [](const Crossings& c) {
        return fmt::format("<pellucid.Crossings: {}>", c.layers->depth.size());
      });
}

void define_deep(py::module_& module) {
  py::class_<Deep> kind(module, "Deep",
                        "All crossings of all pixels in flat arrays: those of the pixel in column "
                        "x, row y (0 on top) "
                        "are offsets[y * W + x] to offsets[y * W + x + 1] - 1, front to back.");
  define_layers(kind);
  kind.def_property_readonly(
          "offsets",
          [](const Deep& d) {
            return array_over(d.offsets, d.offsets->data(), {py::ssize_t(d.offsets->size())});
          },
          "Where the pixels' crossings begin and end: uint64 (W * H + 1,).")
      .def_property_readonly(
          "shape", [](const Deep& d) { return py::make_tuple(d.height, d.width); },
          "Height and width of the picture, pixels.")
      .def("__repr__", [](const Deep& d) {
        return fmt::format("<pellucid.Deep: {} crossings of {} × {} pixels>",
                           d.layers->depth.size(), d.width, d.height);
      });
}

}  // namespace

void define_rays(py::module_& module, py::class_<Scene, std::shared_ptr<Scene>>& scene) {
  define_crossings(module);
  define_deep(module);
  scene
      .def("crossings", crossings_at, py::arg("x"), py::arg("y"),
           "Returns all crossings of the ray through the centre of the pixel in column x, row y (0 "
           "on top). Raises InputError for a pixel outside the picture.")
      .def("deep", deep,
           "Returns all crossings of the rays through all pixels' centres, about 90 bytes each. "
           "Raises InputError for a scene of several samples per pixel.");
}

}  // namespace pellucid::python
