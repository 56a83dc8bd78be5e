// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/blocks.h"
#include "tests/support/memory_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <thread>

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
  const Blocks blocks = file.blocks();
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
    EXPECT_THROW(file.blocks(), BlockError) << size;
  }
}

TEST(UnitBlocks, NumbersThatComePieceByPieceAreOneArray) {
  std::vector<double> numbers(3 * 20000);  // more than is kept back before it is written
  std::iota(numbers.begin(), numbers.end(), 0.5);
  const Blocks blocks = testing::blocks_of([&](BlockWriter& out) {
    out.add_text("before", "x");
    out.begin("points", NumberType::f64, 3, 20000);
    for (std::size_t i = 0; i < numbers.size(); i += 600)
      out.append(&numbers[i], 600 * sizeof(double));
    out.add_text("after", "y");
  });
  EXPECT_TRUE(std::ranges::equal(blocks.at("points").values<double>(), numbers));
  EXPECT_EQ(blocks.text("before") + blocks.text("after"), "xy");
}

TEST(UnitBlocks, NumbersAreHandedOverOnce) {
  const Blocks blocks = testing::blocks_of([](BlockWriter& out) { out.add_text("kind", "mesh"); });
  const Blocks again = blocks.within("");
  void* numbers = again.at("kind").release();
  ASSERT_NE(numbers, nullptr);
  EXPECT_EQ(numbers, blocks.at("kind").bytes.data());
  EXPECT_EQ(blocks.at("kind").release(), nullptr);
  EXPECT_EQ(blocks.text("kind"), "mesh");
  std::free(numbers);
}

TEST(UnitBlocks, ThroughAPipeComesWhatIsClaimedAndNoMoreThanIsAllowed) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::thread writer([file = ends[1]] {
    const std::vector<double> numbers(100000, 0.25);  // more than a pipe holds
    BlockWriter out(file);
    out.add("numbers", std::span<const double>(numbers));
    out.finish();
    ::close(file);
  });
  EXPECT_EQ(Blocks(ends[0], 800048).at("numbers").values<double>().back(), 0.25);
  writer.join();
  ::close(ends[0]);
}

/// 40 MiB, so that pages go back twice while others are on their way.
TEST(UnitBlocks, WhatIsForgottenCameThroughThePipeAndIsNoMoreThere) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::vector<double> numbers(5 << 20);
  std::iota(numbers.begin(), numbers.end(), 1.);
  std::thread writer([&, file = ends[1]] {
    BlockWriter out(file);
    out.add_and_forget("numbers", NumberType::f64, 1, numbers.size(), numbers.data());
    out.add("kept", std::span<const double>(numbers));
    out.finish();
    ::close(file);
  });
  const Blocks blocks(ends[0]);
  writer.join();
  ::close(ends[0]);
  const auto came = blocks.at("numbers").values<double>();
  double expected = 1;
  for (const double number : came) ASSERT_EQ(number, expected++);
  EXPECT_GE(std::ranges::count(numbers, 0.), 4 << 20);
  EXPECT_TRUE(std::ranges::equal(blocks.at("kept").values<double>(), numbers));
}

TEST(UnitBlocks, AClaimBeyondTheLimitIsRefusedBeforeItsMemoryIsAskedFor) {
  const MemoryFile file;
  BlockWriter out(file.descriptor());
  out.begin("numbers", NumberType::f64, 1, std::uint64_t(1) << 60);
  out.finish();
  ::lseek(file.descriptor(), 0, SEEK_SET);
  try {
    Blocks(file.descriptor(), 5 << 20);
    FAIL();
  } catch (const BlockError& error) {
    EXPECT_STREQ(error.what(), "it claims more than 5 MiB");
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
      const Blocks blocks = file.blocks();
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
