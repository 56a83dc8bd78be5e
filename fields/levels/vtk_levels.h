// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "fields/levels/exact_levels.h"

class vtkDataSet;

namespace pellucid::fields {

/// An ArrayChoice is a scalar's name as a file's user gives it: "point:p", "cell:p", or "p", which
/// is that of the points where both have it.
struct ArrayChoice {
  explicit ArrayChoice(std::string_view scalar);

  std::string name;
  bool of_points = true, of_cells = true;  // one or both may be meant
};

/// Returns the level of a data set's scalar: of an image or a rectilinear grid of cubes along the
/// world's axes, a scalar of points, or of cells, whose centres are the samples then; or, where
/// none has the name and it is a derived one, that of the `velocity` (pick_vectors()). Throws
/// InputError, naming `path`, for what is no such grid, with a way to make one, and for samples
/// that check_level() refuses; when there is no such array it lists those that there are. Of a
/// large scalar that nothing but the data set has, the numbers are gone from there afterwards.
ExactLevels level_of(vtkDataSet& data, const std::filesystem::path& path, std::string_view scalar,
                     const std::string& velocity = {});

/// Returns which of a data set's two scalars of a name level_of() takes, where both points and
/// cells have one and the name leaves it open, for reports; "" elsewhere.
std::string remark_on_choice(vtkDataSet& data, const std::filesystem::path& path,
                             std::string_view scalar);

}  // namespace pellucid::fields
