// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/vec.h"

namespace pellucid::fields {

/// Why a velocity could not be given.
enum class SampleStatus { ok, outside, not_finite };

/// One thread's view of a field: it owns whatever caches a look-up needs (grid accessors, cell
/// locators, a formula's stack) and is not shared between threads. Counting evaluations is the
/// caller's business.
class FieldSampler {
 public:
  virtual ~FieldSampler() = default;

  /// Velocity at world position x and time t, in world units per unit of time. `v` is only valid
  /// when the status is ok.
  virtual SampleStatus velocity(const Vec3& x, double t, Vec3& v) = 0;

  /// Velocity and its Jacobian, jacobian[j][i] = ∂v_i/∂x_j (GLM's column j is the derivative along
  /// axis j).
  virtual SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) = 0;
};

/// A vector field v(x, t). Immutable and shared between threads; samplers are per thread and must
/// not outlive it.
class VectorField {
 public:
  virtual ~VectorField() = default;

  virtual std::unique_ptr<FieldSampler> sampler() const = 0;

  /// Where samples exist; unbounded for most analytic fields.
  virtual Box3 domain() const { return Box3::unbounded(); }
  /// True when v does not depend on t.
  virtual bool steady() const = 0;
  /// Smallest cell width in world units for sampled fields: the default step is half of it.
  virtual std::optional<double> cell_size() const { return std::nullopt; }
  /// Largest estimated interpolation error of the velocity, in world units per unit of time. The
  /// first call looks at all samples.
  virtual std::optional<double> sampling_error() const { return std::nullopt; }
  /// Sampled fields: is there a velocity everywhere in domain()? Only then may a step be longer
  /// than a cell; it could jump over a hole.
  virtual bool fills_domain() const { return false; }
  /// One line for reports: name, parameters or file, size.
  virtual std::string description() const = 0;
};

}  // namespace pellucid::fields
