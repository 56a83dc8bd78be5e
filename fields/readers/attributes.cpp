// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/readers/attributes.h"

#include <limits>

#include "core/parallel.h"
#include "fields/readers/file_field.h"

namespace pellucid::fields {

Attributes::Attributes(std::string_view text, const std::filesystem::path& base,
                       std::span<const std::string> names)
    : names_(names.begin(), names.end()) {
  for (const std::string& name : names_) scalars_.push_back(read_file_scalar(text, base, name));
}

std::vector<double> Attributes::values(std::size_t number, std::span<const Vec3> places,
                                       std::span<const double> times) const {
  std::vector<double> values(places.size(), std::numeric_limits<double>::quiet_NaN());
  // Neighbours follow each other, and lie in the same cell or the next: a thread looks them up in
  // turn.
  parallel_ranges(tbb::blocked_range<std::size_t>(0, places.size(), 1024), [&](const auto& part) {
    const auto sampler = scalars_[number]->sampler();
    for (std::size_t i = part.begin(); i != part.end(); ++i) {
      Vec3 v;
      if (sampler->velocity(places[i], times[i], v) == SampleStatus::ok) values[i] = v.x;
    }
  });
  return values;
}

}  // namespace pellucid::fields
