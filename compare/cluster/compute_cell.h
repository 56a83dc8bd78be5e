// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/run/run_study.h"

namespace pellucid::compare {

/// Computes the one cell of that name, "SCENE/METHOD:PARAMETERS", from what its study says and the
/// reference's picture in the folder, and returns its row. It leaves the cell's row, pictures and
/// nothing else in the folder, each whole or not at all and the row last, as run_study() does. Any
/// number of cells may be computed at once, on any machines that share the folder, more than once:
/// who computes a cell that is being computed waits for it. With `resume` a row that this build
/// finished is kept. A cell that fails, or whose scene's reference has failed, is a row with its
/// error. Throws InputError that names the nearest cells when there is none of that name; WorkError
/// when the reference's picture, which it needs, is not there.
ResultRow compute_cell(const Study& study, const std::string& name, const StudyOptions& options);

}  // namespace pellucid::compare
