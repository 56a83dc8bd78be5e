// SPDX-License-Identifier: GPL-3.0-or-later
// "NAME:key=value,…" of methods, integrators and fields, as command line and files write it.

#include "compare/methods/method_call.h"
#include "compare/methods/methods.h"
#include "compare/methods/surface_methods.h"
#include "core/options/names.h"
#include "fields/make_field.h"
#include "fuzz/support/attempt.h"
#include "fuzz/support/file_in_memory.h"
#include "fuzz/support/use_field.h"
#include "integrators/lines/integrate_lines.h"

using namespace pellucid;

namespace {

void check(const NameAndOptions& call, std::string_view kind,
           std::span<const scene::MethodRow> rows) {
  const scene::MethodRow& row = find_row(kind, call.name, rows);
  const Parameters parameters(row.name, row.parameters, call.options);
  const compare::MethodCall method{&row, parameters};
  const NameAndOptions again = parse_name_and_options(method.text());
  if (again.name != call.name || again.options != call.options) std::abort();
  for (const ParameterSpec& spec : row.parameters)
    if (spec.kind == ParameterSpec::Kind::integer && parameters.is_set(spec.name))
      parameters.integer(spec.name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of({data, size}));
  NameAndOptions call;
  fuzz::attempt("", [&] { call = parse_name_and_options(text); });
  fuzz::attempt("", [&] { check(call, "method", compare::methods()); });
  fuzz::attempt("", [&] { check(call, "integrator", compare::surface_methods()); });
  fuzz::attempt("", [&] { integrators::line_particles(text); });
  fuzz::attempt("", [&] { fuzz::use(*fields::make_field(text)); });
  return 0;
}
