// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/study/study.h"

namespace pellucid::compare {

/// A FigureCrop is a part of a scene's pictures that is enlarged below each.
struct FigureCrop {
  std::string scene;  // empty: every scene
  Crop crop;          // pixels of the pictures
};

/// A FigureRequest says what a figure shows of a study's results.
struct FigureRequest {
  std::vector<std::string> scenes;   // names; empty: all, in their order
  std::vector<std::string> methods;  // see methods_of_text(); empty: all of the first scene
  std::vector<FigureCrop> crops;
  bool own_crops = true;  // without any of the above: where the methods differ most
  std::vector<std::string> numbers = {"ssim", "rmse", "seconds", "bytes"};  // columns, below each
  std::vector<std::string> labels;        // of the columns, in their order; empty: methods' titles
  std::vector<std::string> scene_labels;  // empty: scenes' names, where there are several
  bool errors = false, flips = false;     // a further line of maps each
};

/// A FigureWidth is the width of a column of a style, or of its page.
struct FigureWidth {
  std::string_view name;  // as --width takes it
  std::string_view title;
  double millimetres = 0;
  bool is_page = false;  // it goes across all columns: figure* in LaTeX
};

/// Returns the table of widths.
std::span<const FigureWidth> figure_widths();

/// Returns the row of that name; a number is that many millimetres, which go across columns from
/// 110 on. Throws InputError for other texts and for widths not within 20 … 1000.
FigureWidth width_of_text(std::string_view text);

/// A FigureStyle says how a figure is set.
struct FigureStyle {
  FigureWidth width = figure_widths().front();
  double font_size = 8;                               // of the labels, points; numbers are smaller
  std::string font = "Helvetica, Arial, sans-serif";  // families, the first that is there
  int dots_per_inch = 300;                            // of a PNG
};

}  // namespace pellucid::compare
