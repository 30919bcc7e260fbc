#include "devices/protocol/dtrack_answer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/random_world.h"

namespace carom {
namespace {

void expectAnswer(std::string_view answer, std::string_view asked, DtrackAnswer::Kind kind,
                  std::string_view text) {
  const DtrackAnswer read = readDtrackAnswer(answer, asked);
  EXPECT_EQ(read.kind, kind) << answer;
  EXPECT_EQ(read.text, text) << answer;
}

TEST(DtrackAnswer, IsReadInEachOfItsForms) {
  expectAnswer("dtrack2 ok", "", DtrackAnswer::Kind::ok, "");
  expectAnswer("dtrack2 err 12 \"license missing\"", "", DtrackAnswer::Kind::refused,
               "error 12: license missing");
  expectAnswer("dtrack2 err -1", "", DtrackAnswer::Kind::refused, "error -1");
  expectAnswer("dtrack2 set status active mea", "status active", DtrackAnswer::Kind::value, "mea");
  expectAnswer("dtrack2 set status active mea", "config active_config", DtrackAnswer::Kind::unknown,
               "dtrack2 set status active mea");
  expectAnswer("dtrack2 err x", "", DtrackAnswer::Kind::unknown, "dtrack2 err x");
  expectAnswer("", "", DtrackAnswer::Kind::unknown, "");
}

TEST(DtrackAnswer, WhateverComesIsPrintableAndShort) {
  test::Random random(76);
  const std::string_view front[]{"", "dtrack2 ", "dtrack2 err 7 \"", "dtrack2 set a "};
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    std::string answer(front[static_cast<int>(random.in(0.0, 4.0))]);
    for (int k = static_cast<int>(random.in(0.0, 400.0)); k > 0; --k)
      answer += static_cast<char>(static_cast<unsigned char>(random.in(0.0, 256.0)));
    const DtrackAnswer read = readDtrackAnswer(answer, "a");
    EXPECT_LE(read.text.size(), 220u);
    EXPECT_TRUE(
        std::all_of(read.text.begin(), read.text.end(), [](char c) { return c >= ' ' && c != '\x7f'; }));
  }
}

}  // namespace
}  // namespace carom
