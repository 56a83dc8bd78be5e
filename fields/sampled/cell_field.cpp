// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/cell_field.h"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

#include "fields/finite.h"
#include "fields/lazy.h"
#include "fields/sampled/cell_corners.h"
#include "fields/sampled/cell_error.h"
#include "fields/sampled/cell_grid.h"
#include "fields/sampled/cell_inverse.h"
#include "fields/sampled/cell_locator.h"
#include "fields/sampled/linear_cells.h"
#include "fields/sampled/planar_field.h"

namespace pellucid::fields {
namespace {

/// GetCell is safe on several threads as long as each brings its own vtkGenericCell; the grid and
/// the locator do not change once built. Of cells that hold a place together, on their borders or
/// where a file's overlap, the particle's last one counts, else the first.
class CellSampler final : public FieldSampler {
 public:
  CellSampler(const CellLocator& locator, const CellCorners& corners, const CellGrid& grid,
              double rounding)
      : locator_(locator), corners_(corners), grid_(grid), rounding_(rounding) {}

  SampleStatus velocity(const Vec3& x, double, Vec3& v) override {
    if (!find(x)) return SampleStatus::outside;
    v = interpolate();
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double, Vec3& v, Mat3& jacobian) override {
    if (!find(x)) return SampleStatus::outside;
    v = interpolate();
    jacobian = grid_.constant ? Mat3(0) : slope();
    return is_finite(v) && is_finite(jacobian) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  void follow(LastCell* last) override { last_ = last; }

 private:
  /// Takes a place x to the weights inverse (x - corner) of a tetrahedron's other corners.
  struct TetrahedronMap {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t cell = none;
    Vec3 corner{0};
    Mat3 inverse{0};
  };
  /// By whom the cell was solved.
  enum class Kind { tetrahedron, hexahedron, vtk };

  bool find(const Vec3& x) {
    if (last_ && last_->number < corners_.cells() && holds(last_->number, x, true)) return true;
    if (!search(x)) return false;
    if (last_) last_->number = cell_;
    return true;
  }

  bool search(const Vec3& x) {
    const std::span<const std::uint32_t> near = locator_.cells_at(x);
    for (const std::uint32_t cell : near)
      if (holds(cell, x)) return true;
    for (const std::uint32_t cell : near)
      if (solve(cell, x)) return true;
    return false;
  }

  bool holds(std::uint32_t cell, const Vec3& x, bool is_last = false) {
    numbers_ = corners_.points(cell, eight_);
    cell_ = cell;
    switch (corners_.type(cell)) {
      case VTK_TETRA:
        return in_tetrahedron(x, is_last);
      case VTK_HEXAHEDRON:
        return in_hexahedron(x);
      default:
        return by_vtk(x);
    }
  }

  template <std::size_t N>
  std::array<Vec3, N> arms(const Vec3& x) const {
    std::array<Vec3, N> arms;
    for (std::size_t i = 0; i < N; ++i) arms[i] = corners_.place(numbers_[i]) - x;
    return arms;
  }

  /// Of the particle's last cell by its map, which is known most often; of others by volumes, which
  /// tell first that it is not. Neither asks what was known: that would let chance decide on faces.
  bool in_tetrahedron(const Vec3& x, bool is_last) {
    if (!is_last && !is_in_tetrahedron(arms<4>(x))) return false;
    if (tetrahedron_.cell != cell_) tetrahedron_ = map_of_tetrahedron();
    const Vec3 p = tetrahedron_.inverse * (x - tetrahedron_.corner);
    const double first = 1 - p.x - p.y - p.z;
    if (is_last && !(p.x >= 0 && p.y >= 0 && p.z >= 0 && first >= 0)) return false;
    weights_[0] = first, weights_[1] = p.x, weights_[2] = p.y, weights_[3] = p.z;
    kind_ = Kind::tetrahedron;
    return true;
  }

  bool in_hexahedron(const Vec3& x) {
    const Side side = place_in_hexahedron(arms<8>(x), parametric_);
    if (side == Side::unsure) return solve(cell_, x);
    if (side == Side::outside) return false;
    std::ranges::copy(hexahedron_weights(parametric_), weights_.begin());
    kind_ = Kind::hexahedron;
    return true;
  }

  bool by_vtk(const Vec3& x) {
    if (!corners_.box(cell_).contains(x)) return false;
    grid_.cells->GetCell(cell_, vtk_cell_);
    int part;
    double squared_distance;
    if (vtk_cell_->EvaluatePosition(&x.x, nullptr, part, &parametric_.x, squared_distance,
                                    weights_.data()) != 1)
      return false;
    kind_ = Kind::vtk;
    if (!grid_.constant) polish(x);
    return true;
  }

  /// Finds where in the cell x is by an iteration that ends also where those above give up, and
  /// forgives a rounding.
  bool solve(std::uint32_t cell, const Vec3& x) {
    numbers_ = corners_.points(cell, eight_);
    cell_ = cell;
    grid_.cells->GetCell(cell, vtk_cell_);
    const std::optional<Vec3> place = place_in_cell(*vtk_cell_, x);
    if (place) move_to(*place);
    kind_ = Kind::vtk;
    return place.has_value();
  }

  void move_to(const Vec3& place) {
    parametric_ = place;
    vtk_cell_->InterpolateFunctions(&parametric_.x, weights_.data());
  }

  /// One more step of Newton's iteration: VTK stops when a step is below a thousandth of a cell,
  /// and the next one squares the error. A step longer than that is one of a cell that is nearly
  /// flat there.
  void polish(const Vec3& x) {
    constexpr double longest = 1e-3;
    if (vtk_cell_->GetCellType() == VTK_VOXEL) return;  // solved directly
    Vec3 miss = x;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      miss -= weights_[i] * corners_.place(numbers_[i]);
    if (glm::length(miss) <= rounding_) return;
    const Vec3 step = glm::inverse(grid_.slopes(*vtk_cell_, &parametric_.x).position) * miss;
    if (glm::length(step) <= longest)
      move_to(parametric_ + step);
    else
      solve(cell_, x);
  }

  Vec3 interpolate() const {
    if (grid_.constant) return grid_.velocity(cell_);
    Vec3 sum(0);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      sum += weights_[i] * grid_.velocity(numbers_[i]);
    return sum;
  }

  Mat3 slope() {
    switch (kind_) {
      case Kind::tetrahedron:
        return slope_of_tetrahedron();
      case Kind::hexahedron:
        return CellGrid::jacobian([this](const Vec3& at) { return slopes_of_hexahedron(at); },
                                  parametric_, Vec3(0.5));
      case Kind::vtk:
        return grid_.jacobian(*vtk_cell_, &parametric_.x);
    }
    return {};
  }

  TetrahedronMap map_of_tetrahedron() const {
    const Vec3& corner = corners_.place(numbers_[0]);
    Mat3 edges;
    for (int k = 0; k < 3; ++k) edges[k] = corners_.place(numbers_[std::size_t(k + 1)]) - corner;
    return {cell_, corner, glm::inverse(edges)};
  }
  Mat3 slope_of_tetrahedron() const {
    Mat3 slopes;
    for (int k = 0; k < 3; ++k)
      slopes[k] = grid_.velocity(numbers_[std::size_t(k + 1)]) - grid_.velocity(numbers_[0]);
    return slopes * tetrahedron_.inverse;
  }

  CellGrid::Slopes slopes_of_hexahedron(const Vec3& at) const {
    const std::array<Vec3, 8> of_weights = hexahedron_slopes(at);
    CellGrid::Slopes slopes{Mat3(0), Mat3(0)};
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 8; ++i) {
        slopes.position[axis] += of_weights[i][axis] * corners_.place(numbers_[i]);
        slopes.velocity[axis] += of_weights[i][axis] * grid_.velocity(numbers_[i]);
      }
    return slopes;
  }

