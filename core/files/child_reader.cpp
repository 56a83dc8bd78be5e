// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/child_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>

#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/output_file.h"
#include "core/files/own_files.h"

namespace pellucid {
namespace {

namespace fs = std::filesystem;

constexpr int result_file = 3;  // where the child finds the pipe for its blocks
constexpr int complaint_code = 2;
constexpr std::string_view complaint = "complaint";

/// A Pipe is what the child writes to and this process reads from; other processes that are started
/// meanwhile do not hold it open.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0)
      throw WorkError(fmt::format("no pipe to a reader: {}", std::strerror(errno)));
    constexpr int largest = 1 << 20;  // that everyone may ask for; less serves, too
    ::fcntl(ends_[1], F_SETPIPE_SZ, largest);
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int to_read() const { return ends_[0]; }
  int to_write() const { return ends_[1]; }
  void close_to_read() { close_end(0); }
  void close_to_write() { close_end(1); }

 private:
  void close_end(int which) {
    if (ends_[which] >= 0) ::close(ends_[which]);
    ends_[which] = -1;
  }
  int ends_[2] = {-1, -1};
};

/// What the new process has open: the pipe for the result, and nothing to read or print.
class SpawnFiles {
 public:
  explicit SpawnFiles(int result) {
    ::posix_spawn_file_actions_init(&actions_);
    for (int standard = 0; standard < 3; ++standard)
      ::posix_spawn_file_actions_addopen(&actions_, standard, "/dev/null", O_RDWR, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, result, result_file);
  }
  ~SpawnFiles() { ::posix_spawn_file_actions_destroy(&actions_); }
  SpawnFiles(const SpawnFiles&) = delete;
  SpawnFiles& operator=(const SpawnFiles&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// This process's environment, and large pages for what the child allocates: its time goes into
/// faults of small ones (glibc's malloc, where it is that of 2.35 or later).
class ChildEnvironment {
 public:
  ChildEnvironment() {
    constexpr std::string_view tunables = "GLIBC_TUNABLES=";
    bool is_there = false;
    for (char** variable = environ; *variable; ++variable) {
      is_there = is_there || std::string_view(*variable).starts_with(tunables);
      variables_.push_back(*variable);
    }
    if (!is_there) variables_.push_back(huge_pages_.data());
    variables_.push_back(nullptr);
  }
  char* const* get() const { return variables_.data(); }

 private:
  std::string huge_pages_ = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";
  std::vector<char*> variables_;
};

/// A Child is waited for, whatever happens meanwhile: else it would stay in the table of processes.
class Child {
 public:
  Child() = default;
  ~Child() {
    if (pid_ > 0) wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void start(const fs::path& program, std::vector<std::string> words, int result);
  /// Returns its status, as waitpid() has it.
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
    return status;
  }

 private:
  pid_t pid_ = 0;
};

void Child::start(const fs::path& program, std::vector<std::string> words, int result) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const SpawnFiles files(result);
  const ChildEnvironment environment;
  const int code =
      ::posix_spawn(&pid_, program.c_str(), files.get(), nullptr, argv.data(), environment.get());
  if (code != 0)
    throw WorkError(
        fmt::format("{}: cannot be started: {}", program.string(), std::strerror(code)));
}

/// Why the child ended without an answer.
std::string reason(int status, const ReadLimits& limits) {
  if (!WIFSIGNALED(status))
    return fmt::format("its reader ended with code {}", WEXITSTATUS(status));
  switch (WTERMSIG(status)) {
    case SIGXCPU:
      return fmt::format("reading it takes over {} s", limits.cpu_seconds);
    case SIGALRM:
      return fmt::format("reading it takes over {} s", limits.wall_seconds);
    case SIGKILL:
      return "its reader was killed: out of memory?";
    default:
      return fmt::format("its reader crashed ({})", ::strsignal(WTERMSIG(status)));
  }
}

std::string not_valid(const fs::path& file, std::string_view why) {
  return fmt::format("{}: not a valid {} file: {}", file.string(), file.extension().string(), why);
}

/// The signal comes at the soft limit; at the hard one of processor time it would be SIGKILL.
void limit(decltype(RLIMIT_AS) what, std::uint64_t amount) {
  const rlimit bounds{amount, amount + 1};
  ::setrlimit(what, &bounds);
}

void set_limits(const ReadLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for the answer any more
  ::signal(SIGPIPE, SIG_DFL);          // nobody reads it any more
  ::signal(SIGXFSZ, SIG_DFL);          // a reader that writes is none
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, limits.bytes);  // a sanitizer's shadow takes far more
#endif
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  ::alarm(limits.wall_seconds);
}

/// What came through the pipe: blocks, or what is wrong with them.
struct Answer {
  std::optional<Blocks> blocks;
  std::string flaw;
};

Answer receive(int pipe, std::uint64_t most) {
  try {
    return {Blocks(pipe, most), {}};
  } catch (const BlockError& error) {
    return {std::nullopt, error.what()};
  }
}

/// A child that died says more than the blocks which it left unfinished, unless it died of having
/// said too much.
Blocks judged(const Answer& answer, int status, const ReadLimits& limits, const fs::path& file) {
  const bool answered =
      WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == complaint_code);
  const bool was_cut_off = WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE;
  if (!answered && !was_cut_off) throw InputError(not_valid(file, reason(status, limits)));
  if (!answer.blocks) throw InputError(not_valid(file, answer.flaw));
  if (!answered || WEXITSTATUS(status) == complaint_code)
    throw InputError(answer.blocks->text(complaint));
  return *answer.blocks;
}

