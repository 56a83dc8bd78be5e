// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace pellucid {

/// An InputError says that the caller's input or call is wrong, in one line: where, what was got,
/// what is accepted. The program exits with code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A WorkError says that the work itself failed: disk full, out of memory, a driver that lacks
/// something. The program exits with code 1.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pellucid
