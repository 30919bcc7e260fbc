#include "devices/protocol/qtm_bodies.h"

#include <gtest/gtest.h>

#include "devices/qtm_sender.h"

namespace carom {
namespace {

using Names = std::vector<std::string>;
using test::QtmSender;

TEST(QtmBodies, AreNamedInTheirOrder) {
  EXPECT_EQ(readQtmBodies(QtmSender::xml({"Head", " Wand &amp; cue ", "Table"})),
            (Names{"Head", "Wand & cue", "Table"}));
  EXPECT_EQ(readQtmBodies(QtmSender::xml({})), Names{});
  EXPECT_EQ(readQtmBodies("<Q><The_6D><Body/><Body><Name/></Body></The_6D></Q>"), (Names{"", ""}));
}

TEST(QtmBodies, WhatIsNoAnswerIsRefused) {
  EXPECT_FALSE(readQtmBodies(""));
  EXPECT_FALSE(readQtmBodies("<Q>"));
  EXPECT_FALSE(readQtmBodies("no XML"));
  EXPECT_FALSE(readQtmBodies("<!DOCTYPE q [<!ENTITY a 'aaaa'>]><Q><Body><Name>&a;</Name></Body></Q>"));
  std::string deep, many;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_FALSE(readQtmBodies(deep));
  for (int i = 0; i < 5000; ++i) many += "<Body/>";
  EXPECT_FALSE(readQtmBodies("<Q>" + many + "</Q>"));
}

TEST(QtmBodies, NamesAreShort) {
  const auto names = readQtmBodies(QtmSender::xml({std::string(1'000'000, 'x')}));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->at(0).size(), 100u);
}

}  // namespace
}  // namespace carom
