// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "integrators/front/front_line.h"

namespace pellucid::integrators {

/// A SynchronousFront is a front line whose particles all advance by the same time; it tiles the
/// ribbons between them as it goes.
class SynchronousFront {
 public:
  /// `rows`: so many of equal duration without refinement; 0: as the refinement says.
  SynchronousFront(SurfaceRun& run, const Refinement& refinement, int rows)
      : run_(run), refinement_(refinement), rows_(rows), front_(run, refinement, rows == 0) {}

  void sweep(std::span<const double> seeds, bool ring);

 private:
  struct Ribbon {
    int left, right;
  };

  void line_up();
  void follow(int first);
  template <class Function>
  void for_each_moving(const Function& function);
  void advance();
  void advance_as_refined();
  double planned_step();
  double row_after(double dt) const;
  double reach(double t);
  bool try_merge(const Ribbon& a, const Ribbon& b);
  void tile(const Ribbon& ribbon);
  void tile(const FrontPoint& left, const FrontPoint& right, std::span<const int> chain);
  void end(const Ribbon& ribbon);
  bool diagonals_stray(const Ribbon& ribbon);
  template <class SurfaceAt>
  double diagonal_sagitta(int left, int right, const SurfaceAt& surface_at) const;
  bool moves_on(int p) const { return !front_.at(p).path.end() || head_of(p).t < path_end(p); }
  const FrontPoint& head_of(int p) const { return front_.at(p).head; }
  double path_end(int p) const { return front_.at(p).path.time(); }

  SurfaceRun& run_;
  const Refinement& refinement_;
  int rows_;
  FrontLine front_;
  double t_ = 0, dt_ = std::numeric_limits<double>::infinity();  // of the last row
  std::vector<int> line_;     // particles with a neighbour, ascending
  std::vector<int> moving_;   // those of them that go on
  std::vector<Ribbon> row_;   // between them
  int known_ = 0;             // particles that line_ has been told of
  std::vector<int> visited_;  // by particle: in which row follow() was there last
  int row_count_ = 0;
  std::vector<FrontPoint> before_;  // by particle: its head in the row before
  std::vector<double> steps_;       // scratch: by moving particle
  std::vector<int> chain_;          // scratch of tile()
};

}  // namespace pellucid::integrators
