// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/sums_file.h"

#include <fmt/format.h>

#include "compare/pictures/exr_file.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
const fs::path& checked(const fs::path& path) {
  if (small_ending(path) != ".exr")
    throw InputError(
        fmt::format("{}: ending '{}'; accepted: .exr", path.string(), path.extension().string()));
  return path;
}

}  // namespace

void write_sums(const fs::path& path, const Raster<groundtruth::PixelSums>& sums,
                const PictureForm& picture) {
  static_assert(sizeof(groundtruth::PixelSums) == 7 * sizeof(float));
  write_text(checked(path), encode_exr(path, sums.width, sums.height,
                                       {"layers", "coverage", "transmittance", "importance_sum",
                                        "optical_depth", "near", "far"},
                                       Imf::FLOAT, sums.pixels.data(),
                                       text_beside(picture, "exact sums along each pixel's ray")));
}

}  // namespace pellucid::compare
