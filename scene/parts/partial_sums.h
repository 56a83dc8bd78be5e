// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Methods whose pictures are made of sums over the fragments of a pixel: what parts of a scene sum
// up, each by itself, adds up to the whole.

#include <span>
#include <string>
#include <vector>

#include "core/raster.h"

namespace pellucid::scene {

/// A Combine says how the sums of two parts of a scene become those of both.
enum class Combine { add, multiply };

/// A SumPlane holds what a method has summed up over the fragments of every pixel, of one kind.
struct SumPlane {
  std::string name;  // "sums of colour and opacity"
  Combine combine = Combine::add;
  int channels = 1;           // 1 … 4
  std::vector<float> values;  // `channels` of each pixel, row by row from the top
};

/// SumPlanes are all that one phase of a method sums up.
using SumPlanes = std::vector<SumPlane>;

/// PartialSums are a renderer's way to draw a part of a scene. A method has one phase or two: those
/// that weight fragments by the optical depth in front of them sum this up in the first, and
/// weighted colours in the second, for which they have to know the first one's totals over all
/// parts.
class PartialSums {
 public:
  virtual ~PartialSums() = default;
  /// Returns the number of phases.
  virtual int phases() const = 0;
  /// Sums up `phase`, from 0, over the scene's fragments, one sample at each pixel's centre;
  /// `totals` are those of all phases before it. Throws InputError as composite(), and WorkError.
  virtual SumPlanes sum(int phase, std::span<const SumPlanes> totals) = 0;
  /// Makes the picture of all phases' totals. Throws InputError for planes that it does not have.
  virtual Image composite(std::span<const SumPlanes> totals) = 0;
  /// Returns what lies behind the transparent fragments: colour and 1 of the nearest opaque one, or
  /// the background's colour and 0.
  virtual Image behind() = 0;
};

}  // namespace pellucid::scene
