// Addresses of Open Sound Control with places for numbers.
#include "devices/osc/osc_pattern.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace carom {
namespace {

TEST(OscPattern, TakesTheNumbersOfAnAddress) {
  const OscPattern pattern("/wand{sensor}/button/{n}/state", true);
  const auto numbers = pattern.match("/wand12/button/3/state");
  ASSERT_TRUE(numbers);
  EXPECT_EQ(numbers->sensor, 12);
  EXPECT_EQ(numbers->index, 3);
  for (const char* other :
       {"/wand12/button/3", "/wand/button/3/state", "/wand12/button/3/state/", "/wand123456/button/3/state",
        "/wand12/button/-3/state", "/wand99999/button/3/state", ""}) {
    EXPECT_FALSE(pattern.match(other)) << other;
  }
  EXPECT_EQ(OscPattern("/head", false).match("/head")->sensor, 0);
}

TEST(OscPattern, IsReadOrExplained) {
  for (const char* wrong : {"", "head", "/head {sensor}", "/{sensor", "/{name}", "/{n}", "/{sensor}/{sensor}",
                            "/1{sensor}", "/{sensor}1", "/head}", "/head/*"}) {
    try {
      const OscPattern pattern(wrong, false);
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("expected"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(OscPattern("/{sensor}{n}", true), std::invalid_argument);
}

}  // namespace
}  // namespace carom
