// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/dense_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/error.h"
#include "fields/finite.h"
#include "fields/lazy.h"
#include "fields/sampled/sampling_error.h"

namespace pellucid::fields {
namespace {

Box3 grid_box(const std::array<Axis, 3>& axes) {
  return {Vec3(axes[0].front(), axes[1].front(), axes[2].front()),
          Vec3(axes[0].back(), axes[1].back(), axes[2].back())};
}

Vec3 smallest_widths(const std::array<Axis, 3>& axes) {
  return {axes[0].smallest_width(), axes[1].smallest_width(), axes[2].smallest_width()};
}

/// What samplers share and do not change.
template <class Sample, class Interpolant>
struct DenseData {
  explicit DenseData(DenseGrid<Sample> grid_)
      : grid(std::move(grid_)),
        box(grid_box(grid.axes)),
        slack(edge_rounding * smallest_widths(grid.axes)),
        stride_y(grid.axes[0].size() - fewer),
        stride_z(stride_y * (grid.axes[1].size() - fewer)),
        interpolants{Interpolant(grid.axes[0]), Interpolant(grid.axes[1]),
                     Interpolant(grid.axes[2])} {}

  DenseGrid<Sample> grid;
  static constexpr std::size_t fewer = Interpolant::support == 1;  // samples than positions

  Box3 box;    // in grid coordinates
  Vec3 slack;  // so little beyond the box is still in it
  std::size_t stride_y, stride_z;
  std::array<Interpolant, 3> interpolants;
};

template <class Sample, class Interpolant>
class DenseSampler final : public FieldSampler {
 public:
  using Data = DenseData<Sample, Interpolant>;
  explicit DenseSampler(const Data& data) : data_(data) {}

  SampleStatus velocity(const Vec3& x, double, Vec3& v) override {
    Vec3 p;
    if (!to_grid(x, p)) return SampleStatus::outside;
    const auto wx = stencil(p, 0), wy = stencil(p, 1), wz = stencil(p, 2);
    v = Vec3(0);
    for (int k = 0; k < N; ++k) {
      Vec3 plane(0);
      for (int j = 0; j < N; ++j) plane += wy.value[j] * row(wx, wy.first + j, wz.first + k);
      v += wz.value[k] * plane;
    }
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double, Vec3& v, Mat3& jacobian) override {
    Vec3 p;
    if (!to_grid(x, p)) return SampleStatus::outside;
    const auto wx = stencil(p, 0), wy = stencil(p, 1), wz = stencil(p, 2);
    v = Vec3(0);
    jacobian = Mat3(0);
    for (int k = 0; k < N; ++k) {
      Vec3 plane(0), plane_dx(0), plane_dy(0);
      for (int j = 0; j < N; ++j) {
        Vec3 line_dx;
        const Vec3 line = row(wx, wy.first + j, wz.first + k, line_dx);
        plane += wy.value[j] * line;
        plane_dx += wy.value[j] * line_dx;
        plane_dy += wy.slope[j] * line;
      }
      v += wz.value[k] * plane;
      jacobian[0] += wz.value[k] * plane_dx;
      jacobian[1] += wz.value[k] * plane_dy;
      jacobian[2] += wz.slope[k] * plane;
    }
    if (data_.grid.frame) jacobian = jacobian * data_.grid.frame->grid_from_world;
    return is_finite(v) && is_finite(jacobian) ? SampleStatus::ok : SampleStatus::not_finite;
  }

 private:
  static constexpr int N = Interpolant::support;

  /// False outside.
  bool to_grid(const Vec3& x, Vec3& p) const {
    p = data_.grid.frame ? data_.grid.frame->to_grid(x) : x;
    return data_.box.contains(p) || clamp_rounding(p);
  }

  /// The file's spacing and the caller's position are rounded: a point that misses the last sample
  /// by less than that is on it.
  bool clamp_rounding(Vec3& p) const {
    const Vec3 moved = p;
    p = glm::clamp(p, data_.box.min, data_.box.max);
    return glm::all(glm::lessThan(glm::abs(p - moved), data_.slack));
  }

  Stencil<N> stencil(const Vec3& p, int axis) const {
    return data_.interpolants[axis].stencil(data_.grid.axes[axis], p[axis]);
  }

  const Sample* row_begin(std::size_t i, std::size_t j, std::size_t k) const {
    return data_.grid.samples.data() + k * data_.stride_z + j * data_.stride_y + i;
  }

