// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ. tinyobjloader reads a number that it cannot parse as 0; this reader refuses such a
// file and names the line.

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/files/mesh_formats.h"

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

struct ObjReader {
  std::string file;
  std::size_t line = 0;
  TriangleMesh mesh;
  std::vector<std::vector<std::uint32_t>> lines;
  std::vector<Vec3> normals;        // as listed
  std::vector<Vec3> vertex_normal;  // per position, the last one that a face named
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

  /// One-based, or negative from the end.
  std::uint32_t index(std::string_view word, std::size_t count, std::string_view what) const {
    const double given = number(word);
    const double zero_based = given < 0 ? double(count) + given : given - 1;
    if (!(zero_based >= 0 && zero_based < double(count)) || zero_based != std::uint32_t(zero_based))
      fail(fmt::format("{} index {}, but {} were listed so far", what, word, count));
    return static_cast<std::uint32_t>(zero_based);
  }

  std::uint32_t corner(std::string_view word) {
    const std::size_t slash = word.find('/'), last = word.rfind('/');
    const std::uint32_t v = index(word.substr(0, slash), mesh.positions.size(), "vertex");
    if (slash != last && last + 1 < word.size()) {
      vertex_normal.resize(mesh.positions.size());
      vertex_normal[v] = normals[index(word.substr(last + 1), normals.size(), "normal")];
    }
    return v;
  }

  void face(Words& words) {
    std::uint32_t first = 0, previous = 0;
    int corners = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const std::uint32_t v = corner(word);
      if (corners++ >= 2) mesh.triangles.push_back({first, previous, v});
      if (corners == 1) first = v;
      previous = v;
    }
  }

  void polyline(Words& words) {
    lines.emplace_back();
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
      lines.back().push_back(
          index(word.substr(0, word.find('/')), mesh.positions.size(), "vertex"));
  }

  void read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      Words words(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line;
      const std::string_view keyword = words.next();
      if (keyword == "v") vertex(words);
      if (keyword == "vn") normals.push_back(vector(words));
      if (keyword == "f") face(words);
      if (keyword == "l") polyline(words);
    }
  }
};

TriangleMesh read_obj(const std::filesystem::path& path) {
  ObjReader reader{path.string(), 0, {}, {}, {}, {}, false};
  reader.read(read_text(path));
  if (!reader.has_color) reader.mesh.colors.clear();
  if (reader.vertex_normal.size() == reader.mesh.positions.size())
    reader.mesh.normals = std::move(reader.vertex_normal);
  return std::move(reader.mesh);
}

LineSet read_obj_lines(const std::filesystem::path& path) {
  ObjReader reader{path.string(), 0, {}, {}, {}, {}, false};
  reader.read(read_text(path));
  LineSet lines;
  for (const auto& polyline : reader.lines) {
    for (const std::uint32_t v : polyline) {
      lines.positions.push_back(reader.mesh.positions[v]);
      if (reader.has_color) lines.colors.push_back(reader.mesh.colors[v]);
    }
    lines.offsets.push_back(lines.positions.size());
  }
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
          .read_mesh = read_obj,
          .read_lines = read_obj_lines,
          .write_mesh = write_obj,
          .write_lines = write_obj_lines};
}

}  // namespace pellucid::geometry
