// The fields of a form, as browsers send them.
#include "app/study/form_fields.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(FormFields, TakesWhatBrowsersSend) {
  const FormFields fields("a=1+2&b=%C3%A4%26&c=&d&a=3&e=%0a%");
  EXPECT_EQ(fields["a"], "1 2");
  EXPECT_EQ(fields["b"], "\xC3\xA4&");
  EXPECT_TRUE(fields.has("c"));
  EXPECT_FALSE(fields.has("d"));
  EXPECT_EQ(fields["e"], "\n%");
  EXPECT_EQ(FormFields("f=%00%1b%7f")["f"], "???");
  EXPECT_EQ(FormFields("n=7")["x"], "");
  EXPECT_EQ(FormFields("n=7").number("n", 10, -1), 7);
  for (const char* wrong : {"n=11", "n=-1", "n=7x", "n=", "n=7.0", "m=7"})
    EXPECT_EQ(FormFields(wrong).number("n", 10, -1), -1) << wrong;
}

}  // namespace
}  // namespace carom
