// SPDX-License-Identifier: GPL-3.0-or-later
// Is a point inside an octahedron? Exits 0 when the library says what is known.
#include <pellucid/rays.h>
#include <pellucid/version.h>

#include <cstdio>
#include <stdexcept>

int main() {
  const std::vector<pellucid::Point3> corners{{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                              {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t octant = 0; octant < 8; ++octant)
    faces.push_back({octant & 1 ? 3u : 0u, octant & 2 ? 4u : 1u, octant & 4 ? 5u : 2u});
  const pellucid::MeshRays octahedron(corners, faces);

  // Through two vertices, through two edges, beside it.
  const bool counts = octahedron.count({-5, 0, 0}, {1, 0, 0}) == 2 &&
                      octahedron.count({-5, 0.25, 0}, {1, 0, 0}) == 2 &&
                      octahedron.count({-5, 2, 0}, {1, 0, 0}) == 0;
  const bool sides = octahedron.inside({0, 0, 0}) && octahedron.inside({0.3, 0.3, 0.3}) &&
                     !octahedron.inside({0.4, 0.4, 0.4}) && !octahedron.inside({0, 0, 2});
  const auto first = octahedron.first({-5, 0.25, 0.25}, {2, 0, 0});
  const bool nearest = first && first->t == 2.25;
  bool refused = false;
  try {
    octahedron.all({0, 0, 0}, {0, 0, 0});
  } catch (const std::invalid_argument&) {
    refused = true;
  }
  std::printf("pellucid %s: counts %d, sides %d, nearest %d, refused %d\n", PELLUCID_VERSION,
              counts, sides, nearest, refused);
  return counts && sides && nearest && refused ? 0 : 1;
}
