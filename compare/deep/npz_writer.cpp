// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/deep/array_file.h"
#include "compare/deep/deep_formats.h"
#include "compare/pack/archive_writer.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

class NpzWriter : public DeepWriter {
 public:
  NpzWriter(const fs::path& path, const DeepInfo& info)
      : info_(info), archive_(path, ArchiveKind::zip), path_(path) {
    offsets_.add(std::span<const std::uint64_t>(&total_, 1));
  }

  void add(const DeepRow& row) override {
    for (const std::uint32_t count : row.counts) {
      total_ += count;
      offsets_.add(std::span<const std::uint64_t>(&total_, 1));
    }
    add(depth_, row, &DeepLayer::depth);
    add(opacity_, row, &DeepLayer::opacity);
    add(importance_, row, &DeepLayer::importance);
    add(object_, row, &DeepLayer::object);
    add(primitive_, row, &DeepLayer::primitive);
    for (const DeepLayer& layer : row.layers)
      color_.add(std::span<const double>(&layer.color.x, 3));
  }

  void commit() override {
    for (ArrayFile* array :
         {&offsets_, &depth_, &color_, &opacity_, &importance_, &object_, &primitive_})
      array->pack(archive_);
    const std::int64_t shape[] = {info_.height, info_.width};
    ArrayFile sides("shape", "<i8", 0, path_);
    sides.add(std::span<const std::int64_t>(shape));
    sides.pack(archive_);
    const std::string text = text_of(info_);
    const std::string header = npy_header(fmt::format("|S{}", text.size()), "");
    archive_.begin("info.npy", header.size() + text.size());
    archive_.write(header);
    archive_.write(text);
    archive_.commit();
  }

 private:
  template <class T>
  static void add(ArrayFile& array, const DeepRow& row, T DeepLayer::*member) {
    for (const DeepLayer& layer : row.layers) array.add(std::span<const T>(&(layer.*member), 1));
  }

  DeepInfo info_;
  ArchiveWriter archive_;
  fs::path path_;
  std::uint64_t total_ = 0;  // layers
  ArrayFile offsets_{"offsets", "<u8", 0, path_};
  ArrayFile depth_{"depth", "<f8", 0, path_};
  ArrayFile color_{"color", "<f8", 3, path_};
  ArrayFile opacity_{"opacity", "<f8", 0, path_};
  ArrayFile importance_{"importance", "<f4", 0, path_};
  ArrayFile object_{"object", "<u4", 0, path_};
  ArrayFile primitive_{"primitive", "<u4", 0, path_};
};

}  // namespace

std::unique_ptr<DeepWriter> make_npz_writer(const fs::path& path, const DeepInfo& info) {
  return std::make_unique<NpzWriter>(path, info);
}

}  // namespace pellucid::compare
