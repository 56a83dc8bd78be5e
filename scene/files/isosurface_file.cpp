// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/isosurface_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "core/parallel.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/level_field.h"
#include "fields/levels/level_files.h"
#include "fields/levels/surface_extraction.h"
#include "fields/levels/vdb_levels.h"
#include "geometry/files/mesh_file.h"
#include "geometry/solid_mesh.h"
#include "scene/appearance/colormap.h"
#include "scene/datasets/dataset.h"
#include "scene/files/any_number.h"

namespace pellucid::scene {
namespace {

/// What a surface is drawn of, its own scalar first.
using LevelData = std::vector<fields::FileLevels>;

std::vector<JsonNode> files_of(const JsonNode& node) {
  const JsonNode file = node["file"];
  return file.is_array() ? file.elements() : std::vector{file};
}

/// The names of the data, as the scene has them.
std::string names_of(const JsonNode& node) {
  if (node.has("dataset")) return node["dataset"].string();
  std::vector<std::string> names;
  for (const JsonNode& file : files_of(node)) names.push_back(file.string());
  return fmt::format("{}", fmt::join(names, ", "));
}

LevelData generate(const JsonNode& node, std::span<const std::string> scalars) {
  const JsonNode dataset = node["dataset"];
  const auto velocity = at_place(dataset, [&] { return make_velocity_levels(dataset.string()); });
  LevelData data;
  for (const std::string& scalar : scalars) {
    fields::FileLevels made;
    made.levels = at_place(data.empty() ? node["scalar"] : node,
                           [&] { return fields::scalars_of(velocity, scalar); });
    made.range = fields::sample_range(made.levels);
    data.push_back(std::move(made));
  }
  return data;
}

/// "first", "last", or a number, as the fields' time=.
std::string read_time(const JsonNode& node) {
  if (!node.has("time")) return {};
  const JsonNode time = node["time"];
  return time.is_string() ? time.string() : fmt::format("{}", time.number(-any, any));
}

/// Adds the levels of one file.
void read_file(const std::filesystem::path& path, const JsonNode& node,
               std::span<const std::string> scalars, LevelData& data) {
  const std::string velocity = node.has("velocity") ? node["velocity"].string() : "";
  for (std::size_t i = 0; i < scalars.size(); ++i)
    append(fields::read_levels(path, scalars[i], velocity, read_time(node)), data[i]);
}

LevelData read_files(const JsonNode& node, const std::filesystem::path& folder,
                     std::span<const std::string> scalars) {
  LevelData data(scalars.size());
  for (fields::FileLevels& scalar : data) scalar.range = fields::sample_range({});
  for (const JsonNode& name : files_of(node))
    at_place(name, [&] { read_file(folder / name.string(), node, scalars, data); });
  return data;
}

bool on_same_samples(const fields::LevelField& a, const fields::LevelField& b) {
  return std::ranges::equal(a.levels(), b.levels(), [](const auto& p, const auto& q) {
    return p.origin == q.origin && p.width == q.width && p.size == q.size;
  });
}

/// What is not by a scalar stays the default's.
void color_vertices(const Isosurface& surface, geometry::TriangleMesh& mesh) {
  apply_appearance({}, mesh);
  parallel_for(std::size_t(0), mesh.positions.size(), [&](std::size_t i) {
    const Vec3& x = mesh.positions[i];
    Rgba& color = mesh.colors[i];
    if (const auto& by = surface.coloring) color = Rgba(by->color(by->scalar.fraction(x)), color.a);
    if (surface.fading) color.a = surface.fading->opacity(x);
  });
}

/// Triangles with a corner in the hole are left out.
geometry::TriangleMesh mesh_of(const Isosurface& surface) {
  fields::ExtractedSurface extracted = fields::extract_surface(*surface.field, surface.value);
  geometry::TriangleMesh mesh;
  mesh.positions = std::move(extracted.positions);
  mesh.normals = std::move(extracted.normals);
  std::ranges::copy_if(extracted.triangles, std::back_inserter(mesh.triangles), [&](const auto& t) {
    return std::ranges::none_of(
        t, [&](std::uint32_t corner) { return surface.cuts_away(mesh.positions[corner]); });
  });
  if (surface.coloring || surface.fading) color_vertices(surface, mesh);
  return mesh;
}

std::string describe(const fields::LevelField& field, const std::string& scalar) {
  std::vector<std::string> sizes;
  for (const fields::ScalarLevel& level : field.levels())
    sizes.push_back(fmt::format("{}", fmt::join(level.size, " × ")));
  return fmt::format("{} on {} samples, {}", scalar, fmt::join(sizes, " and "),
                     field.reconstruction().name);
}

decltype(Isosurface::hole) read_hole(const JsonNode& node, const std::filesystem::path& folder) {
  if (!node.has("mesh")) {
    node.accept_keys({"center", "radius", "mesh", "distance"});
    return Isosurface::Ball{node["center"].vec3(), node["radius"].number(0, any)};
  }
  node.accept_keys({"mesh", "distance"});
  const JsonNode mesh = node["mesh"];
  return Isosurface::Body{at_place(mesh,
                                   [&] {
                                     return std::make_shared<const geometry::SolidMesh>(
                                         geometry::read_mesh(folder / mesh.string()));
                                   }),
                          node.has("distance") ? node["distance"].number(0, any) : 0};
}

class IsosurfaceReader {
 public:
  IsosurfaceReader(const JsonNode& node, const std::filesystem::path& folder,
                   const Appearance& appearance)
      : node_(node),
        folder_(folder),
        color_(std::get_if<ScalarColor>(&appearance.color)),
        opacity_(std::get_if<ScalarOpacity>(&appearance.opacity)),
        reconstruction_(&reconstruction()) {}

