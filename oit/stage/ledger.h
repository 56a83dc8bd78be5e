// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "scene/renderer.h"

namespace pellucid::oit {

/// A Ledger counts the bytes that a method has allocated, by name, where it allocates them. An
/// allocation of a name that is there already replaces it.
class Ledger {
 public:
  void record(std::string_view name, std::uint64_t bytes) {
    const auto found =
        std::find_if(parts_.begin(), parts_.end(),
                     [&](const scene::NamedBytes& part) { return part.name == name; });
    if (found != parts_.end())
      found->bytes = bytes;
    else
      parts_.push_back({std::string(name), bytes});
  }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const scene::NamedBytes& part : parts_) sum += part.bytes;
    return sum;
  }
  const std::vector<scene::NamedBytes>& parts() const { return parts_; }

 private:
  std::vector<scene::NamedBytes> parts_;
};

}  // namespace pellucid::oit
