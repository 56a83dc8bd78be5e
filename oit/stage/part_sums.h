// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/stage/summing_method.h"

namespace pellucid::oit {

/// PartSums let a method sum up over a part of a scene, and composite what all parts have summed
/// up. Throws InputError for a scene of several samples a pixel, and as
/// SummingMethod::check_parts() does.
class PartSums final : public scene::PartialSums {
 public:
  /// All of them have to outlive it; `picture` is the texture that `target` draws into.
  PartSums(Stage& stage, SummingMethod& method, const Texture& picture, const Framebuffer& target);

  int phases() const override { return method_.rounds_are_apart() ? 1 : method_.rounds(); }
  scene::SumPlanes sum(int phase, std::span<const scene::SumPlanes> totals) override;
  Image composite(std::span<const scene::SumPlanes> totals) override;
  Image behind() override;

 private:
  /// The rounds first … end - 1.
  struct Rounds {
    int first, end;
  };
  Rounds rounds_of(int phase) const;
  Frame begin() const;
  /// Puts totals into the place of what the phase's rounds would have summed up.
  void take(int phase, const scene::SumPlanes& totals, Frame& frame) const;

  Stage& stage_;
  SummingMethod& method_;
  const Texture& picture_;
  const Framebuffer& target_;
};

}  // namespace pellucid::oit
