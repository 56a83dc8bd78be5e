// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/object_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "geometry/files/mesh_file.h"
#include "geometry/unused_vertices.h"
#include "scene/datasets/dataset.h"
#include "scene/files/any_number.h"
#include "scene/files/appearance_file.h"
#include "scene/files/flow_file.h"
#include "scene/files/isosurface_file.h"
#include "scene/files/object_look.h"
#include "scene/files/radius_file.h"
#include "scene/files/transform_file.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

Halo read_halo(const JsonNode& node) {
  node.accept_keys({"width", "depth", "color"});
  Halo halo;
  halo.width = node["width"].number(0, any);
  halo.depth = node.has("depth") ? node["depth"].number(0, any) : halo.width;
  if (node.has("color")) halo.color = read_rgb(node["color"]);
  return halo;
}

/// What is known of an object before it is read.
void read_look(const JsonNode& node, SceneObject& object) {
  if (node.has("opaque")) object.opaque = node["opaque"].boolean();
  if (node.has("lighting")) object.lighting = read_lighting(node["lighting"]);
}

std::string name_of_object(const JsonNode& node) {
  return node.has("name") ? node["name"].string() : node.place();
}

class ObjectReader {
 public:
  ObjectReader(const JsonNode& node, const ObjectContext& context)
      : node_(node), context_(context) {}

