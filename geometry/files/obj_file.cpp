// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ. tinyobjloader reads a number that it cannot parse as 0; this reader refuses such a
// file and names the line.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"
#include "geometry/polygons/triangulate.h"

namespace pellucid::geometry {
namespace {

/// Words of one line, split at blanks.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line.substr(0, line.find('#'))) {}

  std::string_view next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size()));
    const std::size_t end = std::min(rest_.find_first_of(" \t\r"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

 private:
  std::string_view rest_;
};

constexpr std::uint32_t none = ~0u;

/// A corner of a face or of a line, by the numbers of what is listed; `none` where it names none.
struct Corner {
  std::uint32_t position = none, texture = none, normal = none;
};

/// Rows of values, such as the corners of faces: those of all, and where those of each end.
template <class Value>
struct Rows {
  std::vector<Value> values;
  std::vector<std::size_t> ends{0};

  std::size_t count() const { return ends.size() - 1; }
  std::span<const Value> row(std::size_t i) const {
    return std::span(values).subspan(ends[i], ends[i + 1] - ends[i]);
  }
};

/// The largest index so far that counts from the front: it may be listed later.
struct Largest {
  std::uint32_t index = 0;
  std::size_t line = 0;  // 0: there is none
};

struct ObjReader {
  std::string file;
  std::size_t line = 0;
  Largest position, texture_place, normal;
  TriangleMesh mesh;  // its vertices are the positions as listed
  Rows<Corner> faces, lines;
  std::vector<Vec3> normals;  // as listed
  Rows<double> textures;      // as listed: one to three numbers each
  bool has_color = false;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file, line, what));
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
    mesh.positions.push_back(vector(words));
    const std::string_view red = words.next();
    const std::string_view green = words.next(), blue = words.next();
    // "v x y z r g b" carries a colour; "v x y z w" a weight, which is ignored.
    Rgba color(1);
    if (!blue.empty()) {
      has_color = true;
      color = Rgba(number(red), number(green), number(blue), 1);
    }
    mesh.colors.push_back(color);
  }

  /// One-based, of what is listed anywhere; or negative, from the end of what is listed so far.
  std::uint32_t index(std::string_view word, std::size_t count, std::string_view what,
                      Largest& largest) const {
    const double given = number(word);
    if (given != std::floor(given) || given == 0 || !(given < double(none)) ||
        given < -double(count))
      fail(fmt::format("{} index {}, but {} were listed so far", what, word, count));
    if (given < 0) return std::uint32_t(double(count) + given);
    const auto zero_based = std::uint32_t(given - 1);
    if (largest.line == 0 || zero_based > largest.index) largest = {zero_based, line};
    return zero_based;
  }
  void check(const Largest& largest, std::size_t count, std::string_view what) {
    line = largest.line;
    if (line > 0 && largest.index >= count)
      fail(fmt::format("{} index {}, but {} are listed", what, std::uint64_t(largest.index) + 1,
                       count));
  }
  void check_indices() {
    check(position, mesh.positions.size(), "vertex");
    check(texture_place, textures.count(), "texture");
    check(normal, normals.size(), "normal");
  }

  void texture(Words& words) {
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      textures.values.push_back(number(word));
    textures.ends.push_back(textures.values.size());
  }

  /// "v", "v/vt", "v//vn" or "v/vt/vn". Of a face "vt" says nothing that is drawn, and is passed
  /// over.
  Corner corner(std::string_view word, bool of_line) {
    const auto part = [&] {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::string_view first = word.substr(0, slash);
      word.remove_prefix(std::min(slash + 1, word.size()));
      return first;
    };
    Corner corner;
    corner.position = index(part(), mesh.positions.size(), "vertex", position);
    const std::string_view vt = part(), vn = part();
    if (of_line && !vt.empty())
      corner.texture = index(vt, textures.count(), "texture", texture_place);
    if (!of_line && !vn.empty()) corner.normal = index(vn, normals.size(), "normal", normal);
    return corner;
  }

  void row(Words& words, Rows<Corner>& rows) {
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      rows.values.push_back(corner(word, &rows == &lines));
    rows.ends.push_back(rows.values.size());
  }

  void statement(Words words) {
    const std::string_view keyword = words.next();
    if (keyword == "v") vertex(words);
    if (keyword == "vn") normals.push_back(vector(words));
    if (keyword == "vt") texture(words);
    if (keyword == "f") row(words, faces);
    if (keyword == "l") row(words, lines);
  }

  /// A backslash at a line's end goes on in the next one.
  void read(std::string_view text) {
    std::string joined;
    while (!text.empty()) {
      std::string_view row = take_line(text);
      ++line;
      row = row.substr(0, row.find_last_not_of(" \t\r") + 1);
      const bool goes_on = row.ends_with('\\') && row.find('#') == row.npos && !text.empty();
      if (row.ends_with('\\')) row.remove_suffix(1);
      if (goes_on || !joined.empty()) (joined += row) += ' ';
      if (goes_on) continue;
      statement(Words(joined.empty() ? row : joined));
      joined.clear();
    }
  }
};

ObjReader read_file(const std::filesystem::path& path) {
  ObjReader reader;
  reader.file = path.string();
  const std::string content = read_text(path);
  reader.read(without_mark(content));
  reader.check_indices();
  if (!reader.has_color) reader.mesh.colors.clear();
  return reader;
}

