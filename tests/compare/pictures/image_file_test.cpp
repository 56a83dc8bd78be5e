// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/image_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>

#include "compare/pictures/exr_file.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/compare/pictures/metric_pairs.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::compare {
namespace {

using ::testing::HasSubstr;
using namespace pellucid::compare::testing;

Image colourful(int width, int height) {
  Image image = picture(width, height, noise);
  for (int x = 0; x < width; ++x) image.at(x, 0).a = float(x) / float(width);
  image.at(0, 0) = Rgba(-2.5f, 1e6f, 1e-30f, 0.25f);
  return image;
}

template <class Function>
std::string input_error(Function function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(UnitImageFile, ExrKeepsEveryBit) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(7, 5), std::pair(1, 1), std::pair(64, 33)}) {
    const Image image = colourful(width, height);
    write_image(folder / "a.exr", image, {});
    const Image back = read_image(folder / "a.exr");
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

TEST(UnitImageFile, PngHoldsTheNearestBytesWithoutATransferCurve) {
  const TemporaryFolder folder;
  Image image(256, 2);
  for (int n = 0; n < 256; ++n) {
    image.at(n, 0) = Rgba((float(n) + 0.4f) / 255.f);
    image.at(n, 1) = Rgba((float(n) - 0.4f) / 255.f);
  }
  write_image(folder / "a.png", image, {});
  const Image back = read_image(folder / "a.png");
  for (int n = 0; n < 256; ++n) {
    EXPECT_FLOAT_EQ(back.at(n, 0).g, float(n) / 255.f);
    EXPECT_FLOAT_EQ(back.at(n, 1).g, float(n) / 255.f);
  }
  EXPECT_EQ(back.at(3, 0).a, 1);
}

TEST(UnitImageFile, PngClampsWhatItCannotHold) {
  EXPECT_EQ(displayed_byte(-1), 0);
  EXPECT_EQ(displayed_byte(2), 255);
  EXPECT_EQ(displayed_byte(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(displayed_byte(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(UnitImageFile, CountsSurvive) {
  const TemporaryFolder folder;
  CountImage counts(9, 4);
  for (std::size_t i = 0; i < counts.pixels.size(); ++i)
    counts.pixels[i] = std::uint32_t(i * 100003);
  write_counts(folder / "n.exr", counts, {});
  EXPECT_EQ(read_counts(folder / "n.exr").pixels, counts.pixels);
  write_counts(folder / "n.png", counts, {});
  EXPECT_EQ(read_image(folder / "n.png").at(1, 0).r, 1);  // 100003 layers are shown as 255
}

TEST(UnitImageFile, WrongFilesAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error([&] { read_image(folder / "none.exr"); }), HasSubstr("none.exr"));
  write_text(folder / "text.png", "not a picture");
  EXPECT_THAT(input_error([&] { read_image(folder / "text.png"); }), HasSubstr("text.png"));
  EXPECT_THAT(input_error([&] { write_image(folder / "a.bmp", Image(2, 2), {}); }),
              HasSubstr("accepted: .exr, .png"));
  EXPECT_THAT(input_error([&] { write_image(folder / "no/such/a.png", Image(2, 2), {}); }),
              HasSubstr("a.png"));
}

/// A pixel of these channels with the values 0, 1, 2, …, in this order.
PictureRead read_pixel(const std::vector<std::string>& channels) {
  const TemporaryFolder folder;
  std::vector<float> values;
  for (std::size_t i = 0; i < channels.size(); ++i) values.push_back(float(i));
  write_text(folder / "a.exr",
             encode_exr("a.exr", 1, 1, channels, Imf::FLOAT, values.data(), PictureText{}));
  return read_picture(folder / "a.exr");
}

TEST(PropertyImageFile, EveryLayoutOfChannelsIsReadAsItIsNamedOrRefused) {
  struct Layout {
    std::vector<std::string> channels;
    Rgba pixel;
    bool has_alpha;
  };
  const Layout layouts[] = {{{"R", "G", "B", "A"}, {0, 1, 2, 3}, true},
                            {{"B", "R", "G"}, {1, 2, 0, 1}, false},
                            {{"red", "green", "blue", "alpha"}, {0, 1, 2, 3}, true},
                            {{"R", "G", "B", "Z", "left.R"}, {0, 1, 2, 1}, false},
                            {{"R", "G", "B", "shadow.A"}, {0, 1, 2, 1}, false},
                            {{"a.R", "R", "G", "B"}, {1, 2, 3, 1}, false},
                            {{"l.R", "l.G", "l.B", "l.A", "n.X"}, {0, 1, 2, 3}, true},
                            {{"a.R", "b.R", "b.G", "b.B"}, {1, 2, 3, 1}, false},
                            {{"Y"}, {0, 0, 0, 1}, false},
                            {{"A", "Y"}, {1, 1, 1, 0}, true},
                            {{"tau"}, {0, 0, 0, 1}, false}};
  for (const Layout& layout : layouts) {
    const PictureRead read = read_pixel(layout.channels);
    EXPECT_EQ(read.image.at(0, 0), layout.pixel) << ::testing::PrintToString(layout.channels);
    EXPECT_EQ(read.has_alpha, layout.has_alpha) << ::testing::PrintToString(layout.channels);
  }
  const std::vector<std::string> refused[] = {
      {"R", "G"},
      {"Y", "Z"},
      {"a.R", "b.G", "c.B"},
      {"albedo.R", "albedo.G", "albedo.B", "beauty.R", "beauty.G", "beauty.B"},
      {"coverage", "transmittance", "near"}};
  for (const std::vector<std::string>& channels : refused)
    EXPECT_THAT(input_error([&] { read_pixel(channels); }), HasSubstr("its channels are"))
        << ::testing::PrintToString(channels);
}

TEST(PropertyImageFile, NoTruncationIsReadAsAPicture) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "a.png"}) {
    write_image(folder / name, colourful(40, 30), {});
    const std::string whole = read_text(folder / name);
    for (std::size_t part = 0; part < 16; ++part) {
      write_text(folder / ("cut-" + std::string(name)), whole.substr(0, whole.size() * part / 16));
      EXPECT_THAT(input_error([&] { read_image(folder / ("cut-" + std::string(name))); }),
                  HasSubstr(name))
          << part << "/16";
    }
  }
}

TEST(PropertyImageFile, NothingIsLeftBesideAPicture) {
  const TemporaryFolder folder;
  write_image(folder / "a.png", Image(3, 3), {});
  write_image(folder / "a.exr", Image(3, 3), {});
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace pellucid::compare
