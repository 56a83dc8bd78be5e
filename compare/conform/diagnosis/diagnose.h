// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "compare/conform/conformance_case.h"

namespace pellucid::compare {

/// A Verdict says whether a picture is the right one of a case, and else what it looks like.
struct Verdict {
  bool passed = false;
  double max_error = 0;          // over red, green, blue of all pixels
  std::size_t wrong = 0;         // pixels beyond the tolerance
  std::string_view fault = {};   // one of the kinds below; empty when it passed
  std::string explanation = {};  // more about it, for people
};

/// Returns whether the picture passed or, stored in 8 bits, is off by two of their steps at most.
bool is_right_to_two_steps(const Verdict& verdict);

/// A Fault is a kind of it, by its name.
struct Fault {
  static constexpr std::string_view background = "background";
  static constexpr std::string_view colors = "colours";
  static constexpr std::string_view eight_bits = "8 bits";
  static constexpr std::string_view precision = "precision";
  static constexpr std::string_view missed = "missed";
  static constexpr std::string_view capped = "capped";
  static constexpr std::string_view doubled = "doubled";
  static constexpr std::string_view opaque = "opaque";
  static constexpr std::string_view picture = "picture";
  static constexpr std::string_view misordered = "misordered";
  static constexpr std::string_view no_picture = "no picture";
  static constexpr std::string_view other = "other";
};

/// A right picture may be off by this: a renderer that composites in floats loses 1e-5 in 10 000
/// layers, one 8-bit step is 4e-3.
inline constexpr double conformance_tolerance = 1e-4;

/// Holds a picture of the case's size and of finite values against the right one, over the
/// background: A is not judged. Of pictures that are stored in 8 bits as much more is allowed as
/// these round. What is named explains nine tenths of the wrong pixels by the layers that are known
/// of each, leaving less than half of each one's error, and leaves the least of it; of explanations
/// that leave about as little the one that takes the least for granted.
/// - background: the layers are right, what shows through them is another colour;
/// - colours: through a curve, by a factor, channels exchanged, straight, multiplied or blended
/// once too often;
/// - 8 bits: of a picture that is stored so, right to two steps; else as if every step of the
/// composite, or its result, or what is stored of fragments were rounded to 8 bits;
/// - precision: the same of half floats, or off by a 50th at most in a way that nothing else
/// explains;
/// - capped: the nearest k layers alone, of k the same in all pixels;
/// - missed, doubled: layers, or all that equal one, are not there; or count several times;
/// - opaque: what is said to be opaque lets through what is behind it;
/// - picture: turned or shifted: see given_faults();
/// - misordered: all layers, composited in another order or in none (mean, sum, as drawn); where no
/// background explains as much, any mixture of them.
Verdict judge(const ConformanceCase& conformance_case, const Image& picture, bool stored_in_8_bits,
              double tolerance = conformance_tolerance);

}  // namespace pellucid::compare
