// SPDX-License-Identifier: GPL-3.0-or-later
// A time series of files, linear in time between them and `outside` before the first and after the
// last, but for a rounding: 0.1 + 0.2 is not 0.3, and files have times in floats. The description
// is the JSON that ParaView writes:
//   {"file-series-version": "1.0", "files": [{"name": "a.vti", "time": 0}, …]}
// with one file or more in any order, names relative to the description. The options hold for
// every file. All files are read at once.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/error.h"
#include "core/files/bad_file.h"
#include "core/files/json_text.h"
#include "fields/lazy.h"
#include "fields/readers/file_field.h"
#include "fields/readers/series_field.h"
#include "fields/sampled/dense_field.h"
#include "readers/vtk/times.h"

namespace pellucid::fields {
namespace {

using Path = std::filesystem::path;

using Frames = std::vector<Frame>;

/// Where a time lies between two frames.
struct Between {
  std::size_t frame;  // and the next one
  double s;           // from 0 at `frame` to 1 at the next
};

Between locate(const Frames& frames, double t) {
  const auto after = std::upper_bound(frames.begin() + 1, frames.end() - 1, t,
                                      [](double time, const Frame& f) { return time < f.time; });
  const std::size_t i = std::size_t(after - frames.begin()) - 1;
  return {i, (t - frames[i].time) / (frames[i + 1].time - frames[i].time)};
}

/// Gaps that are together less than a fiftieth of the time, the shortest first, do not count: a
/// step is not shorter for frames that are there twice but for a rounding, and who makes steps as
/// long as the result makes fifty of each frame at most.
double usual_spacing(const Frames& frames) {
  constexpr double part = 0.02;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    gaps.push_back(frames[i].time - frames[i - 1].time);
  std::ranges::sort(gaps);
  double left = part * (frames.back().time - frames.front().time);
  for (const double gap : gaps)
    if ((left -= gap) < 0) return gap;
  return gaps.back();
}

/// A thousandth of a millionth of the whole, as places beyond the last sample by as little of a
/// cell; and what adding up durations leaves of the digits of a time.
TimeRange range_of(const Frames& frames) {
  const double first = frames.front().time, last = frames.back().time;
  const double ulps = 16 * std::numeric_limits<double>::epsilon();
  return {first, last,
          edge_rounding * (last - first) + ulps * std::max(std::abs(first), std::abs(last))};
}

class SeriesSampler final : public FieldSampler {
 public:
  SeriesSampler(const Frames& frames, const TimeRange& times)
      : frames_(frames), times_(times), samplers_(frames.size()) {}

  SampleStatus velocity(const Vec3& x, double t, Vec3& v) override {
    return mix_over_time(t, [&](FieldSampler& sampler, double weight) {
      Vec3 part;
      const SampleStatus status = sampler.velocity(x, t, part);
      if (status != SampleStatus::ok) return status;
      v = weight < 0 ? part : glm::mix(v, part, weight);
      return status;
    });
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double t, Vec3& v, Mat3& jacobian) override {
    return mix_over_time(t, [&](FieldSampler& sampler, double weight) {
      Vec3 part;
      Mat3 slope;
      const SampleStatus status = sampler.velocity_and_jacobian(x, t, part, slope);
      if (status != SampleStatus::ok) return status;
      v = weight < 0 ? part : glm::mix(v, part, weight);
      jacobian = weight < 0 ? slope : jacobian * (1 - weight) + slope * weight;
      return status;
    });
  }
  /// Frames mostly have the same cells.
  void follow(LastCell* last) override {
    last_ = last;
    for (const auto& sampler : samplers_)
      if (sampler) sampler->follow(last);
  }

 private:
  /// `add` takes the first frame with a negative weight and mixes the second into it. At a frame's
  /// own time the other is not asked.
  template <class Add>
  SampleStatus mix_over_time(double t, const Add& add) {
    if (!times_.contains(t)) return SampleStatus::outside;
    const auto [frame, s] = locate(frames_, std::clamp(t, times_.first, times_.last));
    if (s == 1) return add(sampler(frame + 1), -1);
    const SampleStatus status = add(sampler(frame), -1);
    return status != SampleStatus::ok || s == 0 ? status : add(sampler(frame + 1), s);
  }

