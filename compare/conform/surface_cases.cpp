// SPDX-License-Identifier: GPL-3.0-or-later
// Edges and vertices at pixel centres, planes that go through one another, opaque things among
// transparent ones, perspective.
#include <fmt/format.h>

#include <cmath>

#include "compare/conform/case_builder.h"

namespace pellucid::compare {
namespace {

constexpr int reach = case_side / 2 + 2;  // of grids: beyond the picture's rim

/// Unit squares from -reach to reach, their corners moved by `offset`, split along a diagonal.
geometry::TriangleMesh grid(double offset, double z, const Rgba& color) {
  geometry::TriangleMesh mesh;
  const std::uint32_t side = 2 * reach + 1;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      mesh.positions.emplace_back(double(x) - reach + offset, double(y) - reach + offset, z);
      mesh.colors.push_back(color);
    }
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x, b = a + 1, c = a + side, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

/// Triangles around a point, which together are a square that is larger than the picture.
geometry::TriangleMesh fan(const Vec3& center, const Rgba& color) {
  geometry::TriangleMesh mesh;
  mesh.positions.push_back(center);
  for (const Vec2& x : {Vec2(-16, -16), Vec2(3, -16), Vec2(16, -16), Vec2(16, 5), Vec2(16, 16),
                        Vec2(-2, 16), Vec2(-16, 16), Vec2(-16, 1)})
    mesh.positions.emplace_back(x, center.z);
  mesh.colors.assign(mesh.positions.size(), color);
  const auto rim = std::uint32_t(mesh.positions.size() - 1);
  for (std::uint32_t i = 0; i < rim; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % rim});
  return mesh;
}

ConformanceCase empty_case(std::string family, double n, const char* name, std::string what,
                           scene::Scene scene) {
  return {.name = fmt::format("{}-{}", family, name),
          .family = std::move(family),
          .n = n,
          .what = std::move(what),
          .scene = std::move(scene),
          .layers = {},
          .which = {}};
}

void add_edges(std::vector<ConformanceCase>& cases, double n, const char* name,
               const std::string& what, std::vector<geometry::TriangleMesh> meshes) {
  ConformanceCase c = empty_case("edges", n, name, what, parallel_scene());
  Layers layers;
  for (geometry::TriangleMesh& mesh : meshes) {
    layers.push_back(mesh.colors.front());
    c.scene.objects.push_back(object_of(std::move(mesh), "mesh"));
  }
  set_layers(c, [&](int, int) { return layers; });
  cases.push_back(std::move(c));
}

void add_edge_cases(std::vector<ConformanceCase>& cases) {
  const Rgba red(0.9, 0.2, 0.1, 0.5), blue(0.2, 0.3, 0.9, 0.4);
  add_edges(cases, 1, "through", "every pixel's centre on an edge that two triangles share",
            {grid(0, 0, red)});
  add_edges(cases, 2, "vertices", "every pixel's centre on a vertex of six triangles",
            {grid(0.5, 0, red)});
  add_edges(cases, 3, "both", "both meshes, one before the other, and a fan at a pixel's centre",
            {grid(0, 2, red), grid(0.5, 1, blue), fan({0.5, -2.5, 0}, {0.1, 0.9, 0.3, 0.5})});
}

void add_crossing(std::vector<ConformanceCase>& cases) {
  const Plane planes[] = {{0, {0.5, 0}, {0.9, 0.1, 0.1, 0.6}},
                          {0, {-0.5, 0}, {0.1, 0.2, 0.9, 0.6}},
                          {0.125, {0, 0.375}, {0.2, 0.9, 0.1, 0.6}},
                          {0.09375, {0.25, -0.25}, {0.9, 0.9, 0.1, 0.6}}};
  for (const int n : {2, 3, 4}) {
    ConformanceCase c = empty_case("crossing", n, fmt::format("{}", n).c_str(),
                                   "so many planes through one another", parallel_scene());
    geometry::TriangleMesh mesh;
    for (int i = 0; i < n; ++i) add_plane(planes[i], mesh);
    c.scene.objects.push_back(object_of(std::move(mesh)));
    set_layers(c, [&](int x, int y) {
      std::vector<Plane> order(planes, planes + n);
      std::ranges::sort(order, std::greater(),
                        [&](const Plane& p) { return p.at(center_of(x, y)); });
      Layers layers;
      for (const Plane& plane : order) layers.push_back(plane.color);
      return layers;
    });
    cases.push_back(std::move(c));
  }
}

/// Covers the picture's left half, with its rim between two columns of pixels.
geometry::TriangleMesh left_half(double z, const Rgba& color) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, -32, z}, {0, 64, z}, {-96, -32, z}};
  mesh.colors.assign(3, color);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// What an opaque thing hides stands behind it in the list: a renderer at fault may show it. Of an
