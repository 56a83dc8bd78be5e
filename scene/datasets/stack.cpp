// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace pellucid::scene {
namespace {

constexpr ParameterSpec parameters[] = {
    {.name = "layers",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "8",
     .min = 1,
     .max = 1e6,
     .unit = "sheets"},
    {.name = "alpha", .default_value = "0.3", .min = 0, .max = 1, .help = "opacity of each sheet"},
    {.name = "depths",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "even",
     .choices = "even|equal|ulp",
     .help = "even: from z = 1 to -1; equal: all at z = 0; ulp: from z = 1 down, one ulp apart"},
    {.name = "order",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "shuffled",
     .choices = "front|back|shuffled",
     .help = "of the triangles: the front sheet first, the back sheet first, or by `seed`"},
    {.name = "sheet",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "square",
     .choices = "square|grid|needles",
     .help = "a sheet's triangles: two; 64 x 64 x 2, whose edges meet the centres of a picture of "
             "128 pixels; or a fan of 64 slivers and a triangle of no area"},
    {.name = "scale", .default_value = "1", .min = 1e-30, .max = 1e30, .unit = "world units"},
    {.name = "shift",
     .default_value = "0",
     .min = -1e30,
     .max = 1e30,
     .unit = "world units",
     .help = "of the stack along x, y and z"},
    {.name = "seed",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "1",
     .min = 0,
     .max = 1e9}};

constexpr int pieces = 64;
/// Half a sheet's side: beyond the square [-1, 1]² that the camera sees.
constexpr double reach = 2;

double depth_of(const std::string& depths, int i, int layers) {
  if (depths == "equal" || layers == 1) return 0;
  if (depths == "even") return 1 - 2.0 * i / (layers - 1);
  return 1 - i * std::numeric_limits<double>::epsilon() / 2;  // an ulp below 1
}

void add_square(std::uint32_t first, geometry::TriangleMesh& mesh) {
  for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    mesh.positions.emplace_back(reach * corner, 0);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

void add_grid(std::uint32_t first, geometry::TriangleMesh& mesh) {
  constexpr std::uint32_t n = pieces, row = n + 1;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.positions.emplace_back(reach * (2.0 * x / n - 1), reach * (2.0 * y / n - 1), 0);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = first + y * row + x;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
}

/// All slivers meet in one corner, so that most of them are needles.
void add_fan(std::uint32_t first, geometry::TriangleMesh& mesh) {
  constexpr std::uint32_t n = pieces / 2;
  mesh.positions.emplace_back(-reach, -reach, 0);
  for (std::uint32_t i = 0; i <= n; ++i)
    mesh.positions.emplace_back(reach, reach * (2.0 * i / n - 1), 0);
  for (std::uint32_t i = 1; i <= n; ++i)
    mesh.positions.emplace_back(reach * (1 - 2.0 * i / n), reach, 0);
  for (std::uint32_t i = 0; i < 2 * n; ++i)
    mesh.triangles.push_back({first, first + 1 + i, first + 2 + i});
  mesh.triangles.push_back({first, first + 1, first + 1});
}

void add_sheet(const std::string& sheet, geometry::TriangleMesh& mesh) {
  const auto first = std::uint32_t(mesh.positions.size());
  if (sheet == "square") add_square(first, mesh);
  if (sheet == "grid") add_grid(first, mesh);
  if (sheet == "needles") add_fan(first, mesh);
}

/// The sheets, as numbers from the front, in the order in which they are drawn.
std::vector<int> drawing_order(const Parameters& values) {
  std::vector<int> order(std::size_t(values.integer("layers")));
  std::iota(order.begin(), order.end(), 0);
  if (values.text("order") == "back") std::reverse(order.begin(), order.end());
  // std::shuffle is not the same everywhere; this is (Fisher and Yates, by the raw generator).
  std::mt19937 random(std::uint32_t(values.integer("seed")));
  if (values.text("order") == "shuffled")
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

Dataset make(const Parameters& values, const Progress&) {
  const double scale = values.real("scale"), alpha = values.real("alpha");
  const Vec3 shift(values.real("shift"));
  geometry::TriangleMesh mesh;
  for (const int i : drawing_order(values)) {
    const std::size_t first = mesh.positions.size();
    const double z = depth_of(values.text("depths"), i, values.integer("layers"));
    add_sheet(values.text("sheet"), mesh);
    for (std::size_t k = first; k < mesh.positions.size(); ++k)
      mesh.positions[k] = scale * Vec3(Vec2(mesh.positions[k]), z) + shift;
    mesh.colors.resize(mesh.positions.size(), stack_color(i, alpha));
  }
  return mesh;
}

}  // namespace

Rgba stack_color(int i, double alpha) {
  const auto channel = [&](double phase) {
    return 0.5 + 0.5 * std::cos(2 * std::numbers::pi * (i / std::numbers::phi + phase));
  };
  return {channel(0), channel(1.0 / 3), channel(2.0 / 3), alpha};
}

const DatasetRow& stack_dataset() {
  static constexpr DatasetRow row{.name = "stack",
                                  .title = "Sheets above one another",
                                  .citation = "closed form: Baeza Rojo et al. 2019, Eq. 12",
                                  .parameters = parameters,
                                  .make = make};
  return row;
}

}  // namespace pellucid::scene
