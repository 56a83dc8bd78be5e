// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of the command line, over bad things × commands: exit code 2, one line on stderr
// that names the file, and nothing left behind.

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/files/output_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Something that takes the place of an input and must be refused.
struct BadThing {
  const char* name;
  std::function<void(const fs::path&)> make;
};

void write(const fs::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary) << content;
}

std::string repeated(const char* text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

const std::vector<BadThing>& bad_things() {
  static const std::vector<BadThing> things = {
      {"nothing", [](const fs::path&) {}},
      {"folder", [](const fs::path& p) { fs::create_directory(p); }},
      {"pipe", [](const fs::path& p) { ASSERT_EQ(::mkfifo(p.c_str(), 0600), 0); }},
      {"device", [](const fs::path& p) { fs::create_symlink("/dev/zero", p); }},
      {"link_to_itself", [](const fs::path& p) { fs::create_symlink(p.filename(), p); }},
      {"empty", [](const fs::path& p) { write(p, ""); }},
      {"zeros", [](const fs::path& p) { write(p, std::string(5000, '\0')); }},
      {"binary", [](const fs::path& p) { write(p, repeated("\xFF\x1B[2J\n\x80", 300)); }},
      {"text", [](const fs::path& p) { write(p, "ply obj <VTKFile {\"format\": 1}\n"); }},
      {"nested", [](const fs::path& p) { write(p, repeated("[", 100000)); }},
      {"long_line", [](const fs::path& p) { write(p, repeated("ä", 100000)); }},
  };
  return things;
}

/// One way to hand a file to the program: its ending, and the arguments with {} for it.
struct Reading {
  const char* name;
  const char* ending;
  const char* arguments;
};

constexpr Reading readings[] = {
    {"scene", ".json", "render {} -m raytrace -o out.exr"},
    {"scene_of_tune", ".json", "tune {} --max-rmse 0.1"},
    {"scene_of_frames", ".json", "frames {} -m raytrace --orbit 10 --frames 2 -o frames"},
    {"study", ".json", "study {} -o results"},
    {"picture_exr", ".exr", "compare {} good.exr --diff out.png"},
    {"picture_png", ".png", "compare good.exr {} --diff out.png"},
    {"parts", ".exr", "merge {} -o out.exr"},
    {"info", ".exr", "info {}"},
    {"field_vti", ".vti",
     "trace --field {} --integrator fixed-front --seed 0,0,0:1,0,0 --duration 1 -o out.ply"},
    {"field_vtk", ".vtk",
     "trace --field {} --integrator fixed-front --seed 0,0,0:1,0,0 --duration 1 -o out.ply"},
    {"field_vdb", ".vdb",
     "trace --field {} --integrator fixed-front --seed 0,0,0:1,0,0 --duration 1 -o out.ply"},
    {"field_mhd", ".mhd",
     "trace --field {} --integrator fixed-front --seed 0,0,0:1,0,0 --duration 1 -o out.ply"},
    {"series", ".series",
     "trace --field {} --integrator fixed-front --seed 0,0,0:1,0,0 --duration 1 -o out.ply"},
    {"mesh_ply", ".ply", "render MESH -m raytrace -o out.exr"},
    {"mesh_obj", ".obj", "render MESH -m raytrace -o out.exr"},
    {"mesh_vtp", ".vtp", "render MESH -m raytrace -o out.exr"},
    {"points_csv", ".csv", "render POINTS -m raytrace -o out.exr"},
    {"points_vdb", ".vdb", "render POINTS -m raytrace -o out.exr"},
    {"lines_binlines", ".binlines", "render LINES -m raytrace -o out.exr"},
};

class UnitContract : public ::testing::Test {
 protected:
  struct Outcome {
    int exit_code;
    std::string err;
  };

  Outcome run(const std::string& arguments, const std::string& before = "",
              const std::string& output = "/dev/null") const {
    const testing::TemporaryFolder beside;
    const std::string command = "cd " + folder_.path().string() + " && " + before + "timeout 20 " +
                                PELLUCID_PROGRAM + " " + arguments + " --quiet > " + output +
                                " 2> " + (beside / "err").string();
    const int status = std::system(command.c_str());
    std::ifstream err(beside / "err");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            std::string(std::istreambuf_iterator<char>(err), {})};
  }
  std::set<fs::path> files() const {
    std::set<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) all.insert(entry);
    return all;
  }
  /// A scene with the file as a mesh, as points or as lines.
  void write_scene(const std::string& kind, const std::string& file) const {
    const std::string radius = kind == "mesh" ? "" : R"(, "radius": 0.1)";
    write(folder_ / "of.json", R"({"format": "pellucid-scene", "version": 1, "resolution": [8, 8],
      "objects": [{")" + kind + "\": \"" +
                                   file + "\"" + radius + "}]}");
  }

  testing::TemporaryFolder folder_;
};

class PropertyContract : public UnitContract, public ::testing::WithParamInterface<std::size_t> {};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
  return text;
}

TEST_P(PropertyContract, ABadInputIsOneLineThatNamesIt) {
  const Reading& reading = readings[GetParam()];
  write(
      folder_ / "sheet.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
      "3 0 1 2\n");
  write_scene("mesh", "sheet.ply");
  ASSERT_EQ(run("render of.json -m raytrace -o good.exr").exit_code, 0);
  for (const BadThing& thing : bad_things()) {
    const std::string file = std::string("bad_") + thing.name + reading.ending;
    thing.make(folder_ / file);
    std::string arguments = replaced(reading.arguments, "{}", file);
    for (const char* kind : {"mesh", "points", "lines"}) {
      std::string capitals = kind;
      std::ranges::transform(capitals, capitals.begin(),
                             [](unsigned char c) { return std::toupper(c); });
      if (arguments.find(capitals) == std::string::npos) continue;
      write_scene(kind, file);
      arguments = replaced(arguments, capitals, "of.json");
    }
    const auto before = files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << ": " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(file));
    EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << "an escape reached the terminal";
    EXPECT_EQ(files(), before) << arguments;
  }
}

/// What a picture claims of its size is held to its bytes: 69 of a PNG that says 16384².
TEST_F(UnitContract, APictureThatClaimsAGigabyteIsRefused) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer's own memory is beyond the limit";
#endif
  const auto word = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift & 0xff);
    return bytes;
  };
  const auto chunk = [&](const std::string& content) {  // its first four letters are the kind
    std::uint32_t sum = 0xffffffff;                     // CRC-32, as ISO 3309 has it
    for (const char c : content) {
      sum ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return word(std::uint32_t(content.size()) - 4) + content + word(~sum);
  };
  const std::string header = word(16384) + word(16384) + std::string("\x08\x06\0\0\0", 5);
  write(folder_ / "large.png", "\x89PNG\r\n\x1a\n" + chunk("IHDR" + header) +
                                   chunk("IDAT" + std::string("\x78\x9c\x03\0\0\0\0\x01", 8)) +
                                   chunk("IEND"));
  // Below what the pixels alone would take, 1 GiB.
  const Outcome outcome = run("compare large.png large.png", "ulimit -v 900000; ");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("large.png"));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(UnitContract, AFullStandardOutputIsAnError) {
  write(folder_ / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const char* arguments : {"list methods", "info mesh.obj --json", "--version"}) {
    const Outcome outcome = run(arguments, "", "/dev/full");
    EXPECT_EQ(outcome.exit_code, 1) << arguments << ": " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(, PropertyContract, ::testing::Range<std::size_t>(0, std::size(readings)),
                         [](const auto& index) { return std::string(readings[index.param].name); });

}  // namespace
}  // namespace pellucid::app
