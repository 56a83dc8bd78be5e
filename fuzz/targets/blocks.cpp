// SPDX-License-Identifier: GPL-3.0-or-later
// What a child reader has left, before anyone knows what it is.

#include "core/files/blocks.h"

#include <numeric>

#include "fuzz/support/attempt.h"
#include "fuzz/support/block_file.h"

using namespace pellucid;

namespace {

/// Reads every byte that a block says it has.
void touch(const Block& block) {
  volatile unsigned sum = 0;
  for (const std::byte byte : block.bytes) sum = sum + unsigned(byte);
  if (block.bytes.size() != size_of(block.type) * block.components * block.tuples) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt_blocks({data, size}, [](const Blocks& blocks) {
    for (const Block& block : blocks.all()) {
      touch(block);
      blocks.at(block.name);
      fuzz::refusable([&] { blocks.text(block.name); });
    }
  });
  return 0;
}
