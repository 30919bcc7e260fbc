#include "app/journal/linked_game_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/journal_frames.h"
#include "app/temporary_folder.h"
#include "log_lines.h"

namespace carom {
namespace {

using namespace test;

ToldMoment momentOf(std::uint64_t frame) {
  const double x = 0.1 * static_cast<double>(frame);
  ToldMoment moment;
  moment.kind = frame == 0 ? ToldKind::begins : frame == 9 ? ToldKind::ends : ToldKind::goesOn;
  moment.head = {x + 1.0 / 3.0, {x, 2.0, 1.6}};
  moment.hand = {x + 1.0 / 7.0, {x, 2.0 / 3.0, 1.2}};
  moment.properTime_s = x / 7.0;
  moment.facing_rad = -x / 3.0;
  moment.hasHand = 1;
  moment.hasCue = frame % 2;
  moment.cue_rad = x / 9.0;
  moment.caroms = frame / 4;
  moment.setName("anna");
  return moment;
}

LinkNews newsOf(std::uint64_t frame) {
  const double x = 0.1 * static_cast<double>(frame);
  LinkNews news;
  news.rows.push_back({1, "playing", 100 + frame, 0.2, {x, {1.0, -0.0, x}}, "anna", frame % 2 == 0, 1.5, 7});
  news.persons.push_back({1, frame == 9 ? 0 : 100 + frame, momentOf(frame)});
  if (frame == 3) news.notes.push_back({1, "paired", "game 0123456789abcdef with lyon to ± 10 ms"});
  if (frame == 8) news.notes.push_back({1, "gone", "lyon: it was not heard for 6 s"});
  if (frame == 5) {
    Stroke stroke{0, 0.5, Vec3(1.0 / 3.0, 0.0, 0.5), {0.1, -0.2}, 0.01};
    news.strokes.push_back({stroke, 0, 1, 4, "anna"});
  }
  return news;
}

void writeTo(const std::filesystem::path& file, bool isLinked) {
  SessionFacts facts = kFacts;
  facts.pucks = {"white", "red"};
  facts.isLinked = isLinked;
  Journal journal(file, facts, false);
  for (std::uint64_t frame = 0; frame < 10; ++frame)
    journal.add(frameOf(frame), head(), {}, {}, isLinked ? newsOf(frame) : LinkNews{});
}

TEST(LinkedGameFile, GivesBackWhatTheJournalWasTold) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "grenoble.db";
  writeTo(file, true);
  const std::vector<LinkedGameRows> games = linkedGamesOf(file);
  ASSERT_EQ(games.size(), 1U);
  const LinkedGameRows& game = games[0];
  EXPECT_EQ(game.number, "0123456789abcdef");
  EXPECT_EQ(game.otherRoom, 1U);
  EXPECT_EQ(game.firstFrame, 3);
  EXPECT_EQ(game.lastFrame, 8);
  ASSERT_EQ(game.promises.size(), 6U);
  const Event& promise = game.promises.at(5).at(0);
  EXPECT_EQ(promise.t_s, 0.5);
  EXPECT_EQ(promise.r_m, Vec3(1.0, 0.0, 0.5));
  EXPECT_EQ(game.knownUntil_s, 0.8);
  ASSERT_EQ(game.told.size(), 6U);
  EXPECT_EQ(game.told[1].first, "anna");
  EXPECT_EQ(game.told[1].second[0], 0.4 + 1.0 / 3.0) << "to the bit";
  ASSERT_EQ(game.strokes.size(), 1U);
  const auto& [key, stroke] = *game.strokes.begin();
  EXPECT_EQ(key, (std::pair<std::int64_t, std::int64_t>(1, 4)));
  EXPECT_EQ(stroke.first, "white");
  EXPECT_EQ(stroke.second, (std::vector<double>{0.5, 1.0 / 3.0, 0.0, 0.5, 0.1, -0.2, 0.01}));
  EXPECT_EQ(game.heads.at("viewer").size(), 10U);
  EXPECT_FALSE(game.turns.empty());
}

TEST(LinkedGameFile, FramesBringWhatWasToldOfPeopleToTheBit) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "grenoble.db";
  writeTo(file, true);
  SessionFile session(file, {}, true);
  EXPECT_TRUE(session.facts().isLinked);
  for (const bool isChangesAlone : {false, true}) {
    isChangesAlone ? session.goToChanges() : session.goTo(0);
    std::uint64_t frames = 0;
    for (FrameState state; session.next(state); ++frames) {
      ASSERT_EQ(state.told.size(), 1U);
      const ToldMoment expected = momentOf(state.record.number);
      EXPECT_EQ(std::memcmp(&state.told[0], &expected, sizeof expected), 0) << state.record.number;
    }
    EXPECT_EQ(frames, 10U);
  }
}

