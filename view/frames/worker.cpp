// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/frames/worker.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <future>

#include "core/float_environment.h"
#include "core/parallel.h"

namespace pellucid::view {

struct Worker::Job {
  std::string page;
  const Work* work;
  std::promise<void> done = {};
  tbb::task_group_context loops = {};  // all loops of the work are part of it
  std::atomic<bool> cancelled = false;

  void cancel() {
    cancelled = true;
    loops.cancel_group_execution();
  }
  void refuse() { done.set_exception(std::make_exception_ptr(Replaced())); }

  /// What cancelled work throws, from whichever library, is no failure.
  void run() {
    const DefaultFloats floats;
    try {
      tbb::task_group group(loops);
      group.run_and_wait([this] { (*work)(progress()); });
      cancelled ? refuse() : done.set_value();
    } catch (...) {
      cancelled ? refuse() : done.set_exception(std::current_exception());
    }
  }

  Progress progress() {
    return [this](double, std::string_view) {
      if (cancelled) throw Cancelled();
    };
  }
};

Worker::Worker() : thread_([this] { loop(); }) {}

Worker::~Worker() {
  end();
  thread_.join();
}

void Worker::run(const std::string& page, const Work& work) {
  const auto job = std::make_shared<Job>();
  job->page = page;
  job->work = &work;
  std::future<void> done = job->done.get_future();
  {
    const std::lock_guard lock(mutex_);
    if (ended_) throw Replaced();
    if (!page.empty()) replace(page);
    waiting_.push_back(job);
  }
  changed_.notify_one();
  done.get();
}

void Worker::replace(const std::string& page) {
  const auto older = [&](const std::shared_ptr<Job>& job) {
    if (job->page != page) return false;
    job->refuse();
    return true;
  };
  std::erase_if(waiting_, older);
  if (running_ && running_->page == page) running_->cancel();
}

void Worker::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  for (const auto& job : waiting_) job->refuse();
  waiting_.clear();
  if (running_) running_->cancel();
  changed_.notify_all();
}

std::shared_ptr<Worker::Job> Worker::next() {
  std::unique_lock lock(mutex_);
  running_.reset();
  changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
  if (waiting_.empty()) return nullptr;
  running_ = waiting_.front();
  waiting_.pop_front();
  return running_;
}

void Worker::loop() {
  while (const auto job = next()) job->run();
}

}  // namespace pellucid::view
