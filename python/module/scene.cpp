// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/scene.h"

#include <fmt/format.h>

#include <functional>

#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/picture_pair.h"
#include "compare/pictures/png_file.h"
#include "compare/results/render_json.h"
#include "core/error.h"
#include "module/shapes.h"
#include "module/values.h"
#include "module/work.h"
#include "scene/files/camera_file.h"
#include "scene/halo.h"

namespace pellucid::python {
namespace {

/// The shapes that a scene's text has named until now.
class ShapeNames {
 public:
  /// Returns the text that stands for the shape; empty for what is none.
  std::string name(const py::handle& value) {
    const Shape* shape = shape_in(value);
    if (!shape) return {};
    std::string name = fmt::format("<pellucid {} {}>", shape->key(), given_.size());
    given_[name] = shape->shape;
    return name;
  }
  scene::GivenShapes take() { return std::move(given_); }

 private:
  scene::GivenShapes given_;
};

nlohmann::json scene_text(const py::handle& value, std::string_view what, ShapeNames& names) {
  return json_of(value, what, [&](const py::handle& other) { return names.name(other); });
}

std::shared_ptr<Scene> scene_of_dict(const py::handle& dict, const std::string& folder) {
  ShapeNames names;
  nlohmann::json text = scene_text(dict, "scene", names);
  text.emplace("format", "pellucid-scene");
  text.emplace("version", 1);
  const scene::SceneSource source{"scene", folder, names.take()};
  return std::make_shared<Scene>(
      result_unlocked([&](const Progress& p) { return scene::read_scene(text, source, p); }),
      folder);
}

std::shared_ptr<Scene> load_scene(const py::object& what, const py::object& folder) {
  const std::string start = folder.is_none() ? "" : path_of(folder, "load_scene: folder");
  if (is_mapping(what)) return scene_of_dict(what, start);
  const std::filesystem::path path = std::filesystem::path(start) / path_of(what, "load_scene");
  return std::make_shared<Scene>(
      result_unlocked([&](const Progress& p) { return scene::load_scene(path, p); }),
      path.parent_path());
}

void add(Scene& scene, const py::object& object, const py::kwargs& keys) {
  ShapeNames names;
  nlohmann::json text = scene_text(object, "object", names);
  if (const Shape* shape = shape_in(object)) text = nlohmann::json::object({{shape->key(), text}});
  if (!text.is_object())
    throw InputError("add: accepted: a Mesh, Lines, Points, or an object of a scene as a dict");
  const nlohmann::json further = scene_text(keys, "object", names);
  for (const auto& [key, value] : further.items())
    if (!text.emplace(key, value).second)
      throw InputError(fmt::format("add: {}: the object has one; accepted: each key once", key));
  const scene::SceneSource source{"scene", scene.folder(), names.take()};
  run_unlocked([&](const Progress& progress) {
    scene.change([&](scene::Scene& s) { scene::append_object(text, source, s, progress); });
  });
}

compare::MethodCall call_of(const py::handle& method) {
  return compare::parse_call(text_of(method, "render: method"));
}

struct RenderRequest {
  compare::MethodCall call;
  std::optional<compare::MethodCall> opacities;
  std::string gl;
  bool warm_up = true;
};

Rendering render_now(const scene::Scene& scene, const RenderRequest& request,
                     const Progress& progress) {
  const auto renderer = request.call.row->make(scene, request.call.parameters, {.gl = request.gl});
  report(progress, 0, "rendering");
  if (request.warm_up) renderer->render({.progress = progress});
  scene::Rendering made = renderer->render({.layers = true, .progress = progress});
  compare::require_finite(made.image, request.call.text());
  Rendering rendering;
  rendering.stats =
      compare::render_json(request.call, request.opacities, scene, made.stats, *renderer);
  rendering.form = compare::form_of_picture(
      scene, {request.call.text(), request.opacities ? request.opacities->text() : "", false});
  rendering.image = std::make_shared<Image>(std::move(made.image));
  rendering.layers = std::make_shared<CountImage>(std::move(made.layers));
  return rendering;
}

/// With optimized opacities the scene is another one.
Rendering render_asked(const scene::Scene& scene, const RenderRequest& request,
                       const Progress& progress) {
  if (!request.opacities) return render_now(scene, request, progress);
  scene::Scene optimized = scene;
  compare::optimize_opacities(*request.opacities, {.gl = request.gl}, optimized,
                              compare::further_samplings({&request.call, 1}));
  return render_now(optimized, request, progress);
}

Rendering render(const Scene& scene, const py::object& method, const py::object& opacities,
                 bool warm_up, const py::object& gl) {
  RenderRequest request{call_of(method), std::nullopt, text_of(gl, "render: gl"), warm_up};
  if (!opacities.is_none())
    request.opacities = compare::parse_opacities(text_of(opacities, "render: opacities"));
  return result_unlocked([&](const Progress& progress) {
    return scene.with([&](const scene::Scene& s) { return render_asked(s, request, progress); });
  });
}

py::object image_array(const Rendering& rendering) {
  const Image& image = *rendering.image;
  return array_over(rendering.image, reinterpret_cast<const float*>(image.pixels.data()),
                    {image.height, image.width, 4}, true);
}

py::object layers_array(const Rendering& rendering) {
  const CountImage& layers = *rendering.layers;
  if (layers.pixels.empty()) return py::none();
  return array_over(rendering.layers, layers.pixels.data(), {layers.height, layers.width}, true);
}

void save_rendering(const Rendering& rendering, const py::object& path) {
  const std::string file = path_of(path, "save: path");
  run_unlocked(
      [&](const Progress&) { compare::write_image(file, *rendering.image, rendering.form); });
}

nlohmann::json numbers(const Vec3& x) { return {x.x, x.y, x.z}; }

/// Looks at the scene without Python's lock, as every thread does that waits for it.
template <class Look>
auto look_at(const Scene& scene, const Look& look) {
  const py::gil_scoped_release unlocked;
  return scene.with(look);
}

using SceneClass = py::class_<Scene, std::shared_ptr<Scene>>;

/// A key of a scene file as a property that may be set.
void define_view_key(SceneClass& kind, const char* key,
                     std::function<nlohmann::json(const scene::Scene&)> get, const char* doc) {
  kind.def_property(
      key, [get](const Scene& scene) { return python_of(look_at(scene, get)); },
      [key](Scene& scene, const py::object& value) {
        const nlohmann::json text{{key, json_of(value, fmt::format("scene: {}", key))}};
        run_unlocked([&](const Progress&) { scene.set_view(text); });
      },
      doc);
}

void define_view(SceneClass& kind) {
  using S = scene::Scene;
  define_view_key(
      kind, "resolution",
      [](const S& s) {
        return nlohmann::json{s.width, s.height};
      },
      "Width and height of the picture, pixels.");
  define_view_key(
      kind, "samples", [](const S& s) { return nlohmann::json(scene::samples_json(s.samples)); },
      "Samples per pixel along each axis; or {'frames': n}, so many places of the camera within a "
      "pixel.");
  define_view_key(
      kind, "camera", [](const S& s) { return nlohmann::json(scene::camera_json(s.camera)); },
      "The camera, a dict as in a scene file: eye, target, up in world units, fov in degrees.");
  define_view_key(
      kind, "background", [](const S& s) { return numbers(s.background); },
      "Red, green, blue in [0, 1].");
  define_view_key(
      kind, "lighting", [](const S& s) { return nlohmann::json(name_of(s.lighting)); },
      "'none', 'headlight' or 'phong'.");
}

constexpr const char* load_doc =
    R"(Loads a scene file, or makes a scene of a dict with the same keys.

In a dict a Mesh, Lines or Points stands where a file's name may: {"mesh": Mesh(...)}; "format" and
"version" may be left out. Relative paths start at the scene file, or at `folder`. Raises InputError.)";

constexpr const char* render_doc =
    R"(Renders the scene by a method, such as 'raytrace' or 'fourier:bands=5' (`pellucid list methods`).

opacities: composite the opacities that this call finds, such as 'decoupled-lists'. warm_up: as the
command line does, render twice and time the second picture; False halves the wait, and the times of
OpenGL's methods then have compiling in them. gl: as `--gl` of the command line.)";

constexpr const char* add_doc =
    R"(Adds a Mesh, Lines, Points, or an object of a scene file as a dict, with further keys of such an
object: add(mesh, opacity=0.4, color={'by': 'speed', 'map': 'viridis'}). Lines and points need a radius,
in world units, or by a scalar: radius={'by': 'thickness'}. A camera that was not given is fitted again. Raises InputError.)";

