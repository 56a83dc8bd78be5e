// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/export/export_scene.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/export/camera_matrices.h"
#include "compare/export/exported_object.h"
#include "compare/export/gltf.h"
#include "compare/pictures/image_file.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "groundtruth/methods/raytrace.h"
#include "scene/files/camera_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json rows_of(const Mat4& m) {
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) rows.push_back({m[0][i], m[1][i], m[2][i], m[3][i]});
  return rows;
}

Json camera_json(const scene::Camera& camera, const CameraMatrices& matrices) {
  const bool perspective = camera.projection == scene::Projection::perspective;
  return {{"type", perspective ? "perspective" : "orthographic"},
          {"view", rows_of(matrices.view)},
          {"projection", rows_of(matrices.projection)},
          {"eye", to_json(camera.eye)},
          {"target", to_json(camera.target)},
          {"up", to_json(camera.up)},
          {perspective ? "fov" : "height", perspective ? camera.fov : camera.height},
          {"near", matrices.near},
          {"far", matrices.far}};
}

Json object_json(const ExportedObject& object, const scene::SceneObject& given,
                 scene::Lighting lighting, const std::string& file) {
  const bool wide = object.kind != "triangles", one = wide && !object.radius.vary();
  return {{"file", file},
          {"name", given.name},
          {"kind", object.kind},
          {"radius", one ? Json(object.radius.largest()) : Json()},
          {"profile", wide ? Json(object.profile) : Json()},
          {"opaque", object.opaque},
          {"lighting", name_of(lighting)},
          {"lit", object.lit},
          {"vertices", object.vertices.positions.size()},
          {"count", object.count()}};
}

Json scene_json(const scene::Scene& scene, const scene::DepthRange& depths,
                const CameraMatrices& matrices) {
  return {{"format", "pellucid-export"},
          {"version", 1},
          {"name", scene.name},
          {"resolution", {scene.width, scene.height}},
          {"samples", scene::samples_json(scene.samples)},
          {"background", to_json(scene.background)},
          {"lighting", name_of(scene.lighting)},
          {"camera", camera_json(scene.camera, matrices)},
          {"depth", {{"near", depths.near}, {"far", depths.far}}},
          {"colour", "straight alpha, display values"},
          {"rows", "top first"},
          {"pixel", "centre"}};
}

void write_reference(const scene::Scene& scene, const fs::path& file, const Progress& progress) {
  const scene::MethodRow& row = groundtruth::raytrace_method();
  const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
  write_image(file, renderer->render({.progress = progress}).image,
              form_of_picture(scene, {std::string(row.name), "", false}));
}

}  // namespace

void export_scene(const scene::Scene& scene, const fs::path& folder, const ExportRequest& request) {
  const scene::DepthRange depths = scene::depth_range(scene);
  const CameraMatrices matrices = camera_matrices(scene, depths);
  Json json = scene_json(scene, depths, matrices);
  std::vector<ExportedObject> objects;
  double rounding = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    report(request.progress, 0.4 * double(i) / double(scene.objects.size()), "exporting");
    objects.push_back(exported_object(scene, i));
    const std::string file = fmt::format("object-{}.ply", i);
    write_exported_ply(folder / file, objects.back());
    const scene::Lighting lighting = scene::lighting_of(scene, scene.objects[i]);
    json["objects"].push_back(object_json(objects.back(), scene.objects[i], lighting, file));
    rounding = std::max(rounding, float_rounding(objects.back()));
  }
  json["rounding"] = rounding;
  const bool gltf = request.gltf && write_gltf(folder / "scene.glb", scene, matrices, objects);
  json["gltf"] = gltf ? Json("scene.glb") : Json();
  if (request.reference)
    write_reference(scene, folder / "reference.exr",
                    part_of(request.progress, 0.5, 1, "exact picture"));
  json["reference"] = request.reference ? Json("reference.exr") : Json();
  write_text(folder / exported_scene_name,
             json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void export_camera(const scene::Scene& scene, const fs::path& file) {
  const CameraMatrices matrices = camera_matrices(scene, scene::depth_range(scene));
  write_text(file, camera_json(scene.camera, matrices).dump(1) + '\n');
}

}  // namespace pellucid::compare
