// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of every kind that OpenImageIO has written are read with the values that it was given.
#include "readers/pictures/picture_file.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {
namespace {

using OIIO::ImageSpec;
using OIIO::TypeDesc;
using ::testing::HasSubstr;

/// A Kind is a format with what it can hold exactly: multiples of 1/steps, 0 to 1.
struct Kind {
  const char* name;
  const char* ending;
  TypeDesc::BASETYPE type;
  int channels;
  int steps;
};

constexpr Kind kinds[] = {
    {"png_grey", ".png", TypeDesc::UINT8, 1, 255},
    {"png_grey_alpha", ".png", TypeDesc::UINT8, 2, 255},
    {"png_rgb", ".png", TypeDesc::UINT8, 3, 255},
    {"png_rgba", ".png", TypeDesc::UINT8, 4, 255},
    {"png_grey_16", ".png", TypeDesc::UINT16, 1, 65535},
    {"png_rgba_16", ".png", TypeDesc::UINT16, 4, 65535},
    {"exr_half", ".exr", TypeDesc::HALF, 4, 1024},
    {"exr_float", ".exr", TypeDesc::FLOAT, 3, 1 << 23},
    {"exr_integers", ".exr", TypeDesc::UINT32, 1, 1},
    {"tiff_rgb", ".tif", TypeDesc::UINT8, 3, 255},
    {"tiff_float_alpha", ".tif", TypeDesc::FLOAT, 4, 1 << 23},
    {"bmp", ".bmp", TypeDesc::UINT8, 3, 255},
};

constexpr int width = 23, height = 11;  // no multiple of what a library takes at once

/// Value number i of the interleaved ones.
float value(const Kind& kind, std::size_t i) {
  return float(i * 7919 % std::size_t(kind.steps + 1)) / float(kind.steps);
}

std::vector<float> values_of(const Kind& kind) {
  std::vector<float> values(std::size_t(width) * height * kind.channels);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(kind, i);
  return values;
}

void write_by_openimageio(const std::filesystem::path& path, const ImageSpec& spec,
                          const std::vector<float>& values) {
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output) << OIIO::geterror();
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, values.data())) << output->geterror();
  ASSERT_TRUE(output->close()) << output->geterror();
}

ImageSpec spec_of(const Kind& kind) {
  ImageSpec spec(width, height, kind.channels, kind.type);
  spec.attribute("oiio:UnassociatedAlpha", 1);  // no colour is multiplied by alpha on its way
  return spec;
}

double at(const Block& channel, std::size_t i) {
  return channel.type == NumberType::u32 ? channel.values<std::uint32_t>()[i]
                                         : channel.values<float>()[i];
}

/// OpenEXR sorts channels by name: R G B A come as A B G R.
std::vector<std::size_t> places(const PictureFile& file) {
  static const std::vector<std::string> order = {"R", "G", "B", "Y", "A"};
  std::vector<std::size_t> sorted(file.channels.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = i;
  std::ranges::sort(sorted, {}, [&](std::size_t i) {
    return std::ranges::find(order, file.channels[i].name) - order.begin();
  });
  return sorted;
}

class PropertyPictureFile : public ::testing::TestWithParam<Kind> {
 protected:
  std::filesystem::path file_of(const std::string& name) const {
    return folder_ / (name + GetParam().ending);
  }
  pellucid::testing::TemporaryFolder folder_;
};

TEST_P(PropertyPictureFile, HasTheValuesThatWereWritten) {
  const Kind& kind = GetParam();
  const std::vector<float> values = values_of(kind);
  const auto path = file_of("whole");
  write_by_openimageio(path, spec_of(kind), values);
  const PictureFile file = read_picture_file(path);
  EXPECT_EQ(file.data.width, width);
  EXPECT_EQ(file.picture.height, height);
  ASSERT_EQ(file.channels.size(), std::size_t(kind.channels));
  // OpenImageIO writes an integer of what is 1 as the largest there is.
  const double unit = kind.type == TypeDesc::UINT32 ? 4294967295. : 1;
  const auto channels = places(file);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Block& channel = file.channels[channels[i % channels.size()]];
    ASSERT_FLOAT_EQ(float(at(channel, i / channels.size()) / unit), values[i]) << i;
  }
}