  FieldSampler& sampler(std::size_t frame) {
    if (!samplers_[frame]) {
      samplers_[frame] = frames_[frame].field->sampler();
      samplers_[frame]->follow(last_);
    }
    return *samplers_[frame];
  }

  const Frames& frames_;
  const TimeRange& times_;
  std::vector<std::unique_ptr<FieldSampler>> samplers_;  // made when first needed
  LastCell* last_ = nullptr;
};

class SeriesField final : public VectorField {
 public:
  SeriesField(Frames frames, std::string description)
      : frames_(std::move(frames)),
        times_(range_of(frames_)),
        description_(std::move(description)) {}

  std::unique_ptr<FieldSampler> sampler() const override {
    return std::make_unique<SeriesSampler>(frames_, times_);
  }
  Box3 domain() const override {
    Box3 common = frames_.front().field->domain();
    for (const Frame& frame : frames_) {
      common.min = glm::max(common.min, frame.field->domain().min);
      common.max = glm::min(common.max, frame.field->domain().max);
    }
    return common;
  }
  bool steady() const override { return false; }
  const TimeRange& times() const { return times_; }
  std::optional<double> time_spacing() const override { return usual_spacing(frames_); }
  std::optional<double> cell_size() const override {
    std::optional<double> smallest;
    for (const Frame& frame : frames_)
      if (const auto size = frame.field->cell_size())
        smallest = std::min(smallest.value_or(*size), *size);
    return smallest;
  }
  std::optional<double> sampling_error() const override {
    return sampling_error_.get([this] { return error_in_space() + error_in_time(); });
  }
  bool fills_domain() const override {
    return std::all_of(frames_.begin(), frames_.end(),
                       [](const Frame& frame) { return frame.field->fills_domain(); });
  }
  std::string description() const override { return description_; }

 private:
  double error_in_space() const {
    double largest = 0;
    for (const Frame& frame : frames_)
      largest = std::max(largest, frame.field->sampling_error().value_or(0));
    return largest;
  }

  /// h²/8 |∂²v/∂t²| from three frames at a time, the largest over places spread evenly.
  double error_in_time() const {
    double largest = 0;
    const Box3 box = finite_domain();
    for (std::size_t k = 1; k + 1 < frames_.size(); ++k) {
      const auto before = frames_[k - 1].field->sampler(), at = frames_[k].field->sampler(),
                 after = frames_[k + 1].field->sampler();
      const double h1 = frames_[k].time - frames_[k - 1].time;
      const double h2 = frames_[k + 1].time - frames_[k].time;
      for (int i = 0; i < 2000; ++i) {
        const Vec3 x = spread_place(box, i);
        Vec3 v0, v1, v2;
        if (before->velocity(x, 0, v0) != SampleStatus::ok ||
            at->velocity(x, 0, v1) != SampleStatus::ok ||
            after->velocity(x, 0, v2) != SampleStatus::ok)
          continue;
        const Vec3 second = 2.0 * ((v2 - v1) / h2 - (v1 - v0) / h1) / (h1 + h2);
        const double gap = std::max(h1, h2);
        largest = std::max(largest, glm::length(second) * gap * gap / 8);
      }
    }
    return largest;
  }

  /// The domain; along an axis without an end, of a field that repeats itself, 1000 cells.
  Box3 finite_domain() const {
    Box3 box = domain();
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(box.max[axis] - box.min[axis]))
        box.min[axis] = 0, box.max[axis] = 1000 * cell_size().value_or(1);
    return box;
  }

  /// Place i of a low-discrepancy sequence in the box: multiples of the powers of 1/φ₃, the root of
  /// φ⁴ = φ + 1.
  static Vec3 spread_place(const Box3& box, int i) {
    const Vec3 s = glm::fract(double(i) * Vec3(0.8191725134, 0.6710436067, 0.5497004779));
    return box.min + (box.max - box.min) * s;
  }