  Isosurface read() {
    node_.accept_keys({"file", "dataset", "scalar", "value", "reconstruction", "hole", "mesh",
                       "velocity", "time"});
    Isosurface surface;
    surface.value = node_["value"].number(-any, any);
    LevelData scalars = read_levels();
    fields::FileLevels& own = scalars.front();
    refuse_value(surface.value, own);
    surface.field = field_on(rounded(std::move(own.levels), surface.value), std::move(own.gaps));
    surface.corners = corners_of(surface.field->bounds());
    for (const fields::FileLevels& scalar : scalars) add_remarks(scalar, surface.corners.remarks);
    if (color_)
      surface.coloring = {other_scalar(std::move(scalars[1].levels), *surface.field, *color_),
                          color_map(), color_->custom, color_->nan};
    if (opacity_)
      surface.fading = {other_scalar(std::move(scalars.back().levels), *surface.field, *opacity_),
                        opacity_->opacities};
    if (node_.has("hole")) surface.hole = read_hole(node_["hole"], folder_);
    return surface;
  }

 private:
  const fields::ReconstructionRow& reconstruction() const {
    return at_place(node_, [&]() -> const fields::ReconstructionRow& {
      return fields::find_reconstruction(
          node_.has("reconstruction") ? node_["reconstruction"].string() : "blend");
    });
  }

  /// Of the surface's scalar, then of its colour's, last of its opacity's.
  LevelData read_levels() const {
    if (node_.has("dataset") == node_.has("file"))
      node_.fail("accepted: one of the keys file, dataset");
    if (node_.has("velocity") && node_.has("dataset"))
      node_["velocity"].fail("names a grid of a file; accepted: with the key file");
    if (node_.has("time") && node_.has("dataset"))
      node_["time"].fail("is one of a file; accepted: with the key file");
    std::vector<std::string> scalars{node_["scalar"].string()};
    if (color_) scalars.push_back(color_->scalar);
    if (opacity_) scalars.push_back(opacity_->scalar);
    return node_.has("dataset") ? generate(node_, scalars) : read_files(node_, folder_, scalars);
  }

