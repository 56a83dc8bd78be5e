// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/surface_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "fields/levels/box_polynomial.h"
#include "fields/levels/level_boxes.h"
#include "fields/levels/surface_cells.h"

namespace pellucid::fields {
namespace {

/// Whether 0, which counts as inside, is between the coefficients: what they are of takes no value
/// beyond theirs.
bool change_sign(std::span<const double> coefficients) {
  const auto outside = [](double c) { return c < 0; };
  return std::ranges::any_of(coefficients, outside) && !std::ranges::all_of(coefficients, outside);
}

class PieceCutter {
 public:
  PieceCutter(const LevelField& field, double value, std::span<const LevelField* const> others,
              SurfacePieces& out)
      : field_(field), value_(value), others_(others), out_(out) {}

  void add(const LatticeCell& cell) {
    const Box3 box = cell_box(field_, cell);
    for (int axis = 0; axis < 3; ++axis) cuts_[axis] = {box.min[axis], box.max[axis]};
    const Box3 around = with_rounding(field_, box);
    bool alone = true;
    for (std::uint32_t other = 0; other < field_.levels().size(); ++other)
      if (other != cell.level && touch(around, field_.region(other).support) &&
          !(other > cell.level && is_inside(box, field_.region(cell.level).alone))) {
        alone = false;
        cut(other, box);
      }
    if (alone) return add_piece(box);
    for (std::vector<double>& planes : cuts_) merge(planes);
    for_each_part([&](const Box3& part) {
      if (!is_finest(cell.level, part)) return;
      add_piece(part);
      for (int axis = 0; axis < 3; ++axis)
        for (const bool above : {false, true}) add_jump(cell, part, axis, above);
    });
  }

 private:
  /// Adds the planes within the box at which another level's part of the reconstruction changes.
  void cut(std::uint32_t other, const Box3& box) {
    const ScalarLevel& level = field_.levels()[other];
    const Box3 domain = field_.domain(other), support = field_.region(other).support;
    const auto low = field_.cell_at(other, box.min).low, high = field_.cell_at(other, box.max).low;
    for (int axis = 0; axis < 3; ++axis) {
      const auto add = [&](double plane) {
        if (box.min[axis] < plane && plane < box.max[axis]) cuts_[axis].push_back(plane);
      };
      for (const double face :
           {domain.min[axis], domain.max[axis], support.min[axis], support.max[axis]})
        add(face);
      for (int i = low[axis]; i <= high[axis] + 1; ++i) add(level.origin[axis] + level.width * i);
    }
  }

  /// Planes of two levels that rounding alone keeps apart are one: the middle of what lies between
  /// them may be beyond both, and a jump would be on each.
  bool is_same(double a, double b) const { return std::abs(a - b) <= face_rounding(field_); }
  void merge(std::vector<double>& planes) const {
    std::sort(planes.begin(), planes.end());
    const double last = planes.back();  // of the cell
    planes.erase(std::unique(planes.begin(), planes.end(),
                             [&](double a, double b) { return is_same(a, b); }),
                 planes.end());
    planes.back() = last;
  }

  template <class Call>
  void for_each_part(const Call& call) const {
    for (std::size_t k = 0; k + 1 < cuts_[2].size(); ++k)
      for (std::size_t j = 0; j + 1 < cuts_[1].size(); ++j)
        for (std::size_t i = 0; i + 1 < cuts_[0].size(); ++i)
          call(Box3{{cuts_[0][i], cuts_[1][j], cuts_[2][k]},
                    {cuts_[0][i + 1], cuts_[1][j + 1], cuts_[2][k + 1]}});
  }

  static Vec3 middle(const Box3& box) { return 0.5 * box.min + 0.5 * box.max; }

  /// Whether no finer level's domain, whose faces do not cut it, holds the part.
  bool is_finest(std::uint32_t level, const Box3& part) const {
    for (std::uint32_t finer = 0; finer < level; ++finer)
      if (field_.domain(finer).contains(middle(part))) return false;
    return true;
  }

