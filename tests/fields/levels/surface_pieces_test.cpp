// SPDX-License-Identifier: GPL-3.0-or-later
// An isosurface cut into boxes of one polynomial each: these are the reconstruction, and none is
// missing.

#include "fields/levels/surface_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fields/levels/box_polynomial.h"
#include "fields/levels/surface_cells.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using testing::sampled;

double binomial(int n, int k) { return std::round(1 / ((n + 1) * std::beta(n - k + 1., k + 1.))); }

/// Bernstein's coefficients, x fastest, at a place in [0, 1]³.
double value_at(std::span<const double> coefficients, int degree, const Vec3& place) {
  double sum = 0;
  for (int i = 0; i < int(coefficients.size()); ++i) {
    double term = coefficients[std::size_t(i)];
    for (int axis = 0, rest = i; axis < 3; ++axis, rest /= degree + 1) {
      const int l = rest % (degree + 1);
      term *=
          binomial(degree, l) * std::pow(place[axis], l) * std::pow(1 - place[axis], degree - l);
    }
    sum += term;
  }
  return sum;
}

TEST(UnitBoxPolynomial, IsTheSumAndProductOfItsLines) {
  const auto x = BoxPolynomial::line(0, 0.25, 2), y = BoxPolynomial::line(1, -1, 3),
             z = BoxPolynomial::line(2, 5, 4);
  const BoxPolynomial p = (x * y - z / 2) * x + 0.5;
  EXPECT_EQ(p.degree(), 2);
  for (const int degree : {2, 3, 5}) {
    std::vector<double> coefficients;
    p.append_coefficients(degree, coefficients);
    ASSERT_EQ(coefficients.size(), std::size_t((degree + 1) * (degree + 1) * (degree + 1)));
    for (const Vec3 at : {Vec3(0), Vec3(1), Vec3(0.3, 0.6, 0.9)}) {
      const Vec3 line = glm::mix(Vec3(0.25, -1, 5), Vec3(2, 3, 4), at);
      const double expected = (line.x * line.y - line.z / 2) * line.x + 0.5;
      EXPECT_NEAR(value_at(coefficients, degree, at), expected, 1e-14);  // some ten roundings
    }
  }
}

double hilly(const Vec3& x) { return std::sin(1.3 * x.x) * std::cos(x.y) + 0.3 * x.z - 1; }
double other(const Vec3& x) { return x.x - 2 * x.y + std::cos(x.z); }

/// Levels within one another, beside one another, and across each other's faces.
template <class Function>
std::vector<std::vector<ScalarLevel>> arrangements(const Function& f) {
  return {testing::nested(f),
          {sampled(Vec3(0.5), 1, 8, f)},
          {sampled(Vec3(0.5), 1, 6, f), sampled(Vec3(5.75, 1, 1), 0.5, 7, f)},
          {sampled(Vec3(0.5), 1, 6, f), sampled(Vec3(3.25), 0.5, 11, f),
           sampled(Vec3(4.1), 0.3, 9, f)}};
}

class PropertySurfacePieces : public ::testing::TestWithParam<ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertySurfacePieces, ::testing::ValuesIn(reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

struct Cut {
  LevelField field, beside;
  SurfacePieces pieces;
};

constexpr double surface = 0.05;

Cut cut(std::size_t arrangement, const ReconstructionRow& row) {
  LevelField field(arrangements(hilly)[arrangement], row);
  LevelField beside(arrangements(other)[arrangement], row);
  const LevelField* others[] = {&beside};
  SurfacePieces pieces = surface_pieces(field, surface, surface_cells(field, surface), others);
  return {std::move(field), std::move(beside), std::move(pieces)};
}

TEST_P(PropertySurfacePieces, APieceIsTheReconstruction) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  for (std::size_t arrangement = 0; arrangement < arrangements(hilly).size(); ++arrangement) {
    const Cut all = cut(arrangement, GetParam());
    ASSERT_GT(all.pieces.pieces.size(), 20u);
    for (const SurfacePiece& piece : all.pieces.pieces) {
      const auto numbers = [&](int polynomial) {
        return std::span(all.pieces.numbers)
            .subspan(piece.first + std::size_t(polynomial) * piece.count(), piece.count());
      };
      if (piece.jump_axis >= 0) continue;
      const Vec3 place(unit(random), unit(random), unit(random));
      const Vec3 x = glm::mix(piece.box.min, piece.box.max, place);
      const double weight = piece.weighted ? value_at(numbers(1), piece.degree, place) : 1;
      const auto height = all.field.height(x, surface), scalar = all.beside.value(x);
      ASSERT_TRUE(height && scalar);
      // Values of up to 20, some hundred roundings, over weights of 1e-6 at least.
      EXPECT_NEAR(value_at(numbers(0), piece.degree, place) / weight, *height, 1e-9);
      EXPECT_NEAR(value_at(numbers(1 + piece.weighted), piece.degree, place) / weight, *scalar,
                  1e-9);
    }
  }
}

