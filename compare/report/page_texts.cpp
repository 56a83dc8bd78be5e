// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/page_texts.h"

#include <fmt/format.h>

#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/packed_words.h"
#include "core/files/output_file.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

constexpr int all_bits = 23;  // of a float's mantissa

std::vector<std::uint32_t> words_of(const ReportCell& cell, int mantissa_bits) {
  return color_words(read_image(cell.files.picture()), mantissa_bits);
}

/// So many cells are packed at once: each takes some pictures' memory.
constexpr std::size_t at_once = 8;

/// A PixelTexts packs some cells at once, then the next ones; the reference of the last one's scene
/// is kept.
class PixelTexts {
 public:
  PixelTexts(std::span<const ReportCell> cells, int mantissa_bits)
      : cells_(cells), mantissa_bits_(mantissa_bits) {}

  /// The floats and layers of the next cells, of each apart, in order; of those that failed
  /// nothing. There are cells left.
  std::vector<PageTexts> next() {
    const std::size_t first = next_;
    keep_reference();
    while (next_ < cells_.size() && next_ < first + at_once && is_of_scene(next_)) ++next_;
    std::vector<PageTexts> texts(next_ - first);
    parallel_for(std::size_t(0), texts.size(), [&](std::size_t i) { texts[i] = of(first + i); });
    return texts;
  }
  bool is_over() const { return next_ == cells_.size(); }

 private:
  bool is_of_scene(std::size_t place) const {
    return !cells_[place].is_done() || cells_[place].reference == reference_;
  }

  void keep_reference() {
    const ReportCell& cell = cells_[next_];
    if (!cell.is_done() || (!words_.empty() && reference_ == cell.reference)) return;
    reference_ = cell.reference;
    words_ = words_of(cells_[reference_], mantissa_bits_);
  }

  PageTexts of(std::size_t place) const {
    const ReportCell& cell = cells_[place];
    PageTexts texts;
    if (!cell.is_done()) return texts;
    texts[fmt::format("pixels-{}", place)] =
        place == reference_ ? packed_words(words_)
                            : packed_words(words_of(cell, mantissa_bits_), words_);
    if (std::filesystem::exists(cell.files.layers()))
      texts[fmt::format("layers-{}", place)] =
          packed_words(read_counts(cell.files.layers()).pixels);
    return texts;
  }

  std::span<const ReportCell> cells_;
  int mantissa_bits_;
  std::size_t next_ = 0;
  std::size_t reference_ = 0;
  std::vector<std::uint32_t> words_;  // of the reference's picture
};

/// Maps and further pictures of the cell at `place`.
PageTexts map_texts(const ReportCell& cell, std::size_t place) {
  PageTexts texts;
  if (std::filesystem::exists(cell.files.flip_map()))
    texts[fmt::format("flip-{}", place)] = data_uri(cell.files.flip_map());
  for (std::size_t k = 0; k < cell.row->pictures.size(); ++k)
    texts[fmt::format("further-{}-{}", place, k)] =
        data_uri(cell.files.further(cell.row->pictures[k].name));
  return texts;
}

std::size_t bytes_of(const PageTexts& texts) {
  std::size_t bytes = 0;
  for (const auto& [key, text] : texts) bytes += text.size();
  return bytes;
}

}  // namespace

std::optional<PageTexts> pixel_texts(std::span<const ReportCell> cells, int mantissa_bits,
                                     std::size_t most_bytes) {
  PageTexts texts;
  std::size_t bytes = 0;
  for (PixelTexts pixels(cells, mantissa_bits); !pixels.is_over();)
    for (PageTexts& of_cell : pixels.next()) {
      bytes += bytes_of(of_cell);
      if (bytes > most_bytes) return std::nullopt;
      texts.merge(of_cell);
    }
  return texts;
}

void for_each_text(std::span<const ReportCell> cells,
                   const std::function<void(const std::string&, const std::string&)>& visit) {
  std::size_t place = 0;
  for (PixelTexts pixels(cells, all_bits); !pixels.is_over();)
    for (const PageTexts& of_cell : pixels.next()) {
      for (const auto& [key, text] : of_cell) visit(key, text);
      if (cells[place].is_done())
        for (const auto& [key, text] : map_texts(cells[place], place)) visit(key, text);
      ++place;
    }
}

std::string data_uri(const std::filesystem::path& png) {
  return "data:image/png;base64," + base64(read_text(png));
}

}  // namespace pellucid::compare
