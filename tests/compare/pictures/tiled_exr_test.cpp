// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that are written a row of tiles at a time.
#include "compare/pictures/tiled_exr.h"

#include <OpenEXR/ImfTiledInputFile.h>
#include <gtest/gtest.h>

#include "compare/pictures/image_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using pellucid::testing::TemporaryFolder;

constexpr int side = TiledExr::side;

Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = Rgba(float(x), float(y), float(x * y) / 7, 0.5f);
  return image;
}

void add_rows(const Image& image, TiledExr& file) {
  for (int first = 0; first < image.height; first += side) {
    Image rows(image.width, std::min(side, image.height - first));
    std::copy_n(image.pixels.begin() + std::ptrdiff_t(first) * image.width, rows.pixels.size(),
                rows.pixels.begin());
    file.add(rows);
  }
}

/// Of whole tiles, of cut ones at both ends, smaller than one.
TEST(UnitTiledExr, HoldsThePictureWhateverItsSize) {
  const TemporaryFolder folder;
  for (const auto& [width, height] :
       {std::pair(2 * side, side), std::pair(side + 1, 2 * side + 3), std::pair(5, 1)}) {
    const Image image = gradient(width, height);
    TiledExr file(folder / "tiled.exr", width, height, form_of_map("numbers"));
    add_rows(image, file);
    file.commit();
    EXPECT_TRUE(read_image(folder / "tiled.exr").pixels == image.pixels) << width;
    const Imf::TiledInputFile tiled((folder / "tiled.exr").c_str());
    EXPECT_EQ(tiled.tileXSize(), unsigned(side));
  }
}

TEST(UnitTiledExr, IsThereOnlyWhenItIsWhole) {
  const TemporaryFolder folder;
  {
    TiledExr file(folder / "tiled.exr", side, 2 * side, {});
    file.add(gradient(side, side));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace pellucid::compare
