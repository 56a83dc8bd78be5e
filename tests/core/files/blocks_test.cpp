// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/blocks.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <numeric>
#include <random>

namespace pellucid {
namespace {

class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("blocks", 0)) {}
  ~MemoryFile() { ::close(file_); }
  int descriptor() const { return file_; }

  std::string content() const {
    std::string bytes(std::size_t(::lseek(file_, 0, SEEK_END)), '\0');
    EXPECT_EQ(::pread(file_, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
    return bytes;
  }
  void set(const std::string& bytes) const {
    EXPECT_EQ(::ftruncate(file_, 0), 0);
    EXPECT_EQ(::pwrite(file_, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
  }

 private:
  int file_;
};

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
  std::vector<double> numbers(12);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  BlockWriter out(file.descriptor());
  out.add("points", std::span<const double>(numbers), 3);
  out.add_text("kind", "mesh");
  out.add("none", NumberType::i64, 1, 0, nullptr);
  out.finish();
  const Blocks blocks(file.descriptor());
  ASSERT_EQ(blocks.all().size(), 3u);
  const Block& points = blocks.at("points");
  EXPECT_EQ(points.components, 3u);
  EXPECT_EQ(points.tuples, 4u);
  EXPECT_TRUE(std::ranges::equal(points.values<double>(), numbers));
  EXPECT_EQ(points.number(11), 11.5);
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
