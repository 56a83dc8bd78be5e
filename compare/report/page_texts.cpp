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

/// The floats and layers of the cell at `place`; `reference` is kept for the cells that follow.
void add_pixels(std::span<const ReportCell> cells, std::size_t place, int mantissa_bits,
                std::pair<std::size_t, std::vector<std::uint32_t>>& reference, PageTexts& texts) {
  const ReportCell& cell = cells[place];
  if (reference.second.empty() || reference.first != cell.reference)
    reference = {cell.reference, words_of(cells[cell.reference], mantissa_bits)};
  texts[fmt::format("pixels-{}", place)] =
      place == cell.reference ? packed_words(reference.second)
                              : packed_words(words_of(cell, mantissa_bits), reference.second);
  if (std::filesystem::exists(cell.files.layers()))
    texts[fmt::format("layers-{}", place)] = packed_words(read_counts(cell.files.layers()).pixels);
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
  std::pair<std::size_t, std::vector<std::uint32_t>> reference;
  std::size_t bytes = 0;
  for (std::size_t place = 0; place < cells.size(); ++place) {
    if (!cells[place].is_done()) continue;
    PageTexts of_cell;
    add_pixels(cells, place, mantissa_bits, reference, of_cell);
    bytes += bytes_of(of_cell);
    if (bytes > most_bytes) return std::nullopt;
    texts.merge(of_cell);
  }
  return texts;
}

PageTexts texts_of(std::span<const ReportCell> cells, std::size_t place) {
  PageTexts texts;
  std::pair<std::size_t, std::vector<std::uint32_t>> reference;
  add_pixels(cells, place, all_bits, reference, texts);
  const ReportCell& cell = cells[place];
  if (std::filesystem::exists(cell.files.flip_map()))
    texts[fmt::format("flip-{}", place)] = data_uri(cell.files.flip_map());
  for (std::size_t k = 0; k < cell.row->pictures.size(); ++k)
    texts[fmt::format("further-{}-{}", place, k)] =
        data_uri(cell.files.further(cell.row->pictures[k].name));
  return texts;
}

std::string data_uri(const std::filesystem::path& png) {
  return "data:image/png;base64," + base64(read_text(png));
}

}  // namespace pellucid::compare
