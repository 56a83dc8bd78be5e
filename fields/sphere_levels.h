#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "fields/level.h"

namespace pellucid {

/// A row of the table of velocities that are generated on levels of samples.
struct LevelDatasetRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  std::span<const ParameterSpec> parameters;
  std::vector<VectorLevel> (*make)(const Parameters&);
};

/// sphere-levels: the flow past a sphere at the samples of nested levels, the finest around the
/// sphere, each coarser one twice as coarse.
std::span<const LevelDatasetRow> level_datasets();

/// `dataset` is "NAME[:key=value,…]". Throws InputError for another name, key or value.
std::vector<VectorLevel> make_level_dataset(std::string_view dataset);

}  // namespace pellucid
