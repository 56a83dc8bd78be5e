// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/sheets/sheet_integrator.h"

namespace pellucid::integrators::testing {

/// Returns the request of a sheet whose seeds are still to be set.
inline SheetRequest sheet_over(const fields::VectorField& field, double duration,
                               double start_time) {
  SheetRequest request;
  request.field = &field;
  request.duration = duration;
  request.start_time = start_time;
  return request;
}

inline SheetRequest streak_of(const fields::VectorField& field, const SeedCurve& curve,
                              double duration, double start_time = 0) {
  SheetRequest request = sheet_over(field, duration, start_time);
  request.curve = curve;
  return request;
}

inline SheetRequest time_surface_of(const fields::VectorField& field, const SeedSurface& surface,
                                    double duration, double start_time = 0) {
  SheetRequest request = sheet_over(field, duration, start_time);
  request.surface = surface;
  return request;
}

}  // namespace pellucid::integrators::testing
