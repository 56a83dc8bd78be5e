// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/pictures/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <tbb/global_control.h>

#include <mutex>
#include <sstream>

#include "core/files/write_failure.h"

namespace pellucid::compare {
namespace {

constexpr std::size_t value_size = 4;  // of float and of unsigned integers

/// The rows of interleaved values; OpenEXR writes from what it takes as not constant.
Imf::FrameBuffer frame_of(int width, const std::vector<std::string>& channels, Imf::PixelType type,
                          const void* pixels) {
  char* values = const_cast<char*>(static_cast<const char*>(pixels));
  const std::size_t pixel = channels.size() * value_size;
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < channels.size(); ++i)
    frame.insert(channels[i],
                 Imf::Slice(type, values + i * value_size, pixel, pixel * std::size_t(width)));
  return frame;
}

}  // namespace

void ExrStream::write(const char bytes[], int count) {
  stream_.write(bytes, count);
  check();
}

/// OpenEXR's destructors ask for the position, and may not be thrown at: who writes next is told.
std::uint64_t ExrStream::tellp() { return std::uint64_t(stream_.tellp()); }

void ExrStream::seekp(std::uint64_t position) {
  stream_.seekp(std::streamoff(position));
  check();
}

void ExrStream::check() const {
  if (!stream_) fail_stream(fileName());
}

int exr_threads() {
  const auto threads =
      int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  static std::mutex one_at_a_time;  // files are written at once
  const std::scoped_lock lock(one_at_a_time);
  if (Imf::globalThreadCount() != threads) Imf::setGlobalThreadCount(threads);
  return threads;
}

std::string encode_exr(const std::filesystem::path& path, int width, int height,
                       const std::vector<std::string>& channels, Imf::PixelType type,
                       const void* pixels, const PictureText& text) {
  Imf::Header header(width, height);
  for (const auto& [name, words] : text) header.insert(name, Imf::StringAttribute(words));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& channel : channels) header.channels().insert(channel, Imf::Channel(type));
  std::ostringstream memory;
  {
    ExrStream stream(memory, path);
    Imf::OutputFile file(stream, header, exr_threads());
    file.setFrameBuffer(frame_of(width, channels, type, pixels));
    file.writePixels(height);
  }
  return std::move(memory).str();
}

}  // namespace pellucid::compare
