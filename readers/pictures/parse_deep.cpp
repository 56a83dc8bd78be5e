// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pictures/parse_deep.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <deque>
#include <numeric>
#include <thread>
#include <vector>

#include "readers/pictures/deep_channels.h"
#include "readers/pictures/parse_picture.h"

namespace pellucid::readers {
namespace {

constexpr std::string_view accepted = "accepted: what render --deep FILE.exr has written";

/// A DeepPicture is a deep picture that is open, its header checked.
class DeepPicture {
 public:
  explicit DeepPicture(const std::filesystem::path& path)
      : path_(path), file_(path.c_str(), int(std::thread::hardware_concurrency())) {
    const Imf::Header& header = file_.header(0);
    if (!header.hasType() || header.type() != Imf::DEEPSCANLINE)
      cannot_read_picture(path, fmt::format("it is not deep; {}", accepted));
    if (!header.findTypedAttribute<Imf::StringAttribute>(deep_attribute))
      cannot_read_picture(path, fmt::format("it does not say what it is of; {}", accepted));
    const Imath::Box2i box = header.dataWindow();
    if (box.min.x != 0 || box.min.y != 0 || box != header.displayWindow())
      cannot_read_picture(path, fmt::format("its rows are not those of the picture; {}", accepted));
    size_ = {0, 0, box.max.x + 1, box.max.y + 1};
    check_picture_size(path, size_, size_, 1);
    check_channels();
  }

  const PictureWindow& size() const { return size_; }
  const std::string& text() const {
    return file_.header(0).typedAttribute<Imf::StringAttribute>(deep_attribute).value();
  }
  /// The file's only part.
  Imf::DeepScanLineInputPart open() { return {file_, 0}; }
  const std::filesystem::path& path() const { return path_; }

 private:
  void check_channel(const std::string& name, Imf::PixelType type) const {
    const Imf::Channel* channel = file_.header(0).channels().findChannel(name);
    if (!channel || channel->type != type || channel->xSampling != 1 || channel->ySampling != 1)
      cannot_read_picture(path_, fmt::format("it has no channel '{}'; {}", name, accepted));
  }
  void check_channels() const {
    for (std::size_t number = 0; number < deep_doubles.size(); ++number)
      for (const std::size_t half : {0, 1}) check_channel(deep_channel(number, half), Imf::UINT);
    check_channel("importance", Imf::FLOAT);
    check_channel("object", Imf::UINT);
    check_channel("primitive", Imf::UINT);
  }

  const std::filesystem::path& path_;
  Imf::MultiPartInputFile file_;
  PictureWindow size_;
};

/// A RowReader reads some rows of a deep picture. OpenEXR takes all places before it counts the
/// samples: of each channel, where a pixel's samples will lie is filled in once they are counted.
class RowReader {
 public:
  RowReader(DeepPicture& picture, int first, int end)
      : part_(picture.open()),
        first_(first),
        end_(end),
        width_(std::size_t(picture.size().width)),
        counts_(width_ * std::size_t(end - first)) {
    const std::size_t row = width_ * sizeof counts_[0];
    frame_.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, before_row(counts_.data(), first, row), sizeof counts_[0], row));
  }

  /// Asks for a channel, before anything is read; returns where its samples will be.
  const std::vector<std::uint32_t>& add(const std::string& name, Imf::PixelType type) {
    Channel& channel = channels_.emplace_back();
    channel.pointers.resize(counts_.size());
    const std::size_t pointer = sizeof channel.pointers[0], row = width_ * pointer;
    frame_.insert(name, Imf::DeepSlice(type, before_row(channel.pointers.data(), first_, row),
                                       pointer, row, sizeof(std::uint32_t)));
    return channel.samples;
  }

  const std::vector<std::uint32_t>& count() {
    part_.setFrameBuffer(frame_);
    part_.readPixelSampleCounts(first_, end_ - 1);
    return counts_;
  }

  /// After count().
  void read() {
    const auto total = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t(0));
    for (Channel& channel : channels_) {
      channel.samples.resize(total);
      std::uint32_t* next = channel.samples.data();
      for (std::size_t i = 0; i < counts_.size(); next += counts_[i++]) channel.pointers[i] = next;
    }
    part_.readPixels(first_, end_ - 1);
  }

 private:
  struct Channel {
    std::vector<std::uint32_t> samples;
    std::vector<std::uint32_t*> pointers;  // of each pixel
  };

  Imf::DeepScanLineInputPart part_;
  int first_, end_;
  std::size_t width_;
  std::vector<std::uint32_t> counts_;
  Imf::DeepFrameBuffer frame_;
  std::deque<Channel> channels_;  // what is given away stays where it is
};

void write_doubles(std::string_view name, const std::vector<std::uint32_t>& high,
                   const std::vector<std::uint32_t>& low, BlockWriter& out) {
  std::vector<double> values(high.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = double_of(high[i], low[i]);
  out.add(name, std::span<const double>(values));
}

}  // namespace

void parse_deep_head(const std::filesystem::path& path, BlockWriter& out) {
  DeepPicture picture(path);
  const std::int32_t size[] = {picture.size().width, picture.size().height};
  std::vector<std::uint64_t> samples;
  for (int y = 0; y < picture.size().height; ++y) {
    RowReader reader(picture, y, y + 1);
    const auto& counts = reader.count();
    samples.push_back(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)));
  }
  out.add("size", std::span<const std::int32_t>(size), 2);
  out.add_text("text", picture.text());
  out.add("samples", std::span<const std::uint64_t>(samples));
}

void parse_deep_rows(const std::filesystem::path& path, int first, int end, BlockWriter& out) {
  DeepPicture picture(path);
  if (first < 0 || first >= end || end > picture.size().height)
    cannot_read_picture(path,
                        fmt::format("rows {} to {} of {}", first, end, picture.size().height));
  RowReader reader(picture, first, end);
  std::vector<const std::vector<std::uint32_t>*> halves;
  for (std::size_t number = 0; number < deep_doubles.size(); ++number)
    for (const std::size_t half : {0, 1})
      halves.push_back(&reader.add(deep_channel(number, half), Imf::UINT));
  const auto& importance = reader.add("importance", Imf::FLOAT);
  const auto& object = reader.add("object", Imf::UINT);
  const auto& primitive = reader.add("primitive", Imf::UINT);
  out.add("counts", std::span<const std::uint32_t>(reader.count()));
  reader.read();
  for (std::size_t number = 0; number < deep_doubles.size(); ++number)
    write_doubles(deep_doubles[number], *halves[2 * number], *halves[2 * number + 1], out);
  out.add("importance", NumberType::f32, 1, importance.size(), importance.data());
  out.add("object", std::span<const std::uint32_t>(object));
  out.add("primitive", std::span<const std::uint32_t>(primitive));
}

}  // namespace pellucid::readers
