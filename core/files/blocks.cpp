// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/blocks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "core/error.h"
#include "core/files/pages.h"

namespace pellucid {
namespace {

constexpr std::string_view mark = "PLBLOCK1";
constexpr std::size_t alignment = 16;         // of names and numbers, for every type of number
constexpr std::size_t buffer_size = 1 << 16;  // of pieces that are not worth a call of the system
constexpr std::size_t worth_lending = 1 << 20;
constexpr std::size_t worth_forgetting = 16 << 20;  // of pages that are given back together
constexpr std::uint32_t longest_name = 1 << 20;

struct Head {
  std::uint32_t name_length = 0, type = 0, components = 0, zero = 0;
  std::uint64_t tuples = 0, more_zeros = 0;
};
static_assert(sizeof(Head) == 2 * alignment);

constexpr std::uint64_t padded(std::uint64_t size) {
  return (size + alignment - 1) / alignment * alignment;
}

HeapBytes allocate(std::uint64_t size) {
  HeapBytes memory(static_cast<std::byte*>(std::malloc(size)), &std::free);
  if (!memory) throw BlockError(fmt::format("there is no memory for its {} MiB", size >> 20));
  ask_for_huge_pages(memory.get(), size);
  return memory;
}

/// Takes parts off an open file, and never more than `most` bytes in all.
class Cutter {
 public:
  Cutter(int file, std::uint64_t most) : file_(file), most_(most), left_(most) {}

  /// Says whether so much may still come, before anything is allocated for it.
  void claim(std::uint64_t size) {
    if (size > left_) throw BlockError(fmt::format("it claims more than {} MiB", most_ >> 20));
    left_ -= size;
  }
  void take(void* to, std::size_t size) {
    const std::size_t here = std::min(size, buffered_.size());
    std::copy_n(buffered_.data(), here, static_cast<std::byte*>(to));
    buffered_ = buffered_.subspan(here);
    if (here < size) fetch(static_cast<std::byte*>(to) + here, size - here);
  }
  void skip_padding(std::uint64_t size) {
    std::byte zeros[alignment];
    take(zeros, std::size_t(padded(size) - size));
  }

 private:
  void fetch(std::byte* to, std::size_t size) {
    while (size > 0) {
      const bool is_small = size < buffer_.size();
      const std::size_t got = is_small ? read(buffer_.data(), buffer_.size()) : read(to, size);
      const std::size_t taken = std::min(size, got);
      if (is_small) {
        std::copy_n(buffer_.data(), taken, to);
        buffered_ = std::span(buffer_).subspan(taken, got - taken);
      }
      to += taken;
      size -= taken;
    }
  }
  std::size_t read(std::byte* to, std::size_t size) {
    ssize_t got;
    do got = ::read(file_, to, size);
    while (got < 0 && errno == EINTR);
    if (got <= 0) throw BlockError("it ends too early");
    return std::size_t(got);
  }

  int file_;
  std::uint64_t most_, left_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(buffer_size);
  std::span<const std::byte> buffered_;
};

std::uint64_t size_in_bytes(const Head& head) {
  const std::uint64_t one = size_of(NumberType(head.type)) * head.components;
  std::uint64_t size;
  if (head.type > std::uint32_t(NumberType::f64) || one == 0 ||
      __builtin_mul_overflow(one, head.tuples, &size))
    throw BlockError("a block of an unknown kind");
  return size;
}

std::string take_name(std::uint32_t length, Cutter& file) {
  if (length > longest_name) throw BlockError("a name of more than a MiB");
  std::string name(length, '\0');
  file.take(name.data(), length);
  file.skip_padding(length);
  return name;
}

Block take_block(const Head& head, Cutter& file) {
  const std::uint64_t size = size_in_bytes(head);
  file.claim(sizeof head);
  file.claim(padded(head.name_length));
  file.claim(size);
  Block block;
  block.name = take_name(head.name_length, file);
  block.type = NumberType(head.type);
  block.components = head.components;
  block.tuples = head.tuples;
  if (size == 0) return block;
  block.memory = std::make_shared<HeapBytes>(allocate(size));
  block.bytes = {block.memory->get(), size};
  file.take(block.memory->get(), size);
  file.skip_padding(size);
  return block;
}

bool has_reader(int pipe) {
  pollfd entry{pipe, 0, 0};
  return ::poll(&entry, 1, 0) <= 0 || !(entry.revents & POLLERR);
}

/// Waits until nothing is left in a pipe: who reads from it has copied all of it, or has gone.
void wait_until_drained(int pipe) {
  constexpr auto moment = std::chrono::microseconds(20);
  for (int left = 1; ::ioctl(pipe, FIONREAD, &left) == 0 && left > 0 && has_reader(pipe);)
    std::this_thread::sleep_for(moment);
}

/// Lends pages to a pipe, from which the reader copies them: one copy in place of two. Those that
/// `forgets` go back to the system once they are lent. Returns how many bytes went that way: none
/// where the file is no pipe.
std::size_t lend(int file, const std::byte* bytes, std::size_t size, bool forgets) {
  std::size_t lent = 0, forgotten = 0;
  while (lent < size) {
    const iovec pages{const_cast<std::byte*>(bytes) + lent, size - lent};
    const ssize_t more = ::vmsplice(file, &pages, 1, 0);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    lent += std::size_t(more);
    if (forgets && lent - forgotten >= worth_forgetting) {
      forget_pages(bytes + forgotten, lent - forgotten);
      forgotten = lent;
    }
  }
  if (lent > 0) wait_until_drained(file);  // the memory is the caller's again
  return lent;
}

void write_all(int file, const std::byte* rest, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, rest, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw WorkError(fmt::format("cannot write: {}", std::strerror(errno)));
    rest += written;
    size -= std::size_t(written);
  }
}

}  // namespace

