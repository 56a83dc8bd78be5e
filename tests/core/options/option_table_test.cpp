// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/option_table.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.h"

namespace pellucid {
namespace {

enum class Shape { disc, sphere };

struct Scheme {
  std::string_view name;
  int order;
};
constexpr Scheme schemes[] = {{"euler", 1}, {"midpoint", 2}};

struct Weights {
  double q = 50;
};

struct Everything {
  int bands = 5;
  std::uint64_t most = 20'000'000;
  double clamp = 0.9999;
  float width = 1e-6f;
  bool normalize = true;
  Shape shape = Shape::sphere;
  int precision = 32;
  std::string scalar = "speed";
  std::optional<double> bias;
  std::optional<Shape> profile;
  const Scheme* scheme = &schemes[1];
  double steps = 8;
  std::optional<double> grown;
  Weights weights;
};

const OptionTable<Weights>& weight_options() {
  const std::string help = "percent, " + number_text(Weights{}.q) + " of all";
  static const OptionTable<Weights> table{number("q", &Weights::q, {.min = 0, .help = help})};
  return table;
}

std::string growth_text(const std::optional<double>& by) {
  return by ? "by:" + number_text(*by) : "none";
}

std::optional<double> growth(const std::string& text) {
  double by = 0;
  if (text == "none") return std::nullopt;
  if (!text.starts_with("by:") || !parse_number(text.substr(3), by)) throw InputError(text);
  return by;
}

const OptionTable<Everything>& everything() {
  static const OptionTable<Everything> table{
      number("bands", &Everything::bands, {.min = 1, .max = 64, .unit = "bands"}),
      number("most", &Everything::most, {.min = 1}),
      number("clamp", &Everything::clamp, {.min = 0, .max = 1}),
      number("width", &Everything::width, {}),
      flag("normalize", &Everything::normalize, "on: Eq. 19"),
      choice("shape", &Everything::shape, {{"disc", Shape::disc}, {"sphere", Shape::sphere}}),
      choice("precision", &Everything::precision, {{"16", 16}, {"32", 32}}, "", "bits"),
      text("scalar", &Everything::scalar),
      number("bias", &Everything::bias, {.min = 0}),
      choice("profile", &Everything::profile, {{"disc", Shape::disc}, {"sphere", Shape::sphere}}),
      choice("scheme", &Everything::scheme, schemes, "moves"),
      number("steps", &Everything::steps, {.min = 1, .whole = true}),
      written("grown", &Everything::grown, growth_text, growth),
      part(&Everything::weights, weight_options())};
  return table;
}

Everything read(std::string_view given) {
  const NameAndOptions named = parse_name_and_options(given);
  return everything().read(Parameters(named.name, everything().specs(), named.options));
}

const ParameterSpec& spec_of(std::string_view name) {
  for (const ParameterSpec& spec : everything().specs())
    if (spec.name == name) return spec;
  throw InputError("no such option");
}

std::string_view default_of(std::string_view name) { return spec_of(name).default_value; }

TEST(UnitOptionTable, PrintsTheDefaultsOfTheStruct) {
  EXPECT_EQ(default_of("bands"), "5");
  EXPECT_EQ(default_of("most"), "20000000");
  EXPECT_EQ(default_of("clamp"), "0.9999");
  EXPECT_EQ(default_of("normalize"), "on");
  EXPECT_EQ(default_of("shape"), "sphere");
  EXPECT_EQ(default_of("precision"), "32");
  EXPECT_EQ(default_of("scalar"), "speed");
  EXPECT_EQ(default_of("bias"), "");
  EXPECT_EQ(default_of("profile"), "");
  EXPECT_EQ(default_of("scheme"), "midpoint");
  EXPECT_EQ(default_of("steps"), "8");
  EXPECT_EQ(default_of("grown"), "none");
  EXPECT_EQ(default_of("q"), "50");
}

TEST(UnitOptionTable, WithoutOptionsItReadsTheStruct) {
  const Everything options = read("method");
  EXPECT_EQ(options.bands, 5);
  EXPECT_EQ(options.most, 20'000'000u);
  EXPECT_EQ(options.clamp, 0.9999);
  EXPECT_EQ(options.width, 1e-6f);
  EXPECT_TRUE(options.normalize);
  EXPECT_EQ(options.shape, Shape::sphere);
  EXPECT_EQ(options.scalar, "speed");
  EXPECT_FALSE(options.bias || options.profile);
  EXPECT_EQ(options.weights.q, 50);
}

TEST(UnitOptionTable, WhatIsGivenReachesItsMember) {
  const Everything options = read(
      "method:bands=7,most=9000000000,clamp=0.5,width=2,normalize=off,shape=disc,precision=16,"
      "scalar=q,bias=1e-7,profile=sphere,steps=2,grown=by:0.5,q=3");
  EXPECT_EQ(options.bands, 7);
  EXPECT_EQ(options.most, 9'000'000'000u);
  EXPECT_EQ(options.clamp, 0.5);
  EXPECT_EQ(options.width, 2);
  EXPECT_FALSE(options.normalize);
  EXPECT_EQ(options.shape, Shape::disc);
  EXPECT_EQ(options.precision, 16);
  EXPECT_EQ(options.scalar, "q");
  EXPECT_EQ(options.bias, 1e-7);
  EXPECT_EQ(options.profile, Shape::sphere);
  EXPECT_EQ(options.steps, 2);
  EXPECT_EQ(options.grown, 0.5);
  EXPECT_EQ(options.weights.q, 3);
}

TEST(UnitOptionTable, ARowIsChosenByItsName) {
  EXPECT_EQ(spec_of("scheme").choices, "euler|midpoint");
  EXPECT_EQ(read("method").scheme, &schemes[1]);
  EXPECT_EQ(read("method:scheme=euler").scheme, &schemes[0]);
  EXPECT_THROW(read("method:scheme=verlet"), InputError);
}

TEST(UnitOptionTable, HelpThatWasComposedIsKept) {
  EXPECT_EQ(spec_of("q").help, "percent, 50 of all");
  EXPECT_EQ(spec_of("scheme").help, "moves");
}

TEST(UnitOptionTable, BoundsAndNamesAreChecked) {
  for (const char* wrong :
       {"m:bands=0", "m:bands=65", "m:bands=2.5", "m:shape=cube", "m:q=-1", "m:normalize=yes",
        "m:most=0", "m:steps=2.5", "m:grown=much", "m:none=1"})
    EXPECT_THROW(read(wrong), InputError) << wrong;
}

TEST(UnitOptionTable, NumbersAreWrittenShortAndReadBackEqual) {
  EXPECT_EQ(number_text(1e-6), "1e-6");
  EXPECT_EQ(number_text(1e-4), "0.0001");
  EXPECT_EQ(number_text(2.5e-10), "2.5e-10");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-3), "-3");
  EXPECT_EQ(number_text(1e9), "1000000000");
  for (const double value :
       {0.1, 1e-300, 1e300, 1e-5, 1.0 / 3, 1e22, std::numeric_limits<double>::denorm_min()}) {
    double read = 0;
    EXPECT_TRUE(parse_number(number_text(value), read));
    EXPECT_EQ(read, value);
  }
}

}  // namespace
}  // namespace pellucid
