// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "compare/figure/fitted_text.h"
#include "compare/report/crop.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

// In points.
constexpr double margin = 1;  // half of a frame at the edge would be cut off
constexpr double column_gap = 3, inset_gap = 2, strip_gap = 7;
constexpr double frame_width = 0.8, casing_width = 1.6, hairline = 0.25, zoom_line = 0.4;
constexpr double bar_height = 4;
constexpr double least_font = 4.5;                    // smaller ones are not read
constexpr double line_height = 1.2, baseline = 0.95;  // of a line, in font sizes

const Vec3 white(1), grey(0.7), black(0);

/// Colours that are told apart with colour-blind eyes too (Okabe and Ito 2008).
const Vec3 crop_colors[] = {
    {0.835, 0.369, 0}, {0, 0.447, 0.698}, {0, 0.62, 0.451}, {0.8, 0.475, 0.655}};

Vec3 crop_color(std::size_t i) { return crop_colors[i % std::size(crop_colors)]; }

SheetLine frame(const SheetBox& b, double width, const Vec3& color) {
  return {{{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}},
          true,
          width,
          color};
}

/// Where a part of a picture lies that fills `box`.
SheetBox place_of(const Crop& crop, const Image& picture, const SheetBox& box) {
  const double pixel = box.width / picture.width;
  return {box.x + crop.x * pixel, box.y + crop.y * pixel, crop.width * pixel, crop.height * pixel};
}

/// The enlarged crops side by side, of one height, below `above`; no higher than that.
std::vector<SheetBox> inset_boxes(const std::vector<Crop>& crops, const SheetBox& above) {
  const auto aspect = [](const Crop& crop) { return double(crop.width) / crop.height; };
  const double aspects =
      std::transform_reduce(crops.begin(), crops.end(), 0.0, std::plus(), aspect);
  const double gaps = inset_gap * double(crops.size() - 1);
  const double height = std::min((above.width - gaps) / aspects, above.height);
  if (!(height > hairline))
    throw InputError(
        fmt::format("--crop: {} parts do not fit side by side below a picture {:.0f} mm wide; "
                    "accepted: fewer, less wide ones, or a larger --width",
                    crops.size(), above.width / 72 * 25.4));
  double x = above.middle() - (aspects * height + gaps) / 2;
  std::vector<SheetBox> boxes;
  for (const Crop& crop : crops) {
    boxes.push_back({x, above.bottom() + 2 * inset_gap, aspect(crop) * height, height});
    x = boxes.back().right() + inset_gap;
  }
  return boxes;
}

/// A FigureLayout puts a figure's parts on its sheet, from the top down.
class FigureLayout {
 public:
  FigureLayout(const FigureContent& content, double width, double font_size, const TextRuler& ruler)
      : content_(content), font_(font_size), ruler_(ruler) {
    sheet_.width = width;
    const bool labelled = std::ranges::any_of(
        content.strips, [](const FigureStrip& strip) { return !strip.label.empty(); });
    left_ = margin + (labelled ? 1.4 * font_size : 0);
    const auto columns = double(content.headings.size());
    column_ = (width - margin - left_ - (columns - 1) * column_gap) / columns;
    if (column_ < 2 * font_size) refuse_width();
    number_font_ = number_font();
  }

  FigureSheet sheet() {
    y_ = margin;
    add_headings();
    for (const FigureStrip& strip : content_.strips) add_strip(strip);
    sheet_.height = y_ + margin;
    return std::move(sheet_);
  }

 private:
  double x_of(std::size_t column) const { return left_ + double(column) * (column_ + column_gap); }
  double small_font() const { return 0.85 * font_; }

  [[noreturn]] void refuse_width() const {
    throw InputError(fmt::format(
        "--methods: {} pictures do not fit beside each other in {:.0f} mm; accepted: fewer, a "
        "larger --width, or a smaller --font-size",
        content_.headings.size(), sheet_.width / 72 * 25.4));
  }

  /// The size at which every number fits below its picture.
  double number_font() const {
    double widest = 0;
    for_each_number([&](const std::vector<TextRun>& runs) {
      widest = std::max(widest, ruler_(runs, small_font()));
    });
    const double size = small_font() * std::min(1.0, column_ / std::max(widest, 1e-6));
    if (size < least_font) refuse_width();
    return size;
  }

