// SPDX-License-Identifier: GPL-3.0-or-later
// Tractography in .trx files, which a library unpacks.

#include <archive.h>
#include <archive_entry.h>

#include <map>
#include <memory>

#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Members = std::map<std::string, std::string>;

/// A .zip file of these members, deflated or as they are.
std::string zip(const Members& members, const char* compression) {
  std::string bytes(1 << 16, '\0');
  std::size_t used = 0;
  const std::unique_ptr<archive, decltype(&archive_write_free)> writer(archive_write_new(),
                                                                       archive_write_free);
  archive_write_set_format_zip(writer.get());
  archive_write_set_format_option(writer.get(), "zip", "compression", compression);
  archive_write_open_memory(writer.get(), bytes.data(), bytes.size(), &used);
  for (const auto& [name, content] : members) {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(),
                                                                              archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), la_int64_t(content.size()));
    archive_write_header(writer.get(), entry.get());
    archive_write_data(writer.get(), content.data(), content.size());
  }
  archive_write_close(writer.get());
  return bytes.substr(0, used);
}

/// Streamlines of three points and of two. 0x3800 is 0.5 in 16 bits, 0xC400 is -4, 0x0001 2^-24.
Members two_streamlines() {
  return {
      {"header.json", R"({"NB_VERTICES": 5, "NB_STREAMLINES": 2, "DIMENSIONS": [1, 1, 1]})"},
      {"positions.3.float16", bytes_of<std::uint16_t>({0x3800, 0xC400, 0x0001, 0, 0, 0, 0x3C00, 0,
                                                       0, 0, 0x3C00, 0, 0, 0, 0x3C00})},
      {"offsets.uint32", bytes_of<std::uint32_t>({0, 3})},
      {"dpv/fa.float32", bytes_of<float>({0.5f, 1, 2, 3, 4})},
      {"dpv/color.3.uint8", std::string("\xff\0\x33\xff\0\x33\xff\0\x33\xff\0\x33\xff\0\x33", 15)},
      {"dps/length.float64", bytes_of<double>({7, 9})},
      {"groups/all.uint32", bytes_of<std::uint32_t>({0, 1})}};
}

class UnitTrx : public FormatFiles {
 protected:
  FileLines read(const Members& members, const char* compression = "store") {
    return read_lines(file("a.trx", zip(members, compression)));
  }
  std::string complaint(const Members& members) {
    return refusal([&] { read(members); });
  }
};

TEST_F(UnitTrx, MembersAreArraysByTheirNames) {
  for (const char* compression : {"store", "deflate"}) {
    const FileLines lines = read(two_streamlines(), compression);
    EXPECT_THAT(lines.offsets, ElementsAre(0u, 3u, 5u));
    EXPECT_EQ(lines.positions[0], Vec3(0.5, -4, std::exp2(-24)));
    EXPECT_EQ(lines.positions[3], Vec3(0, 1, 0));
    EXPECT_THAT(lines.scalars.at("fa"), ElementsAre(0.5, 1, 2, 3, 4));
    EXPECT_THAT(lines.scalars.at("length"), ElementsAre(7, 7, 7, 9, 9));
    EXPECT_THAT(lines.values.at("length"), ElementsAre(7, 9));
    EXPECT_EQ(lines.colors[4], Rgba(1, 0, 0.2f, 1));
  }
}

TEST_F(UnitTrx, TheLastOffsetMayBeThere) {
  Members members = two_streamlines();
  members.erase("offsets.uint32");
  members["offsets.uint64"] = bytes_of<std::uint64_t>({0, 3, 5});
  EXPECT_THAT(read(members).offsets, ElementsAre(0u, 3u, 5u));
}

TEST_F(UnitTrx, WhatDoesNotFitTogetherIsRefused) {
  const auto with = [](const std::string& name, const std::string& content) {
    Members members = two_streamlines();
    members[name] = content;
    return members;
  };
  EXPECT_THAT(complaint(with("offsets.uint32", bytes_of<std::uint32_t>({0, 6}))),
              HasSubstr("begins streamline 1 at vertex 6 of 5"));
  EXPECT_THAT(complaint(with("offsets.uint32", bytes_of<std::uint32_t>({0, 1, 2, 3}))),
              HasSubstr("has 4 rows for 2 streamlines"));
  EXPECT_THAT(complaint(with("dpv/fa.float32", bytes_of<float>({1}))),
              HasSubstr("has 1 rows for 5 vertices"));
  EXPECT_THAT(complaint(with("dpv/fa.float33", "")), HasSubstr("not of the form NAME.TYPE"));
  EXPECT_THAT(complaint(with("positions.3.float32", "")), HasSubstr("are both there"));
  EXPECT_THAT(complaint(with("header.json", R"({"NB_VERTICES": -1})")),
              HasSubstr("NB_VERTICES: accepted: a whole number"));
  EXPECT_THAT(complaint({{"header.json", R"({"NB_VERTICES": 0, "NB_STREAMLINES": 0})"}}),
              HasSubstr("it has no positions"));
  EXPECT_THAT(complaint({{"all/header.json", "{}"}}),
              HasSubstr("it has no header.json at its root, but all/header.json"));
  EXPECT_THAT(refusal([&] { read_lines(file("b.trx", "no zip file")); }), HasSubstr("b.trx"));
  expect_cuts_are_refused("cut.trx", zip(two_streamlines(), "store"), read_lines);
}

}  // namespace
}  // namespace pellucid::geometry