std::size_t size_of(NumberType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return std::size_t(type) < std::size(sizes) ? sizes[std::size_t(type)] : 0;
}

void* Block::release() const { return memory ? memory->release() : nullptr; }

void Block::fail(std::string_view why) const {
  throw BlockError(fmt::format("array '{}' {}", name, why));
}

BlockWriter::BlockWriter(int file) : file_(file) {
  write(mark.data(), mark.size());
  pad(mark.size());
}

void BlockWriter::add(std::string_view name, NumberType type, std::uint32_t components,
                      std::uint64_t tuples, const void* numbers) {
  begin(name, type, components, tuples);
  append(numbers, size_);
}

void BlockWriter::add_and_forget(std::string_view name, NumberType type, std::uint32_t components,
                                 std::uint64_t tuples, void* numbers) {
  forgets_ = true;
  add(name, type, components, tuples, numbers);
  forgets_ = false;
}

void BlockWriter::begin(std::string_view name, NumberType type, std::uint32_t components,
                        std::uint64_t tuples) {
  assert(to_come_ == 0);
  const std::string full = prefix_ + std::string(name);
  const Head head{std::uint32_t(full.size()), std::uint32_t(type), components, 0, tuples, 0};
  write(&head, sizeof head);
  write(full.data(), full.size());
  pad(full.size());
  size_ = to_come_ = size_of(type) * components * tuples;
}

void BlockWriter::append(const void* numbers, std::size_t bytes) {
  assert(bytes <= to_come_);
  write(numbers, bytes);
  to_come_ -= bytes;
  if (to_come_ == 0) pad(size_);
}

void BlockWriter::add_text(std::string_view name, std::string_view text) {
  add(name, NumberType::u8, 1, text.size(), text.data());
}

void BlockWriter::finish() {
  const Head end;
  write(&end, sizeof end);
  flush();
}

void BlockWriter::write(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const std::byte*>(data);
  if (waiting_.size() + size > buffer_size) flush();
  if (size <= buffer_size) {
    waiting_.insert(waiting_.end(), bytes, bytes + size);
  } else {
    const std::size_t lent = size < worth_lending ? 0 : lend(file_, bytes, size, forgets_);
    write_all(file_, bytes + lent, size - lent);
  }
}

void BlockWriter::flush() {
  write_all(file_, waiting_.data(), waiting_.size());
  waiting_.clear();
}

void BlockWriter::pad(std::size_t size) {
  static constexpr char zeros[alignment] = {};
  write(zeros, padded(size) - size);
}

Blocks::Blocks(int file, std::uint64_t most) {
  Cutter rest(file, most);
  char begin[padded(mark.size())];
  rest.take(begin, sizeof begin);
  if (std::memcmp(begin, mark.data(), mark.size()) != 0)
    throw BlockError("it does not begin with its mark");
  for (;;) {
    Head head;
    rest.take(&head, sizeof head);
    if (head.name_length == 0) return;
    blocks_.push_back(take_block(head, rest));
  }
}

Blocks Blocks::within(std::string_view prefix) const {
  Blocks some;
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
