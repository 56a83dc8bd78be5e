// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <array>
#include <bit>
#include <fstream>
#include <optional>

#include "compare/deep/deep_formats.h"
#include "compare/pictures/exr_file.h"
#include "core/files/output_file.h"
#include "core/files/write_failure.h"
#include "readers/pictures/deep_channels.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// Rows that OpenEXR compresses at once, by several threads.
constexpr int rows_at_once = 16;

std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(float(value)); }

/// The exact doubles, in the order of readers::deep_doubles.
double exact_double(const DeepLayer& layer, std::size_t number) {
  return number == 0   ? layer.depth
         : number == 4 ? layer.opacity
                       : layer.color[glm::length_t(number) - 1];
}

/// A DeepChannel is one of a layer's numbers, as the 32 bits of a float or an integer.
struct DeepChannel {
  const char* name;
  Imf::PixelType type;
  std::uint32_t (*value)(const DeepLayer& layer);
};

constexpr DeepChannel plain_channels[] = {
    {"R", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.opacity * l.color[0]); }},
    {"G", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.opacity * l.color[1]); }},
    {"B", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.opacity * l.color[2]); }},
    {"A", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.opacity); }},
    {"Z", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.depth); }},
    {"importance", Imf::FLOAT, [](const DeepLayer& l) { return bits(l.importance); }},
    {"object", Imf::UINT, [](const DeepLayer& l) { return l.object; }},
    {"primitive", Imf::UINT, [](const DeepLayer& l) { return l.primitive; }},
};
constexpr std::size_t plain_count = std::size(plain_channels);
constexpr std::size_t channel_count = plain_count + 2 * readers::deep_doubles.size();

std::string name_of(std::size_t channel) {
  if (channel < plain_count) return plain_channels[channel].name;
  return readers::deep_channel((channel - plain_count) / 2, (channel - plain_count) % 2);
}

Imf::PixelType type_of(std::size_t channel) {
  return channel < plain_count ? plain_channels[channel].type : Imf::UINT;
}

std::uint32_t value_of(const DeepLayer& layer, std::size_t channel) {
  if (channel < plain_count) return plain_channels[channel].value(layer);
  return readers::half_of(exact_double(layer, (channel - plain_count) / 2),
                          (channel - plain_count) % 2);
}

Imf::Header deep_header(const DeepInfo& info) {
  Imf::Header header(info.width, info.height);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.insert(readers::deep_attribute, Imf::StringAttribute(text_of(info)));
  for (std::size_t c = 0; c < channel_count; ++c)
    header.channels().insert(name_of(c), Imf::Channel(type_of(c)));
  return header;
}

class ExrWriter : public DeepWriter {
 public:
  ExrWriter(const fs::path& path, const DeepInfo& info)
      : path_(path),
        width_(std::size_t(info.width)),
        output_(path),
        out_(output_.temporary(), std::ios::binary),
        stream_(out_, path) {
    file_.emplace(stream_, deep_header(info), exr_threads());
  }

  void add(const DeepRow& row) override {
    counts_.insert(counts_.end(), row.counts.begin(), row.counts.end());
    for (std::size_t c = 0; c < channel_count; ++c)
      for (const DeepLayer& layer : row.layers) values_[c].push_back(value_of(layer, c));
    if (++waiting_ == rows_at_once) write();
  }

  void commit() override {
    write();
    file_.reset();  // writes where its rows lie
    out_.close();
    if (!out_) fail_stream(path_);
    output_.commit();
  }

 private:
  void write() {
    if (waiting_ == 0) return;
    std::array<std::vector<std::uint32_t*>, channel_count> pointers;
    file_->setFrameBuffer(frame(pointers));
    file_->writePixels(waiting_);
    written_ += waiting_;
    waiting_ = 0;
    counts_.clear();
    for (auto& values : values_) values.clear();
  }

  /// The rows that wait as OpenEXR takes them: for each channel, a pointer per pixel.
  Imf::DeepFrameBuffer frame(std::array<std::vector<std::uint32_t*>, channel_count>& pointers) {
    Imf::DeepFrameBuffer frame;
    const std::size_t count = sizeof counts_[0], pointer = sizeof(std::uint32_t*);
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, readers::before_row(counts_.data(), written_, width_ * count), count,
                   width_ * count));
    for (std::size_t c = 0; c < channel_count; ++c) {
      std::uint32_t* next = values_[c].data();
      for (const std::uint32_t samples : counts_) {
        pointers[c].push_back(next);
        next += samples;
      }
      frame.insert(name_of(c), Imf::DeepSlice(type_of(c),
                                              readers::before_row(pointers[c].data(), written_,
                                                                  width_ * pointer),
                                              pointer, width_ * pointer, sizeof(std::uint32_t)));
    }
    return frame;
  }

  fs::path path_;
  std::size_t width_;
  OutputFile output_;
  std::ofstream out_;
  ExrStream stream_;
  std::optional<Imf::DeepScanLineOutputFile> file_;
  int written_ = 0, waiting_ = 0;  // rows
  std::vector<std::uint32_t> counts_;
  std::array<std::vector<std::uint32_t>, channel_count> values_;
};

}  // namespace

std::unique_ptr<DeepWriter> make_exr_writer(const fs::path& path, const DeepInfo& info) {
  return std::make_unique<ExrWriter>(path, info);
}

}  // namespace pellucid::compare
