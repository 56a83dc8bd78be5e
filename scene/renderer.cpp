// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/renderer.h"

namespace pellucid::scene {

double RenderStats::seconds() const {
  double sum = 0;
  for (const StepTime& step : steps) sum += step.seconds;
  return sum;
}

std::uint64_t RenderStats::total_bytes() const {
  std::uint64_t sum = 0;
  for (const NamedBytes& part : bytes) sum += part.bytes;
  return sum;
}

}  // namespace pellucid::scene