/// object that is said to be opaque the vertices' opacity counts for nothing.
void add_opaque(std::vector<ConformanceCase>& cases) {
  for (const bool by_object : {false, true}) {
    const Layers layers{color_of(1, 0.5), color_of(2, 0.3), color_of(3, 0.6), color_of(4, 0.4)};
    ConformanceCase c =
        empty_case("opaque", by_object ? 2 : 1, by_object ? "object" : "alpha",
                   by_object ? "an object said to be opaque among sheets, over half the picture"
                             : "a sheet of opacity 1 among others, over half the picture",
                   parallel_scene());
    geometry::TriangleMesh mesh;
    for (const int i : {2, 0, 3, 1}) add_plane({-double(i), {0, 0}, layers[std::size_t(i)]}, mesh);
    c.scene.objects.push_back(object_of(std::move(mesh)));
    const Rgba wall(0.3, 0.7, 0.2, 1), drawn(0.3, 0.7, 0.2, by_object ? 0.6 : 1);
    c.scene.objects.push_back(object_of(left_half(-1.5, drawn), "wall"));
    c.scene.objects.back().opaque = by_object;
    set_layers(c, [&](int x, int) {
      return x < case_side / 2 ? Layers{layers[0], layers[1], wall, layers[2], layers[3]} : layers;
    });
    cases.push_back(std::move(c));
  }
}

/// A pixel's ray is (x / 8, y / 8, -1) t: t is the depth.
scene::Scene perspective_scene() {
  scene::Scene scene = parallel_scene({0, 0, 0});
  scene.camera.projection = scene::Projection::perspective;
  scene.camera.fov = 90;
  return scene;
}

void add_perspective_sheets(std::vector<ConformanceCase>& cases) {
  ConformanceCase c =
      empty_case("perspective", 1, "sheets", "sheets that cover the picture from far and near",
                 perspective_scene());
  const Layers layers{color_of(11, 0.4), color_of(12, 0.4), color_of(13, 0.4)};
  geometry::TriangleMesh mesh;
  add_plane({-8, {0, 0}, layers[2]}, mesh);
  add_plane({-0.125, {0, 0}, layers[0]}, mesh);
  add_plane({-2, {0, 0}, layers[1]}, mesh);
  c.scene.objects.push_back(object_of(std::move(mesh)));
  set_layers(c, [&](int, int) { return layers; });
  cases.push_back(std::move(c));
}

/// A plane seen at a slant, coloured linearly in the world: z = -4 + x / 2, red and opacity by x,
/// green by y. The ray meets it at t = 4 / (1 + u / 2), u = x / 8.
void add_perspective_colors(std::vector<ConformanceCase>& cases) {
  ConformanceCase c = empty_case("perspective", 2, "colours",
                                 "colours and opacity that are linear in the world, at a slant",
                                 perspective_scene());
  const auto color_at = [](const Vec2& x) {
    return Rgba(0.5 + x.x / 256, 0.5 + x.y / 256, 0.25, 0.5 + x.x / 512);
  };
  geometry::TriangleMesh mesh;
  add_plane({-4, {0.5, 0}, {}}, mesh);
  mesh.colors.clear();
  for (const Vec3& x : mesh.positions) mesh.colors.push_back(color_at(Vec2(x)));
  c.scene.objects.push_back(object_of(std::move(mesh)));
  set_layers(c, [&](int x, int y) {
    const Vec2 direction = center_of(x, y) / 8.0;
    return Layers{color_at(4 / (1 + direction.x / 2) * direction)};
  });
  cases.push_back(std::move(c));
}

}  // namespace

void add_surface_cases(std::vector<ConformanceCase>& cases) {
  add_edge_cases(cases);
  add_crossing(cases);
  add_opaque(cases);
  add_perspective_sheets(cases);
  add_perspective_colors(cases);
}

}  // namespace pellucid::compare
