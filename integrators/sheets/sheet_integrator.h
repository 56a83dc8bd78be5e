// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/options/parameters.h"
#include "core/progress.h"
#include "fields/field.h"
#include "geometry/triangle_mesh.h"
#include "integrators/paths/seed_curve.h"
#include "integrators/sheets/seed_surface.h"
#include "integrators/surface_integrator.h"

namespace pellucid::integrators {

/// A SheetRequest asks for the surface that particles form at one moment, the end of the journey:
/// of a streak surface those let go along a curve one after another, of a time surface those let go
/// at once all over a surface. The field's time runs along.
struct SheetRequest {
  const fields::VectorField* field = nullptr;
  std::optional<SeedCurve> curve = {};      // of a streak surface
  std::optional<SeedSurface> surface = {};  // of a time surface
  double duration = 0;                      // > 0, time units
  double start_time = 0;                    // the field's time when the first particle is let go
  Progress progress = {};
};

/// An IntegratedSheet is a mesh in world units. Its scalars are "t" (how long a vertex's particle
/// is on its way), "time" (the field's at the end, everywhere), "released" (the field's when the
/// particle was let go) and "speed"; of a streak surface "s" (on the seed curve), of a time surface
/// of a patch "u" and "v".
struct IntegratedSheet : IntegratedSurface {
  std::vector<Vec3> places;  // by vertex, of the sheet's domain: see SheetDomain
};

/// A SheetSeed is what the particles of a sheet start on.
enum class SheetSeed { curve, surface };

/// One row of the table of sheets.
struct SheetIntegratorRow {
  std::string_view name;
  std::string_view title;
  std::string_view citation;
  std::span<const ParameterSpec> parameters;
  SheetSeed seed;
};

}  // namespace pellucid::integrators
