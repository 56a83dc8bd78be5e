// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/blocks.h"
#include "tests/support/memory_blocks.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace pellucid {
namespace {

using testing::MemoryFile;

void write_example(int file) {
  std::vector<double> numbers(12);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  BlockWriter out(file);
  out.add("points", std::span<const double>(numbers), 3);
  out.add("bytes", std::span<const std::uint8_t>(bytes));
  out.add_text("kind", "mesh");
  out.add("none", NumberType::i64, 1, 0, nullptr);
  out.finish();
}

TEST(UnitBlocks, WhatIsWrittenIsRead) {
  const MemoryFile file;
  write_example(file.descriptor());
  const Blocks blocks(file.descriptor());
  ASSERT_EQ(blocks.all().size(), 4u);
  const Block& points = blocks.at("points");
  EXPECT_EQ(points.components, 3u);
  EXPECT_EQ(points.tuples, 4u);
  ASSERT_EQ(points.values<double>().size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(points.values<double>()[i], double(i) + 0.5);
  EXPECT_EQ(blocks.at("bytes").values<std::uint8_t>()[2], 3);
  EXPECT_EQ(blocks.text("kind"), "mesh");
  EXPECT_EQ(blocks.text("other"), "");
  EXPECT_EQ(blocks.at("none").tuples, 0u);
  EXPECT_THROW(blocks.at("other"), BlockError);
  EXPECT_THROW(points.values<float>(), BlockError);
}

TEST(UnitBlocks, EveryBeginningOfAFileIsRefused) {
  const MemoryFile file;
  write_example(file.descriptor());
  const std::string whole = file.content();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    file.set(whole.substr(0, size));
    EXPECT_THROW(Blocks{file.descriptor()}, BlockError) << size;
  }
}

/// Whatever a byte says instead, no array reaches beyond the file.
TEST(PropertyBlocks, NoClaimReachesBeyondTheFile) {
  const MemoryFile file;
  write_example(file.descriptor());
  const std::string whole = file.content();
  std::mt19937 random(3);
  for (int run = 0; run < 20000; ++run) {
    std::string bytes = whole;
    for (std::uint32_t k = 0; k < 1 + random() % 3; ++k)
      bytes[random() % bytes.size()] = char(random() % 4 ? random() : 0xFF);
    file.set(bytes);
    try {
      const Blocks blocks(file.descriptor());
      std::size_t sum = 0;
      for (const Block& block : blocks.all())
        for (const std::byte byte : block.bytes) sum += std::size_t(byte);  // readable
      EXPECT_LE(sum, 255 * bytes.size());
    } catch (const BlockError&) {
    }
  }
}

}  // namespace
}  // namespace pellucid
