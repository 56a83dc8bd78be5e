// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/sums/merge_sums.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/parts/same_whole.h"
#include "core/error.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using scene::Combine;
using scene::SumPlane;

/// A NamedSums is a file of sums and what it says of itself.
struct NamedSums {
  fs::path file;
  SumsInfo info;
};

/// All files, part 1 first.
std::vector<NamedSums> infos_of(const std::vector<fs::path>& files) {
  std::vector<NamedSums> all;
  std::vector<NamedInfo> pictures;
  for (const fs::path& file : files) {
    all.push_back({file, read_sums_info(file)});
    pictures.push_back({file, all.back().info.of});
    check_same_sums(files.front(), all.front().info, file, all.back().info);
    if (all.back().info.phase != all.front().info.phase)
      throw InputError(fmt::format("{}: its phase is {}, of {} it is {}; accepted: one phase",
                                   file.string(), all.back().info.phase, files.front().string(),
                                   all.front().info.phase));
  }
  check_same_whole(pictures);
  std::ranges::sort(all, {}, [](const NamedSums& sums) { return sums.info.of.part.part; });
  return all;
}

}  // namespace

SumsAdder::Total::Total(const SumPlane& like)
    : name(like.name),
      combine(like.combine),
      channels(like.channels),
      values(like.values.begin(), like.values.end()) {}

bool SumsAdder::Total::is_like(const SumPlane& plane) const {
  return plane.name == name && plane.combine == combine && plane.channels == channels &&
         plane.values.size() == values.size();
}

void SumsAdder::Total::add(const SumPlane& plane) {
  parallel_for(std::size_t(0), values.size(), [&](std::size_t i) {
    if (combine == Combine::add)
      values[i] += double(plane.values[i]);
    else
      values[i] *= double(plane.values[i]);
  });
}

SumPlane SumsAdder::Total::plane() const {
  return {name, combine, channels, std::vector<float>(values.begin(), values.end())};
}

void SumsAdder::add(const fs::path& file, const SumsFile& sums) {
  if (totals_.empty()) {
    info_ = sums.info;
    info_.of.part = {};
    behind_ = sums.behind;
    for (const SumPlane& plane : sums.planes) totals_.emplace_back(plane);
    return;
  }
  const auto is_like = [](const Total& a, const SumPlane& b) { return a.is_like(b); };
  if (!std::ranges::equal(totals_, sums.planes, is_like))
    throw InputError(
        fmt::format("{}: holds other sums than the other parts; accepted: those of "
                    "one method, written by one build",
                    file.string()));
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i].add(sums.planes[i]);
}

SumsFile SumsAdder::total() const {
  SumsFile total{info_, {}, behind_};
  for (const Total& plane : totals_) total.planes.push_back(plane.plane());
  return total;
}

void check_same_sums(const fs::path& first_file, const SumsInfo& first, const fs::path& file,
                     const SumsInfo& other) {
  if (other.method != first.method)
    throw InputError(fmt::format("{}: its method is {}, of {} it is {}; accepted: one method",
                                 file.string(), other.method, first_file.string(), first.method));
  DeepInfo picture = other.of;
  picture.part = first.of.part;
  check_same_picture({first_file, first.of}, {file, picture});
}

void check_totals(const fs::path& totals_file, const SumsInfo& totals, const fs::path& file,
                  const SumsInfo& info) {
  if (totals.phases == 1 || totals.phase != 1 || totals.of.part != scene::PartNumber())
    throw InputError(fmt::format(
        "{}: is of phase {} of {} and part {} of {} of {}; accepted: the totals over all parts, as "
        "merge --partial leaves them, of the first of two phases",
        totals_file.string(), totals.phase, totals.phases, totals.of.part.part,
        totals.of.part.count, totals.method));
  check_same_sums(totals_file, totals, file, info);
}

SumsFile merge_sums(const std::vector<fs::path>& files, const Progress& progress) {
  const std::vector<NamedSums> parts = infos_of(files);
  SumsAdder adder;
  for (const NamedSums& part : parts) {
    report(progress, double(part.info.of.part.part - 1) / double(parts.size()), "merging");
    adder.add(part.file, read_sums_file(part.file));
  }
  return adder.total();
}

}  // namespace pellucid::compare