/// Gives every pair of a position and a normal that a face has a vertex of its own. The first of a
/// position keeps its number; a corner without a normal has (0, 0, 0), which is none.
class VertexPairs {
 public:
  explicit VertexPairs(ObjReader& reader) : reader_(reader), first_(reader.mesh.positions.size()) {
    reader.mesh.normals.assign(reader.mesh.positions.size(), Vec3(0));
  }

  std::uint32_t vertex(const Corner& corner) {
    const Vec3 normal = corner.normal == none ? Vec3(0) : reader_.normals[corner.normal];
    std::optional<Vec3>& first = first_[corner.position];
    if (!first) {
      first = normal;
      reader_.mesh.normals[corner.position] = normal;
    }
    if (same(*first, normal)) return corner.position;
    const auto [found, is_new] = further_.try_emplace(
        {corner.position, bits(normal.x), bits(normal.y), bits(normal.z)}, size());
    if (is_new) copy(corner.position, normal);
    return found->second;
  }

 private:
  static std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }
  static bool same(const Vec3& a, const Vec3& b) {
    return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
  }
  std::uint32_t size() const { return std::uint32_t(reader_.mesh.positions.size()); }
  void copy(std::uint32_t position, const Vec3& normal) {
    TriangleMesh& mesh = reader_.mesh;
    mesh.positions.push_back(Vec3(mesh.positions[position]));
    mesh.normals.push_back(normal);
    if (!mesh.colors.empty()) mesh.colors.push_back(Rgba(mesh.colors[position]));
  }

  ObjReader& reader_;
  std::vector<std::optional<Vec3>> first_;                         // normal, by position
  std::map<std::array<std::uint64_t, 4>, std::uint32_t> further_;  // by position and normal's bits
};

TriangleMesh read_obj(const std::filesystem::path& path) {
  ObjReader reader = read_file(path);
  VertexPairs pairs(reader);
  std::vector<std::uint32_t> polygon;
  for (std::size_t face = 0; face < reader.faces.count(); ++face) {
    polygon.clear();
    for (const Corner& corner : reader.faces.row(face)) polygon.push_back(pairs.vertex(corner));
    triangulate_polygon(reader.mesh.positions, polygon, reader.mesh.triangles);
  }
  if (reader.normals.empty()) reader.mesh.normals.clear();
  return std::move(reader.mesh);
}

/// Numbers of the points of lines: those of the "vt" that a corner names, else of the one that is
/// listed as its position is, when there are as many. (So do the data sets of M. Kern et al., A
/// Comparison of Rendering Techniques for 3D Line Sets with Transparency, 2020.) They are called
/// attribute0, attribute1, … as those of .binlines; a point that has none has NaN.
VertexAttributes texture_attributes(const ObjReader& reader) {
  VertexAttributes attributes;
  const bool by_position = reader.textures.count() == reader.mesh.positions.size();
  std::size_t count = 0;
  for (std::size_t i = 0; i < reader.textures.count(); ++i)
    count = std::max(count, reader.textures.row(i).size());
  for (std::size_t k = 0; k < count; ++k)
    for (const Corner& corner : reader.lines.values) {
      const std::uint32_t i =
          corner.texture == none && by_position ? corner.position : corner.texture;
      const bool has = i < reader.textures.count() && k < reader.textures.row(i).size();
      attributes[fmt::format("attribute{}", k)].push_back(has ? reader.textures.row(i)[k] : NAN);
    }
  return attributes;
}

LineSet read_obj_lines(const std::filesystem::path& path) {
  const ObjReader reader = read_file(path);
  LineSet lines;
  for (const Corner& corner : reader.lines.values) {
    lines.positions.push_back(reader.mesh.positions[corner.position]);
    if (reader.has_color) lines.colors.push_back(reader.mesh.colors[corner.position]);
  }
  lines.offsets.assign(reader.lines.ends.begin(), reader.lines.ends.end());
  lines.scalars = texture_attributes(reader);
  return lines;
}

std::string encode_obj(const TriangleMesh& mesh) {
  std::string out;
  const auto to = std::back_inserter(out);
  for (const Vec3& x : mesh.positions) fmt::format_to(to, "v {} {} {}\n", x.x, x.y, x.z);
  for (const Vec3& n : mesh.normals) fmt::format_to(to, "vn {} {} {}\n", n.x, n.y, n.z);
  const bool lit = !mesh.normals.empty();
  for (const auto& [a, b, c] : mesh.triangles)
    if (lit)
      fmt::format_to(to, "f {0}//{0} {1}//{1} {2}//{2}\n", a + 1, b + 1, c + 1);
    else
      fmt::format_to(to, "f {} {} {}\n", a + 1, b + 1, c + 1);
  return out;
}

std::string encode_obj(const LineSet& lines) {
  std::string out;
  const auto to = std::back_inserter(out);
  for (const Vec3& x : lines.positions) fmt::format_to(to, "v {} {} {}\n", x.x, x.y, x.z);
  for (std::size_t line = 0; line < lines.line_count(); ++line) {
    out += 'l';
    for (std::uint64_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
      fmt::format_to(to, " {}", i + 1);
    out += '\n';
  }
  return out;
}

void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh) {
  write_text(path, encode_obj(mesh));
}
void write_obj_lines(const std::filesystem::path& path, const LineSet& lines) {
  write_text(path, encode_obj(lines));
}

}  // namespace

FormatRow obj_format() {
  return {.ending = ".obj",
          .title = "Wavefront object",
          .traps = "vt at lines are the scalars attribute0, …",
          .read_mesh = read_obj,
          .read_lines = read_obj_lines,
          .write_mesh = write_obj,
          .write_lines = write_obj_lines};
}

}  // namespace pellucid::geometry
