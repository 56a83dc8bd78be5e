// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/blocks.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace pellucid {
namespace {

constexpr std::string_view mark = "PLBLOCK1";
constexpr std::size_t alignment = 16;  // of names and numbers, for every type of number

struct Head {
  std::uint32_t name_length = 0, type = 0, components = 0, zero = 0;
  std::uint64_t tuples = 0, more_zeros = 0;
};
static_assert(sizeof(Head) == 2 * alignment);

constexpr std::uint64_t padded(std::uint64_t size) {
  return (size + alignment - 1) / alignment * alignment;
}

std::shared_ptr<const std::byte> map_file(int file, std::size_t size) {
  void* memory = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
  if (memory == MAP_FAILED) throw BlockError("cannot be mapped into memory");
  return {static_cast<const std::byte*>(memory),
          [size](const std::byte* begin) { ::munmap(const_cast<std::byte*>(begin), size); }};
}

/// Takes parts off the front of a mapped file, and never more than is there.
class Cutter {
 public:
  explicit Cutter(std::span<const std::byte> rest) : rest_(rest) {}

  std::span<const std::byte> take(std::uint64_t size) {
    if (size > rest_.size() || padded(size) > rest_.size()) throw BlockError("it ends too early");
    const auto part = rest_.first(size);
    rest_ = rest_.subspan(padded(size));
    return part;
  }

 private:
  std::span<const std::byte> rest_;
};

std::uint64_t size_in_bytes(const Head& head) {
  const std::uint64_t one = size_of(NumberType(head.type)) * head.components;
  std::uint64_t size;
  if (head.type > std::uint32_t(NumberType::f64) || one == 0 ||
      __builtin_mul_overflow(one, head.tuples, &size))
    throw BlockError("a block of an unknown kind");
  return size;
}

Block take_block(const Head& head, Cutter& file) {
  Block block;
  const auto name = file.take(head.name_length);
  block.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
  block.type = NumberType(head.type);
  block.components = head.components;
  block.tuples = head.tuples;
  block.bytes = file.take(size_in_bytes(head));
  return block;
}

}  // namespace

std::size_t size_of(NumberType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return std::size_t(type) < std::size(sizes) ? sizes[std::size_t(type)] : 0;
}

void Block::fail(std::string_view why) const {
  throw BlockError(fmt::format("array '{}' {}", name, why));
}

BlockWriter::BlockWriter(int file) : file_(file) {
  write(mark.data(), mark.size());
  pad(mark.size());
}

void BlockWriter::add(std::string_view name, NumberType type, std::uint32_t components,
                      std::uint64_t tuples, const void* numbers) {
  const std::string full = prefix_ + std::string(name);
  const Head head{std::uint32_t(full.size()), std::uint32_t(type), components, 0, tuples, 0};
  write(&head, sizeof head);
  write(full.data(), full.size());
  pad(full.size());
  const std::size_t size = size_of(type) * components * tuples;
  write(numbers, size);
  pad(size);
}

void BlockWriter::add_text(std::string_view name, std::string_view text) {
  add(name, NumberType::u8, 1, text.size(), text.data());
}

void BlockWriter::finish() {
  const Head end;
  write(&end, sizeof end);
}

void BlockWriter::write(const void* data, std::size_t size) {
  const auto* rest = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(file_, rest, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw WorkError(fmt::format("cannot write: {}", std::strerror(errno)));
    rest += written;
    size -= std::size_t(written);
  }
}

void BlockWriter::pad(std::size_t size) {
  static constexpr char zeros[alignment] = {};
  write(zeros, padded(size) - size);
}

Blocks::Blocks(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0 || status.st_size == 0) throw BlockError("it is empty");
  memory_ = map_file(file, std::size_t(status.st_size));
  Cutter rest({memory_.get(), std::size_t(status.st_size)});
  const auto begin = rest.take(mark.size());
  if (std::memcmp(begin.data(), mark.data(), mark.size()) != 0)
    throw BlockError("it does not begin with its mark");
  for (;;) {
    Head head;
    std::memcpy(&head, rest.take(sizeof head).data(), sizeof head);
    if (head.name_length == 0) return;
    blocks_.push_back(take_block(head, rest));
  }
}

Blocks Blocks::within(std::string_view prefix) const {
  Blocks some;
  some.memory_ = memory_;
  for (const Block& block : blocks_)
    if (block.name.starts_with(prefix)) {
      some.blocks_.push_back(block);
      some.blocks_.back().name.erase(0, prefix.size());
    }
  return some;
}

const Block* Blocks::find(std::string_view name) const {
  for (const Block& block : blocks_)
    if (block.name == name) return &block;
  return nullptr;
}

const Block& Blocks::at(std::string_view name) const {
  if (const Block* block = find(name)) return *block;
  throw BlockError(fmt::format("it has no array '{}'", name));
}

std::string Blocks::text(std::string_view name) const {
  const Block* block = find(name);
  if (!block) return {};
  const auto characters = block->values<std::uint8_t>();
  return {characters.begin(), characters.end()};
}

}  // namespace pellucid
