// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "fields/field.h"

namespace pellucid::fields {

/// Attributes are scalars that a sampled field's files hold beside its velocity, as a pressure: on
/// the same samples, interpolated as the velocity is, in the files' units.
class Attributes {
 public:
  /// Reads the scalars `names` of the field that make_field() makes of `text` and `base`. Throws
  /// InputError as read_file_scalar() does.
  Attributes(std::string_view text, const std::filesystem::path& base,
             std::span<const std::string> names);

  const std::vector<std::string>& names() const { return names_; }

  /// Returns the values of names()[number] at places in world units, each at the field's time: NaN
  /// where the field has none, as in a hole or after its last time.
  std::vector<double> values(std::size_t number, std::span<const Vec3> places,
                             std::span<const double> times) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<VectorField>> scalars_;  // each the first component
};

}  // namespace pellucid::fields
