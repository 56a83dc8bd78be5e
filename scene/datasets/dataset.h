// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/options/parameters.h"
#include "core/progress.h"
#include "fields/levels/level.h"
#include "geometry/line_set.h"
#include "geometry/point_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::scene {

/// Velocities at the samples of nested grids, the coarsest first.
using VelocityLevels = std::vector<fields::VectorLevel>;

/// A Dataset is a shape, or velocities on levels.
using Dataset =
    std::variant<geometry::TriangleMesh, geometry::LineSet, geometry::PointSet, VelocityLevels>;

/// One row of the table of data sets that are generated: stand-ins for data that were never
/// published, and scenes whose answer is known. The same parameters give the same data to the last
/// bit, for any number of threads.
struct DatasetRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;  // or how it is derived
  std::span<const ParameterSpec> parameters;
  Dataset (*make)(const Parameters&, const Progress&);
  bool on_levels = false;  // VelocityLevels, which isosurfaces are made of; otherwise shapes
};

/// Returns the table of data sets.
std::span<const DatasetRow> datasets();

/// `dataset` is "NAME[:key=value,…]". Throws InputError for an unknown name, key or value.
Dataset make_dataset(std::string_view dataset, const Progress& progress = {});

/// Makes the data of a row that is on levels. Throws InputError for another one, too.
VelocityLevels make_velocity_levels(std::string_view dataset, const Progress& progress = {});

}  // namespace pellucid::scene
