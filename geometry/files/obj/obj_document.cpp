// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ. tinyobjloader reads a number that it cannot parse as 0; this reader refuses such a
// file and names the line.

#include "geometry/files/obj/obj_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/files/obj/words.h"
#include "geometry/files/text_lines.h"

namespace pellucid::geometry {
namespace {

/// The largest index so far that counts from the front: it may be listed later.
struct Largest {
  std::uint32_t index = 0;
  std::size_t line = 0;  // 0: there is none
};

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path) { document_.path = path; }

  ObjDocument read() {
    const std::string content = read_text(document_.path);
    read_lines(without_mark(content));
    check_indices();
    take_sevens();
    if (!has_color_) document_.colors.clear();
    if (free_forms_ > 0)
      document_.remarks.push_back(fmt::format(
          "{} free-form curves and surfaces (curv, curv2, surf) are left out; they have "
          "to be made polygons where they come from",
          free_forms_));
    return std::move(document_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", document_.path.string(), line_, what));
  }

  double number(std::string_view word) const {
    double value = 0;
    if (word.empty() || !parse_number(word, value))
      fail(fmt::format("'{}': expected a number", word));
    return value;
  }

  Vec3 vector(Words& words) const {
    const double x = number(words.next()), y = number(words.next());
    return {x, y, number(words.next())};
  }

  void vertex(Words& words) {
    document_.positions.push_back(vector(words));
    std::vector<double> more;  // at most four count
    for (std::string_view word = words.next(); !word.empty() && more.size() < 4;
         word = words.next())
      more.push_back(number(word));
    // "v x y z w" carries a weight, which is ignored; "v x y z r g b" a colour.
    Rgba color(1);
    if (more.size() >= 3) color = Rgba(more[0], more[1], more[2], more.size() > 3 ? more[3] : 1);
    has_color_ = has_color_ || more.size() >= 3;
    if (more.size() > 3) sevens_.push_back(document_.colors.size());
    document_.colors.push_back(color);
  }

  /// Of seven numbers the fourth is a weight where it is 1 in all such vertices, else they end with
  /// red, green, blue and alpha.
  void take_sevens() {
    if (sevens_.empty()) return;
    std::vector<Rgba>& colors = document_.colors;
    const bool weights =
        std::ranges::all_of(sevens_, [&](std::size_t i) { return colors[i].r == 1; });
    if (weights)
      for (const std::size_t i : sevens_)
        colors[i] = Rgba(colors[i].g, colors[i].b, colors[i].a, 1);
    document_.remarks.push_back(
        fmt::format("{} vertices of seven numbers are read as x y z {}", sevens_.size(),
                    weights ? "w red green blue, since the fourth is 1" : "red green blue alpha"));
  }

  /// One-based, of what is listed anywhere; or negative, from the end of what is listed so far.
  std::uint32_t index(std::string_view word, std::size_t count, std::string_view what,
                      Largest& largest) const {
    const double given = number(word);
    if (given != std::floor(given) || given == 0 || !(given < double(obj_none)) ||
        given < -double(count))
      fail(fmt::format("{} index {}, but {} were listed so far", what, word, count));
    if (given < 0) return std::uint32_t(double(count) + given);
    const auto zero_based = std::uint32_t(given - 1);
    if (largest.line == 0 || zero_based > largest.index) largest = {zero_based, line_};
    return zero_based;
  }
  void check(const Largest& largest, std::size_t count, std::string_view what) {
    line_ = largest.line;
    if (line_ > 0 && largest.index >= count)
      fail(fmt::format("{} index {}, but {} are listed", what, std::uint64_t(largest.index) + 1,
                       count));
  }
  void check_indices() {
    check(position_, document_.positions.size(), "vertex");
    check(texture_, document_.textures.count(), "texture");
    check(normal_, document_.normals.size(), "normal");
  }

  void texture(Words& words) {
    Rows<double>& textures = document_.textures;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      textures.values.push_back(number(word));
    textures.ends.push_back(textures.values.size());
  }

  /// "v", "v/vt", "v//vn" or "v/vt/vn". Of a face "vt" says nothing that is drawn, and is passed
  /// over.
  ObjCorner corner(std::string_view word, bool of_line) {
    const auto part = [&] {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::string_view first = word.substr(0, slash);
      word.remove_prefix(std::min(slash + 1, word.size()));
      return first;
    };
    ObjCorner corner;
    corner.position = index(part(), document_.positions.size(), "vertex", position_);
    const std::string_view vt = part(), vn = part();
    if (of_line && !vt.empty())
      corner.texture = index(vt, document_.textures.count(), "texture", texture_);
    if (!of_line && !vn.empty())
      corner.normal = index(vn, document_.normals.size(), "normal", normal_);
    return corner;
  }

  void element(Words& words, ObjElements& elements) {
    Rows<ObjCorner>& corners = elements.corners;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      corners.values.push_back(corner(word, &elements == &document_.lines));
    corners.ends.push_back(corners.values.size());
    elements.materials.push_back(material_);
  }

  void use_material(const std::string& name) {
    const auto [found, is_new] =
        materials_.try_emplace(name, std::uint32_t(document_.materials.size()));
    if (is_new) document_.materials.push_back(name);
    material_ = found->second;
  }

  void statement(Words words) {
    const std::string_view keyword = words.next();
    if (keyword == "v") vertex(words);
    if (keyword == "vn") document_.normals.push_back(vector(words));
    if (keyword == "vt") texture(words);
    if (keyword == "f") element(words, document_.faces);
    if (keyword == "l") element(words, document_.lines);
    if (keyword == "usemtl") use_material(std::string(words.rest()));
    if (keyword == "curv" || keyword == "curv2" || keyword == "surf") ++free_forms_;
    if (keyword == "mtllib") document_.libraries.push_back({std::string(words.rest()), line_});
  }

  /// A backslash at a line's end goes on in the next one.
  void read_lines(std::string_view text) {
    std::string joined;
    while (!text.empty()) {
      std::string_view row = take_line(text);
      ++line_;
      row = row.substr(0, row.find_last_not_of(" \t\r") + 1);
      const bool goes_on = row.ends_with('\\') && row.find('#') == row.npos && !text.empty();
      if (row.ends_with('\\')) row.remove_suffix(1);
      if (goes_on || !joined.empty()) (joined += row) += ' ';
      if (goes_on) continue;
      statement(Words(joined.empty() ? row : joined));
      joined.clear();
    }
  }

  ObjDocument document_;
  std::size_t line_ = 0;
  Largest position_, texture_, normal_;
  std::map<std::string, std::uint32_t> materials_;  // index by name
  std::uint32_t material_ = obj_none;               // of what follows
  bool has_color_ = false;
  std::vector<std::size_t> sevens_;  // vertices of seven numbers or more
  std::size_t free_forms_ = 0;
};

}  // namespace

ObjDocument read_obj_document(const std::filesystem::path& path) { return ObjReader(path).read(); }

}  // namespace pellucid::geometry
