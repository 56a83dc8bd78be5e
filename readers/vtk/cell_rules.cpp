// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/cell_rules.h"

#include <fmt/format.h>
#include <vtkCellType.h>

#include <algorithm>
#include <iterator>

namespace pellucid::readers {
namespace {

[[noreturn]] void fail(const std::string& why) { throw BlockError(why); }

/// How many points a cell of a type has.
struct TypeRule {
  std::uint8_t type;
  std::int64_t least, most;
};
constexpr std::int64_t any = INT64_MAX;
constexpr TypeRule rules[] = {
    {VTK_EMPTY_CELL, 0, any},
    {VTK_VERTEX, 1, 1},
    {VTK_POLY_VERTEX, 0, any},
    {VTK_LINE, 2, 2},
    {VTK_POLY_LINE, 0, any},
    {VTK_TRIANGLE, 3, 3},
    {VTK_TRIANGLE_STRIP, 3, any},
    {VTK_POLYGON, 3, any},
    {VTK_PIXEL, 4, 4},
    {VTK_QUAD, 4, 4},
    {VTK_TETRA, 4, 4},
    {VTK_VOXEL, 8, 8},
    {VTK_HEXAHEDRON, 8, 8},
    {VTK_WEDGE, 6, 6},
    {VTK_PYRAMID, 5, 5},
    {VTK_PENTAGONAL_PRISM, 10, 10},
    {VTK_HEXAGONAL_PRISM, 12, 12},
    {VTK_QUADRATIC_EDGE, 3, 3},
    {VTK_QUADRATIC_TRIANGLE, 6, 6},
    {VTK_QUADRATIC_QUAD, 8, 8},
    {VTK_QUADRATIC_TETRA, 10, 10},
    {VTK_QUADRATIC_HEXAHEDRON, 20, 20},
    {VTK_QUADRATIC_WEDGE, 15, 15},
    {VTK_QUADRATIC_PYRAMID, 13, 13},
    {VTK_BIQUADRATIC_QUAD, 9, 9},
    {VTK_TRIQUADRATIC_HEXAHEDRON, 27, 27},
    {VTK_QUADRATIC_LINEAR_QUAD, 6, 6},
    {VTK_QUADRATIC_LINEAR_WEDGE, 12, 12},
    {VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 18},
    {VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 24},
    {VTK_BIQUADRATIC_TRIANGLE, 7, 7},
    {VTK_CUBIC_LINE, 4, 4},
    {VTK_POLYHEDRON, 4, any},
};

const TypeRule* rule_of(std::uint8_t type) {
  const auto found = std::find_if(std::begin(rules), std::end(rules),
                                  [&](const TypeRule& rule) { return rule.type == type; });
  return found == std::end(rules) ? nullptr : found;
}

void check_index(std::int64_t index, std::int64_t point_count, std::int64_t place) {
  if (index < 0 || index >= point_count)
    fail(fmt::format("point index {} at place {} of its cells, but it has {} points", index, place,
                     point_count));
}

/// Takes the numbers of one polyhedron one by one.
class FaceStream {
 public:
  FaceStream(std::span<const std::int64_t> faces, std::int64_t place, std::int64_t cell)
      : faces_(faces), place_(place), cell_(cell) {
    if (place < 0) wrong();
  }
  std::int64_t next() {
    if (place_ >= std::int64_t(faces_.size())) wrong();
    return faces_[std::size_t(place_++)];
  }
  std::int64_t next_count() {
    const std::int64_t count = next();
    if (count < 0 || count > std::int64_t(faces_.size()) - place_) wrong();
    return count;
  }
  [[noreturn]] void wrong() const {
    fail(fmt::format("the faces of cell {} end elsewhere than they say", cell_));
  }

 private:
  std::span<const std::int64_t> faces_;
  std::int64_t place_, cell_;
};

}  // namespace

void check_cells(const CellGroup& cells, std::int64_t point_count) {
  if (cells.offsets.empty() || cells.offsets[0] != 0) fail("the first cell's offset is not 0");
  for (std::size_t i = 1; i < cells.offsets.size(); ++i)
    if (cells.offsets[i] < cells.offsets[i - 1])
      fail(fmt::format("offset of cell {} is {}; offsets have to ascend", i, cells.offsets[i]));
  if (cells.offsets.back() != std::int64_t(cells.connectivity.size()))
    fail(fmt::format("the last cell's offset is {}, but the cells have {} point indices",
                     cells.offsets.back(), cells.connectivity.size()));
  for (std::size_t i = 0; i < cells.connectivity.size(); ++i)
    check_index(cells.connectivity[i], point_count, std::int64_t(i));
}

void check_types(std::span<const std::uint8_t> types, const CellGroup& cells) {
  if (std::int64_t(types.size()) != cells.count())
    fail(fmt::format("{} types of {} cells", types.size(), cells.count()));
  for (std::int64_t cell = 0; cell < cells.count(); ++cell) {
    const std::uint8_t type = types[std::size_t(cell)];
    const TypeRule* rule = rule_of(type);
    if (!rule)
      fail(fmt::format("cell {} is of VTK type {}; accepted: linear and quadratic cells, polyhedra",
                       cell, type));
    if (const std::int64_t count = cells.points_of(cell); count < rule->least || count > rule->most)
      fail(fmt::format("cell {} of VTK type {} has {} points; expected {}", cell, type, count,
                       rule->least));
  }
}

void check_polyhedra(std::span<const std::uint8_t> types, std::span<const std::int64_t> faces,
                     std::span<const std::int64_t> locations, std::int64_t point_count) {
  for (std::size_t cell = 0; cell < types.size(); ++cell) {
    if (types[cell] != VTK_POLYHEDRON) continue;
    if (cell >= locations.size()) fail(fmt::format("polyhedron {} has no faces", cell));
    FaceStream stream(faces, locations[cell], std::int64_t(cell));
    for (std::int64_t face = stream.next_count(); face > 0; --face)
      for (std::int64_t point = stream.next_count(); point > 0; --point)
        check_index(stream.next(), point_count, std::int64_t(cell));
  }
}

}  // namespace pellucid::readers
