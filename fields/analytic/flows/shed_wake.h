// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The flow past a sphere (sphere.h) with vortex rings in its wake, as if shed in turn to either
// side. A model: it has what Q-criteria are made to find, at sizes that grow downstream, and solves
// no equation of motion.
//
// A ring has centre c, unit axis n, radius R and core size σ. With p = x - c, z = n·p, q = p - z n
// and s = |q|², its vector potential is
//   A = g(s, z) n × p,  g = -(Γ/2) exp( -[ (s - R²)²/4R² + z² ] / 2σ² ),
// the bracket being the squared distance from the circle where that is small. Since ∇ × (n × p) =
// 2n and ∇g = 2 g_s q + g_z n,
//   v = ∇ × A = ∇g × (n × p) + 2g n = n (∇g·p + 2g) - p (∇g·n) = 2 (g + s g_s) n - g_z q,
//   g_s = -g (s - R²)/4R²σ²,  g_z = -g z/σ²:
// free of divergence, smooth, upstream within the ring. Across the core it turns at the rate
// RΓ/2σ², and Q > 0 up to about σ from the circle. Cores spread with the distance as by viscosity:
// σ² linear in it. At the sphere the rings' velocity is below 0.002 Γ.

#include <vector>

#include "fields/analytic/flows/sphere.h"

namespace pellucid::fields::flow {

/// ShedWakeOptions are the constants of the field `shed-wake`.
struct ShedWakeOptions {
  SphereOptions sphere;
  int rings = 5;       // 1.6 radii apart
  double gamma = 0.5;  // U: strength of a ring
};

/// A ShedWake is the field `shed-wake`: flow past a sphere with vortex rings in its wake.
struct ShedWake {
  using Options = ShedWakeOptions;
  static constexpr FlowFacts facts{
      .name = "shed-wake",
      .title = "Flow past a sphere with vortex rings in its wake",
      .citation = "a model: Oseen's flow (see sphere) and rings with Gaussian cores",
      .formula =
          "sphere + curl(g n x p) of each ring, "
          "g = -(gamma/2) exp(-((s - R^2)^2/4R^2 + z^2)/(2 sigma^2)), s = |p|^2 - z^2, z = n.p",
      .divergence_free = true,
      .region = {Vec3(-4, -3, -3), Vec3(10, 3, 3)},
  };
  static const OptionTable<Options>& options() {
    static const OptionTable<Options> table{
        part(&Options::sphere, Sphere::options()),
        number("rings", &Options::rings,
               {.min = 0, .max = 16, .unit = "rings", .help = "vortex rings, 1.6 radii apart"}),
        number("gamma", &Options::gamma, {.unit = "U", .help = "strength of a ring"})};
    return table;
  }

  /// Lengths in units of the sphere's radius.
  struct Ring {
    Vec3 center, axis;
    double sigma2;  // of the core
  };
  static constexpr double radius = 0.75;  // R of every ring

  Sphere sphere;
  double g0;  // of a ring's circle
  std::vector<Ring> rings;

  explicit ShedWake(const Options& given)
      : sphere{given.sphere}, g0(-0.5 * given.gamma * sphere.U) {
    constexpr double first = 2.2, distance = 1.6, aside = 0.35, tilt = 0.6, core = 0.2;
    for (int i = 0; i < given.rings; ++i) {
      const double side = i % 2 == 0 ? 1 : -1;
      rings.push_back({{first + i * distance, side * aside, 0},
                       {std::cos(tilt), side * std::sin(tilt), 0},
                       core * core * (1 + 0.25 * i)});
    }
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& x, double t) const {
    Triple<T> v = sphere(x, t);
    const Triple<T> at{x.x / sphere.a, x.y / sphere.a, x.z / sphere.a};
    if (at.x * at.x + at.y * at.y + at.z * at.z < T(1.0)) return v;
    for (const Ring& ring : rings) add(ring, at, v);
    return v;
  }

 private:
  template <class T>
  void add(const Ring& ring, const Triple<T>& x, Triple<T>& v) const {
    constexpr double R2 = radius * radius;
    const Vec3& n = ring.axis;
    const Triple<T> p{x.x - ring.center.x, x.y - ring.center.y, x.z - ring.center.z};
    const T z = n.x * p.x + n.y * p.y + n.z * p.z;
    const Triple<T> q{p.x - z * n.x, p.y - z * n.y, p.z - z * n.z};
    const T s = q.x * q.x + q.y * q.y + q.z * q.z;
    const T from = (s - R2) / (2 * radius);
    const T g = g0 * exp(-0.5 / ring.sigma2 * (from * from + z * z));
    const T along = 2.0 * g * (1.0 - s * (s - R2) / (4 * R2 * ring.sigma2));
    const T across = g * z / ring.sigma2;  // -g_z
    v.x = v.x + along * n.x + across * q.x;
    v.y = v.y + along * n.y + across * q.y;
    v.z = v.z + along * n.z + across * q.z;
  }
};

}  // namespace pellucid::fields::flow
