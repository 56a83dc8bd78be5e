// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/sampled/periodic_field.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace pellucid::fields {
namespace {

using Repeats = std::array<std::optional<Repeat>, 3>;

/// The place in the first period; what is not finite stays so.
Vec3 folded(const Repeats& along, Vec3 x) {
  for (int axis = 0; axis < 3; ++axis)
    if (const auto& repeat = along[std::size_t(axis)]) {
      const double turns = std::floor((x[axis] - repeat->first) / repeat->period);
      x[axis] -= turns * repeat->period;
    }
  return x;
}

class PeriodicSampler final : public FieldSampler {
 public:
  PeriodicSampler(std::unique_ptr<FieldSampler> inner, const Repeats& along)
      : inner_(std::move(inner)), along_(along) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    return inner_->velocity(folded(along_, x), t, v);
  }
  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    return inner_->velocity_and_jacobian(folded(along_, x), t, v, jacobian);
  }
  void follow(LastCell* last) override { inner_->follow(last); }

 private:
  std::unique_ptr<FieldSampler> inner_;
  const Repeats& along_;
};

class PeriodicField final : public VectorField {
 public:
  PeriodicField(std::unique_ptr<VectorField> inner, const Repeats& along)
      : inner_(std::move(inner)), along_(along) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<PeriodicSampler>(inner_->sampler(), along_);
  }
  Box3 domain() const override {
    Box3 box = inner_->domain();
    for (int axis = 0; axis < 3; ++axis)
      if (along_[std::size_t(axis)]) {
        box.min[axis] = -std::numeric_limits<double>::infinity();
        box.max[axis] = std::numeric_limits<double>::infinity();
      }
    return box;
  }
  bool steady() const override { return inner_->steady(); }
  std::optional<double> time_spacing() const override { return inner_->time_spacing(); }
  std::optional<double> cell_size() const override { return inner_->cell_size(); }
  std::optional<double> sampling_error() const override { return inner_->sampling_error(); }
  bool fills_domain() const override { return inner_->fills_domain(); }
  std::string description() const override {
    std::string text = inner_->description();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (along_[axis])
        text +=
            fmt::format(", periodic along {} over {:.12g}", "xyz"[axis], along_[axis] -> period);
    return text;
  }

 private:
  std::unique_ptr<VectorField> inner_;
  Repeats along_;
};

}  // namespace

std::unique_ptr<VectorField> make_periodic_field(std::unique_ptr<VectorField> field,
                                                 const Repeats& along) {
  return std::make_unique<PeriodicField>(std::move(field), along);
}

}  // namespace pellucid::fields
