// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/parts/deep_outputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/pictures/image_file.h"

namespace pellucid::compare {
namespace {

/// A picture of a part is not the whole's.
PictureForm form_of(const DeepInfo& info) {
  PictureForm form = form_of_picture(origin_of(info, "raytrace"));
  if (info.part.count > 1)
    form.text.emplace_back("Part", fmt::format("{}/{}", info.part.part, info.part.count));
  return form;
}

}  // namespace

DeepOutputs::DeepOutputs(const DeepInfo& info, std::filesystem::path picture,
                         const std::filesystem::path& deep)
    : background_(backdrop(info)), form_(form_of(info)), picture_(std::move(picture)) {
  if (!picture_.empty()) image_ = Image(info.width, info.height);
  if (!deep.empty()) writer_ = make_deep_writer(deep, info);
}

void DeepOutputs::take(int y, const DeepRow& row) {
  const auto width = std::size_t(image_.width);
  if (!picture_.empty())
    composite(row, background_, std::span(image_.pixels).subspan(std::size_t(y) * width, width));
  if (writer_) writer_->add(row);
  crossings_ += row.layers.size();
  for (const std::uint32_t count : row.counts) max_layers_ = std::max(max_layers_, count);
}

void DeepOutputs::commit() {
  if (writer_) writer_->commit();
  if (!picture_.empty()) write_image(picture_, image_, form_);
}

}  // namespace pellucid::compare
