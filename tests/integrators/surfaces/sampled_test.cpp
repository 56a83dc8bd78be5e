// SPDX-License-Identifier: GPL-3.0-or-later
// Trajectories and surfaces in samples of a field against those in the field itself: they differ
// by no more than the sampling error that is reported.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/files/output_file.h"
#include "fields/make_field.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::integrators {
namespace {

constexpr double duration = 0.8;

/// A velocity at count³ points of the cube [low, low + 6]³. Returns the file's name.
std::string write_samples(const testing::TemporaryFolder& folder,
                          const std::function<Vec3(const Vec3& x)>& velocity, double low = 0,
                          int count = 33) {
  const double spacing = 6. / (count - 1);
  std::string raw;
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) {
        const Vec3 v = velocity(Vec3(low) + spacing * Vec3(i, j, k));
        raw.append(reinterpret_cast<const char*>(&v), sizeof v);
      }
  write_text(folder / "samples.raw", raw);
  write_text(folder / "samples.mhd",
             fmt::format("ObjectType = Image\nNDims = 3\nDimSize = {0} {0} {0}\n"
                         "ElementSpacing = {1} {1} {1}\nOffset = {2} {2} {2}\n"
                         "ElementType = MET_DOUBLE\nElementNumberOfChannels = 3\n"
                         "BinaryDataByteOrderMSB = False\nElementDataFile = samples.raw\n",
                         count, spacing, low));
  return (folder / "samples.mhd").string();
}

std::string write_abc(const testing::TemporaryFolder& folder) {
  const auto abc = fields::make_field("abc");
  const auto sampler = abc->sampler();
  return write_samples(folder, [&](const Vec3& x) {
    Vec3 v;
    sampler->velocity(x, 0, v);
    return v;
  });
}

/// Grönwall: velocities that are at most ε apart lead at most ε (e^(LT) - 1) / L apart. For
/// A² = 3, B² = 2, C² = 1 the Frobenius norm of the Jacobian is √6 everywhere.
double largest_deviation(double velocity_error) {
  const double L = std::sqrt(6.);
  return velocity_error * std::expm1(L * duration) / L;
}

