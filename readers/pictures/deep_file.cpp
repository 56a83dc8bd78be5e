// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pictures/deep_file.h"

#include <fmt/format.h>

#include <fstream>
#include <numeric>

#include "core/error.h"
#include "core/files/child_reader.h"
#include "core/files/output_file.h"
#include "readers/pictures/of_picture.h"

namespace pellucid::readers {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view program = "pellucid-read-picture";

template <class T>
std::span<const T> of_length(const Block& block, std::uint64_t length) {
  const std::span<const T> values = block.values<T>();
  if (values.size() != length) block.fail("is not as long as it says");
  return values;
}

DeepHead head_of(const Blocks& blocks) {
  const auto size = of_length<std::int32_t>(blocks.at("size"), 2);
  if (size[0] < 1 || size[1] < 1) blocks.at("size").fail("is that of no picture");
  const auto samples =
      of_length<std::uint64_t>(blocks.at("samples"), static_cast<std::uint64_t>(size[1]));
  return {size[0], size[1], blocks.text("text"), {samples.begin(), samples.end()}};
}

DeepSamples samples_of(const Blocks& blocks, std::uint64_t pixels) {
  DeepSamples samples{
      of_length<std::uint32_t>(blocks.at("counts"), pixels), {}, {}, {}, {}, blocks};
  const std::uint64_t total =
      std::accumulate(samples.counts.begin(), samples.counts.end(), std::uint64_t(0));
  for (std::size_t number = 0; number < deep_doubles.size(); ++number)
    samples.doubles[number] = of_length<double>(blocks.at(deep_doubles[number]), total);
  samples.importance = of_length<float>(blocks.at("importance"), total);
  samples.object = of_length<std::uint32_t>(blocks.at("object"), total);
  samples.primitive = of_length<std::uint32_t>(blocks.at("primitive"), total);
  return samples;
}

/// Of the library's own, and of the samples as it reads them, as doubles, and as they are left.
std::uint64_t memory_for(const DeepHead& head, int first, int end) {
  constexpr std::uint64_t libraries = std::uint64_t(1) << 30, sample = 512, pixel = 256;
  const std::uint64_t samples =
      std::accumulate(head.samples.begin() + first, head.samples.begin() + end, std::uint64_t(0));
  return libraries + sample * samples +
         pixel * std::uint64_t(head.width) * std::uint64_t(end - first);
}

}  // namespace

bool is_deep_picture(const fs::path& path) {
  require_file(path);  // who opens a pipe waits
  // The mark, and a version whose second byte has a flag for deep parts.
  constexpr std::string_view mark = "\x76\x2f\x31\x01";
  constexpr unsigned deep_flag = 0x08;
  std::array<char, 8> begin = {};
  std::ifstream(path, std::ios::binary).read(begin.data(), begin.size());
  return std::string_view(begin.data(), mark.size()) == mark &&
         (static_cast<unsigned char>(begin[5]) & deep_flag) != 0;
}

DeepHead read_deep_head(const fs::path& path) {
  return of_picture(path, [&] { return head_of(read_in_child(program, path, {"deep"})); });
}

DeepSamples read_deep_rows(const fs::path& path, const DeepHead& head, int first, int end) {
  return of_picture(path, [&] {
    Blocks blocks =
        read_in_child(program, path, {"deep", std::to_string(first), std::to_string(end)},
                      memory_for(head, first, end));
    return samples_of(std::move(blocks), std::uint64_t(head.width) * std::uint64_t(end - first));
  });
}

}  // namespace pellucid::readers
