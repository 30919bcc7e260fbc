#include "cave/hud/sentences.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/hud/hud_text.h"
#include "cave/hud/line_breaks.h"

namespace carom {
namespace {

using Sentences = std::vector<std::string_view>;

TEST(Sentences, EndWhereTheNextOneBegins) {
  EXPECT_EQ(sentencesOf(""), Sentences{});
  EXPECT_EQ(sentencesOf("  "), Sentences{});
  EXPECT_EQ(sentencesOf("No full stop"), Sentences{"No full stop"});
  EXPECT_EQ(sentencesOf("At 0.6 c it rests. Opposite, 0.88 c.  "),
            (Sentences{"At 0.6 c it rests.", "Opposite, 0.88 c."}));
  EXPECT_EQ(sentencesOf("Which one? \"That one.\" Good! 5 ticks."),
            (Sentences{"Which one?", "\"That one.\"", "Good!", "5 ticks."}));
  EXPECT_EQ(sentencesOf("Uhren, z. b. am Rand, gehen nach. Sie altern."),
            (Sentences{"Uhren, z. b. am Rand, gehen nach.", "Sie altern."}));
  EXPECT_EQ(sentencesOf("今Bが光ります。輪は0.99秒後です。"),
            (Sentences{"今Bが光ります。", "輪は0.99秒後です。"}));
  EXPECT_EQ(sentencesOf("… (plates, in c). Then."), (Sentences{"… (plates, in c).", "Then."}));
}

TEST(Sentences, StandOneAfterTheOtherAndThenAgain) {
  const Sentences four = sentencesOf("Short. This one is a good deal longer than that. Middle one. End.");
  ASSERT_EQ(four.size(), 4U);
  EXPECT_LT(standsFor_s(four[0]), standsFor_s(four[1]));
  EXPECT_EQ(sentenceAt({}, 5.0), 0U);
  EXPECT_EQ(sentenceAt(four, -1.0), 0U);
  double from_s = 0.0;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < four.size(); ++i) {
      EXPECT_EQ(sentenceAt(four, from_s + 1e-6), i);
      from_s += standsFor_s(four[i]);
      EXPECT_EQ(sentenceAt(four, from_s - 1e-6), i);
    }
  }
}

/// What the panel says, in one text.
std::string saidBy(const HudText& text) {
  std::string all;
  for (const HudLine& line : text.lines()) all += line.text + "|";
  return all;
}

// An explanation is read sentence by sentence; nothing below moves, and it begins anew when it is asked for
// again.
TEST(Sentences, AnExplanationSaysOneAtATime) {
  LessonWords words;
  words.number =
      "It rests. Opposite to it, the rim goes at 0.88 c, and this takes two lines of the panel. End.";
  HudText text;
  text.setLesson(words, {});
  FrameRecord record;
  record.lesson.phase = LessonPhase::shows;
  record.display_s = 100.0;
  text.follow(record);
  record.lesson.phase = LessonPhase::explains;
  std::size_t rows = 0;
  const auto saidAfter = [&](double since_s) {
    record.display_s = 100.0 + since_s;
    text.follow(record);
    if (rows == 0) rows = text.lines().size();
    EXPECT_EQ(text.lines().size(), rows) << "what stands below does not move";
    return saidBy(text);
  };
  EXPECT_EQ(saidAfter(1.0).find("1/3  It rests.|"), 0U);
  const Sentences parts = sentencesOf(words.number);
  double from_s = 1.0 + standsFor_s(parts[0]);
  EXPECT_EQ(saidAfter(from_s + 0.2).find("2/3  Opposite"), 0U);
  from_s += standsFor_s(parts[1]);
  EXPECT_EQ(saidAfter(from_s + 0.2).find("3/3  End."), 0U);
  record.lesson.phase = LessonPhase::shows;
  record.display_s += 1.0;
  text.follow(record);
  record.lesson.phase = LessonPhase::explains;
  EXPECT_EQ(saidAfter(from_s + 2.0).find("1/3  It rests.|"), 0U) << "again from the first";
}

}  // namespace
}  // namespace carom
