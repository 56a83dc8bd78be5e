#include "scene/scene_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "fields/make_field.h"
#include "geometry/mesh_file.h"
#include "integrators/integrate_surface.h"
#include "scene/appearance.h"
#include "scene/json_node.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

constexpr double any = std::numeric_limits<double>::max();
/// A picture of 2^28 pixels takes 4 GiB; anything larger is a slip of the hand.
constexpr int max_side = 1 << 14;

Camera read_camera(const JsonNode& node) {
  node.accept_keys({"type", "eye", "target", "up", "fov", "height"});
  Camera camera;
  const std::string type =
      node.has("type") ? node["type"].one_of({"perspective", "orthographic"}) : "perspective";
  if (type == "orthographic") camera.projection = Projection::orthographic;
  const std::string_view foreign = type == "orthographic" ? "fov" : "height";
  if (node.has(foreign))
    node[foreign].fail(fmt::format("a camera of type {} has none; it takes {}", type,
                                   type == "orthographic" ? "height" : "fov"));
  if (node.has("eye")) camera.eye = node["eye"].vec3();
  if (node.has("target")) camera.target = node["target"].vec3();
  if (node.has("up")) camera.up = node["up"].vec3();
  if (node.has("fov")) camera.fov = node["fov"].number(-any, any);
  if (node.has("height")) camera.height = node["height"].number(-any, any);
  return camera;
}

std::variant<std::monostate, Vec3, ScalarColor> read_color(const JsonNode& node) {
  if (node.is_array()) {
    const Vec3 rgb = node.vec3();
    for (const JsonNode& channel : node.elements()) channel.number(0, 1);
    return rgb;
  }
  node.accept_keys({"by", "map", "range"});
  ScalarColor color{node["by"].string(), "viridis", std::nullopt};
  if (node.has("map")) color.map = node["map"].string();
  if (node.has("range")) {
    const auto ends = node["range"].elements();
    if (ends.size() != 2) node["range"].fail("accepted: two numbers");
    color.range = Vec2(ends[0].number(-any, any), ends[1].number(-any, any));
  }
  return color;
}

Appearance read_appearance(const JsonNode& node) {
  Appearance appearance;
  if (node.has("color")) appearance.color = read_color(node["color"]);
  if (node.has("opacity")) appearance.opacity = node["opacity"].number(0, 1);
  if (node.has("importance")) appearance.importance = node["importance"].string();
  return appearance;
}

SeedCurve read_seed(const JsonNode& node) {
  node.accept_keys({"from", "to", "points", "spline", "closed", "center", "normal", "radius"});
  const bool closed = node.has("closed") && node["closed"].boolean();
  if (node.has("from")) return segment_seed(node["from"].vec3(), node["to"].vec3());
  if (node.has("center"))
    return circle_seed(node["center"].vec3(), node["normal"].vec3(), node["radius"].number(0, any));
  const bool spline = node.has("spline");
  std::vector<Vec3> points;
  for (const JsonNode& point : node[spline ? "spline" : "points"].elements())
    points.push_back(point.vec3());
  return spline ? spline_seed(points, closed) : polyline_seed(points, closed);
}

/// Runs `make` and puts the place in front of what it complains about.
template <class Make>
auto at_place(const JsonNode& node, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    node.fail(error.what());
  }
}

struct Loader {
  fs::path folder;
  Progress progress;
  Scene scene;

  TriangleMesh integrate(const JsonNode& node) {
    node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "path"});
    const std::string field_text = node["field"].string();
    const std::string integrator = node["integrator"].string();
    const auto field = at_place(node["field"], [&] { return make_field(field_text, folder); });
    SurfaceRequest request;
    request.field = field.get();
    request.seed = at_place(node["seed"], [&] { return read_seed(node["seed"]); });
    request.duration = node["duration"].number(0, any);
    if (node.has("start_time")) request.start_time = node["start_time"].number(-any, any);
    if (node.has("path")) request.path = node["path"].boolean();
    request.progress = progress;
    IntegratedSurface surface =
        at_place(node, [&] { return integrate_surface(integrator, request); });
    scene.provenance[node.place()] =
        fmt::format("{}, {}, {} particles, {} triangles", field->description(), integrator,
                    surface.stats.particles, surface.mesh.triangles.size());
    return std::move(surface.mesh);
  }

  TriangleMesh load_mesh(const JsonNode& node) {
    const fs::path path = folder / node.string();
    TriangleMesh mesh = at_place(node, [&] { return read_mesh(path); });
    scene.provenance[node.place()] =
        fmt::format("{}, {} triangles", path.filename().string(), mesh.triangles.size());
    return mesh;
  }

  void add_object(const JsonNode& node) {
    node.accept_keys({"name", "mesh", "surface", "color", "opacity", "importance"});
    if (node.has("mesh") == node.has("surface"))
      node.fail("accepted: exactly one of the keys mesh, surface");
    SceneObject object{node.place(), {}};
    if (node.has("name")) object.name = node["name"].string();
    const Appearance appearance = read_appearance(node);
    object.mesh = node.has("mesh") ? load_mesh(node["mesh"]) : integrate(node["surface"]);
    if (object.mesh.triangles.empty()) node.fail("nothing to draw: it has no triangle");
    at_place(node, [&] { apply_appearance(appearance, object.mesh); });
    if (scene.lighting != Lighting::none) ensure_normals(object.mesh);
    scene.objects.push_back(std::move(object));
  }

  void read(const JsonNode& root) {
    root.accept_keys(
        {"format", "version", "resolution", "camera", "background", "lighting", "objects"});
    root["format"].one_of({"pellucid-scene"});
    root["version"].integer(1, 1);
    if (root.has("resolution")) {
      const auto sides = root["resolution"].elements();
      if (sides.size() != 2) root["resolution"].fail("accepted: two integers, width and height");
      scene.width = sides[0].integer(1, max_side);
      scene.height = sides[1].integer(1, max_side);
    }
    // A wrong camera is refused before anything is integrated.
    if (root.has("camera")) {
      scene.camera = read_camera(root["camera"]);
      at_place(root, [&] { return camera_frame(scene.camera); });
    }
    if (root.has("background")) {
      scene.background = root["background"].vec3();
      for (const JsonNode& channel : root["background"].elements()) channel.number(0, 1);
    }
    if (root.has("lighting") && root["lighting"].one_of({"none", "headlight"}) == "headlight")
      scene.lighting = Lighting::headlight;
    const auto objects = root["objects"].elements();
    if (objects.empty()) root["objects"].fail("the scene is empty; accepted: at least one object");
    for (std::size_t i = 0; i < objects.size(); ++i) {
      report(progress, double(i) / double(objects.size()), "loading " + objects[i].place());
      add_object(objects[i]);
    }
    if (!root.has("camera")) scene.camera = fitted_camera(scene.bounds());
  }
};

}  // namespace

Scene load_scene(const fs::path& path, const Progress& progress) {
  const nlohmann::json json = read_json(path);
  Loader loader{path.parent_path(), progress, {}};
  loader.scene.name = path.stem().string();
  loader.read(JsonNode(path.string(), json));
  return std::move(loader.scene);
}

}  // namespace pellucid
