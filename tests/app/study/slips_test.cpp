// The file of slips: which code belongs to which participant.
#include "app/study/slips.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/study/study_code.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::TemporaryFolder;

TEST(Slips, AreReadWithTheirFaults) {
  const TemporaryFolder folder;
  const std::vector<std::string> codes = newCodes(2);
  const auto read = [&](const std::string& text) { return readSlips(folder.file("slips.csv", text), 2); };
  const auto slips = read("number,code\n1," + codes[0] + "\n2," + codes[1] + "\n");
  EXPECT_EQ(slips.at(codes[0]), 1U);
  EXPECT_EQ(slips.at(codes[1]), 2U);
  for (const std::string& wrong :
       {std::string("code,number\n"), "number,code\n3," + codes[0] + "\n",
        std::string("number,code\n1,AAAAAB\n"), "number,code\n1," + codes[0] + "\n2," + codes[0] + "\n",
        std::string("number,code\n"), "number,code\n1.5," + codes[0] + "\n", std::string("number,code\n1\n")})
    EXPECT_THROW(read(wrong), InputErrors) << wrong;
}

}  // namespace
}  // namespace carom
