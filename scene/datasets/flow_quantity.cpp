// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/flow_quantity.h"

#include <limits>

#include "core/parallel.h"
#include "fields/analytic/flows/benzene.h"

namespace pellucid::scene {
namespace {

double nearness(const Vec3& x) {
  static const fields::flow::Benzene molecule{{}};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& atom : molecule.atoms)
    least = std::min(least, glm::distance(x, Vec3(atom.x, atom.y, 0)));
  return -least;
}

double measure(FlowQuantity quantity, const Vec3& x, fields::FieldSampler& sampler) {
  if (quantity == FlowQuantity::nearness) return nearness(x);
  Vec3 v;
  Mat3 j;
  if (quantity == FlowQuantity::vorticity) {
    if (sampler.velocity_and_jacobian(x, 0, v, j) != fields::SampleStatus::ok) return 0;
    return glm::length(Vec3(j[1][2] - j[2][1], j[2][0] - j[0][2], j[0][1] - j[1][0]));
  }
  if (sampler.velocity(x, 0, v) != fields::SampleStatus::ok) return 0;
  return glm::length(v);
}

}  // namespace

std::vector<double> measure_flow(FlowQuantity quantity, const fields::VectorField& field,
                                 const std::vector<Vec3>& positions) {
  std::vector<double> values(positions.size());
  parallel_ranges(tbb::blocked_range<std::size_t>(0, positions.size(), 1024), [&](auto& range) {
    const auto sampler = field.sampler();
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      values[i] = measure(quantity, positions[i], *sampler);
  });
  return values;
}

}  // namespace pellucid::scene
