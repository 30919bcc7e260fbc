// Who in a room of two is told what, and when.
#include "app/live/announcements.h"

#include <gtest/gtest.h>

#include "cave/texts/texts.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

class AnnouncementsForTwo : public testing::Test {
 protected:
  AnnouncementsForTwo() : rig_(readRig(CAROM_CONFIG_DIR "/rigs/desk-two.toml")) {
    scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml");
    scenario_.captions.clear();
  }

  /// Begins the record of a frame at this time, of the session and of the first viewer's own.
  void begin(double now_s) {
    decision_.beginFrame();
    FrameRecord& record = decision_.frame.record = {};
    record.viewerCount = 2;
    record.display_s = record.viewers[0].observer.properTime_s = now_s;
  }
  std::string read(std::size_t viewer) const { return decision_.frame.record.viewers[viewer].notice.words(); }

  const test::LogLines log_;
  Rig rig_;
  Scenario scenario_;
  Announcements announcements_{rig_, scenario_, {}};
  Decision decision_;
};

TEST_F(AnnouncementsForTwo, OneIsToldAloneAndBothTogetherForAWhile) {
  begin(1.0);
  announcements_.sayTo(1, texts::Saying("yours"), decision_);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "");
  EXPECT_EQ(read(1), "yours");
  ASSERT_EQ(decision_.notes.size(), 1U);
  EXPECT_EQ(decision_.notes[0].viewer, 1U);
  begin(2.0);
  announcements_.later(texts::Saying("both"));
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "both");
  EXPECT_EQ(read(1), "both");
  begin(2.0 + kNoticeShown_s);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "");
  EXPECT_TRUE(decision_.notes.empty());
}

TEST_F(AnnouncementsForTwo, ACaptionTurnsItsViewsOnAndThoseBeforeItOff) {
  scenario_.captions = {{1.0, 1.0, "first", "first, by hand", {.paths = 1}},
                        {3.0, 1.0, "second", "second, by hand", {.clocks = 1}}};
  rig_.viewers[1].hand = HandSetup{};
  begin(0.5);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "");
  begin(1.5);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "first");
  EXPECT_EQ(read(1), "first, by hand");
  ASSERT_EQ(decision_.commands.size(), 1U);
  EXPECT_EQ(nameOf(decision_.commands[0]), "paths");
  begin(2.5);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "") << "it is over";
  begin(3.5);
  announcements_.sayTo(0, texts::Saying("a message"), decision_);
  announcements_.putInto(decision_);
  EXPECT_EQ(read(0), "a message") << "which goes before a caption";
  EXPECT_EQ(read(1), "second, by hand");
  EXPECT_EQ(decision_.commands.size(), 2U);
  begin(3.6);
  announcements_.play();
  announcements_.putInto(decision_);
  EXPECT_EQ(decision_.commands.size(), 3U) << "both captions have begun anew";
}

TEST_F(AnnouncementsForTwo, ACaptionTurnsColourOnAndTheNextOneOff) {
  scenario_.captions = {{1.0, 1.0, "plain", "", {}, false},
                        {3.0, 1.0, "colour", "", {}, true},
                        {5.0, 1.0, "plain", "", {}, false},
                        {7.0, 1.0, "plain", "", {}, false}};
  const auto turned = [](bool on) {
    return std::vector<Command>{SetSwitch{&Switches::colour, false, on},
                                SetSwitch{&Switches::searchlight, false, on}};
  };
  const std::vector<std::pair<double, std::vector<Command>>> expected{
      {1.5, {}}, {3.5, turned(true)}, {5.5, turned(false)}, {7.5, {}}};
  for (const auto& [own_s, commands] : expected) {
    begin(own_s);
    announcements_.putInto(decision_);
    EXPECT_EQ(decision_.commands, commands) << own_s << " s";
    EXPECT_EQ(read(0), own_s == 3.5 ? "colour" : "plain");
    const std::vector<Command> given = decision_.commands;
    begin(own_s + 0.1);
    announcements_.tellEffects(given, decision_);
    announcements_.putInto(decision_);
    EXPECT_EQ(read(0), own_s == 3.5 ? "colour" : "plain") << "the sentence tells of it, and no message";
  }
}

TEST_F(AnnouncementsForTwo, AnEffectChangesAFrameAfterItIsAsked) {
  begin(0.0);
  announcements_.tellEffects({}, decision_);
  begin(0.1);
  decision_.frame.record.switches.colour = 1;
  const Command colour = SetSwitch{&Switches::colour, false, true};
  announcements_.tellEffects(std::span(&colour, 1), decision_);
  EXPECT_EQ(decision_.frame.record.switches.colour, 0);
  announcements_.putInto(decision_);
  EXPECT_NE(read(0).find(texts::keys::kColour.english()), std::string_view::npos) << read(0);
  begin(0.2);
  decision_.frame.record.switches.colour = 1;
  announcements_.tellEffects({}, decision_);
  EXPECT_EQ(decision_.frame.record.switches.colour, 1);
}

TEST_F(AnnouncementsForTwo, WhySteeringDoesNothingIsSaidOnceUntilItIsLetGo) {
  begin(0.0);
  for (const bool asked : {true, true, false, true}) announcements_.tellWhyStill(asked, true, decision_);
  ASSERT_EQ(decision_.notes.size(), 2U);
  EXPECT_EQ(decision_.notes[0].value, texts::message::kFrozen.english());
}

TEST_F(AnnouncementsForTwo, EachReadsOfACaromAsTheirOwnOrTheOthers) {
  begin(0.0);
  announcements_.tellCarom(1, 3, decision_);
  announcements_.putInto(decision_);
  EXPECT_NE(read(0).find(rig_.viewers[1].name), std::string_view::npos) << read(0);
  EXPECT_EQ(read(1).find(rig_.viewers[1].name), std::string_view::npos) << read(1);
}

}  // namespace
}  // namespace carom
