// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace pellucid::compare {

/// A ScreenRule says which calls of a study are not drawn in full: those that another one beats in
/// a smaller picture already, in error and in time by the margin, with no more memory.
struct ScreenRule {
  std::vector<double> sizes{0.25};  // of the small pictures' sides to the scene's, each below 1
  double margin = 2;                // 1 or more
};

}  // namespace pellucid::compare
