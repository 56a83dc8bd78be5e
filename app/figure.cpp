// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "compare/figure/plots/write_plot.h"
#include "compare/figure/write_figure.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "core/options/parameters.h"
#include "core/options/split.h"

namespace pellucid::app {
namespace {

namespace fs = std::filesystem;

struct FigureArguments {
  fs::path results, output;
  std::vector<std::string> crops, numbers;
  bool table = false;
  std::string width = std::string(compare::figure_widths().front().name);
  compare::FigureRequest request;
  compare::PlotRequest plot;
  std::string logarithmic;
  compare::FigureStyle style;
};

/// Parts of all texts between commas.
std::vector<std::string> all_parts(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const std::string& text : texts)
    for (const std::string_view part : split(text, ',')) parts.emplace_back(part);
  return parts;
}

[[noreturn]] void refuse_crop(const std::string& text) {
  throw InputError(fmt::format(
      "--crop: '{}'; accepted: X,Y,WIDTH,HEIGHT or SCENE=X,Y,WIDTH,HEIGHT in whole pixels, or none",
      text));
}

/// A scene's name may hold an '=': what follows the last one are the numbers.
compare::FigureCrop crop_of_text(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::string scene = equals == text.npos ? "" : text.substr(0, equals);
  const std::string_view numbers = std::string_view(text).substr(equals + 1);
  const std::vector<std::string_view> parts = split(numbers, ',');
  if (parts.size() != 4) refuse_crop(text);
  std::array<int, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) {
    double value = 0;
    if (!parse_number(parts[i], value) || !(value >= 0 && value <= 1 << 24) || value != int(value))
      refuse_crop(text);
    values[i] = int(value);
  }
  return {scene, {values[0], values[1], values[2], values[3]}};
}

compare::FigureRequest request_of(const FigureArguments& arguments) {
  compare::FigureRequest request = arguments.request;
  if (!arguments.numbers.empty()) request.numbers = all_parts(arguments.numbers);
  std::erase(request.numbers, "none");
  for (const std::string& crop : arguments.crops)
    if (crop == "none")
      request.own_crops = false;
    else
      request.crops.push_back(crop_of_text(crop));
  return request;
}

nlohmann::ordered_json to_json(const compare::WrittenFigure& figure) {
  nlohmann::ordered_json json{{"files", nlohmann::json::array()},
                              {"scenes", nlohmann::json::array()}};
  if (figure.width > 0) json["width_mm"] = figure.width / 72 * 25.4;
  if (figure.width > 0) json["height_mm"] = figure.height / 72 * 25.4;
  for (const fs::path& file : figure.files) json["files"].push_back(file.string());
  for (std::size_t i = 0; i < figure.rows.size(); ++i) {
    nlohmann::ordered_json scene{{"name", figure.rows[i].scene},
                                 {"methods", nlohmann::json::array()},
                                 {"crops", nlohmann::json::array()}};
    for (const compare::ResultRow& row : figure.rows[i].rows)
      scene["methods"].push_back(row.call());
    if (i < figure.crops.size())
      for (const compare::Crop& crop : figure.crops[i])
        scene["crops"].push_back({crop.x, crop.y, crop.width, crop.height});
    json["scenes"].push_back(scene);
  }
  return json;
}

void print_written(const compare::WrittenFigure& figure) {
  for (const fs::path& file : figure.files)
    fmt::print("{}{}\n", file.string(),
               figure.width > 0 ? fmt::format(": {:.1f} × {:.1f} mm", figure.width / 72 * 25.4,
                                              figure.height / 72 * 25.4)
                                : "");
  for (std::size_t i = 0; i < figure.crops.size(); ++i)
    for (const compare::Crop& crop : figure.crops[i])
      fmt::print("  --crop {}={},{},{},{}\n", figure.rows[i].scene, crop.x, crop.y, crop.width,
                 crop.height);
}

compare::PlotRequest plot_of(const FigureArguments& arguments) {
  compare::PlotRequest plot = arguments.plot;
  plot.scenes = all_parts(arguments.request.scenes);
  plot.methods = arguments.request.methods;
  plot.logarithmic_x = arguments.logarithmic.find('x') != std::string::npos;
  plot.logarithmic_y = arguments.logarithmic.find('y') != std::string::npos;
  return plot;
}

compare::WrittenFigure write(const FigureArguments& arguments, const compare::FigureStyle& style,
                             const GlobalOptions& globals) {
  const compare::FigureRequest request = request_of(arguments);
  const compare::PastRun run = compare::read_past_run(arguments.results);
  if (!arguments.plot.kind.empty())
    return compare::write_plot(arguments.output, run, plot_of(arguments), style);
  const auto write = arguments.table ? compare::write_figure_table : compare::write_figure;
  return write(arguments.output, run, request, style, globals.command_line);
}

void draw_figure(const FigureArguments& arguments, const GlobalOptions& globals) {
  const ProtectedInputs protected_inputs;
  compare::FigureStyle style = arguments.style;
  style.width = compare::width_of_text(arguments.width);
  const compare::WrittenFigure figure = write(arguments, style, globals);
  if (globals.json)
    fmt::print("{}\n", json_text(to_json(figure), 1));
  else if (!globals.quiet)
    print_written(figure);
}