using ReadFunction =
    std::function<void(const fs::path&, std::span<const std::string>, BlockWriter&)>;

/// Returns the exit code.
int answer(int argc, char** argv, const ReadFunction& read) {
  if (argc < 5 || ::fcntl(result_file, F_GETFD) < 0) return 1;  // pellucid starts this, nobody else
  const fs::path file = argv[1];
  const ReadLimits limits{std::strtoull(argv[2], nullptr, 10), unsigned(std::atoi(argv[3])),
                          unsigned(std::atoi(argv[4]))};
  const std::vector<std::string> further(argv + 5, argv + argc);
  set_limits(limits);
  std::string why;
  BlockWriter out(result_file);
  try {
    read(file, further, out);
    out.finish();
    return 0;
  } catch (const InputError& error) {
    why = error.what();
  } catch (const std::bad_alloc&) {
    why = not_valid(file, fmt::format("it claims more than {} MiB", limits.bytes >> 20));
  } catch (const std::exception& error) {
    why = not_valid(file, error.what());
  }
  out.name_within("");  // what was written before is void
  out.add_text(complaint, why);
  out.finish();
  return complaint_code;
}

}  // namespace

ReadLimits read_limits(std::uint64_t size) {
  const auto seconds = unsigned(5 + (size >> 20));
  return {(std::uint64_t(1) << 30) + 64 * size, seconds, 10 * seconds};
}

Blocks read_in_child(std::string_view program, const fs::path& file,
                     const std::vector<std::string>& arguments, std::uint64_t at_least,
                     std::uint64_t beside) {
  require_file(file);
  const fs::path path = helper_program(program);
  note_read(file);
  note_read(path);
  ReadLimits limits = read_limits(fs::file_size(file) + beside);
  limits.bytes = std::max(limits.bytes, at_least);
  std::vector<std::string> words{path.string(), file.string(), std::to_string(limits.bytes),
                                 std::to_string(limits.cpu_seconds),
                                 std::to_string(limits.wall_seconds)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Child child;  // goes after the pipe, whose end ends it
  Pipe pipe;
  child.start(path, std::move(words), pipe.to_write());
  pipe.close_to_write();
  const Answer answer = receive(pipe.to_read(), limits.bytes);
  pipe.close_to_read();  // which ends a child that has more to say
  return judged(answer, child.wait(), limits, file);
}

void run_child_reader(int argc, char** argv, const ReadFunction& read) {
  std::_Exit(answer(argc, argv, read));
}

}  // namespace pellucid