TEST(LinkedGameFile, APersonWhoIsImpossibleIsRefused) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const std::pair<const char*, const char*> faults[] = {{"person = 4", "a person's number is 4"},
                                                        {"kind = 3", "a person's kind is 3"},
                                                        {"hand_x_m = NULL", "a person's hand_x_m is nan"},
                                                        {"t_s = 'x'", "a person's t_s is nan"},
                                                        {"has_cue = 2", "a person's has_cue is 2"}};
  for (const auto& [change, words] : faults) {
    const auto file = folder / "grenoble.db";
    writeTo(file, true);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE link_person SET ") + change + " WHERE frame = 4");
    SessionFile session(file, {}, true);
    FrameState state;
    for (int frame = 0; frame < 4; ++frame) EXPECT_TRUE(session.next(state));
    try {
      session.next(state);
      ADD_FAILURE() << change;
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(words), std::string::npos) << said;
      EXPECT_NE(said.find("frame 4"), std::string::npos) << said;
    }
    std::filesystem::remove(file);
  }
}

/// Writes a linked game in which `host` hosted: strokes of both rooms, with these numbers of those of the
/// other.
void writeStrokes(const std::filesystem::path& file, std::uint32_t host,
                  std::span<const std::uint32_t> others) {
  SessionFacts facts = kFacts;
  facts.pucks = {"white", "red"};
  facts.isLinked = true;
  Journal journal(file, facts, false);
  for (std::uint64_t frame = 0; frame < 10; ++frame) {
    LinkNews news = newsOf(frame);
    news.strokes.clear();
    news.rows[0].room = news.persons[0].room = 1 - host;
    news.persons[0].moment.person = 1;
    std::vector<HandStroke> made;
    const Stroke stroke{
        frame % 2, 0.5 + 0.1 * static_cast<double>(frame), Vec3(1.0 / 3.0, 0.0, 0.5), {0.1, -0.2}, 0.01};
    if (frame < others.size()) news.strokes.push_back({stroke, 0, 1 - host, others[frame], "anna"});
    if (frame == 5 || frame == 7) made.push_back({stroke, 0, host, frame == 7 ? 1U : 0U, {}});
    journal.add(frameOf(frame), head(), {}, made, news);
  }
}

std::vector<Puck> twoPucks() {
  std::vector<Puck> pucks(2);
  pucks[0].name = "white";
  pucks[1].name = "red";
  for (Puck& puck : pucks) {
    puck.mass_kg = 0.2;
    puck.radius_m = 0.03;
  }
  return pucks;
}

TEST(LinkedGameFile, AHostFindsTheStrokesOfBothRoomsAgain) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "grenoble.db";
  const std::array<std::uint32_t, 3> numbers{0, 1, 2};
  writeStrokes(file, 0, numbers);
  const std::vector<Puck> pucks = twoPucks();
  const std::vector<HandStroke> strokes = hostedStrokesOf(file, pucks);
  const std::vector<Stroke> plain = SessionFile(file, {}, true).strokes(pucks);
  ASSERT_EQ(strokes.size(), 5U);
  ASSERT_EQ(plain.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(strokes[i].stroke.at_s, plain[i].at_s);
    EXPECT_EQ(strokes[i].stroke.puck, plain[i].puck);
    EXPECT_EQ(strokes[i].room, i < 3 ? 1U : 0U);
    EXPECT_EQ(strokes[i].number, i < 3 ? i : i - 3);
    EXPECT_EQ(strokes[i].viewer, i < 3 ? 1U : 0U) << "of the people of their room";
  }
}

/// Returns what is said of a file that cannot be hosted again.
std::string refusalOfStrokes(const std::filesystem::path& file) {
  const std::vector<Puck> pucks = twoPucks();
  try {
    (void)hostedStrokesOf(file, pucks);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(LinkedGameFile, WhatCannotBeHostedAgainIsRefusedInWords) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const auto plain = folder / "plain.db", joined = folder / "lyon.db", broken = folder / "broken.db";
  writeTo(plain, false);
  const std::array<std::uint32_t, 3> all{0, 1, 2}, gap{0, 2, 3};
  writeStrokes(joined, 1, all);
  writeStrokes(broken, 0, gap);
  const auto expect = [](const std::filesystem::path& file, const char* words) {
    const std::string said = refusalOfStrokes(file);
    EXPECT_TRUE(said.starts_with("session file " + file.string() + ": ")) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expect(plain, "it has no linked game, expected one of carom cave --link");
  expect(joined, "another room has hosted its newest game");
  expect(broken, "stroke 1 of a room is not there");
}

TEST(LinkedGameFile, ASessionWithoutALinkHasNoneOfItsTables) {
  const NothingIsLogged silence;
  TemporaryFolder folder;
  const auto file = folder / "alone.db";
  writeTo(file, false);
  SQLite::Database database(file.string());
  for (const char* table : {"link", "link_person", "link_note"}) EXPECT_FALSE(database.tableExists(table));
  try {
    linkedGamesOf(file);
    FAIL() << "it has a linked game";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("it has no linked game"), std::string::npos);
  }
}

}  // namespace
}  // namespace carom
