// SPDX-License-Identifier: GPL-3.0-or-later
// `pellucid crossings`: a table of rays, a table of what they cross.
#include "tests/app/command_line.h"

namespace pellucid::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class UnitCrossings : public UnitCommandLine {
 protected:
  void SetUp() override {
    UnitCommandLine::SetUp();
    // The tetrahedron x, y, z >= 0, x + y + z <= 1, all faces outwards.
    write_text(folder_ / "part.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }
  /// The call for a table of these lines.
  std::string call(const std::string& rays, const std::string& head = "x,y,z,dx,dy,dz\n") const {
    write_text(folder_ / "rays.csv", head + rays);
    return "crossings " + (folder_ / "part.obj").string() + " --rays " +
           (folder_ / "rays.csv").string();
  }
};

// Distances are in lengths of the direction; the face x = 0 is entered, the slanted one left.
TEST_F(UnitCrossings, AreThoseOfTheClosedForm) {
  const Outcome outcome = run(call("-1,0.25,0.25,1,0,0\n-1,0.25,0.25,0.5,0,0\n-1,2,2,1,0,0\n"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "ray,t,triangle,u,v,side\n"
            "0,1,2,0.25,0.25,-1\n0,1.5,3,0.25,0.25,1\n"
            "1,2,2,0.25,0.25,-1\n1,3,3,0.25,0.25,1\n");
}

// A ray from inside has an odd number of them, in any direction: towards corners and edges too.
TEST_F(UnitCrossings, TheirNumberIsOddFromInside) {
  const std::string inside = "0.125,0.125,0.125,";
  const Outcome outcome = run(call(inside + "-1,-1,-1\n" + inside + "7,-1,-1\n" + inside +
                                   "-1,-1,0\n" + "2,0.125,0.125,1,0,0\n2,0,0,-1,0,0\n") +
                              " --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rays = nlohmann::json::parse(outcome.out).at("rays");
  ASSERT_EQ(rays.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(rays[i].at("odd"), i < 3) << i;
    EXPECT_EQ(rays[i].at("crossings").size(), rays[i].at("count").get<std::size_t>()) << i;
  }
}

TEST_F(UnitCrossings, AreWrittenToAFile) {
  const std::string output = (folder_ / "found.csv").string();
  const Outcome outcome = run(call("-1,0.25,0.25,1,0,0\n") + " -o " + output);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(read_text(output), HasSubstr("\n0,1,2,0.25,0.25,-1\n"));
}

TEST_F(UnitCrossings, RaysThatAreNoneAreRefused) {
  EXPECT_THAT(refusal(call("0,0,0,1,0,0\n0,0,0,0,0,0\n")),
              AllOf(HasSubstr("rays.csv: ray 1"), HasSubstr("direction is 0")));
  EXPECT_THAT(refusal(call("0,0,0,1,0\n", "x,y,z,dx,dy\n")),
              AllOf(HasSubstr("rays.csv"), HasSubstr("dz")));
}

}  // namespace
}  // namespace pellucid::app
