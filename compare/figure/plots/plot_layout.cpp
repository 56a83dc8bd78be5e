// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compare/figure/fitted_text.h"
#include "compare/figure/plots/plot_scale.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

// In points.
constexpr double margin = 2, gap = 3, tick_length = 2;
constexpr double hairline = 0.25, frame_width = 0.5, series_width = 0.9, mark_radius = 2.1;
// In font sizes.
constexpr double least_panel = 18, least_axis = 8, line_height = 1.3, ascent = 0.75;
constexpr double aspect = 0.62;  // of an axis over the other

const Vec3 light(0.88), grey(0.45), black(0);

/// Told apart with colour-blind eyes, too (Okabe and Ito 2008), but for the yellow, which is not
/// seen on white.
const std::array<Vec3, 7> colors{Vec3(0, 0.447, 0.698),
                                 Vec3(0.835, 0.369, 0),
                                 Vec3(0, 0.62, 0.451),
                                 Vec3(0.8, 0.475, 0.655),
                                 Vec3(0.9, 0.624, 0),
                                 Vec3(0.337, 0.706, 0.914),
                                 Vec3(0.35)};

/// The corners of a mark about the origin: a disc, a square, a triangle, a diamond. With seven
/// colours no two of 28 are the same.
std::vector<Vec2> mark_corners(std::size_t number) {
  constexpr int sides[] = {16, 4, 3, 4};
  constexpr double turns[] = {0, 0.125, 0.75, 0}, radii[] = {1, 1.15, 1.3, 1.25};
  const std::size_t kind = number % std::size(sides);
  std::vector<Vec2> corners;
  for (int i = 0; i < sides[kind]; ++i) {
    const double angle = 2 * std::numbers::pi * (turns[kind] + double(i) / sides[kind]);
    corners.push_back(radii[kind] * mark_radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

/// The axes of a panel on the sheet.
struct PanelBox {
  SheetBox box;
  PlotScale x, y;

  Vec2 at(const Vec2& point) const { return {box.x + x.at(point.x), box.bottom() - y.at(point.y)}; }
};

class PlotLayout {
 public:
  PlotLayout(const Plot& plot, double width, double font_size, const TextRuler& ruler)
      : plot_(plot), font_(font_size), ruler_(ruler) {
    sheet_.width = width;
    for (const PlotPanel& panel : plot.panels)
      for (const PlotSeries& series : panel.series)
        if (std::ranges::find(labels_, series.label) == labels_.end())
          labels_.push_back(series.label);
    const std::size_t panels = plot.panels.size();
    const auto most = std::clamp(std::size_t((width - 2 * margin) / (least_panel * font_)),
                                 std::size_t(1), panels);
    const std::size_t rows = (panels + most - 1) / most;
    columns_ = (panels + rows - 1) / rows;  // as even as can be
    panel_ = (width - 2 * margin - double(columns_ - 1) * font_) / double(columns_);
    left_ = line_height * font_ + widest_tick() + tick_length + gap;
    if (panel_ - left_ < least_axis * font_)
      throw InputError(
          fmt::format("--width: {:.0f} mm has no room for a plot; accepted: more, or a smaller "
                      "--font-size",
                      width / 72 * 25.4));
  }

  FigureSheet sheet() {
    double bottom = margin;
    for (std::size_t i = 0; i < plot_.panels.size(); ++i) {
      if (i % columns_ == 0) y_ = bottom;
      bottom = add_panel(plot_.panels[i], margin + double(i % columns_) * (panel_ + font_));
    }
    y_ = bottom;
    add_legend();
    sheet_.height = y_ + margin;
    return std::move(sheet_);
  }

 private:
  double small() const { return 0.85 * font_; }
  bool is_titled() const { return plot_.panels.size() > 1; }
  double axis_length() const { return panel_ - left_; }
  std::size_t number_of(const std::string& label) const {
    return std::size_t(std::ranges::find(labels_, label) - labels_.begin());
  }

  PlotScale y_scale(const PlotPanel& panel) const {
    std::vector<double> numbers;
    for (const PlotSeries& series : panel.series)
      for (const Vec2& point : series.points) numbers.push_back(point.y);
    return {std::move(numbers), plot_.y, aspect * panel_};
  }
  PlotScale x_scale(const PlotPanel& panel) const {
    std::vector<double> numbers = panel.verticals;
    for (const PlotSeries& series : panel.series)
      for (const Vec2& point : series.points) numbers.push_back(point.x);
    return {std::move(numbers), plot_.x, axis_length()};
  }
  double widest_tick() const {
    double widest = 0;
    for (const PlotPanel& panel : plot_.panels) {
      const PlotScale scale = y_scale(panel);
      for (const PlotTick& tick : scale.ticks())
        widest = std::max(widest, ruler_(tick.label, small()));
    }
    return widest;
  }

  void text(std::vector<TextRun> runs, double size, const Vec2& middle, bool is_turned = false) {
    sheet_.texts.push_back({std::move(runs), size, middle, is_turned});
  }
  void line(std::vector<Vec2> points, double width, const Vec3& color, bool is_dashed = false) {
    sheet_.lines.push_back({std::move(points), false, width, color, false, is_dashed});
  }
  void mark(std::size_t number, const Vec2& at) {
    std::vector<Vec2> corners = mark_corners(number);
    for (Vec2& corner : corners) corner += at;
    sheet_.lines.push_back(
        {std::move(corners), true, hairline, colors[number % colors.size()], true});
  }

  double add_panel(const PlotPanel& panel, double x);
  void add_ticks(const PanelBox& panel);
  void add_titles(const PlotPanel& panel, const PanelBox& box);
  void add_front(const std::vector<Vec2>& front, const PanelBox& panel);
  void add_series(const PlotSeries& series, const PanelBox& panel);
  void add_legend();
  void add_entry(const std::string& label, double& x, const std::function<void(const Vec2&)>& draw);

  const Plot& plot_;
  double font_;
  const TextRuler& ruler_;
  std::vector<std::string> labels_;
  std::size_t columns_ = 1;
  double panel_ = 0, left_ = 0;  // widths: of a panel, of what stands left of its axes
  double y_ = 0;                 // down to which the sheet is full
  FigureSheet sheet_;
};

/// Returns where it ends.
double PlotLayout::add_panel(const PlotPanel& panel, double x) {
  const double title = is_titled() ? line_height * font_ : 0.5 * font_;
  const PanelBox box{
      {x + left_, y_ + title, axis_length(), aspect * panel_}, x_scale(panel), y_scale(panel)};
  add_ticks(box);
  add_titles(panel, box);
  for (const double at : panel.verticals) {
    const double place = box.box.x + box.x.at(at);
    line({{place, box.box.y}, {place, box.box.bottom()}}, frame_width, grey, true);
  }
  add_front(panel.front, box);
  for (const PlotSeries& series : panel.series) add_series(series, box);
  return box.box.bottom() + gap + 2 * line_height * font_ + 0.5 * font_;
}

void PlotLayout::add_ticks(const PanelBox& panel) {
  const SheetBox& box = panel.box;
  for (const PlotTick& tick : panel.x.ticks()) {
    const double x = box.x + tick.at;
    line({{x, box.y}, {x, box.bottom() + tick_length}}, hairline, light);
    text(tick.label, small(), {x, box.bottom() + tick_length + gap + ascent * small()});
  }
  for (const PlotTick& tick : panel.y.ticks()) {
    const double y = box.bottom() - tick.at;
    line({{box.x - tick_length, y}, {box.right(), y}}, hairline, light);
    const double width = ruler_(tick.label, small());
    text(tick.label, small(), {box.x - tick_length - gap - width / 2, y + 0.5 * ascent * small()});
  }
  if (const double rail = panel.x.rail(); rail > 0)
    line({{box.x + rail, box.y}, {box.x + rail, box.bottom()}}, hairline, grey);
  if (const double rail = panel.y.rail(); rail > 0)
    line({{box.x, box.bottom() - rail}, {box.right(), box.bottom() - rail}}, hairline, grey);
  sheet_.lines.push_back(
      {{{box.x, box.y}, {box.right(), box.y}, {box.right(), box.bottom()}, {box.x, box.bottom()}},
       true,
       frame_width,
       grey});
}

void PlotLayout::add_titles(const PlotPanel& panel, const PanelBox& box) {
  const SheetBox& b = box.box;
  const auto fit = [&](const std::string& title, double room) {
    return std::vector<TextRun>{{fitted(title, font_, room, ruler_)}};
  };
  if (is_titled()) text(fit(panel.title, b.width), font_, {b.middle(), b.y - 0.4 * font_});
  text(fit(plot_.x.title, b.width), font_,
       {b.middle(), b.bottom() + tick_length + 2 * line_height * font_});
  text(fit(plot_.y.title, b.height), font_, {b.x - left_ + ascent * font_, b.y + b.height / 2},
       true);
}

void PlotLayout::add_front(const std::vector<Vec2>& front, const PanelBox& panel) {
  std::vector<Vec2> stairs;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const Vec2 here = panel.at(front[i]);
    if (i > 0) stairs.emplace_back(here.x, panel.at(front[i - 1]).y);
    stairs.push_back(here);
  }
  if (stairs.size() > 1) line(std::move(stairs), series_width, light - Vec3(0.2));
}

void PlotLayout::add_series(const PlotSeries& series, const PanelBox& panel) {
  const std::size_t number = number_of(series.label);
  std::vector<Vec2> places;
  for (const Vec2& point : series.points) places.push_back(panel.at(point));
  if (series.is_joined && places.size() > 1)
    line(places, series_width, colors[number % colors.size()]);
  constexpr std::size_t most_marks = 40;  // more would be a line of their own
  if (series.is_joined && places.size() > most_marks) return;
  for (const Vec2& place : places) mark(number, place);
}

/// `draw` puts the mark at its middle.
void PlotLayout::add_entry(const std::string& label, double& x,
                           const std::function<void(const Vec2&)>& draw) {
  const double room = sheet_.width - 2 * margin, space = 1.2 * font_;
  const std::vector<TextRun> runs{{fitted(label, small(), room - space, ruler_)}};
  const double width = space + ruler_(runs, small());
  if (x > margin && x + width > sheet_.width - margin) {
    x = margin;
    y_ += line_height * small();
  }
  draw({x + 0.5 * space, y_ + 0.5 * line_height * small()});
  text(runs, small(),
       {x + space + (width - space) / 2, y_ + (0.5 * line_height + 0.5 * ascent) * small()});
  x += width + space;
}

void PlotLayout::add_legend() {
  double x = margin;
  for (std::size_t i = 0; i < labels_.size(); ++i)
    add_entry(labels_[i], x, [&](const Vec2& at) { mark(i, at); });
  const bool any = std::ranges::any_of(
      plot_.panels, [](const PlotPanel& panel) { return !panel.verticals.empty(); });
  if (any)
    add_entry(plot_.of_verticals, x, [&](const Vec2& at) {
      line({at - Vec2(0, 0.4 * font_), at + Vec2(0, 0.4 * font_)}, frame_width, grey, true);
    });
  y_ += line_height * small();
}

}  // namespace

FigureSheet lay_out_plot(const Plot& plot, double width, double font_size, const TextRuler& ruler) {
  return PlotLayout(plot, width, font_size, ruler).sheet();
}

}  // namespace pellucid::compare
