#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/parameters.h"
#include "fields/level.h"

namespace pellucid {

/// Parameters of the data set `sphere-levels`.
std::span<const ParameterSpec> sphere_levels_parameters();

/// The flow past a sphere (catalogue: sphere) at the samples of nested levels, the finest around
/// the sphere, each coarser one twice as coarse. `dataset` is "sphere-levels[:key=value,…]". Throws
/// InputError for another name, key or value.
std::vector<VectorLevel> make_sphere_levels(std::string_view dataset);

}  // namespace pellucid
