// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_content.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compare/cells/cell.h"
#include "compare/figure/figure_maps.h"
#include "compare/methods/methods.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/image_file.h"
#include "compare/report/crop.h"
#include "core/error.h"
#include "core/options/split.h"

namespace pellucid::compare {
namespace {

Image read_picture(const PastRun& run, const ResultRow& row) {
  const std::filesystem::path file = CellFiles(run.folder, row).picture();
  if (!std::filesystem::exists(file))
    throw InputError(fmt::format("{}: is missing; accepted: a folder of results with its pictures",
                                 file.string()));
  return read_image(file);
}

std::vector<Image> read_pictures(const PastRun& run, const FigureRows& scene) {
  std::vector<Image> pictures;
  for (const ResultRow& row : scene.rows) {
    pictures.push_back(read_picture(run, row));
    const Image &first = pictures.front(), &last = pictures.back();
    if (last.width != first.width || last.height != first.height)
      throw InputError(fmt::format("{}: {}×{} pixels; accepted: {}×{} as the scene's first picture",
                                   CellFiles(run.folder, row).picture().string(), last.width,
                                   last.height, first.width, first.height));
  }
  return pictures;
}

/// The reference, where something is held against it.
Image read_reference(const PastRun& run, const FigureRows& scene, const Image& first) {
  if (!scene.reference)
    throw InputError(
        fmt::format("{}: the reference of {} has no picture; accepted: no --error, --flip",
                    run.folder.string(), scene.scene));
  Image reference = read_picture(run, *scene.reference);
  if (reference.width != first.width || reference.height != first.height)
    throw InputError(fmt::format("{}: the reference of {} has {}×{} pixels, the others {}×{}",
                                 run.folder.string(), scene.scene, reference.width,
                                 reference.height, first.width, first.height));
  return reference;
}

/// Where the pictures differ most from the first: the reference, mostly.
Crop most_different(const std::vector<Image>& pictures) {
  const Image& first = pictures.front();
  Raster<double> error(first.width, first.height);
  for (const Image& picture : pictures)
    for (std::size_t i = 0; i < error.pixels.size(); ++i)
      error.pixels[i] += pixel_error(first.pixels[i], picture.pixels[i]);
  return worst_crop(error);
}

std::vector<Crop> crops_of(const FigureRequest& request, const std::string& scene,
                           const std::vector<Image>& pictures) {
  std::vector<Crop> crops;
  for (const FigureCrop& asked : request.crops)
    if (asked.scene.empty() || asked.scene == scene) {
      require_inside(asked.crop, pictures.front().width, pictures.front().height);
      crops.push_back(asked.crop);
    }
  if (crops.empty() && request.own_crops) crops.push_back(most_different(pictures));
  return crops;
}

FigureStrip read_strip(const PastRun& run, const FigureRows& scene, const FigureRequest& request) {
  FigureStrip strip;
  strip.pictures = read_pictures(run, scene);
  strip.crops = crops_of(request, scene.scene, strip.pictures);
  strip.numbers = figure_numbers(scene, request.numbers);
  if (!request.errors && !request.flips) return strip;
  const Image reference = read_reference(run, scene, strip.pictures.front());
  std::vector<bool> is_reference;
  for (const ResultRow& row : scene.rows) is_reference.push_back(row.reference);
  if (request.errors)
    strip.lines_of_maps.push_back(error_maps(reference, strip.pictures, is_reference));
  if (request.flips)
    strip.lines_of_maps.push_back(flip_maps(reference, strip.pictures, is_reference));
  return strip;
}

FigureHeading heading_of(const ResultRow& row) {
  const auto known = std::ranges::find(methods(), row.method, &scene::MethodRow::name);
  const std::string title(known == methods().end() || !row.given.empty() ? row.method
                                                                         : known->title);
  return {title, fmt::format("{}", fmt::join(split(row.parameters, ','), ", "))};
}

void check_crops(const std::vector<FigureRows>& scenes, const FigureRequest& request) {
  for (const FigureCrop& crop : request.crops)
    if (!crop.scene.empty() &&
        std::ranges::find(scenes, crop.scene, &FigureRows::scene) == scenes.end())
      throw InputError(
          fmt::format("--crop: '{}' is no scene of the figure; accepted: X,Y,WIDTH,HEIGHT or "
                      "SCENE=X,Y,WIDTH,HEIGHT",
                      crop.scene));
}

}  // namespace

std::vector<FigureHeading> figure_headings(const FigureRows& scene, const FigureRequest& request) {
  std::vector<FigureHeading> headings;
  for (const std::string& label : request.labels) headings.push_back({label, ""});
  if (headings.empty())
    for (const ResultRow& row : scene.rows) headings.push_back(heading_of(row));
  if (headings.size() != scene.rows.size())
    throw InputError(fmt::format("--label: {} are given; accepted: {}, one for each picture",
                                 headings.size(), scene.rows.size()));
  return headings;
}

std::vector<std::string> scene_labels(const std::vector<FigureRows>& scenes,
                                      const FigureRequest& request) {
  if (!request.scene_labels.empty() && request.scene_labels.size() != scenes.size())
    throw InputError(fmt::format("--scene-label: {} are given; accepted: {}, one for each scene",
                                 request.scene_labels.size(), scenes.size()));
  std::vector<std::string> labels = request.scene_labels;
  if (labels.empty())
    for (const FigureRows& scene : scenes) labels.push_back(scenes.size() > 1 ? scene.scene : "");
  return labels;
}

FigureContent read_figure(const PastRun& run, const FigureRequest& request) {
  const std::vector<FigureRows> scenes = find_figure_rows(run, request);
  check_crops(scenes, request);
  FigureContent content{figure_headings(scenes.front(), request), {}};
  const std::vector<std::string> labels = scene_labels(scenes, request);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    content.strips.push_back(read_strip(run, scenes[i], request));
    content.strips.back().label = labels[i];
  }
  return content;
}

}  // namespace pellucid::compare
