// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "scene/renderer.h"

namespace pellucid::compare {

class GivenMethod;

/// A MethodCall is a method and the parameters that it is called with.
struct MethodCall {
  const scene::MethodRow* row = nullptr;
  Parameters parameters;
  /// Makes the pictures in the place of the program's own methods, and keeps `row`; mostly none.
  std::shared_ptr<const GivenMethod> given = nullptr;

  /// Returns "fourier:bands=5", as on the command line.
  std::string text() const;
  /// Returns text() as part of a file's name: "fourier-bands-5".
  std::string slug() const;
};

/// Returns the text of a call as part of a file's name: where little of it can stand in one, or it
/// is long, with a hash of all of it. Of calls that differ in ":", "=", "," and "-" alone the names
/// are the same: a study refuses those.
std::string slug_of(const std::string& call);

}  // namespace pellucid::compare
