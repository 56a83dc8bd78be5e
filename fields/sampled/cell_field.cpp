// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_field.h"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <array>
#include <optional>

#include "fields/finite.h"
#include "fields/lazy.h"
#include "fields/sampled/cell_error.h"
#include "fields/sampled/cell_grid.h"
#include "fields/sampled/cell_inverse.h"
#include "fields/sampled/planar_field.h"

namespace pellucid::fields {
namespace {

/// FindCell, FindCellsWithinBounds and GetCell are safe on several threads as long as each brings
/// its own vtkGenericCell and list; the grid and the locator do not change once built.
class CellSampler final : public FieldSampler {
 public:
  CellSampler(vtkStaticCellLocator* locator, const CellGrid& grid)
      : locator_(locator), grid_(grid), rounding_(1e-14 * grid.search_box.diagonal()) {}

  SampleStatus velocity(const Vec3& x, double, Vec3& v) override {
    if (!find(x)) return SampleStatus::outside;
    v = interpolate();
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double, Vec3& v, Mat3& jacobian) override {
    if (!find(x)) return SampleStatus::outside;
    v = interpolate();
    jacobian = grid_.constant ? Mat3(0) : grid_.jacobian(*cell_, parametric_);
    return is_finite(v) && is_finite(jacobian) ? SampleStatus::ok : SampleStatus::not_finite;
  }

 private:
  bool find(const Vec3& x) {
    if (!grid_.search_box.contains(x)) return false;
    double position[3] = {x.x, x.y, x.z};
    number_ = locator_->FindCell(position, 0, cell_, parametric_, weights_.data());
    if (number_ < 0) return search(x);
    if (!grid_.constant) polish(x);
    return true;
  }

  /// Finds the cell where VTK finds none: its iteration gives up in some that hold x.
  bool search(const Vec3& x) {
    double box[6] = {x.x, x.x, x.y, x.y, x.z, x.z};
    for (int axis = 0; axis < 3; ++axis) box[2 * axis] -= rounding_, box[2 * axis + 1] += rounding_;
    near_->Reset();
    locator_->FindCellsWithinBounds(box, near_);
    for (vtkIdType i = 0; i < near_->GetNumberOfIds(); ++i) {
      number_ = near_->GetId(i);
      grid_.cells->GetCell(number_, cell_);
      if (solve(x)) return true;
    }
    return false;
  }

  /// Finds where in the cell x is, by an iteration of our own.
  bool solve(const Vec3& x) {
    const std::optional<Vec3> place = place_in_cell(*cell_, x);
    if (place) move_to(*place);
    return place.has_value();
  }

  void move_to(const Vec3& place) {
    for (int axis = 0; axis < 3; ++axis) parametric_[axis] = place[axis];
    cell_->InterpolateFunctions(parametric_, weights_.data());
  }

  /// One more step of Newton's iteration: VTK stops when a step is below a thousandth of a cell,
  /// and the next one squares the error. A step longer than that is one of a cell that is nearly
  /// flat there.
  void polish(const Vec3& x) {
    constexpr double longest = 1e-3;
    const int type = cell_->GetCellType();
    if (type == VTK_TETRA || type == VTK_VOXEL) return;  // solved directly
    Vec3 miss = x;
    for (int i = 0; i < cell_->GetNumberOfPoints(); ++i)
      miss -= weights_[std::size_t(i)] * grid_.point(cell_->GetPointId(i));
    if (glm::length(miss) <= rounding_) return;
    const Vec3 step = glm::inverse(grid_.slopes(*cell_, parametric_).position) * miss;
    if (glm::length(step) <= longest)
      move_to(Vec3(parametric_[0], parametric_[1], parametric_[2]) + step);
    else
      solve(x);
  }

  Vec3 interpolate() const {
    if (grid_.constant) return grid_.velocity(number_);
    Vec3 sum(0);
    for (vtkIdType i = 0; i < cell_->GetNumberOfPoints(); ++i)
      sum += weights_[std::size_t(i)] * grid_.velocity(cell_->GetPointId(int(i)));
    return sum;
  }

  vtkStaticCellLocator* locator_;
  const CellGrid& grid_;
  double rounding_;  // of a position in the grid
  vtkNew<vtkGenericCell> cell_;
  vtkNew<vtkIdList> near_;  // cells that search() looks at
  vtkIdType number_ = -1;   // of the cell
  std::array<double, CellGrid::largest_cell> weights_{};
  double parametric_[3] = {0, 0, 0};
};

class CellField final : public VectorField {
 public:
  CellField(CellGrid grid, std::string description)
      : grid_(std::move(grid)), description_(std::move(description)) {
    locator_->SetDataSet(grid_.cells);
    locator_->BuildLocator();
  }

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<CellSampler>(locator_.Get(), grid_);
  }
  Box3 domain() const override { return grid_.bounds; }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override { return grid_.smallest_width(); }
  std::optional<double> sampling_error() const override {
    return sampling_error_.get([this] { return cell_sampling_error(grid_); });
  }
  std::string description() const override { return description_; }

 private:
  CellGrid grid_;
  vtkNew<vtkStaticCellLocator> locator_;
  std::string description_;
  Lazy<double> sampling_error_;
};

}  // namespace

std::unique_ptr<VectorField> make_cell_field(vtkDataSet* data, const Vectors& vectors,
                                             const std::filesystem::path& path) {
  CellGrid grid = make_cell_grid(data, vectors, path);
  std::string description =
      fmt::format("{}: {} points, {} cells, {}, {}", path.filename().string(),
                  data->GetNumberOfPoints(), grid.cells->GetNumberOfCells(), vectors.title,
                  grid.constant ? "constant in cells" : "linear");
  const std::optional<Plane> plane = grid.plane;
  const Box3 bounds = grid.bounds;
  std::unique_ptr<VectorField> field =
      std::make_unique<CellField>(std::move(grid), std::move(description));
  return plane ? make_planar_field(std::move(field), *plane, bounds, vectors.quantity)
               : std::move(field);
}

}  // namespace pellucid::fields
