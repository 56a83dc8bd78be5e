// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/reversed_field.h"

#include <utility>

namespace pellucid::fields {
namespace {

class ReversedSampler final : public FieldSampler {
 public:
  ReversedSampler(std::unique_ptr<FieldSampler> inner, double start)
      : inner_(std::move(inner)), start_(start) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    const SampleStatus status = inner_->velocity(x, mirrored(t), v);
    v = -v;
    return status;
  }
  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    const SampleStatus status = inner_->velocity_and_jacobian(x, mirrored(t), v, jacobian);
    v = -v;
    jacobian = -jacobian;
    return status;
  }
  void resolve(double length) override { inner_->resolve(length); }
  void follow(LastCell* last) override { inner_->follow(last); }

 private:
  /// Of `start` itself exactly that: 2 start - t may be rounded.
  double mirrored(double t) const { return start_ - (t - start_); }

  std::unique_ptr<FieldSampler> inner_;
  double start_;
};

class ReversedField final : public VectorField {
 public:
  ReversedField(std::shared_ptr<const VectorField> inner, double start)
      : inner_(std::move(inner)), start_(start) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<ReversedSampler>(inner_->sampler(), start_);
  }
  Box3 domain() const override { return inner_->domain(); }
  bool steady() const override { return inner_->steady(); }
  std::optional<double> time_spacing() const override { return inner_->time_spacing(); }
  std::optional<double> cell_size() const override { return inner_->cell_size(); }
  std::optional<double> sampling_error() const override { return inner_->sampling_error(); }
  bool fills_domain() const override { return inner_->fills_domain(); }
  std::string description() const override { return inner_->description() + ", backward"; }
  double start() const { return start_; }
  const VectorField& inner() const { return *inner_; }

 private:
  std::shared_ptr<const VectorField> inner_;
  double start_;
};

}  // namespace

std::optional<double> start_of_reversed(const VectorField& field) {
  const auto* reversed = dynamic_cast<const ReversedField*>(&field);
  return reversed ? std::optional(reversed->start()) : std::nullopt;
}

const VectorField& unreversed(const VectorField& field) {
  const auto* reversed = dynamic_cast<const ReversedField*>(&field);
  return reversed ? reversed->inner() : field;
}

std::shared_ptr<const VectorField> reversed(std::shared_ptr<const VectorField> field,
                                            double start) {
  return std::make_shared<ReversedField>(std::move(field), start);
}

}  // namespace pellucid::fields
