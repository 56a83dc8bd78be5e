// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/sheet_drawing.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/machine/build_info.h"

namespace pellucid::compare {
namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const {
    release(object);
  }
};

using Surface = std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Release<cairo_destroy>>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Release<cairo_font_options_destroy>>;
using Layout = std::unique_ptr<PangoLayout, Release<g_object_unref>>;
using Attributes = std::unique_ptr<PangoAttrList, Release<pango_attr_list_unref>>;
using FontDescription = std::unique_ptr<PangoFontDescription, Release<pango_font_description_free>>;

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw InputError(fmt::format("the figure cannot be drawn: {}; accepted: a smaller one",
                               cairo_status_to_string(status)));
}

/// Glyphs as they are, not moved to the pixels of some screen: a line is as wide in all formats.
void leave_glyphs(PangoLayout* layout) {
  const FontOptions options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  PangoContext* context = pango_layout_get_context(layout);
  pango_cairo_context_set_font_options(context, options.get());
  pango_context_set_round_glyph_positions(context, FALSE);
  pango_layout_context_changed(layout);
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t begin,
                   std::size_t end) {
  attribute->start_index = guint(begin);
  attribute->end_index = guint(end);
  pango_attr_list_insert(list, attribute);
}

/// The text as it stands: no mark-up is read from it.
Layout layout_of(cairo_t* cairo, const std::vector<TextRun>& runs, double size,
                 const std::string& font) {
  Layout layout(pango_cairo_create_layout(cairo));
  leave_glyphs(layout.get());
  const FontDescription description(pango_font_description_new());
  pango_font_description_set_family(description.get(), font.c_str());
  pango_font_description_set_absolute_size(description.get(), size * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), description.get());
  const Attributes attributes(pango_attr_list_new());
  std::string text;
  for (const TextRun& run : runs) {
    const std::size_t begin = text.size();
    text += one_line(run.text, run.text.size() + 1);
    if (run.is_bold)
      add_attribute(attributes.get(), pango_attr_weight_new(PANGO_WEIGHT_BOLD), begin, text.size());
    if (!run.is_raised) continue;
    add_attribute(attributes.get(), pango_attr_scale_new(0.7), begin, text.size());
    add_attribute(attributes.get(), pango_attr_rise_new(int(0.35 * size * PANGO_SCALE)), begin,
                  text.size());
  }
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  pango_layout_set_text(layout.get(), text.data(), int(text.size()));
  pango_layout_set_attributes(layout.get(), attributes.get());
  return layout;
}

double width_of(PangoLayout* layout) {
  PangoRectangle logical;
  pango_layout_get_extents(layout, nullptr, &logical);
  return double(logical.width) / PANGO_SCALE;
}

