// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/sums/sums_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/pictures/exr_file.h"
#include "core/error.h"
#include "core/files/ending.h"
#include "core/files/output_file.h"
#include "core/files/write_failure.h"
#include "readers/pictures/deep_channels.h"
#include "readers/pictures/picture_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using scene::SumPlane;

constexpr std::string_view behind_name = "behind";
constexpr int most_phases = 2;

/// Names of channels sort as the planes do: OpenEXR keeps them in order of the alphabet.
std::string channel_name(std::size_t plane, int channel) {
  return fmt::format("{:05}.{}", plane, channel);
}
std::string behind_channel(int channel) { return fmt::format("{}.{}", behind_name, channel); }

nlohmann::json json_of(const SumPlane& plane) {
  return {{"name", plane.name},
          {"channels", plane.channels},
          {"combine", plane.combine == scene::Combine::add ? "add" : "multiply"}};
}

std::string text_of(const SumsFile& sums) {
  const SumsInfo& info = sums.info;
  nlohmann::json planes = nlohmann::json::array();
  for (const SumPlane& plane : sums.planes) planes.push_back(json_of(plane));
  return json_text({{"format", "pellucid-sums"},
                    {"version", 1},
                    {"picture", nlohmann::json::parse(compare::text_of(info.of))},
                    {"scene_file", info.scene_file},
                    {"method", info.method},
                    {"phase", {info.phase, info.phases}},
                    {"depths", {info.depths.near, info.depths.far}},
                    {"planes", planes}});
}

std::pair<JsonNode, JsonNode> two_of(const JsonNode& node) {
  const auto elements = node.elements();
  if (elements.size() != 2) node.fail("accepted: two numbers");
  return {elements[0], elements[1]};
}

SumsInfo info_of(const JsonNode& root) {
  constexpr double any = std::numeric_limits<double>::max();
  root["format"].one_of({"pellucid-sums"});  // before all else, which a deep picture lacks
  root.accept_keys(
      {"format", "version", "picture", "scene_file", "method", "phase", "depths", "planes"});
  root["version"].integer(1, 1);
  SumsInfo info;
  info.of = deep_info_of(root["picture"]);
  info.scene_file = root["scene_file"].string();
  info.method = root["method"].string();
  const auto [phase, phases] = two_of(root["phase"]);
  info.phases = phases.integer(1, most_phases);
  info.phase = phase.integer(1, info.phases);
  const auto [near, far] = two_of(root["depths"]);
  info.depths = {near.number(-any, any), far.number(-any, any)};
  return info;
}

scene::SumPlanes planes_of(const JsonNode& root) {
  scene::SumPlanes planes;
  for (const JsonNode& node : root["planes"].elements()) {
    SumPlane plane;
    plane.name = node["name"].string();
    plane.channels = node["channels"].integer(1, 4);
    plane.combine = node["combine"].one_of({"add", "multiply"}) == "add" ? scene::Combine::add
                                                                         : scene::Combine::multiply;
    planes.push_back(std::move(plane));
  }
  return planes;
}

/// Calls use(name, first value, values a pixel) for every channel; `sums` may be constant or not.
template <class Sums, class Use>
void for_each_channel(Sums& sums, const Use& use) {
  for (std::size_t p = 0; p < sums.planes.size(); ++p)
    for (int c = 0; c < sums.planes[p].channels; ++c)
      use(channel_name(p, c), sums.planes[p].values.data() + c, sums.planes[p].channels);
  for (int c = 0; c < 4; ++c) use(behind_channel(c), &sums.behind.pixels.data()->x + c, 4);
}

void write_exr(const fs::path& path, const SumsFile& sums, std::ostream& out) {
  Imf::Header header(sums.behind.width, sums.behind.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert(readers::deep_attribute, Imf::StringAttribute(text_of(sums)));
  Imf::FrameBuffer frame;
  for_each_channel(sums, [&](const std::string& name, const float* first, int stride) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const std::size_t pixel = std::size_t(stride) * sizeof(float);
    // OpenEXR writes from what it takes as not constant.
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(first)),
                                  pixel, pixel * std::size_t(sums.behind.width)));
  });
  ExrStream stream(out, path);
  Imf::OutputFile file(stream, header, exr_threads());
  file.setFrameBuffer(frame);
  file.writePixels(sums.behind.height);
}

[[noreturn]] void fail(const fs::path& path, std::string_view why) {
  throw InputError(fmt::format("{}: {}; accepted: what render --partial FILE.exr has written",
                               path.string(), why));
}

nlohmann::json parsed(const fs::path& path, const std::string& text) {
  if (text.empty()) fail(path, "does not hold sums of a part of a scene");
  return parse_json(path.string(), text);
}

void take_channel(const fs::path& path, const readers::PictureFile& file, const std::string& name,
                  float* first, int stride) {
  const auto channel = std::ranges::find(file.channels, name, &Block::name);
  if (channel == file.channels.end() || channel->type != NumberType::f32)
    fail(path, fmt::format("has no channel '{}'", name));
  for (const float value : channel->values<float>()) {
    *first = value;
    first += stride;
  }
}

}  // namespace

void write_sums_file(const fs::path& path, const SumsFile& sums) {
  if (small_ending(path) != ".exr")
    throw InputError(
        fmt::format("{}: ending '{}'; accepted: .exr", path.string(), path.extension().string()));
  OutputFile output(path);
  std::ofstream out(output.temporary(), std::ios::binary);
  write_exr(path, sums, out);
  out.close();
  if (!out) fail_stream(path);
  output.commit();
}

SumsInfo read_sums_info(const fs::path& path) {
  const nlohmann::json json = parsed(path, readers::read_picture_text(path));
  return info_of(JsonNode(path.string(), json));
}

SumsFile read_sums_file(const fs::path& path) {
  const readers::PictureFile file = readers::read_picture_file(path);
  const nlohmann::json json = parsed(path, file.text);
  const JsonNode root(path.string(), json);
  SumsFile sums{info_of(root), planes_of(root), Image(file.data.width, file.data.height)};
  if (sums.info.of.width != file.data.width || sums.info.of.height != file.data.height)
    fail(path, "is not of the size that it says");
  for (SumPlane& plane : sums.planes)
    plane.values.resize(sums.behind.pixels.size() * std::size_t(plane.channels));
  for_each_channel(sums, [&](const std::string& name, float* first, int stride) {
    take_channel(path, file, name, first, stride);
  });
  return sums;
}

}  // namespace pellucid::compare
