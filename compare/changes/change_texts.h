// SPDX-License-Identifier: GPL-3.0-or-later
// What differs in a cell, a line each, for people.
#pragma once

#include "compare/changes/changes.h"

namespace pellucid::compare {

/// Returns "abc/fourier:bands=5: changed".
std::string heading_line(const CellChange& cell);

/// Returns how many pixels of a picture differ, the first one, and by how much; or why not.
std::string picture_line(const PictureChange& change);

/// Returns "since " and why it may differ.
std::string cause_line(const std::string& cause);

}  // namespace pellucid::compare
