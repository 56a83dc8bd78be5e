// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/gate.h"

#include <gmock/gmock.h>

namespace pellucid::view {
namespace {

using ::testing::HasSubstr;

class UnitGate : public ::testing::Test {
 protected:
  int status(const std::string& path, const std::string& host = "127.0.0.1:8000",
             const std::string& origin = "") const {
    const auto refusal = gate_.refuse({"GET", path, host, origin, "", ""});
    return refusal ? refusal->status : 200;
  }

  std::string token_ = random_token();
  Gate gate_{token_, 8000};
};

TEST_F(UnitGate, LetsInByItsAddress) {
  EXPECT_EQ(gate_.address(), "http://127.0.0.1:8000/" + token_ + "/");
  EXPECT_EQ(status("/" + token_ + "/"), 200);
  EXPECT_EQ(gate_.inner_path({"GET", "/" + token_ + "/scene/0/", "", "", "", ""}), "scene/0/");
}

TEST_F(UnitGate, RefusesAWrongTokenWhereverItDiffers) {
  for (std::size_t i = 0; i < token_.size(); ++i) {
    std::string wrong = token_;
    wrong[i] = wrong[i] == '0' ? '1' : '0';
    EXPECT_EQ(status("/" + wrong + "/"), 403) << i;
  }
  for (const std::string& path : {std::string("/"), std::string("/scene/0/"), "/" + token_,
                                  "/" + token_ + "x/", std::string("//"), std::string()})
    EXPECT_EQ(status(path), 403) << path;
}

// A name that was made to point to this machine, and pages of others that ask it.
TEST_F(UnitGate, RefusesForeignHostsAndOrigins) {
  const std::string path = "/" + token_ + "/";
  EXPECT_EQ(status(path, "localhost:8000"), 200);
  for (const char* host : {"evil.example", "evil.example:8000", "127.0.0.1", "127.0.0.1:80", ""})
    EXPECT_EQ(status(path, host), 403) << host;
  EXPECT_EQ(status(path, "127.0.0.1:8000", "http://127.0.0.1:8000"), 200);
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8000",
                             "http://127.0.0.1:8001", "http://127.0.0.1:8000.evil.example"})
    EXPECT_EQ(status(path, "127.0.0.1:8000", origin), 403) << origin;
}

// Browsers send "Host: 127.0.0.1" to http://127.0.0.1:80/.
TEST_F(UnitGate, NoneIsSentOfTheUsualPort) {
  const Gate gate(token_, 80);
  const std::string path = "/" + token_ + "/";
  for (const char* host : {"127.0.0.1", "localhost", "127.0.0.1:80"})
    EXPECT_FALSE(gate.refuse({"GET", path, host, "http://127.0.0.1", "", ""}).has_value()) << host;
  for (const char* host : {"127.0.0.1:8000", "evil.example", ""})
    EXPECT_TRUE(gate.refuse({"GET", path, host, "", "", ""}).has_value()) << host;
}

TEST_F(UnitGate, NoTwoTokensAreEqual) {
  EXPECT_EQ(token_.size(), 32u);
  EXPECT_NE(token_, random_token());
}

TEST_F(UnitGate, RefusesPathsThatNobodyNeeds) {
  EXPECT_EQ(status("/" + token_ + "/" + std::string(2000, 'x')), 403);
}

}  // namespace
}  // namespace pellucid::view
