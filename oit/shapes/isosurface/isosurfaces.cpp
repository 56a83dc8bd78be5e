// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/isosurface/isosurfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "fields/levels/surface_cells.h"
#include "fields/levels/surface_pieces.h"
#include "oit/gl/bindings.h"
#include "oit/shapes/isosurface/surface_look.h"
#include "oit/shapes/solid/solid_bounds.h"

namespace pellucid::oit {
namespace {

using fields::SurfacePiece;
using fields::SurfacePieces;

// See piece_record.glsl.
struct Record {
  glm::vec4 bounds;
  Vec3 low, high;  // world axes, from the eye
  std::uint32_t numbers, surface, degree, flags;
};
static_assert(sizeof(Record) == 80);

constexpr std::uint64_t most_crossings = (std::uint64_t(1) << 31) / 6;  // of a draw call

/// What the numbers of a polynomial lie between.
struct Range {
  double low = 0, high = 0;
  friend Range operator+(const Range& a, const Range& b) {
    return {a.low + b.low, a.high + b.high};
  }
};

Range product(const Range& a, const Range& b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

/// How the surface's polynomial changes from one end of a piece to the other along an axis: a
/// multiple of its derivative there, whose Bernstein coefficients are differences.
Range change_along(int axis, const SurfacePiece& piece, std::span<const double> numbers) {
  const std::size_t n = std::size_t(piece.degree) + 1;
  const std::size_t step = axis == 0 ? 1 : axis == 1 ? n : n * n;
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < piece.count(); ++i) {
    if (i / step % n == n - 1) continue;
    const double change = numbers[i + step] - numbers[i];
    range = {std::min(range.low, change), std::max(range.high, change)};
  }
  return range;
}

/// How many crossings a ray of the picture may have in a piece: one where the polynomial grows, or
/// falls, along all of them, else as many as its degree along them.
int most_crossings_of(const SurfacePiece& piece, std::span<const double> numbers,
                      const ViewSpace& view) {
  if (piece.jump_axis >= 0) return 1;
  const scene::CameraFrame& frame = view.frame();
  const bool parallel = view.projection() == scene::Projection::orthographic;
  Range along{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double width = piece.box.max[axis] - piece.box.min[axis];
    const Range direction = parallel ? Range{frame.forward[axis], frame.forward[axis]}
                                     : Range{piece.box.min[axis] - frame.eye[axis],
                                             piece.box.max[axis] - frame.eye[axis]};
    along = along +
            product(product(change_along(axis, piece, numbers), {1 / width, 1 / width}), direction);
  }
  return along.low > 0 || along.high < 0 ? 1 : 3 * piece.degree;
}

PictureRectangle bounds_of(const SurfacePiece& piece, const ViewSpace& view) {
  Box3 box = piece.box;
  if (piece.jump_axis >= 0) box.max[piece.jump_axis] = box.min[piece.jump_axis];
  std::array<Vec3, 8> corners;
  std::ranges::transform(scene::corners_of(box).positions, corners.begin(),
                         [&](const Vec3& corner) { return view.view_position(corner); });
  return bounds_in_picture(corners, view);
}

/// Gathers crossings and numbers of all surfaces.
class Collector {
 public:
  explicit Collector(const ViewSpace& view) : view_(view) {
    const double unit = 1 / view.exact_length(1);
    const scene::CameraFrame& frame = view.frame();
    for (const Vec3& axis : {frame.right, frame.up, frame.forward}) append(unit * axis);
  }

  /// `part` chooses among its cells, `index` being the object's in the scene. Returns the number of
  /// crossings of pieces of degree one, which come first.
  std::size_t add(const scene::Isosurface& surface, std::size_t index,
                  const scene::PartNumber& part) {
    std::vector<const fields::LevelField*> others;
    if (surface.coloring) others.push_back(surface.coloring->scalar.field.get());
    if (surface.fading) others.push_back(surface.fading->scalar.field.get());
    const std::size_t look = append_look(surface);
    const std::vector<fields::LatticeCell> cells =
        fields::surface_cells(*surface.field, surface.value);
    const scene::Share share = scene::share_of_cells(cells.size(), index, part);
    const SurfacePieces pieces = fields::surface_pieces(
        *surface.field, surface.value,
        std::span(cells).subspan(share.begin, share.end - share.begin), others);
    const std::size_t first = numbers.size();
    numbers.insert(numbers.end(), pieces.numbers.begin(), pieces.numbers.end());
    const auto add_all = [&](bool fading) {
      const std::size_t before = records.size();
      for (const SurfacePiece& piece : pieces.pieces)
        if ((piece.degree > 1) == fading) add(piece, first + piece.first, look);
      return records.size() - before;
    };
    const std::size_t plain = add_all(false);
    add_all(true);
    return plain;
  }

