// SPDX-License-Identifier: GPL-3.0-or-later
// The units of bindings.glsl: used everywhere, told apart in every shader.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>

#include "oit/gl/bindings.h"
#include "oit/gl/pass.h"
#include "oit/gl/program.h"
#include "oit_glsl.h"

namespace pellucid::oit::test {
namespace {

using Matches = std::cregex_iterator;

Matches matches(std::string_view text, const std::regex& pattern) {
  return {text.data(), text.data() + text.size(), pattern};
}

/// The value of every name.
std::map<std::string, int> names() {
  static const std::regex declaration(R"(const int (\w+) = (\d+);)");
  std::map<std::string, int> values;
  for (Matches m = matches(oit_glsl::bindings_glsl(), declaration); m != Matches(); ++m)
    values[(*m)[1]] = std::stoi((*m)[2]);
  return values;
}

/// A unit as a shader writes it: a name, or a name + a number.
int value_of(const std::string& unit) {
  std::smatch parts;
  if (!std::regex_match(unit, parts, std::regex(R"((\w+)(?: \+ (\d+))?)"))) return -1;
  static const std::map<std::string, int> all = names();
  const auto found = all.find(parts[1]);
  if (found == all.end()) return -1;
  return found->second + (parts[2].matched ? std::stoi(parts[2]) : 0);
}

struct Bound {
  std::string unit, type, name;
};

/// What a shader with its shared files binds, whatever its defines.
std::vector<Bound> bound_by(std::string_view text) {
  static const std::regex layout(
      R"(layout\(binding = ([^,)]+)[^)]*\)\s*(?:(?:coherent|readonly|uniform)\s+)*(\w+)\s*(\w*))");
  std::vector<Bound> all;
  for (Matches m = matches(text, layout); m != Matches(); ++m)
    all.push_back({(*m)[1], (*m)[2], (*m)[3]});
  return all;
}

std::string kind_of_type(const std::string& type) {
  for (const char* kind : {"image", "sampler", "atomic", "buffer"})
    if (type.find(kind) != std::string::npos) return kind;
  return "uniform block";
}

bool is_shader(const oit_glsl::File& file) {
  return file.path.ends_with(".frag.glsl") || file.path.ends_with(".vert.glsl");
}

TEST(UnitBindings, NoShaderHasAUnitOfItsOwn) {
  static const std::regex literal(R"(binding\s*=\s*\d)");
  static const std::regex attribute(R"(location\s*=\s*\d+\)\s*in\b)");
  for (const oit_glsl::File& file : oit_glsl::files()) {
    EXPECT_EQ(matches(file.text(), literal), Matches()) << file.path;
    EXPECT_EQ(matches(file.text(), attribute), Matches()) << file.path;
  }
}

TEST(UnitBindings, CppAndGlslReadTheSameNumbers) {
  EXPECT_EQ(value_of("element_opacities_image"), bindings::element_opacities_image);
  EXPECT_EQ(value_of("coefficients_image + 2"), bindings::coefficients_image + 2);
  EXPECT_EQ(value_of("no_such_image"), -1);
}

// Also of a superset: what a shader binds with some defines and what with others.
TEST(PropertyBindings, NoTwoOfAShadersUnitsAreOne) {
  int seen = 0;
  for (const oit_glsl::File& file : oit_glsl::files()) {
    if (!is_shader(file)) continue;
    std::map<std::pair<std::string, int>, std::set<std::string>> units;
    const std::string text = expand_includes(file.text());
    for (const auto& [unit, type, name] : bound_by(text)) {
      ASSERT_GE(value_of(unit), 0) << file.path << ": " << unit;
      units[{kind_of_type(type), value_of(unit)}].insert(type + " " + name);
      ++seen;
    }
    for (const auto& [unit, names] : units)
      EXPECT_EQ(names.size(), 1u) << file.path << ": " << *names.begin() << ", " << *names.rbegin();
  }
  EXPECT_GT(seen, 100);
}

TEST(PropertyBindings, EveryUnitIsOneThatDriversHave) {
  const std::map<std::string, int> most = {{"image", bindings::image_units},
                                           {"sampler", bindings::texture_units},
                                           {"buffer", bindings::storage_blocks},
                                           {"atomic", bindings::atomic_counters},
                                           {"uniform block", bindings::uniform_blocks}};
  for (const oit_glsl::File& file : oit_glsl::files())
    for (const auto& [unit, type, name] : bound_by(file.text()))
      EXPECT_LT(value_of(unit), most.at(kind_of_type(type))) << file.path << ": " << unit;
}

Resource at(ResourceKind kind, GLuint unit) { return {.kind = kind, .unit = unit}; }

TEST(UnitResources, KindsHaveUnitsOfTheirOwn) {
  const Resources list{at(ResourceKind::texture, 1), at(ResourceKind::image, 1),
                       at(ResourceKind::image, 2)};
  EXPECT_TRUE(list.holds(ResourceKind::image, 1));
  EXPECT_TRUE(list.holds(ResourceKind::image, 2));
  EXPECT_FALSE(list.holds(ResourceKind::texture, 2));
  EXPECT_TRUE((list + at(ResourceKind::texture, 2)).holds(ResourceKind::texture, 2));
}

TEST(UnitResources, TwoAtOneUnitAssert) {
  Resources list{at(ResourceKind::image, 1)};
  EXPECT_DEBUG_DEATH(list.add(at(ResourceKind::image, 1)), "at one unit");
}

TEST(UnitPass, TheLastBlendIsThatOfAllThatFollow) {
  const Framebuffer none;
  const Pass pass(none, {Blend::add, Blend::under});
  EXPECT_EQ(pass.blends[0], Blend::add);
  for (std::size_t i = 1; i < pass.blends.size(); ++i) EXPECT_EQ(pass.blends[i], Blend::under);
}

}  // namespace
}  // namespace pellucid::oit::test
