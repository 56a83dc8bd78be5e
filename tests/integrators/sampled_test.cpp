// Trajectories and surfaces in samples of a field against those in the field itself: they differ
// by no more than the sampling error that is reported.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/output_file.h"
#include "fields/make_field.h"
#include "integrators/integrate_surface.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

constexpr double duration = 0.8;

/// The ABC flow at 33³ points of [0, 6]³.
std::string write_samples(const testing::TemporaryFolder& folder) {
  constexpr int count = 33;
  constexpr double spacing = 6. / (count - 1);
  const auto abc = make_field("abc");
  const auto sampler = abc->sampler();
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nABC\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {0} {0} {0}\n"
      "ORIGIN 0 0 0\nSPACING {1} {1} {1}\nPOINT_DATA {2}\nVECTORS v double\n",
      count, spacing, count * count * count);
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) {
        Vec3 v;
        sampler->velocity(spacing * Vec3(i, j, k), 0, v);
        text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
      }
  const auto path = folder / "abc.vtk";
  write_text(path, text);
  return path.string();
}

/// Grönwall: velocities that are at most ε apart lead at most ε (e^(LT) - 1) / L apart. For
/// A² = 3, B² = 2, C² = 1 the Frobenius norm of the Jacobian is √6 everywhere.
double largest_deviation(double velocity_error) {
  const double L = std::sqrt(6.);
  return velocity_error * std::expm1(L * duration) / L;
}

TEST(AgreementSampled, SurfacesAreWithinTheReportedErrorOfTheAnalyticOnes) {
  const testing::TemporaryFolder folder;
  const std::string file = write_samples(folder);
  const auto abc = make_field("abc");
  const SeedCurve seed = segment_seed({2.6, 3, 3}, {3.4, 3, 3});
  const auto positions = [&](const VectorField& field) {
    const SurfaceRequest request{&field, seed, duration, 0, false, {}};
    return integrate_surface("fixed-front:particles=40,rows=4", request).mesh.positions;
  };
  const std::vector<Vec3> truth = positions(*abc);
  for (const char* sampler : {"linear", "c1"}) {
    const auto field = make_field(file + ":sampler=" + sampler);
    const std::vector<Vec3> sampled = positions(*field);
    ASSERT_EQ(sampled.size(), truth.size());
    double largest = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      largest = std::max(largest, glm::distance(truth[i], sampled[i]));
    const double bound = largest_deviation(*field->sampling_error());
    EXPECT_LE(largest, bound) << sampler;
    // And the bound says something: most of it is the exponential's pessimism.
    EXPECT_GE(largest, bound / 100) << sampler;
  }
}

}  // namespace
}  // namespace pellucid
