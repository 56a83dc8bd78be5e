// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/cell_estimate.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/files/json_text.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// These rules of thumb are of two cores without a graphics card; docs/cluster.md says what they
// were measured on.
constexpr double seconds_to_start = 1;
constexpr double seconds_per_byte_read = 2e-8;
constexpr double seconds_per_sample = 3e-7;            // of a picture of some ten layers
constexpr double seconds_per_pixel_compared = 1.5e-6;  // metrics, maps and files of a picture
constexpr double bytes_to_start = 1.5e8;               // the program and its libraries
constexpr double bytes_per_byte_read = 8;              // geometry and hierarchy
constexpr double bytes_per_pixel_compared = 200;       // pictures and what metrics are made of
constexpr double bytes_per_sample = 150;               // of a method that keeps some ten layers

json value_at(const json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object.at(key) : json();
}

/// What is no number is for the scene's reader to refuse.
double number_or(const json& value, double otherwise) {
  return value.is_number() ? value.get<double>() : otherwise;
}

double pixels_of(const json& scene) {
  const json sides = value_at(scene, "resolution");
  const scene::Scene usual;
  if (!sides.is_array() || sides.size() != 2) return double(usual.width) * usual.height;
  return number_or(sides[0], usual.width) * number_or(sides[1], usual.height);
}

double samples_of(const json& scene) {
  const json samples = value_at(scene, "samples");
  const double per_axis = number_or(samples, 1);
  return number_or(value_at(samples, "frames"), per_axis * per_axis);
}

double views_of(const json& scene, const Views& views) {
  if (views.path) return number_or(value_at(value_at(scene, "camera_path"), "frames"), 1);
  if (!views.cameras.empty()) return double(views.cameras.size());
  return views.orbit > 0 ? views.orbit : 1;
}

/// Texts that are files, seen from the scene's folder, are what it reads.
double bytes_named(const json& value, const fs::path& folder) {
  double bytes = 0;
  if (value.is_string()) {
    std::error_code code;
    const fs::path file = folder / value.get<std::string>();
    if (fs::is_regular_file(file, code)) bytes = double(fs::file_size(file, code));
  }
  if (value.is_structured())
    for (const json& part : value) bytes += bytes_named(part, folder);
  return bytes;
}

/// A picture after another, of which the first is not timed.
double seconds_of_pictures(const SceneSize& size, const TimingRule& timing,
                           const ResultRow* known) {
  const double picture =
      known ? known->seconds.median : seconds_per_sample * size.pixels * size.samples;
  const double first = known ? known->first_frame_seconds() : picture;
  const int repeats = known ? std::max(known->repeats, timing.min) : timing.min;
  const double timed = repeats * picture;
  return first + (timing.seconds ? std::min(timed, std::max(*timing.seconds, picture)) : timed);
}

}  // namespace

SceneSize scene_size(const fs::path& scene_file, const Views& views) {
  const json scene = read_json(scene_file);
  return {pixels_of(scene), samples_of(scene), views_of(scene, views),
          double(fs::file_size(scene_file)) + bytes_named(scene, scene_file.parent_path())};
}

CellEstimate estimate_cell(const SceneSize& size, const TimingRule& timing,
                           const ResultRow* known) {
  const double of_method =
      known ? double(known->total_bytes()) : bytes_per_sample * size.pixels * size.samples;
  return {seconds_to_start + seconds_per_byte_read * size.bytes_read +
              size.views * (seconds_of_pictures(size, timing, known) +
                            seconds_per_pixel_compared * size.pixels),
          bytes_to_start + bytes_per_byte_read * size.bytes_read +
              bytes_per_pixel_compared * size.pixels + of_method};
}

}  // namespace pellucid::compare
