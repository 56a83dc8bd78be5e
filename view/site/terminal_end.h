// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pellucid::view {

/// A TerminalEnd waits for whatever ends a program on a terminal: SIGINT, SIGHUP, SIGTERM, and the
/// end of the standard input where that is a terminal or a pipe. From the time at which it is made
/// on these signals end wait() and nothing else; one that is ignored stays so. There is one in a
/// program.
class TerminalEnd {
 public:
  /// Throws WorkError when the system has no descriptor left.
  TerminalEnd();

  /// Returns when the program has to end; until then it takes no processor time.
  void wait() const;
};

}  // namespace pellucid::view
