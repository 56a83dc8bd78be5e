// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/make_field.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"
#include "fields/analytic/catalogue.h"
#include "fields/analytic/formula_field.h"
#include "fields/readers/file_field.h"

namespace pellucid::fields {
namespace {

[[noreturn]] void fail_unknown(std::string_view name) {
  std::vector<std::string_view> known;
  for (const FieldRow& row : analytic_fields()) known.push_back(row.name);
  known.push_back("formula");
  throw InputError(fmt::format("{}; or a file ending in {}", unknown_name("field", name, known),
                               file_endings()));
}

std::unique_ptr<VectorField> make_analytic(const FieldRow& row, const RawOptions& options) {
  return row.make(Parameters(fmt::format("field {}", row.name), row.parameters, options));
}

}  // namespace

std::unique_ptr<VectorField> make_field(std::string_view text, const std::filesystem::path& base) {
  if (auto field = read_file_field(text, base)) return field;
  const NameAndOptions given = parse_name_and_options(text);
  if (given.name == "formula") return make_formula_field(given.options);
  for (const FieldRow& row : analytic_fields())
    if (row.name == given.name) return make_analytic(row, given.options);
  fail_unknown(given.name);
}

}  // namespace pellucid::fields
