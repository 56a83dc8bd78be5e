// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/names.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace pellucid {
namespace {

/// Characters of a wrong name that are compared: it may be as long as a file.
constexpr std::size_t longest_compared = 100;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string_view> nearest_first(std::string_view name,
                                            std::span<const std::string_view> known) {
  struct Candidate {
    std::size_t distance;
    std::string_view name;
  };
  std::vector<Candidate> candidates;
  for (const std::string_view candidate : known)
    candidates.push_back({edit_distance(name.substr(0, longest_compared), candidate), candidate});
  std::ranges::stable_sort(candidates, {}, &Candidate::distance);
  std::vector<std::string_view> sorted;
  for (const Candidate& candidate : candidates) sorted.push_back(candidate.name);
  return sorted;
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         std::span<const std::string_view> known) {
  if (known.empty()) return fmt::format("unknown {} '{}'; known: none", kind, name);
  return fmt::format("unknown {} '{}'; known: {}", kind, name,
                     fmt::join(nearest_first(name, known), ", "));
}

}  // namespace pellucid