/// The displayed values of a picture, without alpha, which PDF would keep as a second picture.
Surface surface_of(const Image& image) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
  check(cairo_surface_status(surface.get()));
  unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height; ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(bytes + std::ptrdiff_t(y) * stride);
    for (int x = 0; x < image.width; ++x) {
      const Rgba& c = image.at(x, y);
      row[x] = std::uint32_t(displayed_byte(c.r)) << 16 | std::uint32_t(displayed_byte(c.g)) << 8 |
               displayed_byte(c.b);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void set_color(cairo_t* cairo, const Vec3& color) {
  cairo_set_source_rgb(cairo, color.r, color.g, color.b);
}

bool is_of_dots(cairo_t* cairo) {
  return cairo_surface_get_type(cairo_get_target(cairo)) == CAIRO_SURFACE_TYPE_IMAGE;
}

/// Whether a unit, a picture's pixel, is less than a dot: then not every pixel has one of its own.
bool has_fewer_dots(cairo_t* cairo) {
  double width = 1, height = 0;
  cairo_user_to_device_distance(cairo, &width, &height);
  return is_of_dots(cairo) && width < 1;
}

void draw(cairo_t* cairo, const SheetPicture& picture) {
  const Surface surface = surface_of(picture.image);
  const SheetBox& box = picture.box;
  cairo_save(cairo);
  cairo_translate(cairo, box.x, box.y);
  cairo_scale(cairo, box.width / picture.image.width, box.height / picture.image.height);
  cairo_set_source_surface(cairo, surface.get(), 0, 0);
  cairo_pattern_t* pattern = cairo_get_source(cairo);
  cairo_pattern_set_filter(pattern, picture.is_enlarged && !has_fewer_dots(cairo)
                                        ? CAIRO_FILTER_NEAREST
                                        : CAIRO_FILTER_GOOD);
  // In dots, what is beyond the edge would be mixed into it; formats that keep the picture whole
  // would keep a larger one.
  if (is_of_dots(cairo)) cairo_pattern_set_extend(pattern, CAIRO_EXTEND_PAD);
  cairo_rectangle(cairo, 0, 0, picture.image.width, picture.image.height);
  cairo_fill(cairo);
  cairo_restore(cairo);
}

void draw(cairo_t* cairo, const SheetLine& line) {
  for (const Vec2& point : line.points) cairo_line_to(cairo, point.x, point.y);
  if (line.is_closed) cairo_close_path(cairo);
  cairo_set_line_width(cairo, line.width);
  set_color(cairo, line.color);
  constexpr double dashes[] = {2, 2};  // points
  cairo_set_dash(cairo, dashes, line.is_dashed ? 2 : 0, 0);
  if (line.is_filled) cairo_fill_preserve(cairo);
  cairo_stroke(cairo);
}

void draw(cairo_t* cairo, const SheetText& text, const std::string& font) {
  cairo_save(cairo);
  cairo_translate(cairo, text.at.x, text.at.y);
  if (text.is_turned) cairo_rotate(cairo, -std::numbers::pi / 2);
  const Layout layout = layout_of(cairo, text.runs, text.size, font);
  const double ascent = double(pango_layout_get_baseline(layout.get())) / PANGO_SCALE;
  cairo_move_to(cairo, -width_of(layout.get()) / 2, -ascent);
  set_color(cairo, Vec3(0));
  pango_cairo_show_layout(cairo, layout.get());
  cairo_restore(cairo);
}

void draw(cairo_surface_t* surface, const FigureSheet& sheet, const std::string& font,
          double scale = 1) {
  check(cairo_surface_status(surface));
  const Context cairo(cairo_create(surface));
  cairo_scale(cairo.get(), scale, scale);
  for (const SheetPicture& picture : sheet.pictures) draw(cairo.get(), picture);
  for (const SheetLine& line : sheet.lines) draw(cairo.get(), line);
  for (const SheetText& text : sheet.texts) draw(cairo.get(), text, font);
  check(cairo_status(cairo.get()));
}

/// SVG as cairo writes it leaves to the viewer how pixels are enlarged, and most blur them: each is
/// as many as 600 dots per inch show.
Image repeated(const Image& image, double points) {
  const int times = std::max(1, int(std::ceil(points / 72 * 600 / image.width)));
  Image large(times * image.width, times * image.height);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x) large.at(x, y) = image.at(x / times, y / times);
  return large;
}

cairo_status_t keep(void* text, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

/// What cairo has left to write, it writes when the surface is finished.
std::string finished(const Surface& surface, const std::string& file) {
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return file;
}

}  // namespace

TextRuler text_ruler(const std::string& font) {
  const std::shared_ptr<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1),
                                                 cairo_surface_destroy);
  const std::shared_ptr<cairo_t> cairo(cairo_create(surface.get()), cairo_destroy);
  return [surface, cairo, font](const std::vector<TextRun>& runs, double size) {
    return width_of(layout_of(cairo.get(), runs, size, font).get());
  };
}

std::string pdf_of(const FigureSheet& sheet, const std::string& font, const std::string& title) {
  std::string file;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(keep, &file, sheet.width, sheet.height));
  check(cairo_surface_status(surface.get()));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, one_line(title).c_str());
  cairo_pdf_surface_set_metadata(
      surface.get(), CAIRO_PDF_METADATA_CREATOR,
      fmt::format("pellucid {} ({})", build_version, build_commit).c_str());
  // Equal figures are equal files: no time of writing.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  draw(surface.get(), sheet, font);
  return finished(surface, file);
}

std::string svg_of(const FigureSheet& whole, const std::string& font) {
  FigureSheet sheet = whole;
  for (SheetPicture& picture : sheet.pictures)
    if (picture.is_enlarged) picture.image = repeated(picture.image, picture.box.width);
  std::string file;
  const Surface surface(
      cairo_svg_surface_create_for_stream(keep, &file, sheet.width, sheet.height));
  check(cairo_surface_status(surface.get()));
  draw(surface.get(), sheet, font);
  return finished(surface, file);
}

Image picture_of(const FigureSheet& sheet, const std::string& font, int dots_per_inch) {
  const double scale = dots_per_inch / 72.0;
  const int width = int(std::lround(sheet.width * scale));
  const int height = int(std::lround(sheet.height * scale));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  check(cairo_surface_status(surface.get()));
  {
    const Context cairo(cairo_create(surface.get()));
    set_color(cairo.get(), Vec3(1));
    cairo_paint(cairo.get());
  }
  draw(surface.get(), sheet, font, scale);
  cairo_surface_flush(surface.get());
  Image picture(width, height);
  const unsigned char* bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + std::ptrdiff_t(y) * stride);
    for (int x = 0; x < width; ++x)
      picture.at(x, y) =
          Rgba(glm::vec3(row[x] >> 16 & 255, row[x] >> 8 & 255, row[x] & 255) / 255.f, 1.f);
  }
  return picture;
}

}  // namespace pellucid::compare