  const CellLocator& locator_;
  const CellCorners& corners_;
  const CellGrid& grid_;
  double rounding_;  // of a position in the grid
  vtkNew<vtkGenericCell> vtk_cell_;

  LastCell* last_ = nullptr;

  // The cell that was found.
  std::uint32_t cell_ = 0;
  Kind kind_ = Kind::vtk;
  CellCorners::Numbers numbers_;  // of its points
  std::array<vtkTypeInt64, 8> eight_;
  TetrahedronMap tetrahedron_;  // of the last cell that was one
  std::array<double, CellGrid::largest_cell> weights_{};
  Vec3 parametric_{0};
};

class CellField final : public VectorField {
 public:
  CellField(CellGrid grid, std::string description)
      : grid_(std::move(grid)),
        corners_(*grid_.cells),
        rounding_(1e-14 * grid_.search_box.diagonal()),
        locator_(std::size_t(grid_.cells->GetNumberOfCells()),
                 [this](std::size_t cell) {
                   const Box3 box = corners_.box(cell);
                   return Box3{box.min - rounding_, box.max + rounding_};
                 }),
        description_(std::move(description)) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<CellSampler>(locator_, corners_, grid_, rounding_);
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
  CellCorners corners_;
  double rounding_;  // of a position in the grid
  CellLocator locator_;
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
