// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fields/field.h"

namespace pellucid::fields {

/// A Frame is a steady field at one moment, in units of time.
struct Frame {
  double time = 0;
  std::unique_ptr<VectorField> field;
};

/// A SeriesEntry is one file of a .series.
struct SeriesEntry {
  double time = 0;
  std::filesystem::path file;
  std::size_t number = 0;  // its place in the list
};

/// Reads ParaView's list of the files of a time series, one or more, and puts them in the order of
/// their times. Throws InputError, naming `path`, for what is none.
std::vector<SeriesEntry> series_entries(const std::filesystem::path& path);

/// A TimeRange says when a series has velocities, in units of time.
struct TimeRange {
  double first = 0, last = 0;
  double rounding = 0;  // what is outside by no more counts as at the first or the last time

  bool contains(double t) const { return t >= first - rounding && t <= last + rounding; }
};

/// Returns the times of a series; nothing of another field.
std::optional<TimeRange> times_of_series(const VectorField& field);

/// Makes a field that is linear in time between two frames or more, and `outside` before the first
/// and after the last but for a rounding (TimeRange); a field of one frame is that frame's. Throws
/// InputError, naming `path`, where times do not ascend.
std::unique_ptr<VectorField> make_series_field(std::vector<Frame> frames,
                                               const std::filesystem::path& path);

/// Makes a field of what `frame_at` makes at each of the times, one or more: of all of them, or of
/// the one that `wanted` names (readers::chosen_time()).
std::unique_ptr<VectorField> field_over_times(
    std::span<const double> times, const std::string& wanted, const std::filesystem::path& path,
    const std::function<std::unique_ptr<VectorField>(std::size_t)>& frame_at);

}  // namespace pellucid::fields
