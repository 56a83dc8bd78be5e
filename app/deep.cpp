// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/deep.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/parts/deep_outputs.h"
#include "compare/parts/trace_deep.h"
#include "core/error.h"
#include "core/files/json_text.h"

namespace pellucid::app {
namespace {

void print_crossings(const DeepRequest& request, const compare::DeepInfo& info,
                     const compare::DeepOutputs& outputs, const GlobalOptions& globals) {
  if (globals.json)
    fmt::print("{}\n", json_text({{"deep", request.deep},
                                  {"part", {info.part.part, info.part.count}},
                                  {"fragments", outputs.crossings()},
                                  {"max_layers", outputs.max_layers()}},
                                 2));
  else if (!globals.quiet)
    fmt::print("{}: {} crossings, at most {} in a pixel\n", request.deep, outputs.crossings(),
               outputs.max_layers());
}

void write(const DeepRequest& request, const compare::DeepInfo& info, const scene::Scene& scene,
           const groundtruth::RayProbe& probe, const Progress& progress,
           const GlobalOptions& globals, bool print) {
  compare::DeepOutputs outputs(info, request.picture, request.deep);
  compare::trace_deep(
      scene, probe, [&](int y, const compare::DeepRow& row) { outputs.take(y, row); }, progress);
  report(progress, 1, "deep picture");
  outputs.commit();
  if (print) print_crossings(request, info, outputs, globals);
}

}  // namespace

void check_deep(const scene::Scene& scene) {
  if (!scene.samples.is_center())
    throw InputError(fmt::format("--deep: the scene takes {}; accepted: samples 1",
                                 scene::describe(scene.samples)));
}

void write_deep(const DeepRequest& request, const scene::Scene& scene, const Progress& progress,
                const GlobalOptions& globals, bool print) {
  check_deep(scene);
  write(request, compare::deep_info(scene, {}, request.source), scene, groundtruth::RayProbe(scene),
        progress, globals, print);
}

void write_part(const DeepRequest& request, const groundtruth::ScenePart& part,
                const Progress& progress, const GlobalOptions& globals) {
  check_deep(part.scene);
  write(request, compare::deep_info(part.scene, part.whole.part, request.source), part.scene,
        groundtruth::RayProbe(part), progress, globals, true);
}

}  // namespace pellucid::app
