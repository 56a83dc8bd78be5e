// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <fstream>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::fields {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// 5 × 9 × 3 samples; that at (i, j, k) is (i, 10 j, 100 k), which linear interpolation keeps.
std::string samples(std::endian order = std::endian::little) {
  std::string bytes;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 5; ++i)
        for (const float value : {float(i), float(10 * j), float(100 * k)}) {
          std::string number(reinterpret_cast<const char*>(&value), sizeof value);
          if (order == std::endian::big) std::ranges::reverse(number);
          bytes += number;
        }
  return bytes;
}

std::string compressed(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return packed.substr(0, size);
}

class UnitMetaImage : public ::testing::Test {
 protected:
  /// A field of the file with further lines in its header.
  std::unique_ptr<VectorField> field(const std::string& lines,
                                     const std::string& data = samples()) const {
    const fs::path path = folder_ / "field.mha";
    std::ofstream(path, std::ios::binary)
        << "ObjectType = Image\nNDims = 3\nDimSize = 5 9 3\n"
        << lines
        << "ElementNumberOfChannels = 3\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n"
        << data;
    return make_field(path.string());
  }

  std::string complaint(const std::string& lines, const std::string& data = samples()) const {
    try {
      field(lines, data);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  testing::TemporaryFolder folder_;
};

Vec3 at(const VectorField& field, const Vec3& x) {
  Vec3 v;
  return field.sampler()->velocity(x, 0, v) == SampleStatus::ok ? v : Vec3(-1);
}

TEST_F(UnitMetaImage, AMatrixTurnsTheAxesUnderEachOfItsNames) {
  // The first axis along +y, the second along -x: sample (i, j, k) is at (7 - 2 j, 5 + i / 2, 3 k).
  for (const char* key : {"TransformMatrix", "Rotation", "Orientation"}) {
    const auto turned = field(
        fmt::format("{} = 0 1 0 -1 0 0 0 0 1\nOffset = 7 5 0\nElementSpacing = 0.5 2 3\n", key));
    for (const Vec3 index : {Vec3(0, 0, 0), Vec3(4, 8, 2), Vec3(1.25, 6.5, 0.75)})
      EXPECT_LT(glm::length(at(*turned, {7 - 2 * index.y, 5 + index.x / 2, 3 * index.z}) -
                            index * Vec3(1, 10, 100)),
                1e-10)
          << key;
    EXPECT_EQ(at(*turned, {8, 5, 0}), Vec3(-1)) << key;  // outside, though inside if not turned
  }
}

TEST_F(UnitMetaImage, AnIdentityMayBeWrittenInAnyWay) {
  const auto plain = field("\nTransformMatrix = 1.0 0.0 0 0 1e0 0 -0 0 1.000\n\n");
  EXPECT_EQ(at(*plain, {4, 8, 2}), Vec3(4, 80, 200));
}

TEST_F(UnitMetaImage, BigEndianIsSaidInTheWaysOfMetaIO) {
  for (const char* word : {"True", "true", "T", "1"})
    EXPECT_EQ(
        at(*field(fmt::format("BinaryDataByteOrderMSB = {}\n", word), samples(std::endian::big)),
           {4, 8, 2}),
        Vec3(4, 80, 200))
        << word;
  for (const char* word : {"False", "false", "F", "0"})
    EXPECT_EQ(at(*field(fmt::format("ElementByteOrderMSB = {}\n", word)), {4, 8, 2}),
              Vec3(4, 80, 200))
        << word;
  EXPECT_THAT(complaint("BinaryDataByteOrderMSB = maybe\n"), HasSubstr("maybe; accepted: True"));
}

TEST_F(UnitMetaImage, CompressedDataAreThoseUncompressed) {
  const auto packed = field("CompressedData = True\n", compressed(samples()));
  EXPECT_EQ(at(*packed, {4, 8, 2}), Vec3(4, 80, 200));
  EXPECT_EQ(at(*packed, {0, 3.5, 1}), Vec3(0, 35, 100));
}

TEST_F(UnitMetaImage, CompressedDataThatAreNotWhatIsClaimedAreRefused) {
  const std::string whole = compressed(samples()), yes = "CompressedData = True\n";
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THAT(complaint(yes, whole.substr(0, length)), HasSubstr("field.mha: ")) << length;
  EXPECT_THAT(complaint(yes, compressed(samples() + "1234")), HasSubstr("damaged, or not 1620"));
  EXPECT_THAT(complaint(yes, compressed(samples().substr(4))), HasSubstr("damaged, or not 1620"));
  EXPECT_THAT(complaint(yes + "DimSize = 1000000 1000000 1000000\n", whole),
              HasSubstr("compressed bytes hold no 1000000000000000000 samples of 12"));
}

TEST_F(UnitMetaImage, VectorsMayBeOfAnyNumbers) {
  const auto field_of = [&](const char* type, auto number) {
    std::string bytes;
    for (const int value :
         {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24}) {
      number = decltype(number)(value);
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    const fs::path path = folder_ / "t.mha";
    std::ofstream(path, std::ios::binary)
        << "NDims = 3\nDimSize = 2 2 2\nElementNumberOfChannels = 3\nElementType = " << type
        << "\nElementDataFile = LOCAL\n"
        << bytes;
    return at(*make_field(path.string()), {1, 1, 0});
  };
  const Vec3 fourth(10, 11, 12);
  EXPECT_EQ(field_of("MET_CHAR", std::int8_t()), fourth);
  EXPECT_EQ(field_of("MET_UCHAR", std::uint8_t()), fourth);
  EXPECT_EQ(field_of("MET_SHORT", std::int16_t()), fourth);
  EXPECT_EQ(field_of("MET_USHORT", std::uint16_t()), fourth);
  EXPECT_EQ(field_of("MET_INT", std::int32_t()), fourth);
  EXPECT_EQ(field_of("MET_LONG", std::int32_t()), fourth);
  EXPECT_EQ(field_of("MET_UINT", std::uint32_t()), fourth);
  EXPECT_EQ(field_of("MET_LONG_LONG", std::int64_t()), fourth);
  EXPECT_EQ(field_of("MET_ULONG_LONG", std::uint64_t()), fourth);
  EXPECT_EQ(field_of("MET_DOUBLE", double()), fourth);
}

TEST_F(UnitMetaImage, OtherNumbersOfASampleAreNoVectors) {
  const fs::path path = folder_ / "s.mha";
  std::ofstream(path, std::ios::binary)
      << "NDims = 3\nDimSize = 1 1 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nab";
  for (const char* const array : {"", ":array=MetaImage"})
    EXPECT_THAT([&] { make_field(path.string() + array); },
                ::testing::ThrowsMessage<InputError>(
                    HasSubstr("ElementNumberOfChannels = 1; accepted of a field: 3")));
}

TEST_F(UnitMetaImage, AxesThatDoNotSpanSpaceAreRefused) {
  for (const char* matrix : {"1 0 0 1 0 0 0 0 1", "0 0 0 0 0 0 0 0 0", "nan 0 0 0 1 0 0 0 1"})
    EXPECT_NE(complaint(fmt::format("Rotation = {}\n", matrix)), "") << matrix;
  EXPECT_THAT(complaint("Rotation = 1 0 0 1 0 0 0 0 1\n"), HasSubstr("Rotation = 1 0 0 1"));
  EXPECT_THAT(complaint("Rotation = 1 0 0\n"), HasSubstr("expected 9 numbers"));
}

TEST_F(UnitMetaImage, HeaderSizeSaysWhereTheDataBegin) {
  const fs::path raw = folder_ / "data.raw", header = folder_ / "field.mhd";
  const auto read = [&](const std::string& size, const std::string& more = "") {
    std::ofstream(header) << "NDims = 3\nDimSize = 5 9 3\nElementNumberOfChannels = 3\n"
                          << "ElementType = MET_FLOAT\n"
                          << size << "ElementDataFile = data.raw\n"
                          << more;
    return at(*make_field(header.string()), {2, 3, 1});
  };
  const auto said = [&](const std::string& size, const std::string& more = "") -> std::string {
    try {
      read(size, more);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  };
  std::ofstream(raw, std::ios::binary) << std::string(17, 'x') << samples();
  EXPECT_EQ(read("HeaderSize = 17\n"), Vec3(2, 30, 100));
  EXPECT_EQ(read("HeaderSize = -1\n"), Vec3(2, 30, 100));
  EXPECT_THAT(said(""), HasSubstr("bytes of data; its header says"));
  EXPECT_THAT(said("HeaderSize = 16\n"), HasSubstr("bytes of data; its header says"));
  EXPECT_THAT(said("HeaderSize = 99999\n"), HasSubstr("data from byte 99999 of"));
  EXPECT_THAT(said("HeaderSize = -2\n"), HasSubstr("HeaderSize = -2; accepted"));
  EXPECT_THAT(said("HeaderSize = -1\nCompressedData = True\n"), HasSubstr("of compressed data"));
  std::ofstream(raw, std::ios::binary) << samples();
  EXPECT_EQ(read("HeaderSize = -1\n"), Vec3(2, 30, 100));
  EXPECT_THAT(said("", "ElementSpacing = 2 2 2\n"),
              HasSubstr("'ElementSpacing' follows ElementDataFile"));
  std::ofstream(raw, std::ios::binary) << "short";
  EXPECT_THAT(said("HeaderSize = -1\n"), HasSubstr("5 bytes; its header says"));
}

}  // namespace
}  // namespace pellucid::fields
