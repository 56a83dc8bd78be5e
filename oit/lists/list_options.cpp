// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/lists/list_options.h"

namespace pellucid::oit {

const OptionTable<ListOptions>& list_options() {
  static const OptionTable<ListOptions> table{
      number("fragments-per-pass", &ListOptions::fragments_per_pass,
             {.min = 1,
              .max = 1e12,
              .unit = "fragments",
              .help = "kept at once; a picture of more is drawn by bands of rows, each a pass over "
                      "the scene. Not set: as many as the driver's largest buffer holds"})};
  return table;
}

}  // namespace pellucid::oit