  template <class Visit>
  void for_each_number(const Visit& visit) const {
    for (const FigureStrip& strip : content_.strips)
      for (const FigureNumbers& numbers : strip.numbers) {
        std::ranges::for_each(numbers.errors, visit);
        std::ranges::for_each(numbers.costs, visit);
      }
  }

  void add_text(std::vector<TextRun> runs, double size, const Vec2& at, bool is_turned = false) {
    sheet_.texts.push_back({std::move(runs), size, at, is_turned});
  }

  void add_framed(const SheetBox& box, double width, const Vec3& color) {
    sheet_.lines.push_back(frame(box, casing_width, white));
    sheet_.lines.push_back(frame(box, width, color));
  }

  struct HeadingLine {
    std::string text;
    double size;
  };

  std::vector<HeadingLine> lines_of(const FigureHeading& heading) const {
    std::vector<HeadingLine> lines;
    for (std::string& line : wrapped(heading.title, font_, column_, 2, ruler_))
      lines.push_back({std::move(line), font_});
    for (std::string& line : wrapped(heading.parameters, small_font(), column_, 2, ruler_))
      lines.push_back({std::move(line), small_font()});
    return lines;
  }

  /// Above their columns, the last lines of all at one height.
  void add_headings() {
    double height = 0;
    std::vector<std::vector<HeadingLine>> all;
    for (const FigureHeading& heading : content_.headings) {
      all.push_back(lines_of(heading));
      height = std::max(height, height_of(all.back()));
    }
    for (std::size_t column = 0; column < all.size(); ++column) {
      double y = y_ + height - height_of(all[column]);
      for (const HeadingLine& line : all[column]) {
        add_text({{line.text}}, line.size, {x_of(column) + column_ / 2, y + baseline * line.size});
        y += line_height * line.size;
      }
    }
    y_ += height + 1;
  }

  static double height_of(const std::vector<HeadingLine>& lines) {
    double height = 0;
    for (const HeadingLine& line : lines) height += line_height * line.size;
    return height;
  }

  SheetBox box_of(std::size_t column, const Image& picture) const {
    return {x_of(column), y_, column_, column_ * picture.height / picture.width};
  }

  void add_strip(const FigureStrip& strip) {
    if (&strip != &content_.strips.front()) y_ += strip_gap;
    const SheetBox first = box_of(0, strip.pictures.front());
    if (!strip.label.empty())
      add_text({{fitted(strip.label, font_, first.height, ruler_)}}, font_,
               {margin + font_, first.y + first.height / 2}, true);
    double bottom = first.bottom();
    for (std::size_t i = 0; i < strip.pictures.size(); ++i)
      bottom = std::max(bottom, add_picture(strip, i));
    y_ = bottom;
    for (const FigureMaps& maps : strip.lines_of_maps)
      add_maps(strip, maps, &strip == &content_.strips.back());
    y_ += 1;
    add_numbers(strip, &FigureNumbers::errors);
    add_numbers(strip, &FigureNumbers::costs);
  }

  void add_image(const SheetBox& box, const Image& image) {
    sheet_.pictures.push_back({box, image});
    sheet_.lines.push_back(frame(box, hairline, grey));
  }

  /// Returns where it ends.
  double add_picture(const FigureStrip& strip, std::size_t column) {
    const Image& picture = strip.pictures[column];
    const SheetBox box = box_of(column, picture);
    add_image(box, picture);
    if (strip.crops.empty()) return box.bottom();
    const std::vector<SheetBox> insets = inset_boxes(strip.crops, box);
    for (std::size_t i = 0; i < insets.size(); ++i)
      add_inset(picture, strip.crops[i], place_of(strip.crops[i], picture, box), insets[i],
                crop_color(i));
    return insets.front().bottom();
  }

  void add_inset(const Image& picture, const Crop& crop, const SheetBox& from, const SheetBox& to,
                 const Vec3& color) {
    sheet_.pictures.push_back({to, cut(picture, crop), true});
    sheet_.lines.push_back({{{from.x, from.bottom()}, {to.x, to.y}}, false, zoom_line, color});
    sheet_.lines.push_back(
        {{{from.right(), from.bottom()}, {to.right(), to.y}}, false, zoom_line, color});
    add_framed(from, frame_width, color);
    sheet_.lines.push_back(frame(to, frame_width, color));
  }

