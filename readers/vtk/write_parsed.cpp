// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/write_parsed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vtkDataSet.h>

#include "readers/vtk/data_set_blocks.h"

namespace pellucid::readers {

void write_parsed(const std::filesystem::path& path, std::span<const VtkReader> readers,
                  std::span<const std::string> arguments, BlockWriter& out) {
  VtkRequest request;
  if (arguments.size() == 3) request = {arguments[0], arguments[1], arguments[2]};
  int number = 0;
  const auto take = [&](const ParsedTime& parsed) {
    out.name_within(fmt::format("{}|", number++));
    write_data_set(*parsed.data, out, parsed.is_last ? Numbers::for_once : Numbers::kept);
    out.add_text("blocks", fmt::format("{}", fmt::join(parsed.blocks, "\n")));
    out.add_text("left out", fmt::format("{}", fmt::join(parsed.left_out, "\n")));
  };
  const FileTimes times = parse_vtk_file(path, readers, request, take);
  out.name_within("");
  out.add("times", std::span<const double>(times.read));
  out.add("all times", std::span<const double>(times.all));
}

}  // namespace pellucid::readers
