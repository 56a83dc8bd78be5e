// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/planar_field.h"

#include <cmath>
#include <string>

namespace pellucid::fields {
namespace {

class PlanarSampler final : public FieldSampler {
 public:
  PlanarSampler(std::unique_ptr<FieldSampler> inner, const Plane& plane, Quantity quantity)
      : inner_(std::move(inner)),
        plane_(plane),
        along_(Mat3(1) - glm::outerProduct(plane.normal, plane.normal)),
        flatten_(quantity == Quantity::velocity ? along_ : Mat3(1)) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    if (!is_on_plane(x)) return SampleStatus::outside;
    const SampleStatus status = inner_->velocity(plane_.onto(x), t, v);
    v = flatten_ * v;
    return status;
  }
  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    if (!is_on_plane(x)) return SampleStatus::outside;
    const SampleStatus status = inner_->velocity_and_jacobian(plane_.onto(x), t, v, jacobian);
    v = flatten_ * v;
    jacobian = flatten_ * jacobian * along_;
    return status;
  }
  void follow(LastCell* last) override { inner_->follow(last); }

 private:
  bool is_on_plane(const Vec3& x) const { return std::abs(plane_.distance(x)) <= plane_.slack; }

  std::unique_ptr<FieldSampler> inner_;
  Plane plane_;
  Mat3 along_;    // takes a vector's part across the plane away
  Mat3 flatten_;  // of what is sampled
};

class PlanarField final : public VectorField {
 public:
  PlanarField(std::unique_ptr<VectorField> inner, const Plane& plane, const Box3& bounds,
              Quantity quantity)
      : inner_(std::move(inner)), plane_(plane), bounds_(bounds), quantity_(quantity) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<PlanarSampler>(inner_->sampler(), plane_, quantity_);
  }
  Box3 domain() const override { return bounds_; }
  bool steady() const override { return inner_->steady(); }
  std::optional<double> time_spacing() const override { return inner_->time_spacing(); }
  std::optional<double> cell_size() const override { return inner_->cell_size(); }
  std::optional<double> sampling_error() const override { return inner_->sampling_error(); }
  std::string description() const override {
    return inner_->description() + ", on a plane, the velocity's part across it left out";
  }

 private:
  std::unique_ptr<VectorField> inner_;
  Plane plane_;
  Box3 bounds_;
  Quantity quantity_;
};

}  // namespace

std::unique_ptr<VectorField> make_planar_field(std::unique_ptr<VectorField> field,
                                               const Plane& plane, const Box3& bounds,
                                               Quantity quantity) {
  return std::make_unique<PlanarField>(std::move(field), plane, bounds, quantity);
}

}  // namespace pellucid::fields
