// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <limits>
#include <string>
#include <thread>

#include "readers/pictures/deep_channels.h"
#include "readers/pictures/parse_picture.h"

namespace pellucid::readers {
namespace {

/// Empty where the box is, or where its size is none of an int.
PictureWindow window_of(const Imath::Box2i& box) {
  const std::int64_t width = std::int64_t(box.max.x) - box.min.x + 1,
                     height = std::int64_t(box.max.y) - box.min.y + 1;
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (width < 1 || height < 1 || width > most || height > most) return {};
  return {box.min.x, box.min.y, std::int32_t(width), std::int32_t(height)};
}

void check_kind(const std::filesystem::path& path, const Imf::Header& header) {
  if (header.hasType() && Imf::isDeepData(header.type()))
    cannot_read_picture(path, "it is deep; accepted: one sample per pixel");
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
    if (i.channel().xSampling != 1 || i.channel().ySampling != 1)
      cannot_read_picture(path, "it has channels of fewer pixels; accepted: one value per pixel");
}

/// Numbers of 32 bits of any kind: half floats are made float.
struct ChannelValues {
  std::string name;
  Imf::PixelType type;
  std::vector<std::uint32_t> bits;
};

std::vector<ChannelValues> channels_of(const Imf::Header& header) {
  std::vector<ChannelValues> channels;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    const bool is_count = i.channel().type == Imf::UINT;
    channels.push_back({i.name(), is_count ? Imf::UINT : Imf::FLOAT, {}});
  }
  return channels;
}

void read_channels(Imf::InputPart part, const Imath::Box2i& box,
                   std::vector<ChannelValues>& channels) {
  Imf::FrameBuffer buffer;
  for (ChannelValues& channel : channels)
    buffer.insert(channel.name, Imf::Slice::Make(channel.type, channel.bits.data(), box));
  part.setFrameBuffer(buffer);
  part.readPixels(box.min.y, box.max.y);
}

void write_exr_text(const Imf::Header& header, const char* attribute, BlockWriter& out) {
  if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>(attribute))
    out.add_text("text", text->value());
}

}  // namespace

void parse_exr_text(const std::filesystem::path& path, const char* attribute, BlockWriter& out) {
  const Imf::MultiPartInputFile file(path.c_str(), 0);
  write_exr_text(file.header(0), attribute, out);
}

void parse_exr(const std::filesystem::path& path, BlockWriter& out) {
  Imf::MultiPartInputFile file(path.c_str(), int(std::thread::hardware_concurrency()));
  const Imf::Header& header = file.header(0);
  const Imath::Box2i box = header.dataWindow();
  const PictureWindow data = window_of(box), picture = window_of(header.displayWindow());
  check_kind(path, header);
  if (file.parts() > 1)  // of which the first may hold no colours, and the others differ
    cannot_read_picture(path, "it has " + std::to_string(file.parts()) + " parts; accepted: one");
  std::vector<ChannelValues> channels = channels_of(header);
  check_picture_size(path, data, picture, channels.size());
  for (ChannelValues& channel : channels) channel.bits.resize(std::size_t(data.pixels()));
  read_channels(Imf::InputPart(file, 0), box, channels);
  write_windows(data, picture, out);
  write_exr_text(header, deep_attribute, out);
  for (const ChannelValues& channel : channels)
    out.add(std::string(channel_prefix) + channel.name,
            channel.type == Imf::UINT ? NumberType::u32 : NumberType::f32, 1, channel.bits.size(),
            channel.bits.data());
}

}  // namespace pellucid::readers
