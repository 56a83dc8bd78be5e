// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/huge_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace pellucid {

void ask_for_huge_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t page = 2 << 20;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  if (bytes >= 4 * page && begin < end)
    ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace pellucid
