// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Loops on TBB's threads. TBB's library is not instrumented, so the thread sanitizer does not see
// that a loop's tasks follow its call and precede its return; here it is shown, and nothing else
// is: tasks stay unordered among each other. Without the sanitizer these are TBB's own loops.
//
// Every task computes in its caller's floating-point environment. A thread of TBB otherwise keeps
// the one that was set when TBB or the thread's arena began, and Embree flushes denormal numbers to
// zero while it builds a hierarchy: nextafter(0, d) would be 0 in whatever follows.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace pellucid {

#if defined(__SANITIZE_THREAD__)

/// A TaskFence orders a loop: its call comes before each task, and these before it ends or throws.
class TaskFence {
 public:
  void open() { __tsan_release(&begun_); }
  void enter() { __tsan_acquire(&begun_); }
  void leave() { __tsan_release(&ended_); }
  void join() { __tsan_acquire(&ended_); }
  ~TaskFence() { join(); }

 private:
  char begun_, ended_;  // only their addresses count
};

/// A FencedBody is a function as TBB hands it, and what it is called with, from thread to thread:
/// both are read before the fence is entered, so this is not instrumented.
template <class Body>
class FencedBody {
 public:
  FencedBody(const Body& body, TaskFence& fence) : body_(&body), fence_(&fence) {}

  template <class... Arguments>
  __attribute__((no_sanitize("thread"))) auto operator()(Arguments... arguments) const {
    return run(*body_, *fence_, arguments...);
  }

 private:
  struct Leave {
    TaskFence& fence;
    ~Leave() { fence.leave(); }
  };

  template <class... Arguments>
  __attribute__((noinline)) static auto run(const Body& body, TaskFence& fence,
                                            Arguments&... arguments) {
    fence.enter();
    const Leave leave{fence};
    return body(arguments...);
  }

  const Body* body_;
  TaskFence* fence_;
};

#else

/// A TaskFence does nothing without the thread sanitizer.
class TaskFence {
 public:
  void open() {}
  void enter() {}
  void leave() {}
  void join() {}
};

/// Returns `body` itself: without the thread sanitizer there is no fence.
template <class Body>
const Body& FencedBody(const Body& body, TaskFence&) {
  return body;
}

#endif

/// Cancelled is thrown by a loop whose work nobody wants any more: the tbb::task_group_context in
/// which it runs was cancelled. It is no std::exception, since it is no failure: who makes a row of
/// each failure, and goes on with the next, lets it pass.
struct Cancelled {};

/// A LoopContext carries the floating-point environment (rounding, denormal numbers) of the thread
/// that makes it into the tasks that are given it.
class LoopContext {
 public:
  operator tbb::task_group_context&() { return context_; }
  /// Throws Cancelled when the loop has ended early because it, or what it is part of, was
  /// cancelled.
  void check() {
    if (context_.is_group_execution_cancelled()) throw Cancelled();
  }

 private:
  using Context = tbb::task_group_context;
  Context context_{Context::bound, Context::default_traits | Context::fp_settings};
};

/// Calls body(i) for first ≤ i < last, on TBB's threads and in any order.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  TaskFence fence;
  LoopContext context;
  fence.open();
  tbb::parallel_for(first, last, FencedBody(body, fence), context);
  fence.join();
  context.check();
}

/// Calls body(part) for parts of a TBB range, on TBB's threads and in any order.
template <class Range, class Body>
void parallel_ranges(const Range& range, const Body& body) {
  TaskFence fence;
  LoopContext context;
  fence.open();
  tbb::parallel_for(range, FencedBody(body, fence), context);
  fence.join();
  context.check();
}

/// Returns the sum of body(part, identity) by join(left, right), the same to the last bit for any
/// number of threads: the tree of sums depends on the range alone.
template <class Range, class Sum, class Body, class Join>
Sum parallel_sum(const Range& range, const Sum& identity, const Body& body, const Join& join) {
  TaskFence fence;
  LoopContext context;
  fence.open();
  Sum sum = tbb::parallel_deterministic_reduce(range, identity, FencedBody(body, fence),
                                               FencedBody(join, fence), context);
  fence.join();
  context.check();
  return sum;
}

}  // namespace pellucid
