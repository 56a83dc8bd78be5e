// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/progress.h"

namespace pellucid::python {

/// Runs the work on a thread of its own and waits for it without Python's lock, which it may not
/// touch. Ctrl-C, or whatever else a signal's handler raises, ends the work at its next report or
/// loop and then leaves as Python's exception. Rethrows what the work throws, as InputError,
/// WorkError or std::bad_alloc.
void run_unlocked(const std::function<void(const Progress&)>& work);

/// Runs the work as run_unlocked() does and returns what it returns.
template <class Work>
auto result_unlocked(const Work& work) {
  std::optional<decltype(work(Progress()))> result;
  run_unlocked([&](const Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

}  // namespace pellucid::python
