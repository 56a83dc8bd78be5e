// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "integrators/paths/seed_curve.h"
#include "integrators/sheets/seed_surface.h"

namespace pellucid::app {

/// SeedTexts are the options of `trace` that say where particles start.
struct SeedTexts {
  std::string seed;   // --seed: X,Y,Z:X,Y,Z[:...]
  std::string seeds;  // --seeds: FILE, circle:…, grid:…, patch:… or sphere:…
  bool closed = false;
};

/// Returns the curve that a surface is swept from. Throws InputError where not exactly one of the
/// two texts is given, where it is wrong, and for a grid, which is no curve.
integrators::SeedCurve surface_seed(const SeedTexts& texts);

/// Returns the surface that the particles of a time surface start on: a patch, a sphere, or the
/// mesh of a file. Throws InputError for any other text.
integrators::SeedSurface sheet_seed(const SeedTexts& texts);

/// Returns where lines start: the points that are given, or as many on the curve as the integrator
/// "NAME[:key=value,…]" asks for. Throws InputError as surface_seed(), but takes a grid.
std::vector<Vec3> line_seeds(const SeedTexts& texts, const std::string& integrator);

}  // namespace pellucid::app
