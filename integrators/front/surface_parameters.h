// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "core/options/parameters.h"
#include "integrators/paths/stepping_parameters.h"

namespace pellucid::integrators {

/// What every surface integrator takes beside its own parameters and those of stepping.
inline constexpr auto surface_own_parameters = std::to_array<ParameterSpec>(
    {{.name = "normals",
      .kind = ParameterSpec::Kind::choice,
      .default_value = "variational",
      .choices = "variational|ghost|none",
      .help = "∂x/∂s by the variational equation, by a ghost particle, or not at all"},
     {.name = "ghost",
      .kind = ParameterSpec::Kind::choice,
      .default_value = "reset",
      .choices = "reset|rescale",
      .help = "pull the ghost back when it is too far, or after every step"},
     {.name = "rip",
      .kind = ParameterSpec::Kind::real,
      .default_value = "1e-4",
      .min = 1e-12,
      .max = 0.5,
      .unit = "1",
      .help = "neighbours that part are torn once their seeds are so close, in s"},
     {.name = "max-particles",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "1000000",
      .min = 2,
      .max = 1e9,
      .unit = "particles",
      .help = "the surface is not refined any more"},
     {.name = "max-triangles",
      .kind = ParameterSpec::Kind::integer,
      .default_value = "20000000",
      .min = 1,
      .max = 1e9,
      .unit = "triangles",
      .help = "the surface ends"}});

/// It has no default value in the table, so that a tolerance can take its place.
constexpr ParameterSpec threshold_parameter(std::string_view help) {
  return {.name = "threshold", .min = 0, .unit = "world units", .help = help};
}

inline constexpr ParameterSpec tolerance_parameter = {
    .name = "tolerance",
    .min = 0,
    .unit = "world units",
    .help = "largest distance of mesh and surface, instead of a threshold"};

inline constexpr ParameterSpec step_parameter = {
    .name = "step",
    .min = 0,
    .unit = "world units",
    .help = "between a particle's vertices; default: by threshold or tolerance"};

inline constexpr ParameterSpec facet_angle_parameter = {
    .name = "facet-angle",
    .kind = ParameterSpec::Kind::real,
    .default_value = "25",
    .min = 1,
    .max = 180,
    .unit = "degrees",
    .help = "facets farther from the normals at their corners are mended; 180: none"};

/// A row's own parameters, then those of all rows.
template <std::size_t n>
constexpr auto with_surface_parameters(const ParameterSpec (&own)[n]) {
  return concatenate(std::to_array(own), surface_own_parameters, stepping_parameters);
}

inline constexpr auto surface_parameters = concatenate(surface_own_parameters, stepping_parameters);

}  // namespace pellucid::integrators
