// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace pellucid {

/// Asks for large pages below memory that was allocated and not yet touched: what is written to it
/// first then faults a page of 2 MiB at once, where 512 faults take most of the time of a copy. It
/// does nothing for less than some such pages, and where the system has none.
void ask_for_huge_pages(void* memory, std::size_t bytes);

/// Reserves room for so many values in a vector or a string, in large pages.
template <class Values>
void reserve_in_huge_pages(Values& values, std::size_t count) {
  values.reserve(count);
  ask_for_huge_pages(values.data(), count * sizeof(values[0]));
}

/// Gives the pages that lie wholly in memory of the heap back to the system. The memory stays the
/// caller's, but what it held is lost; a pipe to which its pages were lent keeps them.
void forget_pages(const void* memory, std::size_t bytes);

}  // namespace pellucid
