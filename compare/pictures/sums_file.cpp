// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/sums_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>
#include <fmt/format.h>

#include <array>
#include <bit>
#include <fstream>

#include "compare/pictures/exr_file.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using groundtruth::RayLayer;
using groundtruth::RaySums;

const fs::path& checked(const fs::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".exr")
    throw InputError(fmt::format("{}: ending '{}'; accepted: .exr", path.string(), ending));
  return path;
}

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(float(value)); }

/// A DeepChannel is one of a crossing's numbers, as the 32 bits of a float or an integer.
struct DeepChannel {
  const char* name;
  Imf::PixelType type;
  std::uint32_t (*value)(const RayLayer& layer);
};

constexpr DeepChannel deep_channels[] = {
    {"R", Imf::FLOAT, [](const RayLayer& l) { return bits(l.opacity * l.color[0]); }},
    {"G", Imf::FLOAT, [](const RayLayer& l) { return bits(l.opacity * l.color[1]); }},
    {"B", Imf::FLOAT, [](const RayLayer& l) { return bits(l.opacity * l.color[2]); }},
    {"A", Imf::FLOAT, [](const RayLayer& l) { return bits(l.opacity); }},
    {"Z", Imf::FLOAT, [](const RayLayer& l) { return bits(l.depth); }},
    {"importance", Imf::FLOAT, [](const RayLayer& l) { return bits(l.importance); }},
    {"object", Imf::UINT, [](const RayLayer& l) { return std::uint32_t(l.object); }},
    {"primitive", Imf::UINT, [](const RayLayer& l) { return std::uint32_t(l.primitive); }},
};

Imf::Header deep_header(int width, int height) {
  Imf::Header header(width, height);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const DeepChannel& channel : deep_channels)
    header.channels().insert(channel.name, Imf::Channel(channel.type));
  return header;
}

/// A DeepRow is one row's samples as OpenEXR takes them: for each channel, a pointer per pixel.
class DeepRow {
 public:
  explicit DeepRow(const std::vector<RaySums>& rays) : counts_(rays.size()) {
    for (std::size_t x = 0; x < rays.size(); ++x) counts_[x] = unsigned(rays[x].layers.size());
    for (std::size_t c = 0; c < std::size(deep_channels); ++c) fill(c, rays);
  }

  /// The row is number `y` of the file: OpenEXR multiplies it by a stride, which is 0.
  Imf::DeepFrameBuffer frame() {
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts_.data()), sizeof counts_[0], 0));
    for (std::size_t c = 0; c < std::size(deep_channels); ++c)
      frame.insert(
          deep_channels[c].name,
          Imf::DeepSlice(deep_channels[c].type, reinterpret_cast<char*>(pointers_[c].data()),
                         sizeof pointers_[c][0], 0, sizeof(std::uint32_t)));
    return frame;
  }

 private:
  void fill(std::size_t c, const std::vector<RaySums>& rays) {
    for (const RaySums& ray : rays)
      for (const RayLayer& layer : ray.layers) values_[c].push_back(deep_channels[c].value(layer));
    std::uint32_t* next = values_[c].data();
    for (const unsigned count : counts_) {
      pointers_[c].push_back(next);
      next += count;
    }
  }

  std::vector<unsigned> counts_;
  std::array<std::vector<std::uint32_t>, std::size(deep_channels)> values_;
  std::array<std::vector<std::uint32_t*>, std::size(deep_channels)> pointers_;
};

void write_rows(const fs::path& path, std::ostream& out, const Imf::Header& header, int height,
                const std::function<std::vector<RaySums>(int y)>& row) {
  ExrStream stream(out, path);
  Imf::DeepScanLineOutputFile file(stream, header, exr_threads());
  for (int y = 0; y < height; ++y) {
    DeepRow samples(row(y));
    file.setFrameBuffer(samples.frame());
    file.writePixels(1);
  }
}

}  // namespace

void write_sums(const fs::path& path, const Raster<groundtruth::PixelSums>& sums) {
  static_assert(sizeof(groundtruth::PixelSums) == 7 * sizeof(float));
  write_text(checked(path), encode_exr(path, sums.width, sums.height,
                                       {"layers", "coverage", "transmittance", "importance_sum",
                                        "optical_depth", "near", "far"},
                                       Imf::FLOAT, sums.pixels.data()));
}

void write_deep(const fs::path& path, int width, int height,
                const std::function<std::vector<RaySums>(int y)>& row) {
  OutputFile file(checked(path));
  std::ofstream out(file.temporary(), std::ios::binary);
  write_rows(path, out, deep_header(width, height), height, row);
  out.close();
  if (!out) throw WorkError(fmt::format("{}: cannot write the picture", path.string()));
  file.commit();
}

}  // namespace pellucid::compare
