// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of Wavefront OBJ: newmtl, Kd, d, Tr. "d" is the format's, and counts where "Tr", which
// programs have added, says otherwise. What else they say is of light, which the scene has, or a
// texture.

#include "geometry/files/obj/mtl_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/parameters.h"
#include "geometry/files/obj/words.h"
#include "geometry/files/text_lines.h"

namespace pellucid::geometry {
namespace {

class MtlReader {
 public:
  MtlReader(const std::filesystem::path& path, MtlMaterials& materials)
      : path_(path), materials_(materials) {}

  void read() {
    const std::string content = read_text(path_);
    for (std::string_view text = without_mark(content); !text.empty();) {
      ++line_;
      statement(Words(take_line(text)));
    }
  }

 private:
  double share(std::string_view keyword, std::string_view word) const {
    double value = 0;
    if (word.empty() || !parse_number(word, value) || !(value >= 0 && value <= 1))
      throw InputError(fmt::format("{}:{}: {} '{}'; accepted: numbers in 0 … 1", path_.string(),
                                   line_, keyword, word));
    return value;
  }

  /// "Kd r g b", or "Kd r", which is grey. Of a spectrum or of XYZ the colour is not known.
  void diffuse(Words& words) {
    const std::string_view first = words.next();
    if (first == "spectral" || first == "xyz") return pass_over(fmt::format("Kd {}", first));
    const std::string_view green = words.next(), blue = words.next();
    const double red = share("Kd", first);
    material_->color = green.empty() ? Vec3(red) : Vec3(red, share("Kd", green), share("Kd", blue));
  }

  /// "d -halo x" is less opaque where it is seen at a slant; x is that where it is seen so.
  void dissolve(Words& words) {
    std::string_view word = words.next();
    if (word == "-halo") {
      pass_over("d -halo");
      word = words.next();
    }
    material_->opacity = share("d", word);
    has_dissolve_ = true;
  }

  void transparency(Words& words) {
    const double share_through = share("Tr", words.next());
    if (!has_dissolve_) material_->opacity = 1 - share_through;
  }

  void begin(const std::string& name) {
    material_ = &(materials_[name] = {});
    has_dissolve_ = false;
  }
  void pass_over(std::string what) {
    if (material_->passed_over.empty()) material_->passed_over = std::move(what);
  }

  void statement(Words words) {
    const std::string_view keyword = words.next();
    if (keyword == "newmtl") return begin(std::string(words.rest()));
    if (!material_) return;
    if (keyword == "Kd") diffuse(words);
    if (keyword == "d") dissolve(words);
    if (keyword == "Tr") transparency(words);
    if (keyword == "map_Kd" || keyword == "map_d") pass_over(std::string(keyword));
  }

  const std::filesystem::path& path_;
  MtlMaterials& materials_;
  MtlMaterial* material_ = nullptr;
  std::size_t line_ = 0;
  bool has_dissolve_ = false;
};

}  // namespace

void read_mtl(const std::filesystem::path& path, MtlMaterials& materials) {
  MtlReader(path, materials).read();
}

}  // namespace pellucid::geometry
