// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

/// A CellMeasurement is what measuring a method on a scene gives: the row without its metrics, and
/// the pictures.
struct CellMeasurement {
  ResultRow row;
  Image image;
  CountImage layers;           // empty when the method does not count them
  std::vector<Image> draws;    // of a method of random numbers: the same by others
  std::vector<Image> further;  // of row.pictures
};

}  // namespace pellucid::compare
