// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "core/vec.h"

namespace pellucid::fields {

/// A SampleStatus says whether a velocity could be given, and why not: the position is outside of
/// the field, or the velocity there is not finite.
enum class SampleStatus { ok, outside, not_finite };

/// A LastCell is where in a field's cells a particle was last, which its sampler knows how to read.
/// Between samplers of one field it may be handed on.
struct LastCell {
  std::uint32_t number = std::numeric_limits<std::uint32_t>::max();
};

/// A FieldSampler is one thread's view of a field: it owns whatever caches a look-up needs (grid
/// accessors, cell locators, a formula's stack) and is not shared between threads. Counting
/// evaluations is the caller's business.
class FieldSampler {
 public:
  virtual ~FieldSampler() = default;

  /// Computes the velocity at world position x and time t, in world units per unit of time. `v` is
  /// only valid when the status is ok.
  virtual SampleStatus velocity(const Vec3& x, double t, Vec3& v) = 0;

  /// Computes the velocity and its Jacobian, per unit of time: jacobian[j][i] = ∂v_i/∂x_j (GLM's
  /// column j is the derivative along axis j). Both are only valid when the status is ok.
  virtual SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) = 0;

  /// Says that the flow is looked at over this length, in world units: who takes its Jacobian from
  /// differences takes them over a small part of it.
  virtual void resolve(double /*length*/) {}

  /// Makes a sampler of cells look for places in the particle's last cell first, and keep it up to
  /// date; with nullptr in none, as at the beginning. Where cells overlap, the last one may decide
  /// which counts: so it is one particle's, and its way depends on nothing but itself.
  virtual void follow(LastCell* /*last*/) {}
};

/// A VectorField is a velocity v(x, t) in world coordinates. It is immutable and shared between
/// threads; samplers are per thread and must not outlive it.
class VectorField {
 public:
  virtual ~VectorField() = default;

  /// Makes a sampler for one thread.
  virtual std::unique_ptr<FieldSampler> sampler() const = 0;

  /// Returns the box in which samples exist, in world units; unbounded for most analytic fields.
  virtual Box3 domain() const { return Box3::unbounded(); }
  /// Returns true when v does not depend on t.
  virtual bool steady() const = 0;
  /// Returns the time between frames of a series, the shortest that counts, in units of time.
  virtual std::optional<double> time_spacing() const { return std::nullopt; }
  /// Returns the smallest cell width of a sampled field, in world units: the default step is half
  /// of it.
  virtual std::optional<double> cell_size() const { return std::nullopt; }
  /// Returns the largest estimated interpolation error of a sampled field's velocity, in world
  /// units per unit of time. The first call looks at all samples.
  virtual std::optional<double> sampling_error() const { return std::nullopt; }
  /// Returns true when a sampled field has a velocity everywhere in domain(). Only then may a step
  /// be longer than a cell; it could jump over a hole.
  virtual bool fills_domain() const { return false; }
  /// Returns one line for reports: name, parameters or file, size.
  virtual std::string description() const = 0;
};

}  // namespace pellucid::fields
