// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks of tractography, and hair.

#include <limits>

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::HasSubstr;
using UnitTracks = FormatFiles;

constexpr float infinity = std::numeric_limits<float>::infinity();

std::string tck(const std::string& type, const std::string& data) {
  std::string head = "mrtrix tracks\nfoo: bar\ndatatype: " + type + "\nfile: . 100\nEND\n";
  return head + std::string(100 - head.size(), '\0') + data;
}

TEST_F(UnitTracks, TckHasTracksOfBothOrdersAndSizes) {
  const std::vector<float> points{1,   2, 3,   4,   5,   6,        NAN,      NAN,
                                  NAN, 7, 8,   9,   -1,  0,        0.5f,     0,
                                  0,   1, NAN, NAN, NAN, infinity, infinity, infinity};
  const std::vector<double> wide(points.begin(), points.end());
  for (const std::string& content :
       {tck("Float32LE", bytes_of(points)), tck("Float32BE", bytes_of(points, true)),
        tck("Float64LE", bytes_of(wide)), tck("Float64BE", bytes_of(wide, true))}) {
    const LineSet lines = read_lines(file("a.tck", content));
    EXPECT_EQ(lines.offsets, (std::vector<std::uint64_t>{0, 2, 5}));
    EXPECT_EQ(lines.positions[1], Vec3(4, 5, 6));
    EXPECT_EQ(lines.positions[3], Vec3(-1, 0, 0.5));
  }
  expect_cuts_are_refused("cut.tck", tck("Float32LE", bytes_of(points)), read_lines);
  EXPECT_THAT(refusal([&] { read_lines(file("b.tck", tck("Int16LE", ""))); }),
              HasSubstr("datatype: Int16LE; accepted: Float32LE"));
}

TEST_F(UnitTracks, TckIsWrittenAsItIsRead) {
  LineSet lines;
  for (int i = 0; i < 12345; ++i) lines.positions.emplace_back(0.5 * i, -i, 3);
  lines.offsets = {0, 4, 12345};
  for (const std::size_t count : {std::size_t(2), std::size_t(12345)}) {
    lines.positions.resize(count);
    lines.offsets = {0, count};
    write_lines(folder_ / "a.tck", lines);
    const LineSet back = read_lines(folder_ / "a.tck");
    EXPECT_EQ(back.positions, lines.positions);
    EXPECT_EQ(back.offsets, lines.offsets);
  }
}

/// One track of two points, one scalar and a property of two numbers; voxels of 1 × 2 × 4 mm, whose
/// axes run to the right, to the front and up, as those of the image at (10, 20, 30) do.
std::string trk(const std::string& order, bool big_endian) {
  std::string header(1000, '\0');
  const auto put = [&](std::size_t at, const std::string& bytes) {
    header.replace(at, bytes.size(), bytes);
  };
  put(0, "TRACK");
  put(6, bytes_of<std::int16_t>({8, 6, 5}, big_endian));
  put(12, bytes_of<float>({1, 2, 4}, big_endian));
  put(36, bytes_of<std::int16_t>({1}, big_endian));
  put(38, "fa");
  put(238, bytes_of<std::int16_t>({2}, big_endian));
  put(240, std::string("pair\0002", 6));
  put(440, bytes_of<float>({1, 0, 0, 10, 0, 2, 0, 20, 0, 0, 4, 30, 0, 0, 0, 1}, big_endian));
  put(948, order);
  put(996, bytes_of<std::int32_t>({1000}, big_endian));
  return header + bytes_of<std::int32_t>({2}, big_endian) +
         bytes_of<float>({0.5f, 1, 2, 0.25f, 2.5f, 3, 10, 0.75f, -7, 7}, big_endian);
}

TEST_F(UnitTracks, TrkIsInTheScannersCoordinates) {
  for (const bool big_endian : {false, true}) {
    const FileLines lines = read_lines(file("a.trk", trk("RAS", big_endian)));
    // The first point is the centre of voxel (0, 0, 0), the second of (2, 1, 2).
    EXPECT_EQ(lines.positions, (std::vector<Vec3>{{10, 20, 30}, {12, 22, 38}}));
    EXPECT_EQ(lines.scalars.at("fa"), (std::vector<double>{0.25, 0.75}));
    EXPECT_EQ(lines.scalars.at("pair_0"), (std::vector<double>{-7, -7}));
    EXPECT_EQ(lines.scalars.at("pair_1"), (std::vector<double>{7, 7}));
    EXPECT_EQ(lines.values.at("pair_1"), (std::vector<double>{7}));  // of the track
  }
  // The file's first two axes run the other way: voxel (0, 0, 0) of it is (7, 5, 0) of the image.
  EXPECT_EQ(read_lines(file("b.trk", trk("LPS", false))).positions[0], Vec3(17, 30, 30));
  EXPECT_THAT(refusal([&] { read_lines(file("c.trk", trk("RAX", false))); }),
              HasSubstr("voxel_order 'RAX'"));
  const std::string whole = trk("RAS", false);
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_THAT(refusal([&] { read_lines(file("cut.trk", whole.substr(0, size))); }),
                HasSubstr("cut.trk"));
}

/// The voxels of trk(), in an image whose axes run to the front, up and to the right, with voxels
/// of 2 × 4 × 1 mm along them.
std::string trk_of_other_axes(const std::string& order) {
  std::string content = trk(order, false);
  const std::string matrix = bytes_of<float>({0, 0, 1, 10, 2, 0, 0, 20, 0, 4, 0, 30, 0, 0, 0, 1});
  return content.replace(440, matrix.size(), matrix);
}

