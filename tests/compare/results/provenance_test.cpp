// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/provenance.h"

#include <gmock/gmock.h>

namespace pellucid::compare {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ResultRow row(const std::string& build, const std::string& cpu) {
  ResultRow row;
  row.machine = {{"commit", "c0ffee"}, {"build", build}, {"cpu", cpu}, {"driver", cpu + build}};
  return row;
}

TEST(UnitProvenance, RowsOfOneBuildOnOneMachineNeedNoWarning) {
  EXPECT_THAT(provenance_warnings(std::vector{row("1234567890", "x"), row("1234567890", "x")}),
              IsEmpty());
  EXPECT_THAT(provenance_warnings({}), IsEmpty());
}

TEST(UnitProvenance, SeveralBuildsAndSeveralMachinesAreNamed) {
  EXPECT_THAT(provenance_warnings(std::vector{row("1234567890", "x"), row("abcdefabcd", "x")}),
              ElementsAre(HasSubstr("2 builds of the program: c0ffee (12345678); c0ffee (abcdef")));
  EXPECT_THAT(provenance_warnings(std::vector{row("1", "x"), row("1", "y"), row("1", "z")}),
              ElementsAre(HasSubstr("3 machines")));
}

TEST(UnitProvenance, AFailedRowHoldsNoNumber) {
  ResultRow failed = row("2", "y");
  failed.error = "no such file";
  EXPECT_THAT(provenance_warnings(std::vector{row("1", "x"), failed}), IsEmpty());
}

}  // namespace
}  // namespace pellucid::compare
