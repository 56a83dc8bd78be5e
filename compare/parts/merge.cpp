// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "compare/parts/same_whole.h"
#include "core/error.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using readers::DeepHead;
using readers::DeepSamples;

DeepInfo info_of(const fs::path& file, const DeepHead& head) {
  DeepInfo info = deep_info_of(file.string(), head.text);
  if (info.width != head.width || info.height != head.height)
    throw InputError(fmt::format("{}: has {}x{} pixels, but says that it has {}x{}", file.string(),
                                 head.width, head.height, info.width, info.height));
  return info;
}

/// Throws unless all samples have a place: a number that is none has no order.
void check_depths(const fs::path& file, const DeepSamples& samples) {
  const auto is_place = [](double depth) { return depth > 0; };
  if (!std::ranges::all_of(samples.doubles[0], is_place))
    throw InputError(
        fmt::format("{}: is damaged: a view depth that is not above 0", file.string()));
}

DeepLayer layer_of(const DeepSamples& samples, std::size_t i) {
  const auto& [depth, red, green, blue, alpha] = samples.doubles;
  return {depth[i],          Vec3(red[i], green[i], blue[i]),
          alpha[i],          samples.importance[i],
          samples.object[i], samples.primitive[i]};
}

/// A PartRows holds some rows of a part, and where each row's samples begin.
class PartRows {
 public:
  PartRows(DeepSamples samples, std::size_t width) : samples_(std::move(samples)), width_(width) {
    for (std::size_t i = 0; i < samples_.counts.size(); ++i) {
      if (i % width == 0) begins_.push_back(total_);
      total_ += samples_.counts[i];
    }
  }

  std::uint64_t begin_of(std::size_t row) const { return begins_[row]; }
  std::uint32_t count(std::size_t row, std::size_t x) const {
    return samples_.counts[row * width_ + x];
  }
  void append(std::uint64_t first, std::uint32_t count, std::vector<DeepLayer>& layers) const {
    for (std::uint64_t i = first; i < first + count; ++i) layers.push_back(layer_of(samples_, i));
  }

 private:
  DeepSamples samples_;
  std::size_t width_;
  std::uint64_t total_ = 0;
  std::vector<std::uint64_t> begins_;
};

/// Drops what lies behind the first opaque layer.
void end_at_opaque(const std::vector<int>& opaque, std::vector<DeepLayer>& layers) {
  const auto stops = [&](const DeepLayer& layer) {
    return std::ranges::binary_search(opaque, int(layer.object));
  };
  const auto last = std::ranges::find_if(layers, stops);
  if (last != layers.end()) layers.erase(last + 1, layers.end());
}

DeepRow merged_row(const std::vector<PartRows>& parts, std::size_t row, std::size_t width,
                   const std::vector<int>& opaque) {
  std::vector<std::uint64_t> next;
  for (const PartRows& part : parts) next.push_back(part.begin_of(row));
  DeepRow merged;
  std::vector<DeepLayer> layers;
  for (std::size_t x = 0; x < width; ++x) {
    layers.clear();
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const std::uint32_t count = parts[p].count(row, x);
      parts[p].append(next[p], count, layers);
      next[p] += count;
    }
    std::ranges::stable_sort(layers, std::less<>());
    end_at_opaque(opaque, layers);
    merged.counts.push_back(std::uint32_t(layers.size()));
    merged.layers.insert(merged.layers.end(), layers.begin(), layers.end());
  }
  return merged;
}

}  // namespace

DeepParts::DeepParts(const std::vector<fs::path>& files) {
  std::vector<NamedInfo> infos;
  for (const fs::path& file : files) {
    parts_.push_back({file, readers::read_deep_head(file)});
    infos.push_back({file, info_of(file, parts_.back().head)});
  }
  check_same_whole(infos);
  whole_ = infos.front().info;
  whole_.part = {};
}

void DeepParts::merge(const std::function<void(int y, const DeepRow& row)>& take,
                      const Progress& progress, std::uint64_t most_samples) const {
  for (int first = 0, end; first < whole_.height; first = end) {
    report(progress, double(first) / whole_.height, "merging");
    end = end_of_rows(first, most_samples);
    const std::vector<DeepRow> rows = merged_rows(first, end);
    for (int y = first; y < end; ++y) take(y, rows[std::size_t(y - first)]);
  }
}

int DeepParts::end_of_rows(int first, std::uint64_t most_samples) const {
  std::uint64_t samples = 0;
  int end = first;
  for (; end < whole_.height; ++end) {
    for (const Part& part : parts_) samples += part.head.samples[std::size_t(end)];
    if (samples > most_samples) break;
  }
  return std::max(end, first + 1);
}

std::vector<DeepRow> DeepParts::merged_rows(int first, int end) const {
  const auto width = std::size_t(whole_.width);
  std::vector<std::optional<PartRows>> read(parts_.size());
  parallel_for(std::size_t(0), parts_.size(), [&](std::size_t p) {
    DeepSamples samples = readers::read_deep_rows(parts_[p].file, parts_[p].head, first, end);
    check_depths(parts_[p].file, samples);
    read[p].emplace(std::move(samples), width);
  });
  std::vector<PartRows> parts;
  for (auto& part : read) parts.push_back(std::move(*part));
  std::vector<DeepRow> rows(static_cast<std::size_t>(end - first));
  parallel_for(std::size_t(0), rows.size(),
               [&](std::size_t row) { rows[row] = merged_row(parts, row, width, whole_.opaque); });
  return rows;
}

}  // namespace pellucid::compare
