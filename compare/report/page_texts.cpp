// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/page_texts.h"

#include <fmt/format.h>

#include "compare/pictures/image_file.h"
#include "compare/report/base64.h"
#include "compare/report/packed_words.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

constexpr int all_bits = 23;  // of a float's mantissa

std::vector<std::uint32_t> words_of(const ReportCell& cell, int mantissa_bits) {
  return color_words(read_image(cell.files.picture()), mantissa_bits);
}

/// A PixelTexts packs one cell after another; the reference of the last one's scene is kept.
class PixelTexts {
 public:
  PixelTexts(std::span<const ReportCell> cells, int mantissa_bits)
      : cells_(cells), mantissa_bits_(mantissa_bits) {}

  /// The floats and layers of the cell at `place`.
  PageTexts of(std::size_t place) {
    const ReportCell& cell = cells_[place];
    if (words_.empty() || reference_ != cell.reference) {
      reference_ = cell.reference;
      words_ = words_of(cells_[reference_], mantissa_bits_);
    }
    PageTexts texts;
    texts[fmt::format("pixels-{}", place)] =
        place == reference_ ? packed_words(words_)
                            : packed_words(words_of(cell, mantissa_bits_), words_);
    if (std::filesystem::exists(cell.files.layers()))
      texts[fmt::format("layers-{}", place)] =
          packed_words(read_counts(cell.files.layers()).pixels);
    return texts;
  }

 private:
  std::span<const ReportCell> cells_;
  int mantissa_bits_;
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
  PixelTexts pixels(cells, mantissa_bits);
  std::size_t bytes = 0;
  for (std::size_t place = 0; place < cells.size(); ++place) {
    if (!cells[place].is_done()) continue;
    PageTexts of_cell = pixels.of(place);
    bytes += bytes_of(of_cell);
    if (bytes > most_bytes) return std::nullopt;
    texts.merge(of_cell);
  }
  return texts;
}

void for_each_text(std::span<const ReportCell> cells,
                   const std::function<void(const std::string&, const std::string&)>& visit) {
  PixelTexts pixels(cells, all_bits);
  for (std::size_t place = 0; place < cells.size(); ++place) {
    if (!cells[place].is_done()) continue;
    for (const auto& [key, text] : pixels.of(place)) visit(key, text);
    for (const auto& [key, text] : map_texts(cells[place], place)) visit(key, text);
  }
}

std::string data_uri(const std::filesystem::path& png) {
  return "data:image/png;base64," + base64(read_text(png));
}

}  // namespace pellucid::compare
