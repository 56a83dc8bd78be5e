// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "app/info/inspect.h"
#include "compare/deep/deep_info.h"
#include "readers/pictures/deep_file.h"
#include "readers/pictures/picture_file.h"

namespace pellucid::app {
namespace {

ArrayContents contents_of(const Block& channel) {
  RangeCollector ranges(1);
  const bool counts = channel.type == NumberType::u32;
  if (counts)
    for (const std::uint32_t value : channel.values<std::uint32_t>()) ranges.add(0, value);
  else
    for (const float value : channel.values<float>()) ranges.add(0, double(value));
  return ranges.contents(channel.name, "pixel", counts ? "unsigned int" : "float", channel.tuples);
}

FileContents inspect_deep(const std::filesystem::path& path) {
  const readers::DeepHead head = readers::read_deep_head(path);
  const compare::DeepInfo info = compare::deep_info_of(path.string(), head.text);
  FileContents contents;
  contents.kind = "deep picture";
  contents.title = "every crossing of every pixel";
  contents.counts = {
      {"width", std::uint64_t(head.width)},
      {"height", std::uint64_t(head.height)},
      {"crossings", std::accumulate(head.samples.begin(), head.samples.end(), std::uint64_t(0))}};
  contents.more = {
      {"scene", info.scene},
      {"part", {info.part.part, info.part.count}},
      {"camera", info.camera},
      {"background", info.background ? json_of(*info.background) : nlohmann::ordered_json("none")},
      {"opaque", info.opaque},
      {"fingerprint", info.fingerprint},
      {"program", info.program},
      {"build", info.build}};
  return contents;
}

}  // namespace

FileContents inspect_picture(const std::filesystem::path& path) {
  if (readers::is_deep_picture(path)) return inspect_deep(path);
  const readers::PictureFile picture = readers::read_picture_file(path);
  FileContents contents;
  contents.kind = "picture";
  contents.title = "picture, values as they are stored";
  contents.counts = {{"width", std::uint64_t(picture.picture.width)},
                     {"height", std::uint64_t(picture.picture.height)},
                     {"channels", picture.channels.size()}};
  for (const Block& channel : picture.channels) contents.arrays.push_back(contents_of(channel));
  return contents;
}

}  // namespace pellucid::app