std::string names_of_widths() {
  std::string names;
  for (const compare::FigureWidth& width : compare::figure_widths())
    names += fmt::format("{} ({}, {} mm), ", width.name, width.title, width.millimetres);
  return names;
}

/// An option that is given again for each further text, and takes one at a time: what follows may
/// be a file's name.
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
                      const std::string& help) {
  return command.add_option(name, texts, help)->allow_extra_args(false);
}

void add_content_options(CLI::App& command, FigureArguments& arguments) {
  compare::FigureRequest& request = arguments.request;
  add_list(command, "--scene", request.scenes, "Scenes, a line each: NAME[,NAME…]; else all");
  add_list(command, "--methods", request.methods,
           "Columns: CALL[,CALL…], or a method's name for all of its calls; else all");
  add_list(command, "--crop", arguments.crops,
           "Part to enlarge, of every scene or of one: [SCENE=]X,Y,WIDTH,HEIGHT in pixels; may be "
           "given again; or none; else where the methods differ most");
  add_list(command, "--numbers", arguments.numbers,
           "Columns of results.csv to print below each picture: NAME[,NAME…], or none; else ssim, "
           "rmse, seconds, bytes");
  command.add_flag("--table", arguments.table,
                   "The numbers alone, with their intervals, as a table of LaTeX: -o FILE.tex");
  command.add_flag("--error", request.errors, "Add a line of error maps, with their scale");
  command.add_flag("--flip", request.flips, "Add a line of FLIP's maps, with their scale");
  add_list(command, "--label", request.labels,
           "Text above a column, in the place of the method's title; once for each column");
  add_list(command, "--scene-label", request.scene_labels,
           "Text beside a scene, in the place of its name; once for each scene");
}

void add_plot_options(CLI::App& command, FigureArguments& arguments) {
  compare::PlotRequest& plot = arguments.plot;
  plot.kind.clear();  // pictures
  const char* const pictures[] = {"--crop", "--numbers", "--table", "--error", "--flip"};
  CLI::Option* kind = command.add_option(
      "--plot", plot.kind,
      "Plot numbers in place of pictures, a panel for each scene: trade-off; sweep:METHOD, over "
      "the "
      "parameter in which its calls differ; curves:NAME (\"layer error\", …). -o FILE.csv has the "
      "points");
  for (const char* other : pictures) kind->excludes(other);
  command.add_option("--x", plot.x, "Cost of a trade-off: a column of results.csv")
      ->needs(kind)
      ->capture_default_str();
  command.add_option("--y", plot.y, "Number of a trade-off or a sweep: a column of results.csv")
      ->needs(kind)
      ->capture_default_str();
  command.add_option("--log", arguments.logarithmic, "Logarithmic axes of sweeps and curves")
      ->needs(kind)
      ->check(CLI::IsMember({"x", "y", "xy"}));
}

void add_style_options(CLI::App& command, FigureArguments& arguments) {
  compare::FigureStyle& style = arguments.style;
  command.add_option("--width", arguments.width, names_of_widths() + "or millimetres")
      ->capture_default_str();
  command.add_option("--font", style.font, "Families of the font, the first that is there")
      ->capture_default_str();
  command.add_option("--font-size", style.font_size, "Of the labels, points; numbers are smaller")
      ->check(finite_number() & CLI::Range(4.0, 40.0))
      ->capture_default_str();
  command.add_option("--dpi", style.dots_per_inch, "Dots per inch of a PNG")
      ->check(CLI::Range(30, 1200))
      ->capture_default_str();
}

}  // namespace

void add_figure_command(CLI::App& app, GlobalOptions& globals) {
  const auto arguments = std::make_shared<FigureArguments>();
  CLI::App* command = app.add_subcommand(
      "figure", "Draw a paper's figure of a study: pictures side by side, with insets, or a plot");
  command->add_option("RESULTS", arguments->results, "The folder that a study has filled")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "FILE.pdf, .svg, .png, or .tex with FILE-pictures.pdf beside it")
      ->required();
  add_content_options(*command, *arguments);
  add_plot_options(*command, *arguments);
  add_style_options(*command, *arguments);
  command->footer(
      "Examples:\n  pellucid figure results/quickstart -o figure.pdf\n"
      "  pellucid figure results/blending --scene trefoil,tornado \\\n"
      "    --methods linked-list,weighted-average,weighted-blended \\\n"
      "    --methods binning:bins=11,mode=linear,fourier:bands=5 -o figure-7.tex\n"
      "the layout of Fig. 7 of Baeza Rojo et al. 2019, from the study of that name.\n"
      "  pellucid figure results/blending --table --numbers ssim,rmse,seconds -o table.tex\n"
      "  pellucid figure results/quickstart --plot trade-off --x bytes --width ieee -o memory.pdf\n"
      "  pellucid figure results/quickstart --plot \"curves:layer error\" --log xy -o layers.pdf");
  add_global_options(*command, globals);
  command->callback([arguments, &globals] { draw_figure(*arguments, globals); });
}

}  // namespace pellucid::app
