// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "core/options/option_table.h"
#include "fields/analytic/catalogue.h"
#include "fields/dual.h"
#include "fields/field.h"
#include "fields/finite.h"

namespace pellucid::fields {

/// Three numbers of a flow's scalar type: a position or a velocity.
template <class T>
struct Triple {
  T x, y, z;
};

/// A flow is a struct that is made of its options, `Flow{options}`, with
///   static constexpr FlowFacts facts;               what `list fields` says about it
///   using Options = …;                              a struct
///   static const OptionTable<Options>& options();
///   Triple<T> operator()(const Triple<T>& x, double t) const;   for any number type T
/// Its velocity is written once; T is double, or Dual for the Jacobian. A flow that some options
/// make steady or unsteady has a member steady().
template <class Flow>
class AnalyticSampler final : public FieldSampler {
 public:
  AnalyticSampler(const Flow& flow, const Box3& domain) : flow_(flow), domain_(domain) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    if (!domain_.contains(x)) return SampleStatus::outside;
    const Triple<double> u = flow_(Triple<double>{x.x, x.y, x.z}, t);
    v = Vec3(u.x, u.y, u.z);
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    if (!domain_.contains(x)) return SampleStatus::outside;
    const Triple<Dual> u =
        flow_(Triple<Dual>{{x.x, Vec3(1, 0, 0)}, {x.y, Vec3(0, 1, 0)}, {x.z, Vec3(0, 0, 1)}}, t);
    v = Vec3(u.x.value, u.y.value, u.z.value);
    jacobian = glm::transpose(Mat3(u.x.gradient, u.y.gradient, u.z.gradient));
    return is_finite(v) && is_finite(jacobian) ? SampleStatus::ok : SampleStatus::not_finite;
  }

 private:
  Flow flow_;
  Box3 domain_;
};

/// An AnalyticField is a flow of the catalogue as a VectorField, with the options it was given.
template <class Flow>
class AnalyticField final : public VectorField {
 public:
  explicit AnalyticField(const Parameters& parameters)
      : flow_{Flow::options().read(parameters)}, description_(describe(parameters)) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<AnalyticSampler<Flow>>(flow_, domain());
  }
  Box3 domain() const override {
    return Flow::facts.bounded ? Flow::facts.region : Box3::unbounded();
  }
  bool steady() const override {
    if constexpr (requires { flow_.steady(); })
      return flow_.steady();
    else
      return Flow::facts.steady;
  }
  std::string description() const override { return description_; }

 private:
  static std::string describe(const Parameters& parameters) {
    std::string text(Flow::facts.name);
    for (const auto& [key, value] : parameters.all())
      text.append(text.size() == Flow::facts.name.size() ? ":" : ",")
          .append(key)
          .append("=")
          .append(value);
    return text;
  }

  Flow flow_;
  std::string description_;
};

}  // namespace pellucid::fields

/// Flows live in a namespace where the elementary functions of double and of Dual go by one name.
namespace pellucid::fields::flow {

/// A flow that takes no options derives from WithoutOptions.
struct WithoutOptions {
  using Options = WithoutOptions;
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{};
    return table;
  }
};

using std::abs;
using std::cos;
using std::exp;
using std::log;
using std::sin;
using std::sqrt;
using std::tanh;
using std::numbers::pi;

}  // namespace pellucid::fields::flow
