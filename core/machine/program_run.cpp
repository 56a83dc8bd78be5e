// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/program_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "core/error.h"
#include "core/files/descriptor.h"
#include "core/files/files_read.h"
#include "core/machine/stopwatch.h"
#include "core/parallel.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

bool may_be_run(const fs::path& path) {
  std::error_code code;
  return fs::is_regular_file(path, code) && ::access(path.c_str(), X_OK) == 0;
}

Descriptor open_for_writing(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0)
    throw WorkError(fmt::format("{}: cannot write: {}", path.string(), std::strerror(errno)));
  return Descriptor(fd);
}

/// All that the new process needs, made before the fork: after it nothing may be allocated.
struct Start {
  const char* program;
  const char* folder;
  std::vector<char*> argv;
  int in, out, err;
  int report;  // where the errno of a failed start goes
  pid_t parent;
};

[[noreturn]] void become(const Start& start) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int ignored_here : {SIGPIPE, SIGXFSZ}) std::signal(ignored_here, SIG_DFL);
  const bool ready = ::getppid() == start.parent && ::dup2(start.in, 0) >= 0 &&
                     ::dup2(start.out, 1) >= 0 && ::dup2(start.err, 2) >= 0 &&
                     ::chdir(start.folder) == 0;
  if (ready) ::execv(start.program, start.argv.data());
  const int code = errno;
  [[maybe_unused]] const ssize_t told = ::write(start.report, &code, sizeof code);
  ::_exit(127);
}

/// Waits for the end of the parent, however it ends, and ends the group then: the program's death
/// signal does not reach what it has started, nor does Ctrl-C on the terminal. Becomes the program
/// that removes the folder, if there is one: after a fork nothing may be allocated here.
[[noreturn]] void guard(pid_t group, pid_t parent, char* const* removal) {
  sigset_t all, told;
  ::sigfillset(&all);
  ::sigprocmask(SIG_BLOCK, &all, nullptr);
  ::sigemptyset(&told);
  ::sigaddset(&told, SIGTERM);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  int signal = 0;
  if (::getppid() == parent) ::sigwait(&told, &signal);
  ::kill(-group, SIGKILL);
  if (removal) ::execv(removal[0], removal);
  ::_exit(0);
}

/// Whether who has asked, as Python at Ctrl-C, no longer wants the work.
bool is_cancelled() { return tbb::is_current_task_group_canceling(); }

bool has_ended(pid_t child) {
  siginfo_t about{};
  return ::waitid(P_PID, id_t(child), &about, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         about.si_pid != 0;
}

/// Waits for the end of the process, at most so long and as long as it is wanted; says whether it
/// has ended.
bool ends_within(pid_t child, double seconds) {
  const Descriptor watched(int(::syscall(SYS_pidfd_open, child, 0)));
  const Stopwatch watch;
  for (;;) {
    const double left = seconds - watch.seconds();
    if (left <= 0) return false;
    // Milliseconds. Nothing wakes who waits here when the work is cancelled, nor, where the system
    // has no descriptor of a process, when it ends: it looks again and again.
    const double most = watched.fd < 0 ? 10 : 50;
    pollfd entry{watched.fd, POLLIN, 0};
    ::poll(&entry, 1, int(std::min(1e3 * left + 1, most)));
    if (has_ended(child)) return true;
    if (is_cancelled()) return false;
  }
}

int reap(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

std::string ProgramRun::failure() const {
  if (timed_out) return fmt::format("was ended after {:.6g} s, its limit", limit);
  if (exit_code < 0) return fmt::format("was ended by a signal: {}", ::strsignal(signal));
  return fmt::format("ended with code {}", exit_code);
}

fs::path find_program(std::string_view word, const fs::path& base) {
  if (word.find('/') != word.npos) {
    const fs::path path = without_dots(fs::absolute(base / word));
    return may_be_run(path) ? path : fs::path();
  }
  const char* path = std::getenv("PATH");
  std::string_view folders = path ? path : "/usr/bin:/bin";
  while (!folders.empty()) {
    const std::string_view folder = folders.substr(0, folders.find(':'));
    folders.remove_prefix(std::min(folders.size(), folder.size() + 1));
    if (!folder.empty() && may_be_run(fs::path(folder) / word)) return fs::path(folder) / word;
  }
  return {};
}

ProgramRun run_program(const fs::path& program, const std::vector<std::string>& words,
                       const ProgramPlace& place, double timeout) {
  const Descriptor in(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Descriptor out = open_for_writing(place.out), err = open_for_writing(place.err);
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) throw WorkError("cannot make a pipe");
  const Descriptor told(ends[0]);
  Start start{program.c_str(), place.folder.c_str(), {}, in.fd, out.fd, err.fd, ends[1],
              ::getpid()};
  std::vector<std::string> argv = words;
  for (std::string& word : argv) start.argv.push_back(word.data());
  start.argv.push_back(nullptr);
  std::string removal[] = {"/bin/rm", "-rf", "--", place.folder.string()};
  char* const removal_words[] = {removal[0].data(), removal[1].data(), removal[2].data(),
                                 removal[3].data(), nullptr};
  const Stopwatch watch;
  const pid_t child = ::fork();
  if (child == 0) become(start);
  ::close(ends[1]);
  if (child < 0) throw WorkError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  int code = 0;  // the pipe is closed by a successful exec
  if (::read(told.fd, &code, sizeof code) == sizeof code) {
    reap(child);
    throw WorkError(
        fmt::format("{}: cannot be started: {}", program.string(), std::strerror(code)));
  }
  const pid_t guardian = ::fork();
  if (guardian == 0) guard(child, start.parent, place.is_temporary ? removal_words : nullptr);
  ProgramRun run;
  run.limit = timeout;
  run.timed_out = !ends_within(child, timeout);
  run.seconds = watch.seconds();
  ::kill(-child, SIGKILL);  // what it has started and left
  if (guardian > 0) {
    ::kill(guardian, SIGKILL);
    reap(guardian);
  }
  const int status = reap(child);
  if (is_cancelled()) throw Cancelled();
  if (WIFEXITED(status))
    run.exit_code = WEXITSTATUS(status);
  else
    run.signal = WTERMSIG(status);
  return run;
}

std::vector<std::string> split_command(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = 0;
  for (const char c : text) {
    const bool is_end = quote ? c == quote : c == ' ';
    const bool is_start = !quote && (c == '"' || c == '\'');
    if (!in_word && (is_start || c != ' ')) words.emplace_back();
    if (is_start || (is_end && quote)) {
      in_word = true;
      quote = is_start ? c : char(0);
      continue;
    }
    in_word = !is_end;
    if (in_word) words.back() += c;
  }
  if (quote) throw InputError(fmt::format("'{}': a quote without its end", text));
  if (words.empty()) throw InputError("an empty command; accepted: a program and its arguments");
  return words;
}

}  // namespace pellucid
