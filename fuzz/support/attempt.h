// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.h"

namespace pellucid::fuzz {

/// An Outcome counts what became of the inputs that readers have got from attempt().
struct Outcome {
  std::uint64_t accepted = 0, refused = 0;
};

/// Returns this program's count.
inline Outcome& outcome() {
  static Outcome all;
  return all;
}

/// Holds a refusal to its promise: one line that names what is wrong. PELLUCID_FUZZ_TELL, if it is
/// set, asks for its words.
inline void check_message(std::string_view message, std::string_view name) {
  static const bool tells = std::getenv("PELLUCID_FUZZ_TELL");
  if (tells) std::fprintf(stderr, "%.*s\n", int(message.size()), message.data());
  if (message.find('\n') == message.npos && message.find(name) != message.npos) return;
  std::fprintf(stderr, "a refusal has to be one line that names '%.*s': %.*s\n", int(name.size()),
               name.data(), int(message.size()), message.data());
  std::abort();
}

/// Calls `read()`, which accepts an input or refuses it by InputError or WorkError with a message
/// that contains `name`. Whatever else it throws ends the program, as a crash does.
template <class Read>
void attempt(const std::string& name, const Read& read) {
  try {
    read();
    ++outcome().accepted;
  } catch (const InputError& error) {
    check_message(error.what(), name);
    ++outcome().refused;
  } catch (const WorkError& error) {
    check_message(error.what(), name);
    ++outcome().refused;
  }
}

}  // namespace pellucid::fuzz