  void add_piece(const Box3& box) {
    LevelField::Cells found;
    const std::span cells(found.data(), field_.cells_at(middle(box), found));
    if (cells.empty()) return;
    SurfacePiece piece{box, 1, -1, false, out_.numbers.size()};
    if (is_lattice_cell(cells, box)) {
      append_corners(field_, cells.front(), value_);
    } else {
      const auto sum = sum_over(field_, cells, box, value_);
      piece.degree = std::max({sum.sum.degree(), sum.weight.degree(), 1});
      sum.sum.append_coefficients(piece.degree, out_.numbers);
      piece.weighted = append_weights(sum.weight, piece);
    }
    if (!change_sign(std::span(out_.numbers).subspan(piece.first, piece.count())))
      return out_.numbers.resize(piece.first);
    for (const LevelField* other : others_) append_other(*other, cells, piece);
    out_.pieces.push_back(piece);
  }

  /// Adds the part's lower or upper face where the reconstruction jumps there. Between two levels
  /// the coarser one has the face, whose cell is among those of the surface (see surface_cells()).
  void add_jump(const LatticeCell& cell, const Box3& part, int axis, bool above) {
    const double face = above ? part.max[axis] : part.min[axis];
    // Hats do not jump: where none reaches, both sides differ by rounding alone.
    if (field_.reconstruction().kind == Reconstruction::hat) return;
    if (!is_face_of_level(axis, face)) return;
    Vec3 beyond = middle(part);
    beyond[axis] = face + (above ? 1e-6 : -1e-6) * field_.levels().front().width;
    LevelField::Cells own, others;
    const std::span inner(own.data(), field_.cells_at(middle(part), own));
    const std::span outer(others.data(), field_.cells_at(beyond, others));
    if (inner.empty() || outer.empty()) return;
    const std::uint32_t level = outer.front().level;
    if (level > cell.level || (level == cell.level && !above)) return;
    Box3 box = part;
    const double depth = part.max[axis] - part.min[axis];
    box.min[axis] = face;
    box.max[axis] = face + depth;
    add_face(box, axis, above ? inner : outer, above ? outer : inner);
  }

  /// The face is the box's lower one; `below` and `above` are what take part on its sides.
  void add_face(const Box3& box, int axis, std::span<const LatticeCell> below,
                std::span<const LatticeCell> above) {
    SurfacePiece piece{box, 1, axis, false, out_.numbers.size()};
    const auto lower = sum_over(field_, below, box, value_);
    const auto upper = sum_over(field_, above, box, value_);
    piece.degree = std::max({lower.sum.degree(), upper.sum.degree(), upper.weight.degree(), 1});
    upper.sum.append_coefficients(piece.degree, out_.numbers);
    std::vector<double> other_side;
    lower.sum.append_coefficients(piece.degree, other_side);
    if (!jumps(piece, other_side)) return out_.numbers.resize(piece.first);
    piece.weighted = append_weights(upper.weight, piece);
    for (const LevelField* other : others_) append_other(*other, above, piece);
    out_.numbers.insert(out_.numbers.end(), other_side.begin(), other_side.end());
    out_.pieces.push_back(piece);
  }

  /// Whether on the face both sides differ by more than rounding, and the value may be between
  /// them.
  bool jumps(const SurfacePiece& piece, std::span<const double> other_side) const {
    const int n = piece.degree + 1;
    const int step = piece.jump_axis == 0 ? 1 : piece.jump_axis == 1 ? n : n * n;
    const auto own = std::span(out_.numbers).subspan(piece.first, piece.count());
    std::vector<double> on_face;
    double difference = 0, largest = 0;
    for (int i = 0; i < n * n * n; ++i) {
      if (i / step % n != 0) continue;
      const double a = own[std::size_t(i)], b = other_side[std::size_t(i)];
      on_face.insert(on_face.end(), {a, b});
      difference = std::max(difference, std::abs(a - b));
      largest = std::max({largest, std::abs(a), std::abs(b)});
    }
    return difference > 1e-10 * largest && change_sign(on_face);
  }

