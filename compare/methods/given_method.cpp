// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/given_method.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::compare {
namespace {

std::unique_ptr<scene::Renderer> only_by_call(const scene::Scene&, const Parameters& parameters,
                                              const scene::RenderContext&) {
  throw InputError(fmt::format("{}: pictures from elsewhere; accepted: a method of the program",
                               parameters.owner()));
}

}  // namespace

GivenMethod::GivenMethod(std::string name, std::string_view kind)
    : name_(std::move(name)), title_(fmt::format("{} (given: {})", name_, kind)), kind_(kind) {
  row_.name = name_;
  row_.title = title_;
  row_.make = only_by_call;
}

std::unique_ptr<scene::Renderer> make_renderer(const MethodCall& call, const scene::Scene& scene,
                                               const scene::RenderContext& context,
                                               const GivenPlace& place) {
  if (call.given) return call.given->make(scene, place);
  return call.row->make(scene, call.parameters, context);
}

}  // namespace pellucid::compare