  /// The scale stands in the reference's place, which has no map; without one below the last scene.
  void add_maps(const FigureStrip& strip, const FigureMaps& maps, bool is_last) {
    y_ += column_gap;
    std::optional<SheetBox> free;
    for (std::size_t column = 0; column < maps.maps.size(); ++column) {
      const SheetBox box = box_of(column, strip.pictures.front());
      if (!maps.maps[column].pixels.empty())
        add_map(strip, maps.maps[column], box);
      else if (!free)
        free = box;
    }
    y_ = box_of(0, strip.pictures.front()).bottom();
    if (free) return add_scale(maps.scale, *free);
    if (!is_last) return;
    const double height = bar_height + 2.6 * small_font(),
                 width = std::min(0.6 * sheet_.width, 200.0);
    add_scale(maps.scale, {(sheet_.width - width) / 2, y_ + 2, width, height});
    y_ += height + 2;
  }

  void add_map(const FigureStrip& strip, const Image& map, const SheetBox& box) {
    add_image(box, map);
    for (std::size_t i = 0; i < strip.crops.size(); ++i)
      add_framed(place_of(strip.crops[i], map, box), frame_width, crop_color(i));
  }

  /// In the middle of `box`: title, colours and what they mean.
  void add_scale(const FigureScale& scale, const SheetBox& box) {
    const double font = small_font();
    const SheetBox bar{box.x + 0.1 * box.width, box.y + (box.height - bar_height) / 2,
                       0.8 * box.width, bar_height};
    sheet_.pictures.push_back({bar, scale.colors});
    sheet_.lines.push_back(frame(bar, hairline, black));
    add_text({{fitted(scale.title, font, box.width, ruler_)}}, font,
             {bar.middle(), bar.y - 0.4 * font});
    for (const auto& [share, runs] : scale.ticks) {
      const double x = bar.x + share * bar.width;
      sheet_.lines.push_back(
          {{{x, bar.bottom()}, {x, bar.bottom() + 1.5}}, false, hairline, black});
      add_text(runs, font, {x, bar.bottom() + 1.5 + font});
    }
  }

  using NumberLists = std::vector<std::vector<TextRun>> FigureNumbers::*;

  /// As many beside each other as fit below every picture of the figure.
  std::size_t numbers_per_line(NumberLists which) const {
    std::size_t most = 1;
    double widest = 0;
    for (const FigureStrip& strip : content_.strips)
      for (const FigureNumbers& numbers : strip.numbers) {
        most = std::max(most, (numbers.*which).size());
        if ((numbers.*which).size() > 1)
          for (const std::vector<TextRun>& runs : numbers.*which)
            widest = std::max(widest, ruler_(runs, number_font_));
      }
    const double with_space = widest + 0.6 * number_font_;
    return std::clamp(std::size_t(column_ / std::max(with_space, 1e-6)), std::size_t(1), most);
  }

  void add_numbers(const FigureStrip& strip, NumberLists which) {
    const std::size_t per_line = numbers_per_line(which);
    std::size_t most = 0;
    for (std::size_t column = 0; column < strip.numbers.size(); ++column) {
      const auto& list = strip.numbers[column].*which;
      most = std::max(most, list.size());
      for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t line = i / per_line, place = i % per_line;
        const std::size_t beside = std::min(per_line, list.size() - line * per_line);
        const double slot = column_ / double(beside);
        add_text(list[i], number_font_,
                 {x_of(column) + slot * (double(place) + 0.5),
                  y_ + (line_height * double(line) + baseline) * number_font_});
      }
    }
    const std::size_t lines = (most + per_line - 1) / per_line;
    y_ += line_height * number_font_ * double(lines);
  }

  const FigureContent& content_;
  double font_;
  const TextRuler& ruler_;
  double left_ = 0, column_ = 0, number_font_ = 0, y_ = 0;
  FigureSheet sheet_;
};

}  // namespace

FigureSheet lay_out(const FigureContent& content, double width, double font_size,
                    const TextRuler& ruler) {
  return FigureLayout(content, width, font_size, ruler).sheet();
}

}  // namespace pellucid::compare
