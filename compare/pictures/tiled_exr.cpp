// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/tiled_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <array>

#include "core/files/write_failure.h"

namespace pellucid::compare {
namespace {

constexpr std::array<const char*, 4> channels{"R", "G", "B", "A"};

Imf::Header tiled_header(int width, int height, const PictureForm& form) {
  Imf::Header header(width, height);
  for (const auto& [name, words] : text_of_exr(form))
    header.insert(name, Imf::StringAttribute(words));
  header.compression() = Imf::ZIP_COMPRESSION;
  header.setTileDescription(Imf::TileDescription(TiledExr::side, TiledExr::side));
  for (const char* channel : channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  return header;
}

}  // namespace

TiledExr::TiledExr(const std::filesystem::path& path, int width, int height,
                   const PictureForm& form)
    : path_(path), output_(path), out_(output_.temporary(), std::ios::binary), stream_(out_, path) {
  file_.emplace(stream_, tiled_header(width, height, form), exr_threads());
}

void TiledExr::add(const Image& rows) {
  // OpenEXR writes from what it takes as not constant, and counts rows from the picture's top.
  auto* values = reinterpret_cast<char*>(const_cast<Rgba*>(rows.pixels.data()));
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < channels.size(); ++i)
    frame.insert(channels[i],
                 Imf::Slice::Make(Imf::FLOAT, values + i * sizeof(float), Imath::V2i(0, written_),
                                  rows.width, rows.height, sizeof(Rgba)));
  file_->setFrameBuffer(frame);
  file_->writeTiles(0, file_->numXTiles() - 1, written_ / side, written_ / side);
  written_ += rows.height;
}

void TiledExr::commit() {
  file_.reset();  // writes where its tiles lie
  out_.close();
  if (!out_) fail_stream(path_);
  output_.commit();
}

}  // namespace pellucid::compare