/// Where the reconstruction has one sign at a point and another beside it, the points lie in a
/// piece or on both sides of a face.
TEST_P(PropertySurfacePieces, WhereTheValueIsTakenThereIsAPiece) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(0.6, 9);
  std::uniform_real_distribution<double> step(-0.02, 0.02);
  for (std::size_t arrangement = 0; arrangement < arrangements(hilly).size(); ++arrangement) {
    const Cut all = cut(arrangement, GetParam());
    std::size_t crossed = 0;
    for (int i = 0; i < 40000; ++i) {
      const Vec3 a(anywhere(random), anywhere(random), anywhere(random));
      const Vec3 b = a + Vec3(step(random), step(random), step(random));
      const auto at_a = all.field.height(a, surface), at_b = all.field.height(b, surface);
      if (!at_a || !at_b || (*at_a < 0) == (*at_b < 0)) continue;
      ++crossed;
      const Box3 around{glm::min(a, b), glm::max(a, b)};
      EXPECT_TRUE(std::ranges::any_of(all.pieces.pieces,
                                      [&](const SurfacePiece& piece) {
                                        Box3 box = piece.box;
                                        if (piece.jump_axis >= 0)
                                          box.max[piece.jump_axis] = box.min[piece.jump_axis];
                                        return glm::all(glm::lessThanEqual(box.min, around.max)) &&
                                               glm::all(glm::lessThanEqual(around.min, box.max));
                                      }))
          << a.x << ' ' << a.y << ' ' << a.z;
    }
    EXPECT_GT(crossed, 30u);
  }
}

TEST_P(PropertySurfacePieces, BoxesHaveNoVolumeInCommon) {
  for (std::size_t arrangement = 0; arrangement < arrangements(hilly).size(); ++arrangement) {
    const Cut all = cut(arrangement, GetParam());
    const std::vector<SurfacePiece>& pieces = all.pieces.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(pieces[i].jump_axis < 0 && pieces[j].jump_axis < 0 &&
                     glm::all(glm::lessThan(pieces[i].box.min, pieces[j].box.max)) &&
                     glm::all(glm::lessThan(pieces[j].box.min, pieces[i].box.max)));
  }
}

/// Trilinear in the finest level: x on the fine one, and x + 0.4 on the coarse one, cross the value
/// between 3.3 and 3.7 on the face.
TEST(UnitSurfacePieces, AJumpAcrossTheValueIsAPiece) {
  const auto coarse = [](const Vec3& x) { return x.x + 0.4; };
  const auto fine = [](const Vec3& x) { return x.x; };
  const LevelField field({sampled(Vec3(0), 1, 9, coarse), sampled(Vec3(3.5, 2, 2), 0.5, 7, fine)},
                         find_reconstruction("trilinear"));
  const SurfacePieces all = surface_pieces(field, 3.7, surface_cells(field, 3.7));
  double area = 0;
  for (const SurfacePiece& piece : all.pieces)
    if (piece.jump_axis == 0 && piece.box.min.x == 3.5) {
      const Vec3 size = piece.box.max - piece.box.min;
      area += size.y * size.z;
    }
  EXPECT_DOUBLE_EQ(area, 9);  // the face of [2, 5]²
}

}  // namespace
}  // namespace pellucid::fields
