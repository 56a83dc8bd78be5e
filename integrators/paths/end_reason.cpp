// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/paths/end_reason.h"

namespace pellucid::integrators {

std::string_view name_of(EndReason reason) {
  switch (reason) {
    case EndReason::duration:
      return "duration";
    case EndReason::left_domain:
      return "left-domain";
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
  }
  return "";
}

}  // namespace pellucid::integrators
