// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Integral surfaces that are known in closed form: their distance is that of an implicit surface,
// which owes nothing to any integrator.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "fields/make_field.h"
#include "integrators/surfaces/integrate_surface.h"

namespace pellucid::testing {}

namespace pellucid::integrators::testing {

using namespace pellucid::testing;

struct ClosedForm {
  std::string name, field;
  SeedCurve seed;
  double duration;
  bool path;
  std::function<double(const Vec3& x)> implicit;  // 0 on the surface
};

inline std::ostream& operator<<(std::ostream& out, const ClosedForm& form) {
  return out << form.name;
}

/// The wave z = A sin(kx) at y = 1, which saddles carry to z = A sin(kxy).
inline SeedCurve wave_seed(double x0, double x1, double A, double k) {
  return callable_seed(
      [=](double s) {
        const double x = x0 + s * (x1 - x0);
        return Vec3(x, 1, A * std::sin(k * x));
      },
      false,
      [=](double s) {
        const double x = x0 + s * (x1 - x0);
        return (x1 - x0) * Vec3(1, 0, A * k * std::cos(k * x));
      });
}

inline double wave(const Vec3& x) { return x.z - 0.2 * std::sin(3 * x.x * x.y); }

inline std::vector<ClosedForm> closed_forms() {
  return {
      {"Helicoid", "rotation:omega=1,c=0.5", segment_seed({0.2, 0, 0}, {1, 0, 0}), 4, false,
       [](const Vec3& x) { return x.x * std::sin(2 * x.z) - x.y * std::cos(2 * x.z); }},
      {"HalfSaddle", "saddle", wave_seed(0.2, 1, 0.2, 3), 1.5, false, wave},
      {"Shear", "shear:b=1",
       callable_seed([](double s) { return Vec3(0, s, 0.2 * std::sin(3 * s)); }), 1.5, false,
       [](const Vec3& x) { return x.z - 0.2 * std::sin(3 * x.y); }},
      {"UnsteadySaddle", "pulsing-saddle", wave_seed(0.2, 1, 0.2, 3), 1.2, true, wave},
      // Every particle runs on a unit circle through its seed: a cylinder.
      {"UnsteadyDrift", "drift", segment_seed({0, 0, 0}, {0.3, 0, 1}), 3, true,
       [](const Vec3& x) { return std::hypot(x.x - 0.3 * x.z, x.y - 1) - 1; }},
      // With C = 0, H = B sin x + A cos z is kept, and nothing depends on y: a cylinder along y.
      {"AbcWithoutC", "abc:C=0", segment_seed({2.64, 3, 3.14}, {2.64, 4, 3.14}), 2, false,
       [](const Vec3& x) {
         const auto H = [](double x0, double z0) {
           return std::sqrt(2.) * std::sin(x0) + std::sqrt(3.) * std::cos(z0);
         };
         return H(x.x, x.z) - H(2.64, 3.14);
       }},
  };
}

inline Vec3 gradient(const ClosedForm& form, const Vec3& x) {
  constexpr double h = 1e-6;
  Vec3 slope;
  for (int i = 0; i < 3; ++i) {
    Vec3 a = x, b = x;
    a[i] -= h;
    b[i] += h;
    slope[i] = (form.implicit(b) - form.implicit(a)) / (2 * h);
  }
  return slope;
}

/// |F| / |∇F|, which is the distance to first order.
inline double implicit_distance(const ClosedForm& form, const Vec3& x) {
  return std::abs(form.implicit(x)) / glm::length(gradient(form, x));
}

/// The distance to the implicit surface, to 1e-9 of itself or better: its nearest point is found by
/// steps onto the surface along the gradient and by steps beneath `p` in the tangent plane, which
/// leave a share κ d of what they correct, κ d the surface's curvature times the distance.
inline double distance(const ClosedForm& form, const Vec3& p) {
  Vec3 x = p;
  for (int step = 0; step < 20; ++step) {
    const Vec3 slope = gradient(form, x), n = glm::normalize(slope);
    const Vec3 aside = p - x;
    const Vec3 move = aside - glm::dot(aside, n) * n - form.implicit(x) / glm::length(slope) * n;
    x += move;
    if (glm::length(move) <= 1e-9 * glm::distance(x, p)) break;
  }
  return glm::distance(x, p);
}

struct Swept {
  std::unique_ptr<fields::VectorField> field;
  SurfaceRequest request;
  IntegratedSurface surface;
};

inline Swept sweep(const ClosedForm& form, std::string_view integrator) {
  Swept swept{fields::make_field(form.field), {}, {}};
  swept.request.field = swept.field.get();
  swept.request.seed = form.seed;
  swept.request.duration = form.duration;
  swept.request.path = form.path;
  swept.surface = integrate_surface(integrator, swept.request);
  return swept;
}

/// By default a step's error is estimated at 1e-9 of the extent of a surface, some units here, and
/// trajectories take some tens of steps: what they are off by, world units, if errors add up.
constexpr double trajectory_error = 1e-8;

/// Largest distance over each triangle's points of barycentric coordinates that are quarters.
inline double largest_distance(const ClosedForm& form, const geometry::TriangleMesh& mesh) {
  double largest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &x = mesh.positions[a], &y = mesh.positions[b], &z = mesh.positions[c];
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j)
        largest = std::max(largest, distance(form, 0.25 * (double(i) * x + double(j) * y +
                                                           double(4 - i - j) * z)));
  }
  return largest;
}

/// Largest angle between facets and the exact surface's normals, over all triangles, degrees.
inline double worst_facet(const ClosedForm& form, const geometry::TriangleMesh& mesh) {
  double worst = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &x = mesh.positions[a], &y = mesh.positions[b], &z = mesh.positions[c];
    const Vec3 facet = glm::cross(y - x, z - x), normal = gradient(form, (x + y + z) / 3.0);
    const double sine = glm::length(glm::cross(facet, normal));
    worst = std::max(worst, 57.29577951 * std::atan2(sine, std::abs(glm::dot(facet, normal))));
  }
  return worst;
}

}  // namespace pellucid::integrators::testing
