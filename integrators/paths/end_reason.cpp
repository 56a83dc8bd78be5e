// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/end_reason.h"

#include <fmt/format.h>

namespace pellucid::integrators {

std::string_view name_of(EndReason reason) {
  switch (reason) {
    case EndReason::duration:
      return "duration";
    case EndReason::left_domain:
      return "left-domain";
    case EndReason::outside:
      return "outside";
    case EndReason::stagnated:
      return "stagnated";
    case EndReason::not_finite:
      return "not-finite";
    case EndReason::length:
      return "length";
    case EndReason::steps:
      return "steps";
    case EndReason::merged:
      return "merged";
    case EndReason::vertex:
      return "vertex";
    case EndReason::torn:
      return "torn";
    case EndReason::particles:
      return "particles";
    case EndReason::triangles:
      return "triangles";
    case EndReason::vertices:
      return "vertices";
  }
  return "";
}

bool is_for_want_of_field(EndReason reason) {
  return reason == EndReason::outside || reason == EndReason::left_domain ||
         reason == EndReason::not_finite;
}

bool is_budget(EndReason reason) {
  return reason == EndReason::steps || reason == EndReason::particles ||
         reason == EndReason::triangles || reason == EndReason::vertices;
}

bool is_border(EndReason reason) {
  return is_for_want_of_field(reason) || reason == EndReason::duration ||
         reason == EndReason::length;
}

std::string in_words(const EndCounts& ends) {
  std::string text;
  for (const auto& [reason, count] : ends)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(reason));
  return text;
}

}  // namespace pellucid::integrators
