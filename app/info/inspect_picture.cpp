// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/inspect.h"
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

}  // namespace

FileContents inspect_picture(const std::filesystem::path& path) {
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
