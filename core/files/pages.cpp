// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace pellucid {
namespace {

/// Advises the system on the pages, of so many bytes, that lie wholly in memory.
void advise(const void* memory, std::size_t bytes, std::uintptr_t page, int advice) {
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, advice);
}

}  // namespace

void ask_for_huge_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t page = 2 << 20;
  if (bytes >= 4 * page) advise(memory, bytes, page, MADV_HUGEPAGE);
}

void forget_pages(const void* memory, std::size_t bytes) {
  advise(memory, bytes, std::uintptr_t(::sysconf(_SC_PAGESIZE)), MADV_DONTNEED);
}

}  // namespace pellucid