  SceneObject read() {
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return node_.has(k.key); });
    std::vector<std::string_view> of_kinds,
        keys{"name",   "color",   "opacity", "importance", "opaque",
             "radius", "profile", "halo",    "transform",  "lighting"};
    for (const Kind& k : kinds) of_kinds.push_back(k.key);
    keys.insert(keys.end(), of_kinds.begin(), of_kinds.end());
    node_.accept_keys(keys);
    if (std::ranges::count_if(of_kinds, [&](auto key) { return node_.has(key); }) != 1)
      node_.fail(fmt::format("accepted: exactly one of the keys {}", fmt::join(of_kinds, ", ")));
    object_.name = name_of_object(node_);
    read_look(node_, object_);
    (this->*kind->read)(node_[kind->key]);
    if (node_.has("transform")) place(node_["transform"]);
    apply_look(node_, context_.folder, values_, object_);
    return std::move(object_);
  }

  SceneObject restyle(SceneObject object) {
    const bool is_extracted =
        node_.has("isosurface") && !std::holds_alternative<Isosurface>(object.shape);
    if (is_extracted) return read();  // its triangles are those of the value
    if (asks_percentiles_of_file(node_, context_.folder))
      return read();  // the vertices may repeat its values
    if (asks_attributes_of_field(object)) return read();
    object_ = std::move(object);
    read_look(node_, object_);
    if (auto* lines = std::get_if<LineObject>(&object_.shape))
      draw(geometry::LineSet(std::move(lines->set)));
    if (auto* points = std::get_if<PointObject>(&object_.shape))
      draw(geometry::PointSet(std::move(points->set)));
    if (auto* surface = std::get_if<Isosurface>(&object_.shape))
      restyle_isosurface(read_appearance(node_, context_.folder), node_["isosurface"], *surface);
    apply_look(node_, context_.folder, values_, object_);
    return std::move(object_);
  }

 private:
  struct Kind {
    std::string_view key;
    void (ObjectReader::*read)(const JsonNode&);
  };
  static const std::array<Kind, 6> kinds;

  // What is drawn of what was read, with the width that its kind has.

  void draw(geometry::TriangleMesh mesh) {
    for (const char* key : {"radius", "profile"})
      if (node_.has(key)) node_[key].fail("only lines and points have one");
    refuse_halo();
    object_.shape = std::move(mesh);
  }

  void draw(geometry::LineSet set) {
    if (set.segment_count() == 0) node_.fail("nothing to draw: it has no segment");
    const bool tube = node_.has("profile") && node_["profile"].one_of({"ribbon", "tube"}) == "tube";
    Radii radii = read_radii(node_, set);
    LineObject lines{std::move(set), std::move(radii),
                     tube ? LineObject::Profile::tube : LineObject::Profile::ribbon};
    if (node_.has("halo")) lines.halo = read_halo(node_["halo"]);
    object_.shape = std::move(lines);
  }

  void draw(geometry::PointSet set) {
    const bool sphere =
        node_.has("profile") && node_["profile"].one_of({"disc", "sphere"}) == "sphere";
    refuse_halo();
    Radii radii = read_radii(node_, set);
    object_.shape = PointObject{std::move(set), std::move(radii),
                                sphere ? PointObject::Profile::sphere : PointObject::Profile::disc};
  }

  void refuse_halo() const {
    if (node_.has("halo")) node_["halo"].fail("only lines have one");
  }

  /// Returns the shape that the node names: one that was given, or that of a file.
  template <class Shape, class FileShape>
  FileShape shape_of(const JsonNode& node, FileShape (*read_file)(const fs::path&)) const {
    const auto given = context_.given.find(node.string());
    if (given == context_.given.end())
      return at_place(node, [&] { return read_file(path_of(node)); });
    const Shape* shape = std::get_if<Shape>(given->second.get());
    if (!shape)
      node.fail(
          "its shape is of another kind; accepted: a mesh as \"mesh\", lines as "
          "\"lines\", points as \"points\"");
    FileShape whole;
    static_cast<Shape&>(whole) = *shape;
    return whole;
  }

  void read_mesh_file(const JsonNode& node) {
    auto mesh = shape_of<geometry::TriangleMesh>(node, geometry::read_mesh);
    geometry::drop_unused_vertices(mesh);
    note(fmt::format("{}, {} triangles", file_name(node), mesh.triangles.size()), mesh);
    values_ = std::move(mesh.values);
    draw(std::move(mesh));
  }

  void read_surface(const JsonNode& node) {
    std::string how;
    FlowSurface made = read_flow_surface(node, flow_context(), how);
    note(std::move(how));
    draw(std::move(made.mesh));
    object_.source = std::move(made.source);
  }

  FlowContext flow_context() const { return {context_.folder, scalars_asked(), context_.progress}; }

  /// What colours, opacities, importance and radii are by.
  std::vector<std::string> scalars_asked() const {
    std::vector<std::string> scalars = scalars_of(read_appearance(node_, context_.folder));
    if (auto of_radius = scalar_of_radius(node_)) scalars.push_back(std::move(*of_radius));
    return scalars;
  }

  geometry::LineSet flow_lines(const JsonNode& node) {
    std::string how;
    geometry::LineSet lines = read_flow_lines(node, flow_context(), how);
    note(std::move(how));
    return lines;
  }

  void read_line_object(const JsonNode& node) {
    draw(node.is_object() ? flow_lines(node) : line_file(node));
  }

  geometry::LineSet line_file(const JsonNode& node) {
    auto lines = shape_of<geometry::LineSet>(node, geometry::read_lines);
    geometry::drop_unused_vertices(lines);
    values_ = std::move(lines.values);
    note(fmt::format("{}, {} lines, {} points", file_name(node), lines.line_count(),
                     lines.positions.size()),
         lines);
    return lines;
  }

  void read_point_object(const JsonNode& node) {
    auto points = shape_of<geometry::PointSet>(node, geometry::read_points);
    note(fmt::format("{}, {} points", file_name(node), points.positions.size()), points);
    draw(std::move(points));
  }

  void draw_shape(Dataset& data) {
    if (auto* mesh = std::get_if<geometry::TriangleMesh>(&data)) draw(std::move(*mesh));
    if (auto* lines = std::get_if<geometry::LineSet>(&data)) draw(std::move(*lines));
    if (auto* points = std::get_if<geometry::PointSet>(&data)) draw(std::move(*points));
  }

  void read_dataset(const JsonNode& node) {
    Dataset data = at_place(node, [&] { return make_dataset(node.string(), context_.progress); });
    note("data set " + node.string());
    if (std::holds_alternative<VelocityLevels>(data))
      node.fail(node.string() +
                " is on levels of samples, no shape; accepted: \"isosurface\": "
                "{\"dataset\": NAME, …}");
    draw_shape(data);
  }

  void read_isosurface_object(const JsonNode& node) {
    for (const char* key : {"radius", "profile", "importance", "halo"})
      if (node_.has(key)) node_[key].fail("an isosurface has none");
    std::string how;
    std::visit(
        [&](auto surface) { object_.shape = std::move(surface); },
        read_isosurface(node, context_.folder, read_appearance(node_, context_.folder), how));
    note(std::move(how));
  }

  void place(const JsonNode& node) {
    const Transform how = read_transform(node);
    if (std::holds_alternative<Isosurface>(object_.shape))
      node.fail("an isosurface has none; accepted: with \"mesh\": true");
    at_place(node, [&] { transform(how, object_.vertices()); });
    object_.source.reset();  // its field is elsewhere
  }

  bool asks_attributes_of_field(const SceneObject& object) const {
    if (!node_.has("surface") && !(node_.has("lines") && node_["lines"].is_object())) return false;
    return !std::ranges::all_of(scalars_asked(), [&](const std::string& name) {
      return object.vertices().scalars.contains(name);
    });
  }

  fs::path path_of(const JsonNode& node) const { return context_.folder / node.string(); }
  static std::string file_name(const JsonNode& node) {
    return fs::path(node.string()).filename().string();
  }
  void note(std::string how) { context_.provenance[node_.place()] = std::move(how); }
  void note(std::string how, const geometry::Vertices& read) {
    for (const std::string& remark : read.remarks) how += "; " + remark;
    note(std::move(how));
  }

  const JsonNode& node_;
  const ObjectContext& context_;
  SceneObject object_;
  FileValues values_;
};

const std::array<ObjectReader::Kind, 6> ObjectReader::kinds{
    {{"mesh", &ObjectReader::read_mesh_file},
     {"surface", &ObjectReader::read_surface},
     {"lines", &ObjectReader::read_line_object},
     {"points", &ObjectReader::read_point_object},
     {"dataset", &ObjectReader::read_dataset},
     {"isosurface", &ObjectReader::read_isosurface_object}}};

}  // namespace

SceneObject read_object(const JsonNode& node, const ObjectContext& context) {
  return ObjectReader(node, context).read();
}

SceneObject unread_object(const JsonNode& node) {
  SceneObject object{name_of_object(node), geometry::TriangleMesh()};
  read_look(node, object);
  return object;
}

SceneObject restyled_object(const JsonNode& node, const ObjectContext& context,
                            SceneObject object) {
  return ObjectReader(node, context).restyle(std::move(object));
}

}  // namespace pellucid::scene
