// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that cover the whole picture: how many, how opaque, how close, how large, how far away.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "compare/conform/case_builder.h"

namespace pellucid::compare {
namespace {

/// A case of layers that cover the picture, at depths in front of one another.
ConformanceCase covered(std::string family, double n, std::string name, std::string what,
                        scene::Scene scene, Layers layers) {
  ConformanceCase c{.name = fmt::format("{}-{}", family, name),
                    .family = std::move(family),
                    .n = n,
                    .what = std::move(what),
                    .scene = std::move(scene),
                    .layers = {},
                    .which = {}};
  set_layers(c, [&](int, int) { return layers; });
  return c;
}

/// A mesh of sheets at z = -i · step + z0, drawn in an order that is not that of their depths.
geometry::TriangleMesh shuffled_sheets(const Layers& layers, double step, double z0 = 0) {
  std::vector<std::size_t> order(layers.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[std::size_t(random_of(i) * double(i))]);
  geometry::TriangleMesh mesh;
  for (const std::size_t i : order) add_plane({z0 - step * double(i), {0, 0}, layers[i]}, mesh);
  return mesh;
}

/// n layers of random colours, through all of which some 5 % of the background show.
Layers random_layers(int n) {
  constexpr double optical_depth = 3;
  Layers layers;
  for (int i = 0; i < n; ++i) {
    const double share = 0.5 + random_of(std::uint64_t(n) * 7 + std::uint64_t(i));
    layers.push_back(color_of(std::uint64_t(i), 1 - std::exp(-optical_depth / n * share)));
  }
  return layers;
}

void add_layers(std::vector<ConformanceCase>& cases) {
  for (const int n : {1, 2, 10, 100, 1000, 10000}) {
    const Layers layers = random_layers(n);
    scene::Scene scene = parallel_scene();
    scene.objects.push_back(object_of(shuffled_sheets(layers, 0x1p-8)));
    cases.push_back(covered("layers", n, fmt::format("{}", n),
                            "so many sheets, shuffled, of which 5 % of the background is left",
                            std::move(scene), layers));
  }
}

void add_opacity(std::vector<ConformanceCase>& cases, double alpha, const char* name,
                 const std::string& what, const Layers& layers) {
  scene::Scene scene = parallel_scene();
  scene.objects.push_back(object_of(shuffled_sheets(layers, 0x1p-4)));
  cases.push_back(covered("opacity", alpha, name, what, std::move(scene), layers));
}

void add_opacities(std::vector<ConformanceCase>& cases) {
  const Rgba red(0.9, 0.1, 0.2, 0.5), green(0.2, 0.8, 0.1, 0.5), white(1, 1, 1, 0);
  add_opacity(cases, 0.5, "half", "two sheets of opacity 0.5", {red, green});
  add_opacity(cases, 0, "0", "sheets of opacity 0 before, between and behind two others",
              {white, red, white, green, white});
  Layers thin;
  for (std::uint64_t i = 0; i < 255; ++i) thin.push_back(color_of(i, 1.0 / 510));
  add_opacity(cases, 1.0 / 510, "1-510", "255 sheets of opacity 1/510, half of an 8-bit step",
              thin);
  const Rgba nearly(0.1, 0.3, 0.9, 0.9999), wholly(0.1, 0.3, 0.9, 1);
  add_opacity(cases, 0.9999, "0.9999", "a sheet of opacity 0.9999 between two others",
              {red, nearly, green});
  add_opacity(cases, 1, "1", "a sheet of opacity 1 between two others", {red, wholly, green});
}

void add_equal_depths(std::vector<ConformanceCase>& cases) {
  for (const int n : {2, 5, 50}) {
    const Rgba color(0.9, 0.3, 0.1, n < 50 ? 0.3 : 0.05);
    Layers layers(std::size_t(n), color);
    geometry::TriangleMesh mesh;
    for (int i = 0; i < n; ++i) add_plane({0, {0, 0}, color}, mesh);
    layers.emplace_back(0.1, 0.8, 0.4, 0.5);
    add_plane({-1, {0, 0}, layers.back()}, mesh);
    scene::Scene scene = parallel_scene();
    scene.objects.push_back(object_of(std::move(mesh)));
    cases.push_back(covered("equal-depth", n, fmt::format("{}", n),
                            "so many equal sheets at one depth, and another behind",
                            std::move(scene), layers));
  }
}

/// The eye is at the origin, so that view depths are the floats of the file.
void add_close_depths(std::vector<ConformanceCase>& cases) {
  for (const int bits : {8, 12, 16, 20, 23}) {
    const Layers layers{{0.9, 0.1, 0.1, 0.6}, {0.1, 0.1, 0.9, 0.6}, {0.2, 0.8, 0.2, 0.6}};
    geometry::TriangleMesh mesh;
    add_plane({-2, {0, 0}, layers[2]}, mesh);
    add_plane({-1 - std::ldexp(1.0, -bits), {0, 0}, layers[1]}, mesh);
    add_plane({-1, {0, 0}, layers[0]}, mesh);
    scene::Scene scene = parallel_scene({0, 0, 0});
    scene.objects.push_back(object_of(std::move(mesh)));
    cases.push_back(covered("close-depth", bits, fmt::format("2^-{}", bits),
                            bits == 23 ? "two sheets one float apart, a third far behind"
                                       : "two sheets 2^-n of the depth range apart, a third behind",
                            std::move(scene), layers));
  }
}

/// g++ 12 leaves out the rounding of two doubles at once to floats and back (-O3), but not a store.
Vec3 rounded_to_floats(const Vec3& x) {
  volatile float stored[3] = {float(x.x), float(x.y), float(x.z)};
  return {stored[0], stored[1], stored[2]};
}

void scale(scene::Scene& scene, double by) {
  for (scene::SceneObject& object : scene.objects)
    for (Vec3& x : object.vertices().positions) x = rounded_to_floats(by * x);
  scene.camera.eye *= by;
  scene.camera.target *= by;
  scene.camera.height *= by;
}

void add_scales(std::vector<ConformanceCase>& cases) {
  for (const int k : {3, -3, 6, -6, 10, -10}) {
    const Layers layers = random_layers(10);
    scene::Scene scene = parallel_scene();
    scene.objects.push_back(object_of(shuffled_sheets(layers, 0.5)));
    scale(scene, std::pow(10.0, k));
    cases.push_back(covered("scale", k, fmt::format("1e{}", k), "ten sheets, scaled by 1e{n}",
                            std::move(scene), layers));
  }
}

void move(scene::Scene& scene, const Vec3& by) {
  for (scene::SceneObject& object : scene.objects)
    for (Vec3& x : object.vertices().positions) x += by;
  scene.camera.eye += by;
  scene.camera.target += by;
}

/// Coordinates are whole numbers below 2^24, of which floats hold all.
void add_shifts(std::vector<ConformanceCase>& cases) {
  for (const int k : {3, 5, 7}) {
    const Layers layers = random_layers(10);
    scene::Scene scene = parallel_scene();
    scene.objects.push_back(object_of(shuffled_sheets(layers, 1)));
    move(scene, Vec3(std::pow(10.0, k)));
    cases.push_back(covered("shift", k, fmt::format("1e{}", k),
                            "ten sheets a unit apart, shifted by 1e{n} along each axis",
                            std::move(scene), layers));
  }
}

}  // namespace

void add_sheet_cases(std::vector<ConformanceCase>& cases) {
  add_layers(cases);
  add_opacities(cases);
  add_equal_depths(cases);
  add_close_depths(cases);
  add_scales(cases);
  add_shifts(cases);
}

}  // namespace pellucid::compare
