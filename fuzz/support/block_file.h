// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/blocks.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/bytes.h"

namespace pellucid::fuzz {

/// Takes bytes for blocks, as they come from a child reader. Throws BlockError.
Blocks blocks_of(Bytes bytes);

/// Calls `read()`, which may throw BlockError or what attempt() lets pass: those who read files
/// make an InputError of it that names the file.
template <class Read>
void refusable(const Read& read) {
  attempt("", [&] {
    try {
      read();
    } catch (const BlockError& error) {
      throw InputError(error.what());
    }
  });
}

/// Calls `read(blocks)` in the same way, if the bytes are blocks.
template <class Read>
void attempt_blocks(Bytes bytes, const Read& read) {
  refusable([&] { read(blocks_of(bytes)); });
}

}  // namespace pellucid::fuzz