  bool is_face_of_level(int axis, double plane) const {
    for (std::uint32_t level = 0; level < field_.levels().size(); ++level) {
      const Box3 domain = field_.domain(level), support = field_.region(level).support;
      for (const double face :
           {domain.min[axis], domain.max[axis], support.min[axis], support.max[axis]})
        if (is_same(face, plane)) return true;
    }
    return false;
  }

  /// Whether a box is a whole cell of a level that is alone there: its corners are samples then.
  bool is_lattice_cell(std::span<const LatticeCell> cells, const Box3& box) const {
    if (cells.size() > 1) return false;
    const LatticeCell& cell = cells.front();
    const ScalarLevel& level = field_.levels()[cell.level];
    const Vec3 low(cell.low[0], cell.low[1], cell.low[2]);
    bool within = box.min == level.world(low) && box.max == level.world(low + 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      within &= cell.low[axis] >= 0 && cell.low[axis] + 1 < level.size[axis];
    return within;
  }

  void append_corners(const LevelField& field, const LatticeCell& cell, double value) {
    const ScalarLevel& level = field.levels()[cell.level];
    const double kept = field.scale().kept(value);
    for (int corner = 0; corner < 8; ++corner)
      out_.numbers.push_back(
          double(level.at(cell.low[0] + (corner & 1), cell.low[1] + (corner >> 1 & 1),
                          cell.low[2] + (corner >> 2))) -
          kept);
  }

  static LevelSum<BoxPolynomial> sum_over(const LevelField& field,
                                          std::span<const LatticeCell> cells, const Box3& box,
                                          double value) {
    const auto line = [&](int axis) {
      return BoxPolynomial::line(axis, box.min[axis], box.max[axis]);
    };
    return field.sum<BoxPolynomial>(cells, {line(0), line(1), line(2)}, value);
  }

  /// Appends Σ w unless it is 1 but for rounding; returns whether it did.
  bool append_weights(const BoxPolynomial& weight, const SurfacePiece& piece) {
    const std::size_t first = out_.numbers.size();
    weight.append_coefficients(piece.degree, out_.numbers);
    const auto weights = std::span(out_.numbers).subspan(first);
    if (std::ranges::any_of(weights, [](double w) { return std::abs(w - 1) > 1e-12; })) return true;
    out_.numbers.resize(first);
    return false;
  }

  /// Σ w f of another scalar: the weights are the same.
  void append_other(const LevelField& other, std::span<const LatticeCell> cells,
                    const SurfacePiece& piece) {
    const double zero = other.scale().value(0);
    if (is_lattice_cell(cells, piece.box)) return append_corners(other, cells.front(), zero);
    sum_over(other, cells, piece.box, zero).sum.append_coefficients(piece.degree, out_.numbers);
  }

  const LevelField& field_;
  double value_;
  std::span<const LevelField* const> others_;
  SurfacePieces& out_;
  std::array<std::vector<double>, 3> cuts_;  // planes, by axis
};

}  // namespace

SurfacePieces surface_pieces(const LevelField& field, double value,
                             std::span<const LatticeCell> cells,
                             std::span<const LevelField* const> others) {
  constexpr std::size_t run = 4096;  // cells: enough to be worth a task
  std::vector<SurfacePieces> runs((cells.size() + run - 1) / run);
  parallel_for(std::size_t(0), runs.size(), [&](std::size_t r) {
    PieceCutter cutter(field, value, others, runs[r]);
    for (std::size_t i = r * run; i < std::min(cells.size(), (r + 1) * run); ++i)
      cutter.add(cells[i]);
  });
  SurfacePieces all;
  for (SurfacePieces& part : runs) {
    for (SurfacePiece& piece : part.pieces) piece.first += all.numbers.size();
    all.pieces.insert(all.pieces.end(), part.pieces.begin(), part.pieces.end());
    all.numbers.insert(all.numbers.end(), part.numbers.begin(), part.numbers.end());
    part = {};
  }
  return all;
}

}  // namespace pellucid::fields