  Vec3 row(const Stencil<N>& w, std::size_t j, std::size_t k) const {
    const Sample* samples = row_begin(w.first, j, k);
    Vec3 sum(0);
    for (int i = 0; i < N; ++i) sum += w.value[i] * Vec3(samples[i]);
    return sum;
  }

  Vec3 row(const Stencil<N>& w, std::size_t j, std::size_t k, Vec3& slope) const {
    const Sample* samples = row_begin(w.first, j, k);
    slope = Vec3(0);
    for (int i = 0; i < N; ++i) slope += w.slope[i] * Vec3(samples[i]);
    return row(w, j, k);
  }

  const Data& data_;
};

template <class Sample, class Interpolant>
class DenseField final : public VectorField {
 public:
  DenseField(DenseGrid<Sample> grid, std::string description)
      : data_(std::move(grid)),
        description_(fmt::format("{}, {}", description, Interpolant::name)) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<DenseSampler<Sample, Interpolant>>(data_);
  }
  Box3 domain() const override {
    return data_.grid.frame ? data_.grid.frame->world_box(data_.box) : data_.box;
  }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override {
    if (data_.grid.frame) return data_.grid.frame->smallest_unit();
    const Vec3 widths = smallest_widths(data_.grid.axes);
    return std::min({widths.x, widths.y, widths.z});
  }
  std::optional<double> sampling_error() const override {
    return sampling_error_.get(
        [this] { return estimate_sampling_error(data_.grid, Interpolant::support); });
  }
  /// A grid that is turned fills less than its box.
  bool fills_domain() const override {
    return !data_.grid.frame && fills_.get([this] {
      const auto& samples = data_.grid.samples;
      return std::all_of(samples.begin(), samples.end(),
                         [](const Sample& sample) { return is_finite(Vec3(sample)); });
    });
  }
  std::string description() const override { return description_; }

 private:
  DenseData<Sample, Interpolant> data_;
  std::string description_;
  Lazy<double> sampling_error_;
  Lazy<bool> fills_;
};

}  // namespace

Box3 GridFrame::world_box(const Box3& grid_box) const {
  const Mat3 world_from_grid = glm::inverse(grid_from_world);
  Box3 world;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p = grid_box.min;
    for (int axis = 0; axis < 3; ++axis)
      if (corner >> axis & 1) p[axis] = grid_box.max[axis];
    world.extend(world_from_grid * p + origin);
  }
  return world;
}

double GridFrame::smallest_unit() const {
  const Mat3 world_from_grid = glm::inverse(grid_from_world);
  return std::min({glm::length(world_from_grid[0]), glm::length(world_from_grid[1]),
                   glm::length(world_from_grid[2])});
}

namespace {

[[maybe_unused]] std::size_t sample_count(const std::array<Axis, 3>& axes, std::size_t fewer) {
  return (axes[0].size() - fewer) * (axes[1].size() - fewer) * (axes[2].size() - fewer);
}

void require_positions(const std::array<Axis, 3>& axes, std::size_t needed,
                       const std::string& description) {
  for (const Axis& axis : axes)
    if (axis.size() < needed)
      throw InputError(fmt::format("{}: {} samples along an axis; sampler={} needs {}", description,
                                   axis.size(), needed == 2 ? "linear" : "c1", needed));
}

}  // namespace

template <class Sample>
std::unique_ptr<VectorField> make_dense_field(DenseGrid<Sample> grid, Interpolation interpolation,
                                              std::string description) {
  require_positions(grid.axes, interpolation == Interpolation::c1 ? 4 : 2, description);
  assert(grid.samples.size() == sample_count(grid.axes, interpolation == Interpolation::constant));
  const auto field = [&]<class Interpolant>() -> std::unique_ptr<VectorField> {
    return std::make_unique<DenseField<Sample, Interpolant>>(std::move(grid),
                                                             std::move(description));
  };
  switch (interpolation) {
    case Interpolation::c1:
      return field.template operator()<CubicInterpolation>();
    case Interpolation::constant:
      return field.template operator()<ConstantInterpolation>();
    case Interpolation::linear:
      break;
  }
  return field.template operator()<LinearInterpolation>();
}

template std::unique_ptr<VectorField> make_dense_field(DenseGrid<glm::vec3>, Interpolation,
                                                       std::string);
template std::unique_ptr<VectorField> make_dense_field(DenseGrid<Vec3>, Interpolation, std::string);

}  // namespace pellucid::fields