TEST(AgreementSampled, SurfacesAreWithinTheReportedErrorOfTheAnalyticOnes) {
  const testing::TemporaryFolder folder;
  const std::string file = write_abc(folder);
  const auto abc = fields::make_field("abc");
  const SeedCurve seed = segment_seed({2.6, 3, 3}, {3.4, 3, 3});
  const auto positions = [&](const fields::VectorField& field) {
    const SurfaceRequest request{&field, seed, duration, 0, false, {}};
    return integrate_surface("fixed-front:particles=40,rows=4", request).mesh.positions;
  };
  const std::vector<Vec3> truth = positions(*abc);
  for (const char* sampler : {"linear", "c1"}) {
    const auto field = fields::make_field(file + ":sampler=" + sampler);
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

IntegratedSurface sweep_samples(const fields::VectorField& field, const std::string& integrator,
                                const SeedCurve& seed) {
  return integrate_surface(integrator, {&field, seed, duration, 0, false, {}});
}

std::uint64_t evaluations(const fields::VectorField& field, const std::string& integrator,
                          const SeedCurve& seed) {
  return sweep_samples(field, integrator, seed).stats.evaluations;
}

Vec3 swirl(const Vec3& x) { return {-x.y, x.x, 0.3}; }

TEST(UnitSampledSteps, NoKinksNoShortSteps) {
  // Samples of a linear field are the field: they take the steps that its formula takes.
  const testing::TemporaryFolder folder;
  const auto samples = fields::make_field(write_samples(folder, swirl, -3));
  const auto formula = fields::make_field("formula:u=-y,v=x,w=0.3");
  const SeedCurve seed = segment_seed({0.5, 0.1, -0.1}, {1, 0.2, 0.1});
  // So loose that the field alone would allow steps of many cells.
  const std::string integrator = "fixed-front:particles=20,rows=4,normals=none,accuracy=1e-3";
  const std::uint64_t fewest = evaluations(*formula, integrator, seed);
  EXPECT_EQ(evaluations(*samples, integrator, seed), fewest);
  EXPECT_GT(evaluations(*samples, integrator + ",cells=0.5", seed), 2 * fewest);
}

TEST(UnitSampledSteps, HalfACellWhereThereAreKinks) {
  const testing::TemporaryFolder folder;
  const SeedCurve seed = segment_seed({2.6, 3, 3}, {3.4, 3, 3});
  const std::string file = write_abc(folder), integrator = "fixed-front:particles=20,rows=4";
  for (const char* sampler : {"linear", "c1"}) {
    const auto field = fields::make_field(file + ":sampler=" + sampler);
    const auto of = [&](const char* cells) {
      return evaluations(*field, integrator + cells, seed);
    };
    EXPECT_EQ(of(""), of(",cells=0.5")) << sampler;
    // Shorter ones are as many more as they are shorter, but for the first and the last.
    EXPECT_GT(of(",cells=0.05"), 3 * of(",cells=0.5")) << sampler;
  }
}

/// Neighbours whose errors differ by more than the tolerance would make wrinkles, however many
/// there are.
TEST(AgreementSampled, ATimeOfLooseStepsDoesNotWrinkleASurface) {
  const testing::TemporaryFolder folder;
  const auto vortex = [](const Vec3& x) {
    const double decay = std::exp(-x.x * x.x - x.y * x.y);
    return Vec3(-x.y * decay, x.x * decay, 0.1);
  };
  const auto field = fields::make_field(write_samples(folder, vortex, -3, 13));
  const SurfaceRequest request{field.get(), segment_seed({0.2, 0, -1}, {1, 0, -1}), 8, 0, false,
                               {}};
  for (const std::string integrator :
       {"hultquist:tolerance=1e-4", "adaptive-front:tolerance=1e-3"}) {
    const auto surface = integrate_surface(integrator, request);
    const auto exact = integrate_surface(integrator + ",accuracy=1e-9", request);
    EXPECT_LE(surface.mesh.triangles.size(), 1.25 * double(exact.mesh.triangles.size()));
    const Parameters parameters = integrator_parameters(integrator);
    const SurfaceError error = measure_error(surface.mesh, request, 200, parameters);
    EXPECT_LE(error.max, parameters.real("tolerance")) << integrator;
    EXPECT_LE(error.max_from_surface, parameters.real("tolerance")) << integrator;
    EXPECT_LE(error.normal_max_degrees, 30) << integrator;
  }
}

/// u = 2^⌊x⌋ in cells of width 1, as of a file's cells: off from any smooth field by some units.
class Stairs final : public fields::VectorField {
 public:
  std::unique_ptr<fields::FieldSampler> sampler() const override {
    return std::make_unique<Sampler>();
  }
  Box3 domain() const override { return {{0, 0, 0}, {4, 2, 2}}; }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override { return 1; }
  std::optional<double> sampling_error() const override { return 4; }
  bool fills_domain() const override { return true; }
  std::string description() const override { return "stairs"; }

 private:
  class Sampler final : public fields::FieldSampler {
   public:
    fields::SampleStatus velocity(const Vec3& x, double, Vec3& v) override {
      v = Vec3(std::exp2(std::floor(x.x)), 0, 0);
      return x.x >= 0 && x.x < 4 ? fields::SampleStatus::ok : fields::SampleStatus::outside;
    }
    fields::SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v,
                                               Mat3& jacobian) override {
      jacobian = Mat3(0);
      return velocity(x, t, v);
    }
  };
};

/// 0.75 of the time are spent in the first cell, from x = 0.25, at the speed 1, and 0.5 in the
/// second one at 2.
double on_stairs(double t) {
  if (t <= 0.75) return 0.25 + t;
  return t <= 1.25 ? 1 + 2 * (t - 0.75) : 2 + 4 * (t - 1.25);
}

TEST(UnitSampledSteps, CellsOfOneVelocityAreFollowedExactly) {
  const Stairs field;
  const SurfaceRequest request{&field, segment_seed({0.25, 0.5, 1}, {0.25, 1.5, 1}), 1.45, 0, false,
                               {}};
  for (const char* integrator : {"fixed-front:particles=3,rows=58", "hultquist:tolerance=1e-3"}) {
    const auto mesh = integrate_surface(integrator, request).mesh;
    const auto &t = mesh.scalars.at("t"), &speed = mesh.scalars.at("speed");
    for (std::size_t i = 0; i < t.size(); ++i) {
      const bool at_face = std::abs(t[i] - 0.75) < 1e-6 || std::abs(t[i] - 1.25) < 1e-6;
      // A step's estimated error is at most 1e-9; one over a face may in truth be hundreds of that.
      ASSERT_NEAR(mesh.positions[i].x, on_stairs(t[i]), 1e-6) << integrator << ' ' << t[i];
      const double expected = t[i] < 0.75 ? 1 : t[i] < 1.25 ? 2 : 4;
      ASSERT_TRUE(at_face || std::abs(speed[i] - expected) < 1e-6) << integrator << ' ' << t[i];
    }
  }
}

TEST(UnitSampledSteps, NoneOverAHole) {
  // One sample that is no number makes a hole of two cells' width in the way of all particles.
  const testing::TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto field = fields::make_field(write_samples(
      folder, [&](const Vec3& x) { return glm::length(x) < 1e-9 ? Vec3(nan) : Vec3(10, 0, 0); },
      -3));
  const auto surface = sweep_samples(*field, "fixed-front:particles=9,rows=1",
                                     segment_seed({-2, -0.15, -0.1}, {-2, 0.15, 0.1}));
  EXPECT_EQ(surface.stats.ends.at(EndReason::not_finite), 9u);
  // Steps that leave are halved down to ten tolerances of 1e-9 of the extent, 7: see
  // edge_tolerances.
  EXPECT_LE(surface.mesh.bounds().max.x, -6. / 32 + 1e-7);
}

TEST(UnitSampledSteps, NoneOutOfTheSamplesAndInAgain) {
  // Circles that bulge out of the box: a long step could miss that.
  const testing::TemporaryFolder folder;
  const auto field = fields::make_field(write_samples(folder, swirl, -3));
  const auto surface = integrate_surface(
      "fixed-front:particles=9,rows=40",
      {field.get(), segment_seed({2.9, -1.2, -2}, {2.9, -1.4, -2}), 2, 0, false, {}});
  EXPECT_EQ(surface.stats.ends.at(EndReason::left_domain), 9u);
}

}  // namespace
}  // namespace pellucid::integrators
