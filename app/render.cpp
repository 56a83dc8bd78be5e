// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/commands.h"
#include "app/deep.h"
#include "app/drawn_picture.h"
#include "app/part_number.h"
#include "app/sums.h"
#include "compare/methods/methods.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/parts/load_part.h"
#include "compare/parts/scene_fingerprint.h"
#include "compare/pictures/image_file.h"
#include "compare/pictures/sums_file.h"
#include "compare/results/probe_json.h"
#include "compare/sums/draw_sums.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/files/output_file.h"
#include "core/options/split.h"
#include "scene/files/scene_file.h"

namespace pellucid::app {
namespace {

struct RenderOptions {
  std::string scene, method, opacities, output, stats, layers, probe_output, sums, deep, part,
      partial, totals, bounds;
  std::vector<int> probe;  // x, y, x, y, …
  scene::ViewRequest view;
  bool explain = false;
  bool tiles = false;
};

void print_summary(const RenderOptions& options, const scene::Scene& scene,
                   const scene::RenderStats& stats) {
  std::cout << fmt::format("{}: {:.1f} ms, {:.2f} MB, {} fragments, at most {} layers\n",
                           options.output, 1e3 * stats.seconds(), 1e-6 * stats.total_bytes(),
                           stats.fragments, stats.max_layers);
  for (const scene::SceneObject& object : scene.objects)
    for (const std::string& remark : object.vertices().remarks)
      std::cout << fmt::format("note: {}: {}\n", object.name, remark);
}

/// Appends x and y of "X,Y".
void add_pixel(const std::string& text, std::vector<int>& numbers) {
  const std::vector<std::string_view> parts = split(text, ',');
  for (const std::string_view part : parts) {
    const char* const end = part.data() + part.size();
    int number = 0;
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    if (parts.size() != 2 || error != std::errc() || stop != end)
      throw InputError(fmt::format("--probe {}; accepted: a pixel X,Y, two whole numbers", text));
    numbers.push_back(number);
  }
}

/// What is asked for beside the picture: it is exact, whatever the method.
void write_exact_sums(const RenderOptions& options, const scene::Scene& scene,
                      const compare::PictureForm& form, const Progress& progress) {
  if (!options.probe.empty())
    write_text(options.probe_output,
               json_text(compare::probe_json(scene, options.probe), 2) + '\n');
  if (options.sums.empty()) return;
  const groundtruth::RayProbe probe(scene);
  compare::write_sums(options.sums, groundtruth::picture_sums(scene, probe, progress), form);
}

std::optional<compare::SceneBounds> known_bounds(const RenderOptions& options) {
  if (options.bounds.empty()) return std::nullopt;
  return compare::read_bounds(options.bounds);
}

/// Draws a part of the scene. `read` lists what is read meanwhile.
void render_part(const RenderOptions& options, const GlobalOptions& globals,
                 const compare::MethodCall& call, const FilesRead& read) {
  if (call.row->name != "raytrace" || !call.parameters.given().empty())
    throw InputError(fmt::format("--part: the method is '{}'; accepted: raytrace", call.text()));
  const scene::PartNumber number = part_number_of(options.part);
  const Progress progress = console_progress(globals);
  const std::optional<compare::SceneBounds> bounds = known_bounds(options);
  const groundtruth::ScenePart part =
      compare::load_part(options.scene, progress, options.view, number, scene::PartOf::all_objects,
                         bounds ? &*bounds : nullptr);
  const compare::DeepSource source{
      bounds ? bounds->fingerprint : compare::scene_fingerprint(read.paths(), ""), "",
      options.view.without_background};
  write_part({options.deep, options.output, source}, part, progress, globals);
}

/// Sums up over a part of the scene, or all of it.
void write_partial(const RenderOptions& options, const GlobalOptions& globals,
                   const compare::MethodCall& call) {
  const scene::PartNumber part =
      options.part.empty() ? scene::PartNumber() : part_number_of(options.part);
  std::optional<compare::SumsFile> totals;
  if (!options.totals.empty()) totals = compare::read_sums_file(options.totals);
  const std::optional<compare::SceneBounds> bounds = known_bounds(options);
  const compare::SumsFile sums = compare::draw_sums(
      {options.scene, options.view, call, part, globals.gl, bounds ? &*bounds : nullptr},
      totals ? &*totals : nullptr, console_progress(globals));
  compare::write_sums_file(options.partial, sums);
  print_sums(options.partial, sums.info, globals);
}

/// Refuses what --tiles cannot do, and sizes that only it can.
void check_tiles(const RenderOptions& options, const compare::MethodCall& call) {
  const auto& size = options.view.resolution;
  if (size && !options.tiles && std::max((*size)[0], (*size)[1]) > largest_side)
    throw InputError(
        fmt::format("--resolution: {}x{}; accepted: 1 … {} pixels, with --tiles 1 … {}", (*size)[0],
                    (*size)[1], largest_side, largest_tiled_side));
  if (!options.tiles) return;
  if (call.row->name != "raytrace")
    throw InputError(fmt::format("--tiles: the method is '{}'; accepted: raytrace", call.text()));
  if (!options.output.ends_with(".exr"))
    throw InputError(fmt::format("--tiles: {}; accepted: an .exr", options.output));
}

void write_picture(const RenderOptions& options, const GlobalOptions& globals,
                   const DrawnPicture& drawn, const scene::Scene& scene,
                   const compare::PictureForm& form) {
  if (!options.tiles) compare::write_image(options.output, drawn.rendering.image, form);
  if (!options.layers.empty()) compare::write_counts(options.layers, drawn.rendering.layers, form);
  const std::string json = json_text(drawn.json, 2) + '\n';
  if (!options.stats.empty()) write_text(options.stats, json);
  if (globals.json) {
    std::cout << json;
    return;
  }
  for (const std::string& line : drawn.explanation) std::cout << line << '\n';
  print_summary(options, scene, drawn.rendering.stats);
}

/// Whether no picture is asked for, but what parts have to know of the scene.
bool asks_for_bounds(const RenderOptions& options) {
  return !options.bounds.empty() && options.part.empty() && options.output.empty() &&
         options.deep.empty() && options.partial.empty();
}

void write_bounds(const RenderOptions& options, const GlobalOptions& globals) {
  const compare::SceneBounds bounds =
      compare::measure_bounds(options.scene, options.view, console_progress(globals));
  compare::write_bounds(options.bounds, bounds);
  if (!globals.quiet)
    std::cout << fmt::format(
        "{}: {} objects, {} elements to share out\n", options.bounds, bounds.counts.size(),
        std::accumulate(bounds.counts.begin(), bounds.counts.end(), std::uint64_t(0)));
}

void check_part(const RenderOptions& options) {
  if (!options.bounds.empty() && options.part.empty())
    throw CLI::RequiresError("--bounds", "--part, or no output at all");
  if (!options.part.empty() && options.deep.empty() && options.partial.empty())
    throw CLI::RequiresError("--part", "--deep or --partial");
}

void render(const RenderOptions& options, const GlobalOptions& globals) {
  if (asks_for_bounds(options)) {
    const ProtectedInputs inputs;
    return write_bounds(options, globals);
  }
  check_part(options);
  if (options.method.empty()) throw CLI::RequiredError("-m,--method");
  if (options.output.empty() && options.deep.empty() && options.partial.empty())
    throw CLI::RequiredError("-o,--output");
  const ProtectedInputs inputs;
  const FilesRead read;
  const compare::MethodCall call = compare::parse_call(options.method);
  check_tiles(options, call);
  if (!options.partial.empty()) return write_partial(options, globals, call);
  if (!options.part.empty()) return render_part(options, globals, call, read);
  const std::optional<compare::MethodCall> opacities = compare::parse_opacities(options.opacities);
  const Progress progress = console_progress(globals);
  scene::Scene scene = scene::load_scene(options.scene, progress, options.view);
  if (!options.deep.empty()) check_deep(scene);
  if (opacities) {
    report(progress, 0.3, "optimizing opacities");
    compare::optimize_opacities(*opacities, {.gl = globals.gl}, scene,
                                compare::further_samplings({&call, 1}));
  }
  // Whatever may refuse the call comes before the first file.
  const std::string opacities_text = opacities ? opacities->text() : "";
  const bool without_background = options.view.without_background;
  const compare::PictureForm form =
      compare::form_of_picture(scene, {call.text(), opacities_text, without_background});
  const DrawRequest request{call, opacities, scene, options.explain};
  std::optional<DrawnPicture> drawn;
  if (options.tiles)
    drawn = draw_tiles(request, options.output, form, progress);
  else if (!options.output.empty())
    drawn = draw_picture(request, globals, progress);
  write_exact_sums(options, scene, form, progress);
  if (!options.deep.empty())
    write_deep({options.deep,
                {},
                {compare::scene_fingerprint(read.paths(), options.opacities), opacities_text,
                 without_background}},
               scene, progress, globals, options.output.empty());
  if (drawn) write_picture(options, globals, *drawn, scene, form);
}

}  // namespace

void add_render_command(CLI::App& app, GlobalOptions& globals) {
  CLI::App* command = app.add_subcommand("render", "Render one picture of a scene by one method");
  const auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "Scene file")->required();
  command->add_option("-m,--method", options->method,
                      "NAME[:key=value,...]; see 'list methods'; needed for all but --bounds");
  CLI::Option* output = command
                            ->add_option("-o,--output", options->output,
                                         "Picture: .exr (32-bit float) or .png; only with "
                                         "--deep or --partial may it be left out")
                            ->check(ending_among({".exr", ".png"}));
  CLI::Option* stats =
      command->add_option("--stats", options->stats, "Write times, bytes and counts as JSON");
  CLI::Option* layers =
      command
          ->add_option("--layers", options->layers,
                       "Write the number of crossings per pixel; of 'tree', of the layers that "
                       "it has merged them into")
          ->check(ending_among({".exr", ".png"}));
  CLI::Option* probe = command->add_option_function<std::vector<std::string>>(
      "--probe",
      [options](const std::vector<std::string>& pixels) {
        for (const std::string& pixel : pixels) add_pixel(pixel, options->probe);
      },
      "Pixel X,Y whose crossings are wanted; may be given again");
  probe->allow_extra_args(false)->type_name("X,Y");
  CLI::Option* probe_output =
      command->add_option("--probe-out", options->probe_output,
                          "Write the exact crossings and sums along the probes' rays as JSON");
  probe->needs(probe_output);
  probe_output->needs(probe);
  CLI::Option* sums =
      command
          ->add_option(
              "--sums", options->sums,
              "Write the exact sums of every pixel as channels of an .exr: layers, coverage, "
              "transmittance, G, tau, nearest and farthest depth")
          ->check(ending_among({".exr"}));
  CLI::Option* deep = command
                          ->add_option("--deep", options->deep,
                                       "Write every crossing of every pixel: a deep .exr, or .npz "
                                       "for NumPy")
                          ->check(ending_among({".exr", ".npz"}));
  CLI::Option* part = command->add_option("--part", options->part,
                                          "I/N: with --deep or --partial, draw only the I-th of N "
                                          "parts of the primitives, for 'merge'");
  command->add_option(
      "--bounds", options->bounds,
      "Without an output: write what parts have to know of the whole scene, as JSON. With --part: "
      "read it, so that no object is read of which the part has nothing");
  CLI::Option* partial =
      command
          ->add_option("--partial", options->partial,
                       "Write what the method sums up, as channels of an .exr, in the place of a "
                       "picture: 'merge' adds the parts' up and composites them")
          ->check(ending_among({".exr"}));
  CLI::Option* totals = command->add_option(
      "--totals", options->totals,
      "With --partial, of a method of two phases: draw the second, given the first one's totals "
      "over all parts (merge --partial FILE)");
  CLI::Option* tiles =
      command->add_flag("--tiles", options->tiles,
                        fmt::format("With raytrace, a row of tiles at a time into a tiled .exr: up "
                                    "to {0} x {0} pixels, a picture larger than the memory",
                                    largest_tiled_side));
  add_view_options(*command, options->view, largest_tiled_side);
  CLI::Option* opacities = add_opacities_option(*command, options->opacities);
  CLI::Option* explain =
      command->add_flag("--explain", options->explain,
                        "Print what was modelled and left out, and why; with --json "
                        "as its 'explanation'");
  totals->needs(partial);
  tiles->needs(output);
  for (CLI::Option* of_memory : {deep, part, sums, probe, layers, opacities})
    tiles->excludes(of_memory);
  for (CLI::Option* of_picture : {output, deep, sums, probe, stats, layers, explain})
    partial->excludes(of_picture);
  for (CLI::Option* of_method : {stats, layers, explain}) {
    of_method->needs(output);
    part->excludes(of_method);
  }
  for (CLI::Option* of_whole : {probe, sums, opacities}) part->excludes(of_whole);
  partial->excludes(opacities);
  command->footer(
      "Examples:\n  pellucid render scene.json -m raytrace -o picture.exr\n"
      "  pellucid render scene.json -m fourier:bands=5 -o a.png --view +x --resolution 640x480\n"
      "  pellucid render scene.json --bounds bounds.json\n"
      "  pellucid render scene.json -m raytrace --deep part-1.exr --part 1/8 --bounds bounds.json\n"
      "  pellucid render scene.json -m fourier --partial part-1.exr --part 1/8");
  add_gl_option(*command, globals);
  add_global_options(*command, globals);
  command->callback([options, &globals] { render(*options, globals); });
}

}  // namespace pellucid::app
