// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of one evaluation of every field, with and without its Jacobian; and of sampled fields
// beside the barest code that does the same, in one run:
//   bare_vdb         OpenVDB's BoxSampler on one reused accessor, world to index included
//   sampled/vdb      ours: also stops at the edge of the active voxels and tests finiteness
//   bare_dense       trilinear in a plain array, no tests

#include <benchmark/benchmark.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>

#include <cmath>
#include <random>
#include <vector>

#include "fields/analytic/catalogue.h"
#include "fields/make_field.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid {
namespace {

constexpr int side = 64;

Vec3 wave(const Vec3& x) { return {std::sin(6 * x.y), std::cos(5 * x.z), std::sin(4 * x.x)}; }

/// Steps of a hundredth along lines, as an integrator asks; or places all over.
std::vector<Vec3> places(const Box3& box, bool along_lines) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> fraction(0.001, 0.999);
  std::vector<Vec3> points(1 << 14);
  Vec3 from(0), to(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 s(fraction(random), fraction(random), fraction(random));
    if (i % 100 == 0) from = s;
    if (i % 100 == 0) to = Vec3(fraction(random), fraction(random), fraction(random));
    const Vec3 place = along_lines ? glm::mix(from, to, double(i % 100) / 100) : s;
    points[i] = box.min + (box.max - box.min) * place;
  }
  return points;
}

void evaluate(benchmark::State& state, const fields::VectorField& field, const Box3& box,
              bool jacobian) {
  const std::vector<Vec3> points = places(box, true);
  const auto sampler = field.sampler();
  std::size_t i = 0;
  for (auto _ : state) {
    Vec3 v;
    Mat3 m;
    const Vec3& x = points[i++ & (points.size() - 1)];
    benchmark::DoNotOptimize(jacobian ? sampler->velocity_and_jacobian(x, 0, v, m)
                                      : sampler->velocity(x, 0, v));
    benchmark::DoNotOptimize(v);
  }
}

openvdb::Vec3SGrid::Ptr vdb_grid() {
  auto grid = openvdb::Vec3SGrid::create(openvdb::Vec3s(0));
  auto accessor = grid->getAccessor();
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const Vec3 v = wave(Vec3(i, j, k) / double(side - 1));
        accessor.setValueOn({i, j, k}, openvdb::Vec3s(float(v.x), float(v.y), float(v.z)));
      }
  accessor.setValueOn({2 * side, 0, 0});  // no longer a box: stays in the tree
  grid->setName("velocity");
  grid->setTransform(openvdb::math::Transform::createLinearTransform(1.0 / (side - 1)));
  return grid;
}

void bare_vdb(benchmark::State& state, const openvdb::Vec3SGrid& grid) {
  const std::vector<Vec3> points = places({Vec3(0), Vec3(1)}, true);
  const auto accessor = grid.getConstAccessor();
  std::size_t i = 0;
  for (auto _ : state) {
    const Vec3& x = points[i++ & (points.size() - 1)];
    openvdb::Vec3s v;
    openvdb::tools::BoxSampler::sample(accessor, grid.transform().worldToIndex({x.x, x.y, x.z}), v);
    benchmark::DoNotOptimize(v);
  }
}

void bare_dense(benchmark::State& state) {
  std::vector<Vec3> samples;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) samples.push_back(wave(Vec3(i, j, k) / double(side - 1)));
  const std::vector<Vec3> points = places({Vec3(0), Vec3(1)}, true);
  std::size_t n = 0;
  for (auto _ : state) {
    const Vec3 p = points[n++ & (points.size() - 1)] * double(side - 1);
    const int i = int(p.x), j = int(p.y), k = int(p.z);
    const Vec3 s = p - Vec3(i, j, k);
    const Vec3* c = &samples[std::size_t((k * side + j) * side + i)];
    constexpr int row = side, layer = side * side;
    const Vec3 v =
        glm::mix(glm::mix(glm::mix(c[0], c[1], s.x), glm::mix(c[row], c[row + 1], s.x), s.y),
                 glm::mix(glm::mix(c[layer], c[layer + 1], s.x),
                          glm::mix(c[layer + row], c[layer + row + 1], s.x), s.y),
                 s.z);
    benchmark::DoNotOptimize(v);
  }
}

void add_field(const std::string& name, std::shared_ptr<fields::VectorField> field,
               const Box3& box) {
  for (const bool jacobian : {false, true})
    benchmark::RegisterBenchmark(
        (name + (jacobian ? "/jacobian" : "")).c_str(),
        [=](benchmark::State& state) { evaluate(state, *field, box, jacobian); });
}

void add_catalogue() {
  for (const fields::FieldRow& row : fields::analytic_fields())
    add_field("catalogue/" + std::string(row.name), fields::make_field(row.name), row.region);
  add_field("formula/abc",
            fields::make_field("formula:u=sqrt(3)*sin(z)+cos(y),v=sqrt(2)*sin(x)+sqrt(3)*cos(z),"
                               "w=sin(y)+sqrt(2)*cos(x)"),
            {Vec3(0), Vec3(6)});
}

void add_sampled(const testing::TemporaryFolder& folder) {
  const Box3 cube{Vec3(0), Vec3(1)};
  fields::write_cube(folder / "cube.vti", side, wave);
  benchmark::RegisterBenchmark("bare_dense", bare_dense);
  for (const std::string sampler : {"linear", "c1"})
    add_field("sampled/vti_" + sampler,
              fields::make_field((folder / "cube.vti").string() + ":sampler=" + sampler), cube);
  openvdb::initialize();
  const auto grid = vdb_grid();
  openvdb::io::File((folder / "sparse.vdb").string()).write({grid});
  benchmark::RegisterBenchmark("bare_vdb",
                               [grid](benchmark::State& state) { bare_vdb(state, *grid); });
  add_field("sampled/vdb", fields::make_field((folder / "sparse.vdb").string()), cube);
  for (const std::string_view kind : {"vts", "vtu"})
    add_field(
        "sampled/" + std::string(kind),
        fields::make_field(fields::write_grid(folder, fields::grid_kind(kind), wave).string()),
        fields::grid_box);
}

}  // namespace
}  // namespace pellucid

int main(int argc, char** argv) {
  const pellucid::testing::TemporaryFolder folder;
  pellucid::add_catalogue();
  pellucid::add_sampled(folder);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
