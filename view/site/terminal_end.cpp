// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/terminal_end.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>

#include "core/error.h"

namespace pellucid::view {
namespace {

/// A descriptor that a signal's handler writes to: handlers see nothing but what is global.
int signalled = -1;

void note(int) {
  const int error = errno;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(signalled, &one, sizeof(one));
  errno = error;
}

/// nohup has SIGHUP ignored.
void handle(int signal) {
  struct sigaction action {};
  ::sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = note;
  ::sigaction(signal, &action, nullptr);
}

/// A file and /dev/null are at their end from the beginning.
bool can_end_later() {
  struct stat status {};
  if (::fstat(STDIN_FILENO, &status) != 0) return false;
  return S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode) || ::isatty(STDIN_FILENO) != 0;
}

/// Who reads from a terminal in the background is stopped.
bool may_read() { return ::isatty(STDIN_FILENO) == 0 || ::tcgetpgrp(STDIN_FILENO) == ::getpgrp(); }

/// Throws away what was typed; returns whether nothing more can come.
bool has_ended() {
  char typed[256];
  return ::read(STDIN_FILENO, typed, sizeof(typed)) <= 0;
}

}  // namespace

TerminalEnd::TerminalEnd() {
  signalled = ::eventfd(0, EFD_CLOEXEC);
  if (signalled < 0) throw WorkError("the system has no descriptor left to wait for signals by");
  for (const int signal : {SIGINT, SIGHUP, SIGTERM}) handle(signal);
}

void TerminalEnd::wait() const {
  pollfd watched[] = {{signalled, POLLIN, 0}, {can_end_later() ? STDIN_FILENO : -1, POLLIN, 0}};
  while (::poll(watched, 2, -1) >= 0 || errno == EINTR) {
    if (watched[0].revents != 0) return;
    const short input = watched[1].revents;
    if ((input & POLLIN) == 0) {
      if (input != 0) return;  // the other end has gone
    } else if (!may_read()) {
      watched[1].events = 0;  // that it goes is still told
    } else if (has_ended()) {
      return;
    }
  }
}

}  // namespace pellucid::view
