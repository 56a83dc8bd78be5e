// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/batch.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::oit {
namespace {

// A draw call counts vertices in a signed 32-bit integer.
constexpr std::uint64_t most_primitives = (std::uint64_t(1) << 31) / 3;

void check_shape(const scene::SceneObject& object) {
  if (std::holds_alternative<scene::Isosurface>(object.shape))
    throw InputError(fmt::format(
        "{}: an isosurface: raytrace and march draw it; accepted by this method: meshes, "
        "lines, points",
        object.name));
  const auto refuse = [&](const char* profile, const char* accepted) {
    throw InputError(fmt::format(
        "{}: profile \"{}\": raytrace and march draw it; accepted by this method: \"{}\"",
        object.name, profile, accepted));
  };
  if (const auto* lines = std::get_if<scene::LineObject>(&object.shape))
    if (lines->profile == scene::LineObject::Profile::tube) refuse("tube", "ribbon");
  if (const auto* points = std::get_if<scene::PointObject>(&object.shape))
    if (points->profile == scene::PointObject::Profile::sphere) refuse("sphere", "disc");
}

struct CountPrimitives {
  std::uint64_t operator()(const geometry::TriangleMesh& mesh) { return mesh.triangles.size(); }
  std::uint64_t operator()(const scene::LineObject& lines) { return 2 * lines.set.segment_count(); }
  std::uint64_t operator()(const scene::PointObject& points) { return points.set.positions.size(); }
  std::uint64_t operator()(const scene::Isosurface&) { return 0; }  // refused: see check_shape
};

}  // namespace

std::uint64_t primitive_count(const scene::SceneObject& object) {
  return std::visit(CountPrimitives(), object.shape);
}

std::vector<Batch> make_batches(const scene::Scene& scene) {
  std::vector<Batch> batches;
  std::uint64_t total = 0;
  std::array<std::uint32_t, shape_kinds.size()> of_kind{};
  for (const scene::SceneObject& object : scene.objects) {
    check_shape(object);
    const std::uint64_t n = primitive_count(object), first = total;
    if ((total += n) >= most_primitives)
      throw InputError(fmt::format("{}: {} primitives in the scene; accepted: fewer than {}",
                                   object.name, total, most_primitives));
    const ShapeKind kind = kind_of(object);
    std::uint32_t& first_of_kind = of_kind[std::size_t(kind)];
    if (batches.empty() || batches.back().kind != kind || batches.back().opaque != object.opaque)
      batches.push_back({kind, object.opaque, std::uint32_t(first), first_of_kind, 0});
    batches.back().count += std::uint32_t(n);
    first_of_kind += std::uint32_t(n);
  }
  return batches;
}

}  // namespace pellucid::oit
