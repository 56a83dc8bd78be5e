// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "compare/pictures/picture_pair.h"

namespace pellucid::app {

/// CompareFiles name what `compare` reads. An empty path is not given.
struct CompareFiles {
  std::filesystem::path reference, test, mask;
  std::filesystem::path layers;       // of the reference; else its own beside it, if that fits
  std::filesystem::path test_layers;  // the same of the test
  std::vector<int> crop;              // x, y, width, height in pixels from the top left; or empty
};

/// CompareInputs are the pictures that `compare` holds against each other, all cut to the crop.
struct CompareInputs {
  Image reference, test;
  bool have_alpha = true;  // both of them, in their files
  std::optional<compare::Mask> mask;
  std::optional<CountImage> layers, test_layers;

  compare::PairRegions regions() const;
};

/// Reads the files. Throws InputError as the readers do, and where the mask, layers or the crop do
/// not fit the reference.
CompareInputs read_inputs(const CompareFiles& files);

}  // namespace pellucid::app
