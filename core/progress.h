// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace pellucid {

/// A Progress is told how far long work has come: `fraction` in [0, 1] and what is being done. An
/// empty one says that nobody asks. Only app/ prints. It is called from one thread at a time, any.
using Progress = std::function<void(double fraction, std::string_view what)>;

/// Tells `progress` the `fraction`, in [0, 1], and what is being done, unless it is empty.
inline void report(const Progress& progress, double fraction, std::string_view what) {
  if (progress) progress(fraction, what);
}

/// Returns what tells `progress` of a part of its work, from the fraction `begin` to `end`, under
/// the name `what`; nothing where nobody asks.
inline Progress part_of(const Progress& progress, double begin, double end, std::string what) {
  if (!progress) return {};
  return [progress, begin, end, what = std::move(what)](double fraction, std::string_view) {
    progress(begin + fraction * (end - begin), what);
  };
}

/// A CountedProgress tells a Progress how many of `total` equal parts are done, on whichever
/// threads.
class CountedProgress {
 public:
  CountedProgress(const Progress& progress, std::size_t total, std::string_view what)
      : progress_(progress), total_(total), what_(what) {}

  /// Throws what the Progress throws to end the work.
  void add(std::size_t parts) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ = std::min(done_ + parts, total_);  // some may be done again
    progress_(double(done_) / double(total_), what_);
  }

 private:
  const Progress& progress_;
  std::size_t total_, done_ = 0;
  std::string_view what_;
  std::mutex mutex_;
};

}  // namespace pellucid
