// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/planar_cells.h"

#include <fmt/format.h>
#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "readers/vtk/shown_cells.h"

namespace pellucid::fields {
namespace {

// Of the grid's extent: coordinates kept in floats, and computed from some, are off by less.
constexpr double planar_rounding = 1e-6;

Vec3 point_at(vtkDataSet& data, vtkIdType i) {
  double x[3];
  data.GetPoint(i, x);
  return {x[0], x[1], x[2]};
}

bool is_shown_surface(vtkDataSet& data, vtkIdType cell, bool hides) {
  return is_planar_type(data.GetCellType(cell)) && !(hides && readers::hides_cell(&data, cell));
}

/// Twice the area of a cell's outline, along its normal. Of a pixel the corners do not go around:
/// then it is 0, and the first triangle tells.
Vec3 area_vector(vtkDataSet& data, vtkIdList& corners) {
  const Vec3 first = point_at(data, corners.GetId(0));
  Vec3 sum(0);
  for (vtkIdType k = 2; k < corners.GetNumberOfIds(); ++k)
    sum += glm::cross(point_at(data, corners.GetId(k - 1)) - first,
                      point_at(data, corners.GetId(k)) - first);
  if (glm::length(sum) > 0 || corners.GetNumberOfIds() < 3) return sum;
  return glm::cross(point_at(data, corners.GetId(1)) - first,
                    point_at(data, corners.GetId(2)) - first);
}

/// Through the largest cell, its normal along the axis that it is nearest to.
class PlaneFinder {
 public:
  void add(vtkDataSet& data, vtkIdList& corners) {
    const Vec3 area = area_vector(data, corners);
    if (!(glm::length(area) > glm::length(largest_))) return;
    largest_ = area;
    origin_ = point_at(data, corners.GetId(0));
  }

  std::optional<Plane> plane(double slack) const {
    const double length = glm::length(largest_);
    if (!(length > 0)) return std::nullopt;
    Vec3 normal = largest_ / length;
    int main = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (std::abs(normal[axis]) > std::abs(normal[main])) main = axis;
    if (normal[main] < 0) normal = -normal;
    return Plane{origin_, normal, slack};
  }

 private:
  Vec3 largest_{0}, origin_{0};
};

Plane plane_of(vtkDataSet& data, const Box3& bounds, const std::filesystem::path& path) {
  const bool hides = readers::hides_cells(&data);
  PlaneFinder finder;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    if (!is_shown_surface(data, i, hides)) continue;
    data.GetCellPoints(i, corners);
    if (corners->GetNumberOfIds() > 0) finder.add(data, *corners);
  }
  const Vec3 farthest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  const double slack = planar_rounding * std::max(bounds.diagonal(), glm::length(farthest));
  const auto plane = finder.plane(slack);
  if (!plane)
    throw InputError(fmt::format(
        "{}: it has no volume cells, nor surface cells that lie on a plane", path.string()));
  return *plane;
}

/// The triangles and quadrilaterals of a cell become prisms.
class Prisms {
 public:
  Prisms(vtkDataSet& data, const Plane& plane, double half, const std::filesystem::path& path)
      : data_(data), path_(path), count_(data.GetNumberOfPoints()) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(2 * count_);
    for (vtkIdType i = 0; i < 2 * count_; ++i) {
      const Vec3 x = point_at(data, i % count_) + (i < count_ ? -half : half) * plane.normal;
      points->SetPoint(i, x.x, x.y, x.z);
    }
    grid_->SetPoints(points);
    grid_->Allocate(data.GetNumberOfCells());
  }

  void add(vtkIdType cell) {
    data_.GetCellPoints(cell, corners_);
    vtkIdList& c = *corners_;
    switch (data_.GetCellType(cell)) {
      case VTK_QUAD:
        return add(cell, VTK_HEXAHEDRON, {c.GetId(0), c.GetId(1), c.GetId(2), c.GetId(3)});
      case VTK_PIXEL:
        return add(cell, VTK_HEXAHEDRON, {c.GetId(0), c.GetId(1), c.GetId(3), c.GetId(2)});
      case VTK_QUADRATIC_TRIANGLE:
        return add_quadratic(cell);
      default:
        return add_triangles(cell);
    }
  }

