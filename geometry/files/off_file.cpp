// SPDX-License-Identifier: GPL-3.0-or-later
// .off, Geomview's Object File Format (geomview.org/docs/html/OFF.html), as text: letters before
// "OFF" say what a vertex has behind its position, in this order: N a normal, C a colour (three or
// four numbers up to the line's end; many programs write it under the plain head OFF). Then counts
// of vertices, faces and edges; vertices; faces, each its number of corners, the corners, and up to
// the line's end a colour, or its number in a map, which is passed over. "#" begins a comment.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/default_color.h"
#include "geometry/files/face_colors.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"
#include "geometry/polygons/triangulate.h"

namespace pellucid::geometry {
namespace {

/// The words of a file, line by line; lines without a word do not count.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& path)
      : file_(path.string()), content_(read_text(path)), rest_(without_mark(content_)) {}

  /// The words of the next line.
  const std::vector<std::string_view>& next() {
    do {
      if (rest_.empty()) fail("the file ends before all that it declares");
      split();
    } while (words_.empty());
    return words_;
  }
  std::uint64_t bytes_left() const { return rest_.size(); }

  double number(std::string_view word) const {
    double value = 0;
    if (!parse_number(word, value)) fail(fmt::format("'{}': expected a number", word));
    return value;
  }
  /// A whole number below `end`.
  std::uint64_t whole(std::string_view word, double end, std::string_view what) const {
    const double value = number(word);
    if (!(value >= 0 && value < end) || value != std::floor(value))
      fail(fmt::format("{} {}; accepted: 0 … {}", what, word, end - 1));
    return std::uint64_t(value);
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, what));
  }

 private:
  void split() {
    ++line_;
    const std::string_view whole = take_line(rest_);
    std::string_view line = whole.substr(0, whole.find('#'));
    words_.clear();
    constexpr std::string_view blanks = " \t";
    for (std::size_t begin; (begin = line.find_first_not_of(blanks)) != line.npos;) {
      line.remove_prefix(begin);
      words_.push_back(line.substr(0, line.find_first_of(blanks)));
      line.remove_prefix(words_.back().size());
    }
  }

  std::string file_, content_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

struct OffHeader {
  bool normals = false, colors = false;
  std::uint64_t vertices = 0, faces = 0;
};

void read_magic(std::string_view word, OffHeader& header, const Lines& lines) {
  const std::size_t off = word.find("OFF");
  const std::string_view letters = word.substr(0, std::min(off, word.size()));
  if (off == word.npos || word.substr(off) != "OFF" ||
      letters.find_first_not_of("CN") != letters.npos)
    lines.fail(fmt::format("'{}'; accepted: OFF, COFF, NOFF, CNOFF, in text", word));
  header.colors = letters.find('C') != letters.npos;
  header.normals = letters.find('N') != letters.npos;
}

/// The counts may stand on the line of the magic word, or on the next.
OffHeader read_header(Lines& lines) {
  OffHeader header;
  std::vector<std::string_view> words = lines.next();
  read_magic(words.front(), header, lines);
  words.erase(words.begin());
  if (!words.empty() && words.front() == "BINARY") lines.fail("'BINARY'; accepted: files of text");
  if (words.empty()) words = lines.next();
  if (words.size() < 2) lines.fail("expected the numbers of vertices, faces and edges");
  // Each takes a number of bytes that the file has to have.
  const double most = double(lines.bytes_left()) + 1;
  header.vertices = lines.whole(words[0], most, "number of vertices");
  header.faces = lines.whole(words[1], most, "number of faces");
  return header;
}

/// The colours of a file, as they stand in it: of each vertex or face three or four numbers.
class Colors {
 public:
  /// `numbers` are none, or a colour.
  void add(std::span<const double> numbers) {
    has_some_ = has_some_ || !numbers.empty();
    is_whole_ &= std::ranges::all_of(numbers, [](double x) { return x == std::floor(x); });
    for (const double x : numbers) most_ = std::max(most_, x);
    rows_.emplace_back(numbers.begin(), numbers.end());
  }
  bool has_some() const { return has_some_; }

  /// Bytes, where all of the file's are whole and one is above 1; else in [0, 1]. What has none is
  /// of the default colour.
  std::vector<Rgba> take() const {
    const double unit = is_whole_ && most_ > 1 ? 255 : 1;
    std::vector<Rgba> colors;
    colors.reserve(rows_.size());
    for (const auto& row : rows_)
      colors.push_back(row.empty() ? Rgba(default_color, 1)
                                   : Rgba(row[0] / unit, row[1] / unit, row[2] / unit,
                                          row.size() > 3 ? row[3] / unit : 1));
    return colors;
  }

 private:
  std::vector<std::vector<double>> rows_;
  bool has_some_ = false, is_whole_ = true;
  double most_ = 0;
};

/// A vertex with a colour or, under a head that promises none, without.
void read_vertex(Lines& lines, const OffHeader& header, TriangleMesh& mesh, Colors& colors) {
  std::vector<double> numbers;
  for (const std::string_view word : lines.next()) numbers.push_back(lines.number(word));
  const std::size_t before_color = header.normals ? 6 : 3;
  const std::size_t more = numbers.size() - std::min(before_color, numbers.size());
  const bool has_color = more == 3 || more == 4;
  if (numbers.size() < before_color || !(has_color || (more == 0 && !header.colors)))
    lines.fail(fmt::format("a vertex of {} numbers; expected {}{} a colour of 3 or 4",
                           numbers.size(), before_color,
                           header.colors ? " and" : ", with or without"));
  mesh.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
  if (header.normals) mesh.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
  colors.add(std::span(numbers).subspan(before_color));
}

/// A face, whose colour goes to each of its triangles.
void read_face(Lines& lines, TriangleMesh& mesh, Colors& colors) {
  const auto& words = lines.next();
  const std::uint64_t count = lines.whole(words[0], double(words.size()), "number of corners");
  std::vector<std::uint32_t> corners;
  for (std::uint64_t k = 1; k <= count; ++k)
    corners.push_back(
        std::uint32_t(lines.whole(words[k], double(mesh.positions.size()), "a face's vertex")));
  std::vector<double> color;
  const std::size_t more = words.size() - 1 - count;
  for (std::size_t k = 0; k < more && (more == 3 || more == 4); ++k)
    color.push_back(lines.number(words[1 + count + k]));
  const std::size_t before = mesh.triangles.size();
  triangulate_polygon(mesh.positions, corners, mesh.triangles);
  for (std::size_t i = before; i < mesh.triangles.size(); ++i) colors.add(color);
}

FileMesh read_off(const std::filesystem::path& path) {
  Lines lines(path);
  const OffHeader header = read_header(lines);
  FileMesh mesh;
  Colors of_vertices, of_faces;
  for (std::uint64_t i = 0; i < header.vertices; ++i) read_vertex(lines, header, mesh, of_vertices);
  for (std::uint64_t i = 0; i < header.faces; ++i) read_face(lines, mesh, of_faces);
  if (of_vertices.has_some())
    mesh.colors = of_vertices.take();
  else if (of_faces.has_some())
    color_faces({of_faces.take()}, mesh);
  return mesh;
}

}  // namespace

FormatRow off_format() {
  return {.ending = ".off",
          .title = "Geomview object file, text",
          .traps =
              "colours of whole numbers, of which one is above 1, count in 255ths; those of faces "
              "are flat, "
              "and count where the vertices have none",
          .read_mesh = read_off};
}

}  // namespace pellucid::geometry
