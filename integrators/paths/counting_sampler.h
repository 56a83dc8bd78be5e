// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "fields/field.h"

namespace pellucid::integrators {

/// A sampler that counts how often it is asked.
class CountingSampler final : public fields::FieldSampler {
 public:
  explicit CountingSampler(const fields::VectorField& field) : sampler_(field.sampler()) {}
  /// `length`: over which the flow is looked at, world units.
  CountingSampler(const fields::VectorField& field, double length) : CountingSampler(field) {
    sampler_->resolve(length);
  }

  fields::SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    ++evaluations_;
    return sampler_->velocity(x, t, v);
  }
  fields::SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v,
                                             Mat3& jacobian) override {
    ++evaluations_;
    return sampler_->velocity_and_jacobian(x, t, v, jacobian);
  }

  void resolve(double length) override { sampler_->resolve(length); }
  void follow(fields::LastCell* last) override { sampler_->follow(last); }

  std::uint64_t evaluations() const { return evaluations_; }

 private:
  std::unique_ptr<fields::FieldSampler> sampler_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace pellucid::integrators
