// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/stage/oit_renderer.h"
#include "scene/parts/partial_sums.h"

namespace pellucid::oit {

/// A SumTarget is a texture in which a round of a method sums something up over fragments.
struct SumTarget {
  /// Numbers says what its texels hold: floats, counts (unsigned integers), or in the place of an
  /// unsigned integer the bits of a float.
  enum class Numbers { floats, counts, bits_of_floats };

  std::string_view name;
  const Texture* texture;  // has to outlive it
  scene::Combine combine = scene::Combine::add;
  Numbers numbers = Numbers::floats;
};

/// A SummingMethod makes its picture of sums over the fragments of a pixel, in rounds: each clears
/// its targets, draws the geometry into them, and then does what is to be done pixel by pixel. So a
/// part of a scene can be drawn by itself, and its sums added to those of others between the two.
class SummingMethod : public OitMethod {
 public:
  void draw(Frame& frame) final {
    for (int round = 0; round < rounds(); ++round) {
      sum(round, frame);
      close(round, frame);
    }
    composite(frame);
  }

  /// Returns the number of rounds.
  virtual int rounds() const = 0;
  /// Returns whether no round asks for what another has summed up: then all are one phase of
  /// scene::PartialSums, else each is one.
  virtual bool rounds_are_apart() const { return false; }
  /// Returns the targets of a round; rounds may share them.
  virtual std::vector<SumTarget> targets(int round) const = 0;
  /// Clears the targets of a round and sums up.
  virtual void sum(int round, Frame& frame) = 0;
  /// Does pixel by pixel what follows a round, its sums being whole.
  virtual void close(int /*round*/, Frame& /*frame*/) {}
  /// Makes the picture, all rounds being closed.
  virtual void composite(Frame& frame) = 0;
  /// Throws InputError where the sums of parts are not the whole's.
  virtual void check_parts() const {}
};

}  // namespace pellucid::oit