/// nibabel 5.0 writes and reads them so; tests/app/compare_readers.py asks it.
TEST_F(UnitTracks, TrkExchangesAxesAsNibabelDoes) {
  const LineSet circle = read_lines(file("a.trk", trk_of_other_axes("RAS")));
  // Voxel (2, 1, 2) of the file is y of the image: y_0 = 2 (the file's R is the image's third
  // axis), y_1 = 2 (A, its first), y_2 = 1 (S, its second); in mm (y_2, 2 y_0, 4 y_1).
  EXPECT_EQ(circle.positions, (std::vector<Vec3>{{10, 20, 30}, {11, 24, 38}}));
  EXPECT_THAT(circle.remarks,
              ::testing::ElementsAre("voxel_order RAS has other axes than vox_to_ras, ASR: "
                                     "exchanged as nibabel does"));
  // The same axes, of which the file's second runs to the inferior: of 6 voxels.
  const LineSet turned = read_lines(file("b.trk", trk_of_other_axes("AIR")));
  EXPECT_EQ(turned.positions, (std::vector<Vec3>{{10, 20, 50}, {12, 24, 46}}));
  EXPECT_TRUE(turned.remarks.empty());
}

TEST_F(UnitTracks, TrkWithoutAMatrixHasTheIdentity) {
  std::string content = trk("", false);
  content.replace(440, 64, std::string(64, '\0'));
  const LineSet lines = read_lines(file("a.trk", content));
  EXPECT_EQ(lines.positions, (std::vector<Vec3>{{7, 5, 0}, {5, 4, 2}}));  // LPS, of 8 × 6 voxels
  EXPECT_THAT(lines.remarks,
              ::testing::ElementsAre("vox_to_ras is not recorded: taken for the identity"));
  std::string old = trk("", false);
  old[992] = 1;  // a version that has no matrix
  EXPECT_EQ(read_lines(file("b.trk", old)).positions, lines.positions);
  content.replace(440 + 60, 4, bytes_of<float>({1}));
  EXPECT_THAT(refusal([&] { read_lines(file("c.trk", content)); }),
              HasSubstr("vox_to_ras; accepted: a matrix with an inverse"));
}

std::string hair(std::uint32_t arrays, const std::string& data) {
  return "HAIR" + bytes_of<std::uint32_t>({2, 5, arrays, 1}) +
         bytes_of<float>({0.5f, 0.25f, 1, 0.5f, 0}) + std::string(88, 'i') + data;
}

TEST_F(UnitTracks, HairHasStrandsWithOpacityAndColour) {
  const std::string segments = bytes_of<std::uint16_t>({2, 1});
  const std::string points = bytes_of<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 5, 5, 6, 6, 6});
  const LineSet plain = read_lines(file("a.hair", hair(3, segments + points)));
  EXPECT_EQ(plain.offsets, (std::vector<std::uint64_t>{0, 3, 5}));
  EXPECT_EQ(plain.positions[3], Vec3(5));
  EXPECT_EQ(plain.colors[4], Rgba(1, 0.5f, 0, 0.75f));
  EXPECT_EQ(plain.scalars.at("thickness"), std::vector<double>(5, 0.5));
  const std::string whole = hair(31, segments + points + bytes_of<float>({1, 2, 3, 4, 5}) +
                                         bytes_of<float>({0, 0.25f, 0.5f, 0.75f, 1}) +
                                         bytes_of(std::vector<float>(15, 0.5f)));
  const LineSet full = read_lines(file("b.hair", whole));
  EXPECT_EQ(full.colors[3], Rgba(0.5f, 0.5f, 0.5f, 0.25f));
  EXPECT_EQ(full.scalars.at("thickness")[4], 5);
  expect_cuts_are_refused("cut.hair", whole, read_lines);
  EXPECT_THAT(refusal([&] { read_lines(file("c.hair", hair(2, points))); }),
              HasSubstr("strands have 4 points, but there are 5"));
}

TEST_F(UnitTracks, TrkHoldsAsManyTracksAsItSays) {
  std::string counted = trk("RAS", false);
  const auto with_count = [&](std::int32_t count) {
    return file("a.trk", counted.replace(988, 4, bytes_of<std::int32_t>({count})));
  };
  EXPECT_EQ(read_lines(with_count(1)).line_count(), 1u);
  EXPECT_EQ(read_lines(with_count(0)).line_count(), 1u);  // it does not say
  EXPECT_THAT(refusal([&] { read_lines(with_count(99)); }),
              HasSubstr("its header says 99 tracks, but it holds 1"));
}

TEST_F(UnitTracks, TckHoldsAsManyTracksAsItSays) {
  constexpr float nan = NAN, inf = INFINITY;
  const auto with_count = [&](const std::string& count) {
    const std::string head = "mrtrix tracks\ndatatype: Float32LE\n" + count + "file: . 80\nEND\n";
    return file("a.tck", head + std::string(80 - head.size(), ' ') +
                             bytes_of<float>({0,   0, 0, 1, 0, 0, nan, nan, nan, nan, nan,
                                              nan, 0, 1, 0, 1, 1, 0,   inf, inf, inf}));
  };
  for (const char* right : {"", "count: 3\n", "count: 0003\n", "count: 0\n"})
    EXPECT_EQ(read_lines(with_count(right)).line_count(), 2u) << right;  // and one without points
  for (const char* wrong : {"count: 5\n", "count: 2\n"})
    EXPECT_THAT(refusal([&] { read_lines(with_count(wrong)); }),
                HasSubstr("but it holds 3 tracks"));
}

}  // namespace
}  // namespace pellucid::geometry
