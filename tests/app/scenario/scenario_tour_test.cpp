// The tour of a scenario file: what is read, what is refused and in which words.
#include "app/scenario/scenario_tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/scenario/scenario_text.h"
#include "app/toml/toml_file.h"

namespace carom {
namespace {

Scenario scenarioWith(const std::string& text) { return test::read("light_speed_m_s = 1.42\n" + text); }

/// What the person is told; empty: nothing is wrong.
std::string faultOf(const std::string& text) {
  try {
    scenarioWith(text);
  } catch (const InputErrors& errors) {
    return errors.what();
  }
  return {};
}

TEST(TourFile, LegsFollowEachOtherUnlessTheySayWhen) {
  const Scenario scenario = scenarioWith(
      "[tour]\nstarts = 'at once'\n[[tour.leg]]\nfor_s = 2\nthrust_m_s2 = [0, 0.5, 0]\n"
      "[[tour.leg]]\nfor_s = 1\nthrust_m_s2 = [0.5, 0, 0]\n"
      "[[tour.leg]]\nfrom_s = 4\nfor_s = 1\nthrust_m_s2 = [0, 0, 0.1]\n");
  EXPECT_TRUE(scenario.tourAtOnce);
  ASSERT_EQ(scenario.tour.size(), 3u);
  EXPECT_EQ(scenario.tour[0].from_s, 0.0);
  EXPECT_EQ(scenario.tour[1].from_s, 2.0);
  EXPECT_EQ(scenario.tour[1].thrust_m_s2, Vec3(0.5, 0.0, 0.0));
  EXPECT_EQ(scenario.tour[2].from_s, 4.0);
  EXPECT_FALSE(scenarioWith("[tour]\n[[tour.leg]]\nfor_s = 2\nthrust_m_s2 = [0, 0.5, 0]\n").tourAtOnce);
  EXPECT_TRUE(scenarioWith("").tour.empty());
}

TEST(TourFile, SaysWhatItRefuses) {
  const std::string leg = "[[tour.leg]]\nfor_s = 2\nthrust_m_s2 = [0, 0.5, 0]\n";
  EXPECT_EQ(faultOf("[tour]\n" + leg), "");
  EXPECT_NE(faultOf("[tour]\nstarts = 'asked'\n").find("[[tour.leg]]"), std::string::npos);
  EXPECT_NE(faultOf("[tour]\nstarts = 'now'\n" + leg).find("at once"), std::string::npos);
  EXPECT_NE(faultOf("[tour]\n" + leg + "[[tour.leg]]\nfrom_s = 1\nfor_s = 1\nthrust_m_s2 = [0, 0, 0]\n")
                .find("expected a time after the leg before it"),
            std::string::npos);
  EXPECT_EQ(faultOf("[tour]\n[[tour.leg]]\nfor_s = 1\nthrust_m_s2 = [0, 1.0082, 0]\n"), "");  // c²/2 a metre
  EXPECT_NE(faultOf("[tour]\n[[tour.leg]]\nfor_s = 1\nthrust_m_s2 = [0, 1.0083, 0]\n")
                .find("expected 1.0082 at most"),
            std::string::npos);
  EXPECT_NE(faultOf("[tour]\n[[tour.leg]]\nfor_s = 0\nthrust_m_s2 = [0, 0.5, 0]\n").find("for_s"),
            std::string::npos);
  // asinh(10) c/a = 4.2574 s of thrust 1 make γβ 10.
  EXPECT_EQ(faultOf("[tour]\n[[tour.leg]]\nfor_s = 4.25\nthrust_m_s2 = [0, 1, 0]\n"), "");
  const std::string tooFast = "[tour]\n[[tour.leg]]\nfor_s = 4.27\nthrust_m_s2 = [0, 1, 0]\n";
  EXPECT_NE(faultOf(tooFast).find("expected slower"), std::string::npos);
  // The platform's own motion counts, and which way it faces.
  EXPECT_EQ(faultOf("[observer]\nfacing_deg = 0\nbeta = [-0.8, 0, 0]\n" + tooFast), "");
  EXPECT_NE(faultOf("[tour]\n[[tour.leg]]\nfor_s = 1e9\nthrust_m_s2 = [0, 1, 0]\n").find("expected slower"),
            std::string::npos);
}

// What is missing is told once: the times after it are not judged by a time that was not given.
TEST(TourFile, AMissingTimeIsOneFault) {
  const auto linesOf = [](const std::string& said) { return 1 + std::count(said.begin(), said.end(), '\n'); };
  const std::string legs = faultOf(
      "[tour]\n[[tour.leg]]\nthrust_m_s2 = [0, 0.5, 0]\n[[tour.leg]]\nfrom_s = 4\nfor_s = 1\n"
      "thrust_m_s2 = [0, 0, 0]\n");
  EXPECT_NE(legs.find("for_s is missing"), std::string::npos);
  EXPECT_EQ(linesOf(legs), 1) << legs;
  const Scenario shown = scenarioWith(
      "[[caption]]\nfor_s = 1\ntext = 'Look'\ncolour = true\n[[caption]]\nfor_s = 1\ntext = 'Listen'\n");
  EXPECT_TRUE(shown.captions.at(0).colour);
  EXPECT_FALSE(shown.captions.at(1).colour);
  const std::string captions =
      faultOf("[[caption]]\ntext = 'Look'\n[[caption]]\nfrom_s = 4\nfor_s = 1\ntext = 'Listen'\n");
  EXPECT_NE(captions.find("for_s is missing"), std::string::npos);
  EXPECT_EQ(linesOf(captions), 1) << captions;
}

}  // namespace
}  // namespace carom
