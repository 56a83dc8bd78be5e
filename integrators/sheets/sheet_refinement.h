// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/progress.h"
#include "integrators/sheets/sheet_border.h"
#include "integrators/sheets/sheet_facets.h"
#include "integrators/sheets/sheet_options.h"

namespace pellucid::integrators {

/// A SheetRefinement halves the sides of a sheet's facets until the sheet's own points lie near
/// them. Each side is judged once, whichever facet asks, so that the facets always fit together. A
/// side is halved
/// - while it is longer than the first look's distance between particles;
/// - when the sheet is farther from it than a part of the tolerance: at its middle, where a
///   particle is sent, or at its quarters, by the normals at both ends;
/// - when its middle's particle does not come to lie in the middle part of it;
/// - when a facet beside it, wider than the tolerance, turns by more than 30 degrees from the
///   normal at a corner;
/// - when the particles at both its ends are there and the one in its middle is not, or the other
///   way round.
/// Where the sheet ends between a side's two ends, or jumps, the facet is parted at the gap, once
/// the gap's edges are straight enough. Facets as small as `rip`, or made by twice the halvings
/// that lead to it, that cannot be parted so, at the end of a tear, are left out. The same to the
/// last bit for any number of threads.
class SheetRefinement {
 public:
  /// All must outlive it. `tolerance` is in world units.
  SheetRefinement(SheetParticles& particles, const SheetDomain& domain, const SheetOptions& options,
                  double tolerance, const Progress& progress);

  void run();

  const std::vector<SheetVertex>& vertices() const { return vertices_; }
  /// Those of the sheet, of a facet that a gap crosses the parts on its sides; and across how many
  /// the sheet is torn.
  struct SheetFacets {
    std::vector<Facet> facets;
    std::uint64_t torn = 0;
  };
  SheetFacets facets();
  /// Sides that would have been halved when the budget was used up.
  std::uint64_t unfinished() const { return unfinished_; }
  std::optional<EndReason> budget() const { return budget_; }
  std::uint64_t bytes() const;

 private:
  enum class Verdict { fine, halve, gap };
  struct Side {
    std::array<std::uint32_t, 2> ends;
    SheetVertex middle;
    Verdict verdict = Verdict::fine;
    std::optional<std::uint32_t> halved;                  // the middle's number
    std::unique_ptr<SheetGap> gap;                        // by end; few sides have one
    std::array<std::optional<std::uint32_t>, 2> numbers;  // of the gap's vertices
  };

  /// What a gap across two sides leaves of a facet: the corner between them, and the other two.
  struct Parting {
    std::size_t apex;                    // the corner
    std::array<std::uint32_t, 2> sides;  // those before and after it
  };

  std::uint32_t side_of(std::uint32_t a, std::uint32_t b);
  std::array<std::uint32_t, 3> sides_of(const Facet& facet);
  bool pass();
  void judge_new_sides();
  void judge(Side& side);
  void part_or_halve(Side& side);
  double length_of(const Side& side) const;
  int generation_of(const Side& side) const;
  double deviation(const SheetVertex& a, const SheetVertex& b, const SheetVertex& middle) const;
  bool is_uneven(const SheetVertex& a, const SheetVertex& b, const SheetVertex& middle) const;
  void judge_facets();
  bool is_settled(const Facet& facet);
  bool is_bent(const Facet& facet) const;
  std::optional<Parting> parting_of(const Facet& facet);
  std::size_t gaps_across(const Facet& facet);
  double gap_deviation(const Facet& facet, const Parting& parting);
  const SheetVertex* gap_vertex(std::uint32_t side, std::uint32_t beside) const;
  std::uint32_t number_of_gap_vertex(std::uint32_t side, std::uint32_t beside);
  void append_sides_of_gap(const Facet& facet, const Parting& parting, std::vector<Facet>& facets);
  void halve(Side& side);
  void halve_all(const Facet& facet);
  std::optional<EndReason> exhausted_budget() const;
  void halve_sides();

  SheetParticles& particles_;
  const SheetDomain& domain_;
  const SheetOptions& options_;
  const Progress& progress_;
  double tolerance_, size_;
  std::vector<SheetVertex> vertices_;
  std::vector<int> generations_;  // of vertices: 0 at first, that of a side's middle one more
  std::vector<Facet> facets_;
  std::vector<bool> settled_;  // by facet
  std::vector<Side> sides_;
  std::size_t judged_ = 0;                                    // sides
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;  // of sides, by their ends
  std::uint64_t unfinished_ = 0;
  std::optional<EndReason> budget_;
};

}  // namespace pellucid::integrators