  Frames frames_;
  TimeRange times_;
  std::string description_;
  Lazy<double> sampling_error_;
};

constexpr std::string_view series_ending = ".series";

void require_ascending(std::span<const double> times, const Path& path) {
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
      bad_file(path, fmt::format("its time number {} is {}, after {}; times have to ascend", i,
                                 times[i], i > 0 ? times[i - 1] : 0));
}

double time_of(const nlohmann::json& entry, std::size_t number, const Path& path) {
  if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string() ||
      !entry.contains("time") || !entry["time"].is_number())
    bad_file(path, fmt::format("files[{}]: expected {{\"name\": text, \"time\": number}}", number));
  return entry["time"];
}

std::unique_ptr<VectorField> read_frame(const SeriesEntry& entry, const Path& path,
                                        FileOptions options) {
  const FileFormatRow* format = file_format(entry.file.string());
  if (!format || format->ending == series_ending)
    bad_file(path, fmt::format("files[{}]: '{}'; accepted endings: {}, but no series in a series",
                               entry.number, entry.file.filename().string(), file_endings()));
  options.time.clear();  // of the series, not of its files
  std::unique_ptr<VectorField> field;
  try {
    field = read_file(entry.file, *format, options);
  } catch (const InputError& error) {
    bad_file(path, fmt::format("files[{}]: {}", entry.number, error.what()));
  }
  // At a time of the series it would be asked for a time of its own.
  if (!field->steady())
    bad_file(path, fmt::format("files[{}]: '{}' has several times of its own; accepted: files of "
                               "one time each",
                               entry.number, entry.file.filename().string()));
  return field;
}

std::unique_ptr<VectorField> read_series_field(const Path& path, const FileOptions& asked) {
  const FileOptions options = in_common(asked);
  const std::vector<SeriesEntry> entries = series_entries(path);
  std::vector<double> times;
  for (const SeriesEntry& entry : entries) times.push_back(entry.time);
  require_ascending(times, path);
  return field_over_times(times, options.time, path,
                          [&](std::size_t i) { return read_frame(entries[i], path, options); });
}

}  // namespace

std::vector<SeriesEntry> series_entries(const Path& path) {
  const nlohmann::json description = read_json(path);
  if (!description.is_object() || !description.contains("files") ||
      !description["files"].is_array() || description["files"].empty())
    bad_file(path, "expected {\"file-series-version\": \"1.0\", \"files\": [one or more]}");
  std::vector<SeriesEntry> entries;
  for (const nlohmann::json& entry : description["files"]) {
    const double time = time_of(entry, entries.size(), path);
    entries.push_back(
        {time, path.parent_path() / entry["name"].get<std::string>(), entries.size()});
  }
  std::ranges::stable_sort(entries, {}, &SeriesEntry::time);
  return entries;
}

std::unique_ptr<VectorField> make_series_field(std::vector<Frame> frames, const Path& path) {
  if (frames.size() == 1) return std::move(frames.front().field);
  std::string text = fmt::format("{}: {} times from t = {} to {}, the first {}",
                                 path.filename().string(), frames.size(), frames.front().time,
                                 frames.back().time, frames.front().field->description());
  return std::make_unique<SeriesField>(std::move(frames), std::move(text));
}

std::optional<TimeRange> times_of_series(const VectorField& field) {
  const auto* series = dynamic_cast<const SeriesField*>(&field);
  return series ? std::optional(series->times()) : std::nullopt;
}

std::unique_ptr<VectorField> field_over_times(
    std::span<const double> times, const std::string& wanted, const Path& path,
    const std::function<std::unique_ptr<VectorField>(std::size_t)>& frame_at) {
  if (!wanted.empty()) return frame_at(readers::chosen_time(times, wanted, path));
  if (times.size() == 1) return frame_at(0);
  require_ascending(times, path);
  Frames frames;
  for (std::size_t i = 0; i < times.size(); ++i) frames.push_back({times[i], frame_at(i)});
  return make_series_field(std::move(frames), path);
}

std::vector<FileFormatRow> series_formats() {
  return {{series_ending, "time series of files, as ParaView writes it", read_series_field}};
}

}  // namespace pellucid::fields
