// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "fields/levels/level.h"
#include "fields/levels/sample_scale.h"

namespace pellucid::fields {

/// ExactLevels hold every sample as its file or its formula gives it: in floats where these are all
/// floats, else in doubles.
using ExactLevels = std::variant<std::vector<ScalarLevel>, std::vector<DoubleLevel>>;

/// ScaledLevels are levels as a LevelField keeps them, in floats of one scale.
struct ScaledLevels {
  std::vector<ScalarLevel> levels;
  SampleScale scale;
};

/// Returns the levels in floats where each of their samples is one.
ExactLevels exact(std::vector<DoubleLevel> levels);

/// Appends levels, in doubles where one of both is.
void append(ExactLevels more, ExactLevels& levels);

/// Says whether there is no level.
bool is_empty(const ExactLevels& levels);

/// Returns the least and the largest sample; (inf, -inf) of none.
Vec2 sample_range(const ExactLevels& levels);

/// Returns all samples, level by level.
std::vector<double> samples_of(const ExactLevels& levels);

/// Rounds levels to floats. Floats stay as they are. Doubles count from `about` on, so that each is
/// off by 6e-8 of its distance from that value at most: of a surface of that value a crossing keeps
/// its place in its cell to 6e-8 of the cell's width, whatever the samples' range.
ScaledLevels rounded(ExactLevels levels, double about);

}  // namespace pellucid::fields