  std::vector<Record> records;
  std::vector<double> numbers;
  int degree = 1;

 private:
  void append(const Vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

  /// Returns where it begins.
  std::size_t append_look(const scene::Isosurface& surface) {
    constexpr std::size_t size = sizeof(SurfaceLook) / sizeof(double);
    const std::size_t at = numbers.size();
    std::vector<double> stops;
    const SurfaceLook look = look_of(surface, view_.frame().eye, at + size, stops);
    numbers.resize(at + size);
    std::memcpy(&numbers[at], &look, sizeof look);
    numbers.insert(numbers.end(), stops.begin(), stops.end());
    return at;
  }

  void add(const SurfacePiece& piece, std::size_t first, std::size_t look) {
    const PictureRectangle bounds = bounds_of(piece, view_);
    if (bounds.empty()) return;
    const Vec3& eye = view_.frame().eye;
    const int most = most_crossings_of(piece, std::span(numbers).subspan(first), view_);
    for (int crossing = 0; crossing < most; ++crossing)
      records.push_back({glm::vec4(bounds.first, bounds.second), piece.box.min - eye,
                         piece.box.max - eye, std::uint32_t(first), std::uint32_t(look),
                         std::uint32_t(piece.degree | (piece.jump_axis + 1) << 8),
                         std::uint32_t(crossing) << 1 | std::uint32_t(piece.weighted)});
    degree = std::max(degree, piece.degree);
  }

  const ViewSpace& view_;
};

}  // namespace

Isosurfaces::Isosurfaces(const Gl& gl, const scene::Scene& scene, const ViewSpace& view,
                         const scene::PartNumber& part) {
  Collector collector(view);
  const std::vector<Record>& records = collector.records;
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (const auto& object = scene.objects[i];
        const auto* surface = std::get_if<scene::Isosurface>(&object.shape)) {
      if (std::holds_alternative<scene::Isosurface::Body>(surface->hole))
        throw InputError(
            fmt::format("{}: a hole of a mesh: raytrace and march cut it; accepted by "
                        "this method: a hole of a ball (center, radius)",
                        object.name));
      const std::size_t first = records.size();
      const std::size_t plain =
          collector.add(*surface, i, object.opaque ? scene::PartNumber() : part);
      if (records.size() >= most_crossings)
        throw InputError(
            fmt::format("{}: {} crossings of cells; accepted by this method: fewer than {}; "
                        "raytrace draws it",
                        object.name, records.size(), most_crossings));
      runs_.push_back({std::uint32_t(first), std::uint32_t(plain),
                       std::uint32_t(records.size() - first - plain)});
    }
  degree_ = collector.degree;
  if (records.empty()) collector.records.emplace_back();  // a buffer texture is not empty
  pieces_ = {gl, GL_RGBA32UI, Buffer(gl, records)};
  numbers_ = {gl, GL_RG32UI, Buffer(gl, collector.numbers)};
}

std::vector<Batch> Isosurfaces::batches(std::size_t index, const Batch& whole) const {
  const Run& run = runs_[index];
  std::vector<Batch> batches;
  const auto append = [&](ShapeKind kind, std::uint32_t first, std::uint32_t count) {
    if (count == 0) return;
    Batch batch = whole;
    batch.kind = kind;
    batch.first = first;
    batch.count = count;
    batch.first_primitive =
        std::min(whole.first_primitive + (first - run.first), whole.last_primitive);
    batches.push_back(batch);
  };
  append(ShapeKind::isosurface, run.first, run.count);
  append(ShapeKind::fading_isosurface, run.first + run.count, run.fading_count);
  return batches;
}

Resources Isosurfaces::resources() const {
  return {pieces_.as_texture(bindings::isosurface_pieces_texture),
          numbers_.as_texture(bindings::isosurface_numbers_texture)};
}

}  // namespace pellucid::oit
