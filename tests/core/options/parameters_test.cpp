// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/parameters.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/options/names.h"

namespace pellucid {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr ParameterSpec specs[] = {
    {.name = "bands",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "5",
     .min = 1,
     .max = 15},
    {.name = "clamp", .default_value = "0.9999", .min = 0, .max = 1},
    {.name = "normalize", .kind = ParameterSpec::Kind::flag, .default_value = "on"},
    {.name = "weight",
     .kind = ParameterSpec::Kind::choice,
     .default_value = "7",
     .choices = "7|8|10"},
    {.name = "seed", .min = 0}};

/// The message of the InputError that `act` throws; a failure when it throws none.
template <class Act>
std::string message_of(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "expected an InputError";
  return {};
}

Parameters parse(std::string_view text) {
  const NameAndOptions named = parse_name_and_options(text);
  return {named.name, specs, named.options};
}

TEST(UnitParameters, SplitsNameAndOptions) {
  const NameAndOptions named = parse_name_and_options("formula:u=pow(x,2),v=-y,w=0.2");
  EXPECT_EQ(named.name, "formula");
  EXPECT_EQ(named.options.at("u"), "pow(x,2)");
  EXPECT_EQ(named.options.at("v"), "-y");
  EXPECT_EQ(named.options.at("w"), "0.2");
}

TEST(UnitParameters, RefusesWhatIsNotKeyAndValue) {
  EXPECT_THAT(message_of([] { parse("fourier:bands"); }), HasSubstr("'bands' is not of the form"));
  EXPECT_THAT(message_of([] { parse("fourier:bands=5,bands=6"); }), HasSubstr("given twice"));
  EXPECT_THAT(message_of([] { parse(":bands=5"); }), HasSubstr("the name is empty"));
}

TEST(UnitParameters, DefaultsStandUntilGiven) {
  const Parameters defaults = parse("fourier");
  EXPECT_EQ(defaults.integer("bands"), 5);
  EXPECT_EQ(defaults.real("clamp"), 0.9999);
  EXPECT_TRUE(defaults.flag("normalize"));
  EXPECT_FALSE(defaults.is_set("seed"));
  EXPECT_EQ(defaults.given(), "");
  const Parameters given = parse("fourier:normalize=off,bands=10");
  EXPECT_EQ(given.integer("bands"), 10);
  EXPECT_FALSE(given.flag("normalize"));
  EXPECT_EQ(given.given(), "bands=10,normalize=off");
}

TEST(UnitParameters, RefusalsNameOwnerKeyValueAndWhatIsAccepted) {
  EXPECT_THAT(message_of([] { parse("fourier:bands=16"); }),
              AllOf(HasSubstr("fourier"), HasSubstr("bands=16"), HasSubstr("1 … 15")));
  EXPECT_THAT(message_of([] { parse("fourier:bands=2.5"); }), HasSubstr("accepted"));
  EXPECT_THAT(message_of([] { parse("fourier:clamp=nan"); }), HasSubstr("0 … 1"));
  EXPECT_THAT(message_of([] { parse("fourier:clamp="); }), HasSubstr("accepted"));
  EXPECT_THAT(message_of([] { parse("fourier:normalize=yes"); }), HasSubstr("on|off"));
  EXPECT_THAT(message_of([] { parse("fourier:weight=9"); }), HasSubstr("7|8|10"));
  EXPECT_THAT(message_of([] { parse("fourier:band=5"); }),
              HasSubstr("unknown key 'band'; known: bands"));
}

TEST(UnitNames, NearestComesFirst) {
  const std::string_view known[] = {"raytrace", "linked-list", "fourier"};
  EXPECT_EQ(nearest_first("furier", known).front(), "fourier");
  EXPECT_EQ(nearest_first("raytracer", known).front(), "raytrace");
  EXPECT_EQ(unknown_name("method", "linkedlist", known),
            "unknown method 'linkedlist'; known: linked-list, fourier, raytrace");
}

/// A key may be as long as its file: a hundred characters are compared and no more.
TEST(UnitNames, OnlyTheBeginningOfALongNameIsCompared) {
  const std::string as(100, 'a'), bs(200, 'b');
  const std::vector<std::string_view> known = {bs, as};
  EXPECT_EQ(nearest_first(as + std::string(1000, 'b'), known).front(), as);
}

TEST(UnitNames, FindRowThrowsForAnUnknownName) {
  EXPECT_EQ(&find_row("key", "clamp", specs), &specs[1]);
  EXPECT_THROW(find_row("key", "clump", specs), InputError);
}

}  // namespace
}  // namespace pellucid