void define_scene_class(SceneClass& kind) {
  kind.def("render", render, py::arg("method") = "raytrace", py::kw_only(),
           py::arg("opacities") = py::none(), py::arg("warm_up") = true, py::arg("gl") = "osmesa",
           render_doc)
      .def("add", add, py::arg("object"), add_doc)
      .def_property_readonly(
          "objects",
          [](const Scene& scene) {
            return python_of(look_at(scene, [](const scene::Scene& s) {
              nlohmann::json names = nlohmann::json::array();
              for (const scene::SceneObject& object : s.objects) names.push_back(object.name);
              return names;
            }));
          },
          "The objects' names in their order, a list.")
      .def("__repr__", [](const Scene& scene) {
        return look_at(scene, [](const scene::Scene& s) {
          return fmt::format("<pellucid.Scene: {}, {} × {} pixels>", scene::describe_primitives(s),
                             s.width, s.height);
        });
      });
  define_view(kind);
}

void define_rendering(py::module_& module) {
  py::class_<Rendering>(module, "Rendering", "A picture and what it took; a notebook shows it.")
      .def_property_readonly("image", image_array,
                             "Red, green, blue over the background and A = 1 - transmittance: "
                             "float32 (H, W, 4), row 0 on top.")
      .def_property_readonly("layers", layers_array, "Crossings per pixel: uint32 (H, W).")
      .def_property_readonly(
          "stats", [](const Rendering& r) { return python_of(r.stats); },
          "What `render --stats` writes, a dict: seconds, bytes, fragments, max_layers, machine, "
          "view, …")
      .def("save", save_rendering, py::arg("path"),
           "Writes .exr (32-bit float) or .png (8 bits). Raises InputError for another ending.")
      .def("_repr_png_", [](const Rendering& r) { return py::bytes(png_of(*r.image)); })
      .def("__repr__", [](const Rendering& r) {
        return fmt::format("<pellucid.Rendering: {} × {} pixels by {}>", r.image->width,
                           r.image->height, r.stats.at("method").get<std::string>());
      });
}

}  // namespace

