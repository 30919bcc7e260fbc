// The fault of an input file, and its place.
#include "engine/text/input_error.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace carom {
namespace {

TEST(InputError, SaysItsPlaceBeforeItsMessage) {
  const InputError fault("rigs/a.toml", 12, 3, "'x' is wrong, expected a number");
  EXPECT_STREQ(fault.what(), "rigs/a.toml:12:3: 'x' is wrong, expected a number");
  EXPECT_EQ(fault.file(), "rigs/a.toml");
  EXPECT_EQ(fault.line(), 12);
  EXPECT_EQ(fault.column(), 3);
  EXPECT_EQ(fault.message(), "'x' is wrong, expected a number");
  EXPECT_THROW(throw InputError(fault), std::runtime_error);
}

}  // namespace
}  // namespace carom
