// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/sums/draw_sums.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compare/methods/methods.h"
#include "compare/parts/load_part.h"
#include "compare/parts/scene_fingerprint.h"
#include "compare/sums/merge_sums.h"
#include "core/error.h"
#include "core/files/files_read.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// Throws unless the method's pictures are sums.
void check_adds_up(const MethodCall& call) {
  if (call.row->promises.adds_up) return;
  std::vector<std::string_view> names;
  for (const scene::MethodRow& row : methods())
    if (row.promises.adds_up) names.push_back(row.name);
  throw InputError(fmt::format(
      "--partial: the method is '{}', whose pictures are no sums; accepted: {}; of raytrace --deep",
      call.text(), fmt::join(names, ", ")));
}

SumsFile sums_of(const SumsRequest& request, const std::string& fingerprint,
                 const groundtruth::ScenePart& part, const SumsFile* totals) {
  const auto renderer = request.call.row->make(
      part.scene, request.call.parameters,
      {.gl = request.gl, .depths = &part.whole.depths, .part = &part.whole.part});
  scene::PartialSums* const sums = renderer->partial_sums();
  SumsFile file;
  file.info = {
      deep_info(part.scene, request.part, {fingerprint, {}, request.view.without_background}),
      without_dots(fs::absolute(request.scene)).string(),
      request.call.text(),
      totals ? 2 : 1,
      sums->phases(),
      part.whole.depths};
  if (totals) check_totals("--totals", totals->info, request.scene, file.info);
  file.planes = sums->sum(file.info.phase - 1,
                          totals ? std::span(&totals->planes, 1) : std::span<scene::SumPlanes>());
  file.behind = sums->behind();
  return file;
}

/// The view of sums, as a scene file is looked at.
scene::ViewRequest view_of(const SumsInfo& info) {
  scene::ViewRequest view;
  view.camera = info.of.camera;
  view.resolution = {info.of.width, info.of.height};
  view.samples = 1;
  view.background = backdrop(info.of);
  view.without_background = !info.of.background;
  return view;
}

/// A scene without objects, of the size and background of a picture.
scene::Scene empty_scene(const SumsInfo& info) {
  scene::Scene scene;
  scene.name = info.of.scene;
  scene.width = info.of.width;
  scene.height = info.of.height;
  scene.background = backdrop(info.of);
  return scene;
}

}  // namespace

SumsFile draw_sums(const SumsRequest& request, const SumsFile* totals, const Progress& progress) {
  check_adds_up(request.call);
  const FilesRead read;
  const groundtruth::ScenePart part = load_part(request.scene, progress, request.view, request.part,
                                                scene::PartOf::transparent_objects, request.bounds);
  report(progress, 0.5, fmt::format("summing up {}", request.call.row->name));
  const std::string fingerprint =
      request.bounds ? request.bounds->fingerprint : scene_fingerprint(read.paths(), "");
  SumsFile sums = sums_of(request, fingerprint, part, totals);
  report(progress, 1, "summed up");
  return sums;
}

SumsFile draw_second_phase(const SumsFile& totals, int parts, const std::string& gl,
                           const Progress& progress) {
  const SumsInfo& info = totals.info;
  SumsRequest request{info.scene_file, view_of(info), parse_call(info.method), {}, gl};
  SumsAdder adder;
  for (int number = 1; number <= parts; ++number) {
    report(progress, double(number - 1) / parts,
           fmt::format("drawing part {} of {} again", number, parts));
    request.part = {number, parts};
    adder.add(request.scene, draw_sums(request, &totals, {}));
  }
  return adder.total();
}

Image composite_sums(std::span<const SumsFile> totals, const std::string& gl) {
  const SumsInfo& info = totals.front().info;
  const scene::Scene scene = empty_scene(info);
  const MethodCall call = parse_call(info.method);
  check_adds_up(call);
  const auto renderer = call.row->make(
      scene, call.parameters, {.gl = gl, .depths = &info.depths, .behind = &totals.front().behind});
  std::vector<scene::SumPlanes> planes;
  for (const SumsFile& file : totals) planes.push_back(file.planes);
  return renderer->partial_sums()->composite(planes);
}

}  // namespace pellucid::compare
