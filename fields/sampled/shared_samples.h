// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace pellucid::fields {

/// SharedSamples are samples that are read and not changed, where they already are: in a vector, or
/// in a library's array that lives as long as they do. A copy of them shares their memory.
template <class Sample>
class SharedSamples {
 public:
  SharedSamples() = default;
  SharedSamples(std::vector<Sample> samples) {
    const auto kept = std::make_shared<const std::vector<Sample>>(std::move(samples));
    samples_ = *kept;
    owner_ = kept;
  }
  SharedSamples(std::span<const Sample> samples, std::shared_ptr<const void> owner)
      : samples_(samples), owner_(std::move(owner)) {}

  const Sample* data() const { return samples_.data(); }
  std::size_t size() const { return samples_.size(); }
  const Sample& operator[](std::size_t i) const { return samples_[i]; }
  auto begin() const { return samples_.begin(); }
  auto end() const { return samples_.end(); }

 private:
  std::span<const Sample> samples_;
  std::shared_ptr<const void> owner_;
};

}  // namespace pellucid::fields