void Scene::change(const std::function<void(scene::Scene&)>& change) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) throw WorkError("the scene cannot change while another thread looks at it");
  probe_ = nullptr;
  change(scene_);
  if (!fits_camera_) return;
  scene_.camera = scene::fitted_camera(scene_);
  scene::place_halos(scene_);
}

void Scene::set_view(const nlohmann::json& text) {
  change([&](scene::Scene& s) {
    scene::change_view(text, folder_, s);
    if (text.contains("camera")) fits_camera_ = false;
  });
}

std::shared_ptr<const groundtruth::RayProbe> Scene::probe_of_now() {
  const std::lock_guard lock(probe_mutex_);
  if (!probe_) probe_ = std::make_shared<groundtruth::RayProbe>(scene_);
  return probe_;
}

std::string png_of(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgba& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) bytes.push_back(compare::displayed_byte(pixel[c]));
  return compare::encode_png("picture", image.width, image.height, 3, bytes, {});
}

void define_scene(py::module_& module) {
  define_rendering(module);  // first what later functions return
  SceneClass kind(module, "Scene", "What is drawn and how; made by load_scene().");
  define_rays(module, kind);
  define_scene_class(kind);
  module.def("load_scene", load_scene, py::arg("scene"), py::kw_only(),
             py::arg("folder") = py::none(), load_doc);
}

}  // namespace pellucid::python
