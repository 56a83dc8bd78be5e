// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that make geometry: they are refined in the scene's text.
#pragma once

#include "compare/budget/budget_stages.h"

namespace pellucid::compare {

/// Puts the formula in the place of the fields that were sampled from it.
StageRefinement refine_field(const BudgetTools& tools, DrawPlan& plan);

/// Moves particles by Dormand and Prince's scheme with an error of 1e-10 of the seeds' extent a
/// step, or a thousandth of what was asked for, if that is less.
StageRefinement refine_integration(const BudgetTools& tools, DrawPlan& plan);

/// Divides the lengths and angles of meshes and lines by the factor, and draws an isosurface itself
/// in place of its mesh where the method is exact.
StageRefinement refine_mesh(const BudgetTools& tools, DrawPlan& plan);

}  // namespace pellucid::compare
