#include "scene/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/names.h"

namespace pellucid {
namespace {

#include "scene/colormap_tables.inc"

constexpr std::array<ColormapRow, 7> rows{{
    {"viridis", "Smith, van der Walt 2015", viridis_table},
    {"magma", "Smith, van der Walt 2015", magma_table},
    {"inferno", "Smith, van der Walt 2015", inferno_table},
    {"plasma", "Smith, van der Walt 2015", plasma_table},
    {"cividis", "Nuñez, Anderton, Renslow 2018", cividis_table},
    {"turbo", "Mikhailov 2019", turbo_table},
    {"coolwarm", "Moreland 2009", coolwarm_table},
}};

Vec3 entry(const ColormapRow& map, int i) {
  return Vec3(map.table[i][0], map.table[i][1], map.table[i][2]) / 255.0;
}

}  // namespace

Vec3 ColormapRow::operator()(double x) const {
  const double position = std::isfinite(x) ? std::clamp(x, 0.0, 1.0) * 255 : 0;
  const int below = std::min(static_cast<int>(position), 254);
  const double fraction = position - below;
  return entry(*this, below) * (1 - fraction) + entry(*this, below + 1) * fraction;
}

std::span<const ColormapRow> colormaps() { return rows; }

const ColormapRow& find_colormap(std::string_view name) {
  return find_row("colour map", name, rows);
}

}  // namespace pellucid
