// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/work.h"

#include <pybind11/pybind11.h>
#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <thread>

#include "core/error.h"
#include "core/float_environment.h"
#include "core/parallel.h"

namespace py = pybind11;

namespace pellucid::python {
namespace {

/// Who presses Ctrl-C does not feel a wait of this length.
constexpr std::chrono::milliseconds between_looks{50};

/// Work on a thread of its own, which another thread may end early.
class Worker {
 public:
  explicit Worker(const std::function<void(const Progress&)>& work)
      : work_(work), thread_([this] { run(); }) {}
  ~Worker() { thread_.join(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  bool ends_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return has_ended_; });
  }
  void cancel() {
    cancelled_ = true;
    loops_.cancel_group_execution();
  }
  void join() {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return has_ended_; });
  }
  std::exception_ptr error() const { return error_; }

 private:
  void run() {
    const DefaultFloats floats;
    try {
      tbb::task_group group(loops_);
      group.run_and_wait([this] { work_(progress()); });
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_all();
  }

  Progress progress() {
    return [this](double, std::string_view) {
      if (cancelled_) throw Cancelled();
    };
  }

  const std::function<void(const Progress&)>& work_;
  tbb::task_group_context loops_;  // all loops of the work are part of it
  std::atomic<bool> cancelled_ = false;
  std::exception_ptr error_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::thread thread_;  // the last: it uses all others
};

/// Python's exception that a signal's handler has raised, if one has.
std::optional<py::error_already_set> raised_by_signal() {
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() == 0) return std::nullopt;
  return py::error_already_set();
}

[[noreturn]] void rethrow(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const InputError&) {
    throw;
  } catch (const WorkError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::filesystem::filesystem_error& failure) {  // of a path: a circle of links
    throw InputError(failure.what());
  } catch (const std::exception& failure) {
    throw WorkError(failure.what());
  } catch (const Cancelled&) {
    throw WorkError("the work was cancelled");
  }
}

}  // namespace

void run_unlocked(const std::function<void(const Progress&)>& work) {
  std::optional<py::error_already_set> interruption;
  std::exception_ptr error;
  {
    const py::gil_scoped_release unlocked;
    Worker worker(work);
    while (!interruption && !worker.ends_within(between_looks)) interruption = raised_by_signal();
    if (interruption) worker.cancel();
    worker.join();
    error = worker.error();
  }
  if (interruption) throw std::move(*interruption);
  if (error) rethrow(error);
}

}  // namespace pellucid::python