  vtkSmartPointer<vtkDataSet> grid() const { return grid_; }
  std::vector<vtkIdType> take_numbers() { return std::move(numbers_); }

 private:
  void add(vtkIdType cell, int type, std::vector<vtkIdType> below) {
    const std::size_t corners = below.size();
    for (std::size_t k = 0; k < corners; ++k) below.push_back(below[k] + count_);
    grid_->InsertNextCell(type, vtkIdType(below.size()), below.data());
    numbers_.push_back(cell);
  }

  /// Corners below and above, then the middles of the edges below and above.
  void add_quadratic(vtkIdType cell) {
    vtkIdType ids[12];
    for (vtkIdType k = 0; k < 3; ++k) {
      ids[k] = corners_->GetId(k), ids[3 + k] = ids[k] + count_;
      ids[6 + k] = corners_->GetId(3 + k), ids[9 + k] = ids[6 + k] + count_;
    }
    grid_->InsertNextCell(VTK_QUADRATIC_LINEAR_WEDGE, 12, ids);
    numbers_.push_back(cell);
  }

  void add_triangles(vtkIdType cell) {
    vtkNew<vtkIdList> ids;
    vtkNew<vtkPoints> points;
    if (!data_.GetCell(cell)->Triangulate(0, ids, points) && has_area())
      throw InputError(fmt::format(
          "{}: cell {}: its {} corners go around no plain polygon; accepted: polygons that neither "
          "touch nor cross themselves, as those with a hole do: divide them where they come from",
          path_.string(), cell, corners_->GetNumberOfIds()));
    for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); k += 3)
      add(cell, VTK_WEDGE, {ids->GetId(k), ids->GetId(k + 1), ids->GetId(k + 2)});
  }

  /// Whether the corners of the cell at hand span more than their coordinates are rounded.
  bool has_area() const {
    double square = 0;
    for (vtkIdType k = 1; k < corners_->GetNumberOfIds(); ++k)
      square = std::max(square, glm::length(point_at(data_, corners_->GetId(k)) -
                                            point_at(data_, corners_->GetId(0))));
    return glm::length(area_vector(data_, *corners_)) > planar_rounding * square * square;
  }

  vtkDataSet& data_;
  const std::filesystem::path& path_;
  vtkIdType count_;
  vtkNew<vtkIdList> corners_;
  vtkSmartPointer<vtkUnstructuredGrid> grid_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
  std::vector<vtkIdType> numbers_;
};

void require_planar(vtkDataSet& data, const Plane& plane, const std::filesystem::path& path) {
  const bool hides = readers::hides_cells(&data);
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
    if (!is_shown_surface(data, i, hides)) continue;
    data.GetCellPoints(i, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      if (const double off = plane.distance(point_at(data, corners->GetId(k)));
          std::abs(off) > plane.slack)
        throw InputError(fmt::format(
            "{}: it has no volume cells, and its surface is no plane: point {} is {:.3g} off; "
            "accepted: volume cells, or a plane",
            path.string(), corners->GetId(k), off));
  }
}

}  // namespace

bool is_planar_type(int type) {
  return type == VTK_TRIANGLE || type == VTK_TRIANGLE_STRIP || type == VTK_POLYGON ||
         type == VTK_PIXEL || type == VTK_QUAD || type == VTK_QUADRATIC_TRIANGLE;
}

CheckedCells planar_cells(vtkDataSet& data, const Box3& bounds, const std::filesystem::path& path) {
  const Plane plane = plane_of(data, bounds, path);
  require_planar(data, plane, path);
  // As thick as a cell is wide, if there are as many along both axes.
  const double width = bounds.diagonal() / std::sqrt(double(data.GetNumberOfCells()));
  Prisms prisms(data, plane, 0.5 * width, path);
  const bool hides = readers::hides_cells(&data);
  for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i)
    if (is_shown_surface(data, i, hides)) prisms.add(i);
  return {prisms.grid(), prisms.take_numbers(), plane, bounds};
}

}  // namespace pellucid::fields
