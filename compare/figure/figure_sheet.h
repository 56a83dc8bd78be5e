// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A figure as it lies on paper, before any file format: what is drawn, and where. All lengths are
// points (1/72 inch), from the sheet's top left corner.

#include <functional>
#include <string>
#include <vector>

#include "core/raster.h"

namespace pellucid::compare {

/// A SheetBox is a rectangle on a sheet, in points.
struct SheetBox {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  double middle() const { return x + width / 2; }
};

/// A SheetPicture fills its box with a picture's displayed values. Squares with hard edges stand
/// for the pixels of an enlarged one; others are smoothed.
struct SheetPicture {
  SheetBox box;
  Image image;
  bool is_enlarged = false;
};

/// A SheetLine joins points, or goes around them, in one colour.
struct SheetLine {
  std::vector<Vec2> points;
  bool is_closed = false;
  double width = 0;
  Vec3 color{0};
  bool is_filled = false;  // inside of a closed one, too
  bool is_dashed = false;
};

/// A TextRun is a part of a text that is set alike.
struct TextRun {
  std::string text;
  bool is_bold = false;
  bool is_raised = false;  // an exponent
};

/// A SheetText is one line, centred about a place on its baseline.
struct SheetText {
  std::vector<TextRun> runs;
  double size = 0;         // of the font
  Vec2 at{0};              // the middle of the baseline
  bool is_turned = false;  // by a quarter to the left: it reads from below
};

/// A FigureSheet is a figure. Pictures lie below lines, lines below texts.
struct FigureSheet {
  double width = 0, height = 0;
  std::vector<SheetPicture> pictures;
  std::vector<SheetLine> lines;
  std::vector<SheetText> texts;
};

/// A TextRuler returns the width of a line of text that is not turned, in points.
using TextRuler = std::function<double(const std::vector<TextRun>& runs, double size)>;

}  // namespace pellucid::compare
