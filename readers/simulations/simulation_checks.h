// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What VTK's readers of simulations take for something else, without a word, is refused before they
// see it.

#include <filesystem>

namespace pellucid::readers {

/// Throws InputError for a case of EnSight 6 in text whose geometry has structured blocks: VTK does
/// not skip the line above their values, so that each is one line off.
void refuse_ensight6_blocks(const std::filesystem::path& path);

/// Throws InputError for a CGNS file that names cylindrical or spherical coordinates, which VTK
/// takes for Cartesian ones.
void refuse_curved_cgns(const std::filesystem::path& path);

/// Throws InputError for an OpenFOAM case whose processors have times that the case itself lacks:
/// VTK leaves them out.
void refuse_divided_foam(const std::filesystem::path& path);

/// Throws InputError for a Tecplot file with repeated numbers, "9*0", or exponents after a D, which
/// VTK reads as 9 and without the exponent.
void refuse_fortran_numbers(const std::filesystem::path& path);

/// Throws InputError for a Tecplot file with zones of several times (SOLUTIONTIME), which VTK would
/// lay over each other.
void refuse_several_solution_times(const std::filesystem::path& path);

/// Throws InputError for an Exodus file whose values at nodes are not where the library looks for
/// them by the file's model, large or not: VTK then leaves its arrays as the memory has them.
void refuse_unread_exodus(const std::filesystem::path& path);

}  // namespace pellucid::readers
