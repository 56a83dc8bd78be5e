// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/process_and_number.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>

namespace pellucid {

std::string process_and_number() {
  static std::atomic<unsigned> next = 0;
  return fmt::format("{}-{}", ::getpid(), next++);
}

}  // namespace pellucid
