// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pellucid {

/// NumberType is what the numbers of a block are, in the machine's byte order.
enum class NumberType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

/// Returns the size of one number in bytes; 0 when there is no such type.
std::size_t size_of(NumberType type);

/// Returns the type that T is kept as.
template <class T>
constexpr NumberType number_type() {
  static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8);
  if constexpr (std::is_floating_point_v<T>)
    return sizeof(T) == 4 ? NumberType::f32 : NumberType::f64;
  constexpr int power = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
  return NumberType(2 * power + std::is_unsigned_v<T>);
}

/// A BlockError says what is wrong with a stream of blocks.
struct BlockError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// HeapBytes are memory from malloc().
using HeapBytes = std::unique_ptr<std::byte, decltype(&std::free)>;

/// A Block is a named array of `tuples` × `components` numbers.
struct Block {
  std::string name;
  NumberType type = NumberType::u8;
  std::uint32_t components = 1;
  std::uint64_t tuples = 0;
  std::span<const std::byte> bytes;
  std::shared_ptr<HeapBytes> memory;  // behind `bytes`; none where there are no numbers

  /// Returns the numbers, tuple after tuple. Throws BlockError when they are of another type.
  template <class T>
  std::span<const T> values() const {
    if (type != number_type<T>()) fail("is of another type");
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
  /// Hands the memory of the numbers over to a library that will free() it, so that nothing is
  /// copied; `bytes` shows them as long as it does not. Returns nullptr where there are no numbers,
  /// or someone has them already.
  void* release() const;
  [[noreturn]] void fail(std::string_view why) const;
};

/// A BlockWriter writes blocks one after another to an open file, which may be a pipe:
///
///     "PLBLOCK1", then per block: length of the name (u32), type (u32), components (u32), 0 (u32),
///     tuples (u64), 0 (u64), the name, the numbers; name and numbers are padded to 16 bytes
///
/// The end is a block without a name. Throws WorkError when the file takes no more.
class BlockWriter {
 public:
  explicit BlockWriter(int file);

  void add(std::string_view name, NumberType type, std::uint32_t components, std::uint64_t tuples,
           const void* numbers);
  template <class T>
  void add(std::string_view name, std::span<const T> numbers, std::uint32_t components = 1) {
    add(name, number_type<T>(), components, numbers.size() / components, numbers.data());
  }
  /// Adds numbers of the heap that nobody reads again: of an array of many MiB the pages go back to
  /// the system as they are copied, so that writer and reader together hold it once.
  void add_and_forget(std::string_view name, NumberType type, std::uint32_t components,
                      std::uint64_t tuples, void* numbers);
  void add_text(std::string_view name, std::string_view text);
  /// Begins an array whose numbers come piece by piece: append() has to be called for all of them
  /// before anything else is added.
  void begin(std::string_view name, NumberType type, std::uint32_t components,
             std::uint64_t tuples);
  void append(const void* numbers, std::size_t bytes);
  /// Puts `prefix` before the names of all blocks from now on: several data sets in one file.
  void name_within(std::string prefix) { prefix_ = std::move(prefix); }
  /// Writes the end, without which the blocks do not count as whole.
  void finish();

 private:
  void write(const void* data, std::size_t size);
  void pad(std::size_t size);
  void flush();

  int file_;
  std::string prefix_;
  std::vector<std::byte> waiting_;        // small pieces, written together
  std::uint64_t to_come_ = 0, size_ = 0;  // bytes of the array that was begun
  bool forgets_ = false;
};

/// Blocks are what a BlockWriter has written to a file.
class Blocks {
 public:
  /// Reads an open file, which may be a pipe, from where it stands to the end of its blocks, and
  /// believes no claim of more than `most` bytes in all. Throws BlockError.
  explicit Blocks(int file, std::uint64_t most = std::numeric_limits<std::int64_t>::max());
  /// Returns the blocks whose names begin with the prefix, without it; they share the memory.
  Blocks within(std::string_view prefix) const;

  const std::vector<Block>& all() const { return blocks_; }
  /// Returns the block of this name, or nullptr.
  const Block* find(std::string_view name) const;
  /// Returns the block of this name. Throws BlockError when there is none.
  const Block& at(std::string_view name) const;
  /// Returns the characters of a block, or "" where there is none of this name.
  std::string text(std::string_view name) const;

 private:
  Blocks() = default;

  std::vector<Block> blocks_;
};

}  // namespace pellucid
