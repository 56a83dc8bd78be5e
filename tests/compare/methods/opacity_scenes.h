// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes with importance, for the tests of opacity optimization.

#include <cmath>
#include <random>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::testing {}

namespace pellucid::compare::testing {

using namespace pellucid::testing;

inline scene::Rendering draw(std::string_view method, const scene::Scene& scene,
                             const RawOptions& options = {}) {
  return render(find_row("method", method, methods()), scene, options, true);
}

/// A red line from one side of the picture to the other at z = 1, of 16 segments.
inline scene::LineObject long_line(double radius, float opacity) {
  scene::LineObject lines;
  lines.radius = radius;
  for (int i = 0; i <= 16; ++i) {
    lines.set.positions.emplace_back(-1 + i / 8.0, 0, 1);
    lines.set.colors.emplace_back(1, 0, 0, opacity);
  }
  lines.set.offsets = {0, 17};
  return lines;
}

/// Sheets of opacity 1/2 over the whole picture, importance from 0 to 1, front to back.
struct Sheets {
  std::vector<double> d, g;
  scene::Scene scene;
};

inline Sheets important_sheets(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Sheets sheets;
  sheets.scene = stack(n, 3, 2, [&](int i) { return Rgba(i % 2, unit(random), 1 - i % 2, 0.5f); });
  for (int i = 0; i < n; ++i) {
    sheets.g.push_back(i % 2 ? std::pow(unit(random), 2) : 0);
    sheets.d.push_back((double(i) / (n - 1) + 1e-5) / (1 + 2e-5));  // see depth_range()
    sheets.scene.objects[std::size_t(i)].vertices().importance.assign(4, float(sheets.g.back()));
  }
  return sheets;
}

}  // namespace pellucid::compare::testing
