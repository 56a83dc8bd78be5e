// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

namespace pellucid {

/// A Descriptor is an open file of the system, or none where `fd` is below 0; it closes itself.
struct Descriptor {
  explicit Descriptor(int file) : fd(file) {}
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  const int fd;
};

}  // namespace pellucid