TEST_P(PropertyPictureFile, IsRefusedWhenCutOff) {
  const auto path = file_of("whole"), cut = file_of("cut");
  write_by_openimageio(path, spec_of(GetParam()), values_of(GetParam()));
  const std::string whole = read_text(path);
  for (std::size_t part = 0; part < 4; ++part) {
    write_text(cut, whole.substr(0, whole.size() * part / 4));
    EXPECT_THROW(
        {
          try {
            read_picture_file(cut);
          } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(cut.string()));
            throw;
          }
        },
        InputError)
        << part << "/4";
  }
}

INSTANTIATE_TEST_SUITE_P(Of, PropertyPictureFile, ::testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

class UnitPictureFile : public ::testing::Test {
 protected:
  std::string refusal(const std::filesystem::path& path) const {
    try {
      read_picture_file(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "was read";
  }
  pellucid::testing::TemporaryFolder folder_;
};

TEST_F(UnitPictureFile, KnowsItsWindows) {
  const Kind kind{"", ".exr", TypeDesc::FLOAT, 1, 100};
  ImageSpec spec = spec_of(kind);
  spec.x = -3;
  spec.y = 5;
  spec.full_x = 2;
  spec.full_y = -1;
  spec.full_width = 40;
  spec.full_height = 30;
  write_by_openimageio(folder_ / "a.exr", spec, values_of(kind));
  const PictureFile file = read_picture_file(folder_ / "a.exr");
  EXPECT_EQ(file.data.x, -3);
  EXPECT_EQ(file.data.y, 5);
  EXPECT_EQ(file.picture.x, 2);
  EXPECT_EQ(file.picture.y, -1);
  EXPECT_EQ(file.picture.width, 40);
  EXPECT_EQ(file.picture.height, 30);
}

TEST_F(UnitPictureFile, ReadsTilesAsRows) {
  const Kind kind{"", ".exr", TypeDesc::FLOAT, 1, 4096};
  ImageSpec spec = spec_of(kind);
  spec.tile_width = spec.tile_height = 16;
  const auto path = folder_ / "tiles.exr";
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  const std::vector<float> values = values_of(kind);
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, values.data())) << output->geterror();
  ASSERT_TRUE(output->close());
  const PictureFile file = read_picture_file(path);
  EXPECT_TRUE(std::ranges::equal(file.channels[0].values<float>(), values));
}

TEST_F(UnitPictureFile, RefusesDeepData) {
  ImageSpec spec(2, 1, 1, TypeDesc::FLOAT);
  spec.deep = true;
  OIIO::DeepData data(spec);
  for (int pixel = 0; pixel < 2; ++pixel) data.set_samples(pixel, 3);
  const auto path = folder_ / "deep.exr";
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_deep_image(data)) << output->geterror();
  ASSERT_TRUE(output->close());
  EXPECT_THAT(refusal(path), HasSubstr("deep.exr: cannot read the picture: it is deep"));
}

TEST_F(UnitPictureFile, RefusesSeveralParts) {
  const Kind kind{"", ".exr", TypeDesc::FLOAT, 3, 4096};
  const ImageSpec parts[] = {spec_of(kind), spec_of(kind)};
  const std::vector<float> values = values_of(kind);
  const auto path = folder_ / "parts.exr";
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output->open(path.string(), 2, parts)) << output->geterror();
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, values.data())) << output->geterror();
  ASSERT_TRUE(output->open(path.string(), parts[1], OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, values.data())) << output->geterror();
  ASSERT_TRUE(output->close());
  EXPECT_THAT(refusal(path), HasSubstr("parts.exr: cannot read the picture: it has 2 parts"));
}

TEST_F(UnitPictureFile, RefusesWhatIsNoPicture) {
  write_text(folder_ / "text.png", "not a picture");
  EXPECT_THAT(refusal(folder_ / "text.png"), HasSubstr("text.png: "));
  EXPECT_THAT(refusal(folder_ / "none.exr"), HasSubstr("none.exr"));
  EXPECT_THAT(refusal(folder_ / "what?a=1.tif"), HasSubstr("what?a=1.tif"));
}

TEST_F(UnitPictureFile, ANameOfAnyKindIsAName) {
  const Kind kind{"", ".tif", TypeDesc::UINT8, 1, 255};
  write_by_openimageio(folder_ / "plain.tif", spec_of(kind), values_of(kind));
  std::filesystem::rename(folder_ / "plain.tif", folder_ / "a?b=1.tif");
  EXPECT_EQ(read_picture_file(folder_ / "a?b=1.tif").picture.width, width);
}

}  // namespace
}  // namespace pellucid::readers
