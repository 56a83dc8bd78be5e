#pragma once

#include <array>
#include <cstddef>

#include "core/parameters.h"

namespace pellucid {

/// How particles move; trajectory_options() reads them.
inline constexpr ParameterSpec stepping_parameters[] = {
    {.name = "stepper",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "dopri5",
     .choices = "euler|rk4|dopri5",
     .help = "scheme that moves the particles"},
    {.name = "accuracy",
     .kind = ParameterSpec::Kind::real,
     .min = 0,
     .unit = "world units",
     .help = "largest error of one step; default 1e-9 of the seeds' extent"},
    {.name = "dt",
     .kind = ParameterSpec::Kind::real,
     .min = 0,
     .unit = "time",
     .help = "largest time step; euler and rk4 take it, default a 500th of the duration"},
    {.name = "cells",
     .kind = ParameterSpec::Kind::real,
     .min = 0,
     .unit = "cells",
     .help = "largest step in sampled data; default 0.5, or more where no kink is felt"},
    {.name = "length",
     .kind = ParameterSpec::Kind::real,
     .min = 0,
     .unit = "world units",
     .help = "a particle ends when it has gone so far; default: no limit"},
    {.name = "max-steps",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "1000000",
     .min = 1,
     .max = 1e9,
     .unit = "steps",
     .help = "a particle ends after so many"},
};

/// What every surface integrator takes beside its own parameters and those of stepping.
inline constexpr ParameterSpec surface_own_parameters[] = {
    {.name = "normals",
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
     .help = "the surface ends"},
};

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

template <std::size_t n, std::size_t m>
constexpr auto joined(const std::array<ParameterSpec, n>& a, const ParameterSpec (&b)[m]) {
  std::array<ParameterSpec, n + m> all{};
  std::size_t i = 0;
  for (const ParameterSpec& spec : a) all[i++] = spec;
  for (const ParameterSpec& spec : b) all[i++] = spec;
  return all;
}

/// A row's own parameters, then those of all rows.
template <std::size_t n>
constexpr auto with_stepping_parameters(const ParameterSpec (&own)[n]) {
  return joined(std::to_array(own), stepping_parameters);
}
template <std::size_t n>
constexpr auto with_surface_parameters(const ParameterSpec (&own)[n]) {
  return joined(joined(std::to_array(own), surface_own_parameters), stepping_parameters);
}

inline constexpr auto surface_parameters =
    joined(std::to_array(surface_own_parameters), stepping_parameters);

}  // namespace pellucid
