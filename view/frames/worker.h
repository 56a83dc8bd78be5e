// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/progress.h"

namespace pellucid::view {

/// Replaced is thrown to who waits for work that nobody wants any more: its page has asked for
/// other work since, or the program ends. It is no failure.
struct Replaced {};

/// A Worker does all work on one thread, one after another, since a GL context belongs to its
/// thread. Newer work of a page takes the place of its older work, whether that waits or runs.
class Worker {
 public:
  using Work = std::function<void(const Progress&)>;

  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Returns when `work` is done, and throws what it throws, or Replaced. Any thread may call it.
  /// Work whose page is empty is replaced by none.
  void run(const std::string& page, const Work& work);

  /// Ends what runs and waits, and refuses all later work with Replaced.
  void end();

 private:
  struct Job;

  void loop();
  std::shared_ptr<Job> next();
  void replace(const std::string& page);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Job>> waiting_;
  std::shared_ptr<Job> running_;
  bool ended_ = false;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace pellucid::view
