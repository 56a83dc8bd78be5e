// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "fields/field.h"

namespace pellucid::testing {}

namespace pellucid::integrators::testing {

using namespace pellucid::testing;

/// A field from a function that may say that it has no sample; its Jacobian is differenced.
class FunctionField final : public fields::VectorField {
 public:
  using Function = std::function<fields::SampleStatus(const Vec3& x, double t, Vec3& v)>;

  explicit FunctionField(Function function, bool steady = true)
      : function_(std::move(function)), steady_(steady) {}

  std::unique_ptr<fields::FieldSampler> sampler() const override {
    return std::make_unique<Sampler>(function_);
  }
  bool steady() const override { return steady_; }
  std::string description() const override { return "function"; }

 private:
  class Sampler final : public fields::FieldSampler {
   public:
    explicit Sampler(Function function) : function_(std::move(function)) {}

    fields::SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
      return function_(x, t, v);
    }

    fields::SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v,
                                               Mat3& jacobian) override {
      constexpr double h = 1e-6;
      const fields::SampleStatus status = function_(x, t, v);
      for (int j = 0; status == fields::SampleStatus::ok && j < 3; ++j) {
        Vec3 before = x, after = x, v0 = v, v1 = v;
        before[j] -= h;
        after[j] += h;
        function_(before, t, v0);
        function_(after, t, v1);
        jacobian[j] = (v1 - v0) / (2 * h);
      }
      return status;
    }

   private:
    Function function_;
  };

  Function function_;
  bool steady_;
};

/// Velocity v(x) inside the box |x_i| ≤ half, nothing outside.
inline FunctionField boxed(std::function<Vec3(const Vec3&)> velocity, double half) {
  return FunctionField([=](const Vec3& x, double, Vec3& v) {
    v = velocity(x);
    const double farthest = glm::max(glm::max(glm::abs(x.x), glm::abs(x.y)), glm::abs(x.z));
    return farthest <= half ? fields::SampleStatus::ok : fields::SampleStatus::outside;
  });
}

inline FunctionField everywhere(std::function<Vec3(const Vec3&)> velocity) {
  return FunctionField([=](const Vec3& x, double, Vec3& v) {
    v = velocity(x);
    return fields::SampleStatus::ok;
  });
}

}  // namespace pellucid::integrators::testing