  /// What no value reaches would be an empty picture, and what leaves a narrow band a false one.
  void refuse_value(double value, const fields::FileLevels& data) const {
    const bool reached = value >= data.range.x && value <= data.range.y;
    if (reached && !data.gaps.contains(value)) return;
    node_["value"].fail(
        fmt::format("{}; accepted: {}, {} of {} of {}", value, data.gaps.accepted(data.range),
                    data.gaps.empty() ? "the range" : "where the surface stays in the narrow band",
                    node_["scalar"].string(), names_of(node_)));
  }

  /// What is true of the file, and not of the scalar, is said once.
  static void add_remarks(const fields::FileLevels& scalar, std::vector<std::string>& remarks) {
    for (const std::string& remark : scalar.remarks)
      if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
  }

  /// None when the map is one of the scene's own.
  const ColormapRow* color_map() const {
    if (color_->custom) return nullptr;
    return &at_place(node_, [&]() -> const ColormapRow& { return find_colormap(color_->map); });
  }

  std::shared_ptr<const fields::LevelField> field_on(fields::ScaledLevels samples,
                                                     fields::ValueGaps gaps = {}) const {
    return at_place(node_, [&] {
      return std::make_shared<const fields::LevelField>(std::move(samples.levels), *reconstruction_,
                                                        std::move(gaps), samples.scale);
    });
  }

  /// `by` is a ScalarColor or a ScalarOpacity.
  Isosurface::OtherScalar other_scalar(fields::ExactLevels levels,
                                       const fields::LevelField& surface, const auto& by) const {
    const Vec2 range = at_place(node_, [&] {
      return range_over(by, has_given_range(by) ? std::vector<double>() : samples_of(levels));
    });
    const double middle = by.scale == Scale::linear ? range.x / 2 + range.y / 2 : 0;
    const auto field = field_on(rounded(std::move(levels), middle));
    if (!on_same_samples(*field, surface))
      node_.fail(fmt::format(
          "its grids are not those of the scalar '{}'; accepted: the same boxes and widths",
          by.scalar));
    return {field, range, by.scale};
  }

  const JsonNode& node_;
  const std::filesystem::path& folder_;
  const ScalarColor* color_;      // none: not by a scalar
  const ScalarOpacity* opacity_;  // none: the same
  const fields::ReconstructionRow* reconstruction_;
};

}  // namespace

std::variant<Isosurface, geometry::TriangleMesh> read_isosurface(
    const JsonNode& node, const std::filesystem::path& folder, const Appearance& appearance,
    std::string& how) {
  Isosurface surface = IsosurfaceReader(node, folder, appearance).read();
  how = names_of(node) + ": " + describe(*surface.field, node["scalar"].string());
  for (const std::string& remark : surface.corners.remarks) how += "; " + remark;
  if (!node.has("mesh") || !node["mesh"].boolean()) return surface;
  geometry::TriangleMesh mesh = at_place(node, [&] { return mesh_of(surface); });
  mesh.remarks = surface.corners.remarks;
  if (mesh.triangles.empty()) node.fail("nothing to draw: it has no triangle");
  how += fmt::format(", {} triangles", mesh.triangles.size());
  return mesh;
}

void restyle_isosurface(const Appearance& appearance, const JsonNode& node, Isosurface& surface) {
  surface.value = node["value"].number(-any, any);
  if (surface.field->gaps().contains(surface.value))
    node["value"].fail(fmt::format("{}; accepted: {}, where the surface stays in the narrow band",
                                   surface.value, surface.field->gaps().accepted({-any, any})));
  const auto* color = std::get_if<ScalarColor>(&appearance.color);
  if (color && surface.coloring) {
    surface.coloring->map = color->custom ? nullptr : &find_colormap(color->map);
    surface.coloring->custom = color->custom;
    surface.coloring->nan = color->nan;
  }
  const auto* opacity = std::get_if<ScalarOpacity>(&appearance.opacity);
  if (opacity && surface.fading) surface.fading->opacities = opacity->opacities;
}

}  // namespace pellucid::scene
