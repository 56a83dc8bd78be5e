// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/scene_bounds.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/parts/load_part.h"
#include "compare/parts/scene_fingerprint.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_node.h"
#include "core/files/output_file.h"
#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* format = "pellucid-bounds";
constexpr double any = std::numeric_limits<double>::max();

std::map<std::string, std::string> hashes_of(const std::set<fs::path>& files) {
  ContentHashes hashes;
  std::map<std::string, std::string> by_path;
  for (const fs::path& file : files) by_path[file.string()] = hashes.of(file);
  return by_path;
}

json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 read_vec(const JsonNode& node) {
  const std::vector<JsonNode> numbers = node.elements();
  if (numbers.size() != 3) node.fail("accepted: three numbers");
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = numbers[std::size_t(axis)].number(-any, any);
  return v;
}

}  // namespace

SceneBounds measure_bounds(const fs::path& path, const scene::ViewRequest& view,
                           const Progress& progress) {
  const FilesRead read;
  const MeasuredScene measured = measure_scene(path, part_of(progress, 0, 0.5, ""), view);
  if (measured.any_halo)
    throw InputError(
        fmt::format("{}: it has halos, which lie around whole lines; accepted: a scene without",
                    path.string()));
  groundtruth::PartCutter cutter(measured.scene, measured.bounds, measured.counts, {1, 1});
  const scene::Scene scene = scene::load_scene_by_objects(
      path, part_of(progress, 0.5, 1, ""), view, [&](scene::SceneObject& object, std::size_t) {
        cutter.cut(object);
        object.shape = geometry::TriangleMesh();
      });
  const groundtruth::WholeScene whole = cutter.whole(scene);
  return {scene_fingerprint(read.paths(), ""),
          hashes_of(read.paths()),
          scene::camera_text(scene.camera),
          scene.width,
          scene.height,
          measured.bounds,
          whole.depths,
          whole.largest,
          measured.counts};
}

void write_bounds(const fs::path& path, const SceneBounds& bounds) {
  const json text{{"format", format},
                  {"version", 1},
                  {"fingerprint", bounds.fingerprint},
                  {"files", bounds.files},
                  {"camera", bounds.camera},
                  {"resolution", {bounds.width, bounds.height}},
                  {"box", {to_json(bounds.box.min), to_json(bounds.box.max)}},
                  {"depths", {bounds.depths.near, bounds.depths.far}},
                  {"largest", bounds.largest},
                  {"counts", bounds.counts}};
  write_text(path, json_text(text, 1) + '\n');
}

SceneBounds read_bounds(const fs::path& path) {
  const json text = read_json(path);
  const JsonNode root(path.string(), text);
  root["format"].one_of({format});
  root.accept_keys({"format", "version", "fingerprint", "files", "camera", "resolution", "box",
                    "depths", "largest", "counts"});
  root["version"].integer(1, 1);
  SceneBounds bounds;
  bounds.fingerprint = root["fingerprint"].string();
  for (const std::string& file : root["files"].keys())
    bounds.files[file] = root["files"][file].string();
  bounds.camera = root["camera"].string();
  const auto pair = [](const JsonNode& node) {
    std::vector<JsonNode> two = node.elements();
    if (two.size() != 2) node.fail("accepted: a list of two");
    return two;
  };
  constexpr int most_pixels = 1 << 24;
  const auto size = pair(root["resolution"]), box = pair(root["box"]),
             depths = pair(root["depths"]);
  bounds.width = size[0].integer(1, most_pixels);
  bounds.height = size[1].integer(1, most_pixels);
  bounds.box = {read_vec(box[0]), read_vec(box[1])};
  bounds.depths = {depths[0].number(-any, any), depths[1].number(-any, any)};
  bounds.largest = root["largest"].number(0, any);
  constexpr double most_elements = 1LL << 53;
  for (const JsonNode& count : root["counts"].elements())
    bounds.counts.push_back(std::uint64_t(count.number(0, most_elements)));
  return bounds;
}

void check_unchanged(const SceneBounds& bounds, const std::set<fs::path>& files_read) {
  for (const auto& [file, hash] : hashes_of(files_read)) {
    const auto known = bounds.files.find(file);
    if (known == bounds.files.end() || known->second != hash)
      throw InputError(fmt::format(
          "{}: --bounds are not of it: it {}; accepted: those that 'render SCENE --bounds' writes "
          "of "
          "the scene as it is, on this machine",
          file, known == bounds.files.end() ? "was not read then" : "has changed since"));
  }
}

}  // namespace pellucid::compare
