// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fields/levels/level_field.h"
#include "groundtruth/levels/level_ray.h"

namespace pellucid::groundtruth {

/// A HitRefinement says how a crossing between two samples is placed: by the line through both, by
/// bisection of the field, or, as in the report, at the first sample inside, where the field is
/// above the value; ways out do not count then.
enum class HitRefinement { linear, bisection, sample };

/// MarchOptions are the parameters of a march.
struct MarchOptions {
  double steps_per_cell = 8;  // dx / step, of the finest level that takes part; > 0
  HitRefinement refinement = HitRefinement::linear;
  bool skip_empty = true;  // pass over blocks and cells that the surface does not touch

  /// A march ends where its ray enters an opaque sphere of the scene grown by this, in world units;
  /// none: it does not.
  std::optional<double> dilate = {};

  bool operator==(const MarchOptions&) const = default;
};

/// A LevelMarch finds crossings of rays with a surface by marching front to back, as in Li, Chen,
/// Multi-Resolution Isosurface Rendering (2023), Sect. 3.5: the field is sampled at steps of a
/// fraction of the finest cell that takes part where the ray is, and two samples on different sides
/// of the value have one crossing between them. It is placed by the line through both, or by
/// bisection. Of crossings between two samples all but one are lost when they are odd in number,
/// and all when even; a linearly placed one errs by up to a step.
///
/// It differs from the report: steps start anew where the levels that take part change, so that the
/// samples of k steps a cell are among those of 2k; where the report counts the first sample
/// inside as the hit, this one is refined and both ways through the surface count, unless
/// HitRefinement::sample is chosen. Empty space is
/// passed over, in blocks of 4³ lattice cells and in cells, without a change of the samples that a
/// march takes elsewhere: every crossing stays.
class LevelMarch {
 public:
  /// The field has to outlive it.
  LevelMarch(const fields::LevelField& field, double value, const MarchOptions& options);

  /// Calls `visit` with the ray's parameter at every crossing that the march finds from t = 0 on,
  /// ascending, until it returns false.
  void visit_crossings(const WorldRay& ray, const std::function<bool(double)>& visit) const;

  std::uint64_t bytes() const;

 private:
  struct Sample {
    double t = 0;
    std::optional<double> height;  // Σ w (f - value) / Σ w; nothing outside of the field
  };

  std::optional<double> height_at(const Vec3& x, std::span<const std::uint32_t> levels) const;
  /// Whether the surface is crossed from one sample to the next.
  bool is_hit(const Sample& a, const Sample& b) const;
  double refined(const WorldRay& ray, std::span<const std::uint32_t> levels, const Sample& a,
                 const Sample& b) const;
  /// A Stretch is the part of a ray within the same empty blocks, or else cells, of all levels that
  /// take part.
  struct Stretch {
    bool empty;  // of the surface
    double end;  // the ray's parameter
  };
  Stretch stretch_at(const WorldRay& ray, std::span<const std::uint32_t> levels, double t) const;
  /// Samples lie at begin + i step, and at the end.
  struct Samples {
    double begin, step, end;
    double at(double i) const { return std::min(begin + step * i, end); }
    /// The last one before t.
    double before(double t) const { return std::ceil((std::min(t, end) - begin) / step) - 1; }
  };
  /// Returns whether a level's domain holds all samples but the first and the last.
  bool owns(std::uint32_t level, const WorldRay& ray, const Samples& samples) const;
  /// Returns where the ray leaves the empty blocks of a level that follow each other from t on, up
  /// to `end`; t where the first is not empty.
  double end_of_empty_blocks(const WorldRay& ray, std::uint32_t level, double t, double end) const;
  /// Returns the last sample from the i-th on that is known to lie on its side, where the stretch
  /// that holds it is empty, and makes `stretch` that of this sample or of the next. `alone`: all
  /// samples but the first and the last are of one level, and in its domain.
  double last_alike(const WorldRay& ray, std::span<const std::uint32_t> levels,
                    const Samples& samples, double i, bool alone, Stretch& stretch) const;
  std::size_t block_index(std::uint32_t level, const std::array<int, 3>& block) const;

  /// Blocks hold a level's blocks of lattice cells, x fastest.
  struct Blocks {
    std::array<int, 3> size{};
    std::vector<std::uint64_t> occupied;  // a bit a cell: the surface may pass through
  };

  const fields::LevelField& field_;
  double value_;
  MarchOptions options_;
  std::vector<Blocks> blocks_;  // by level; none where empty space is not skipped
};

}  // namespace pellucid::groundtruth
