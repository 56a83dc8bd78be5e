// SPDX-License-Identifier: GPL-3.0-or-later
// By CGAL's k-d tree, of which the headers alone are taken, as in mesh_distance.cpp.
#include "integrators/mesh/nearest_vertices.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <tuple>

namespace pellucid::integrators {
namespace {

using Space = CGAL::Simple_cartesian<double>;
using Numbered = std::tuple<Space::Point_3, std::uint32_t>;
using Traits = CGAL::Search_traits_adapter<Numbered, CGAL::Nth_of_tuple_property_map<0, Numbered>,
                                           CGAL::Search_traits_3<Space>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

Space::Point_3 in_space(const Vec3& x) { return {x.x, x.y, x.z}; }

}  // namespace

struct NearestVertices::Tree {
  Search::Tree points;
};

NearestVertices::NearestVertices(std::span<const Vec3> positions) : tree_(new Tree) {
  for (std::uint32_t i = 0; i < positions.size(); ++i)
    tree_->points.insert({in_space(positions[i]), i});
  tree_->points.build();  // searches would build it, one thread over the other
}

NearestVertices::~NearestVertices() = default;

std::vector<std::uint32_t> NearestVertices::around(const Vec3& x, std::size_t count) const {
  std::vector<std::uint32_t> numbers;
  const Search search(tree_->points, in_space(x), unsigned(count));
  for (const auto& [point, squared_distance] : search) numbers.push_back(std::get<1>(point));
  return numbers;
}

}  // namespace pellucid::integrators
