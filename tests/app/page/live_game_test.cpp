// What pages are told of a game that is played: by the news alone, from any moment on, they know what is
// known.
#include "app/page/live_game.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "cave/frame/bodies.h"

namespace carom {
namespace {

constexpr double kLight_m_s = 1.42, kFrame_s = 1.0 / 60.0;
constexpr std::size_t kPucks = 5;

/// A game with strokes by chance, and its frames.
class Played {
 public:
  explicit Played(unsigned seed) : random_(seed), game_(setup()) {
    lines.push_back(restingWorldLine(kLight_m_s));
    for (std::size_t puck = 0; puck < kPucks; ++puck)
      lines.emplace_back(game_.worldLines()[puck].knots()[0], kLight_m_s, 0.06);
    // A body that moves as told, by two knots.
    WorldLine told(Knot{}, kLight_m_s);
    Knot turns;
    turns.turn = {1e6, Vec3(0.0)};
    told.append(turns);
    lines.push_back(told);
  }

  const FrameState& next() {
    state_ = {};
    state_.record.number = ++number_;
    const double t_s = kFrame_s * static_cast<double>(number_);
    if (std::uniform_real_distribution(0.0, 1.0)(random_) < 0.05) {
      std::uniform_real_distribution push(-0.2, 0.2);
      Stroke stroke;
      stroke.puck = std::uniform_int_distribution<std::size_t>(0, kPucks - 1)(random_);
      stroke.at_s = t_s;
      stroke.momentum_kg_m_s = {push(random_), push(random_)};
      game_.strike(stroke);
    }
    game_.advanceTo(t_s + 1.0);
    const Changes changes = game_.takeChanges();
    FrameRecord& record = state_.record;
    record.display_s = t_s;
    record.pucks = kPucks;
    if (changes.truncatedFrom_s) record.truncateFrom_s = *changes.truncatedFrom_s;
    record.eventsKept = changes.eventsKept;
    for (const Changes::NewKnot& one : changes.knots)
      state_.knots.push_back({kFirstPuck + one.puck, one.knot});
    state_.events = changes.events;
    ObserverView& seen = record.viewers[0].observer;
    seen.middle.observation = seen.left.observation = seen.right.observation = {t_s, Vec3(0.0, -2.0, 1.0)};
    return state_;
  }

  const Billiard& game() const { return game_; }
  std::vector<WorldLine> lines;  ///< as they begin

 private:
  static BilliardSetup setup() {
    BilliardSetup setup;
    setup.lightSpeed_m_s = kLight_m_s;
    setup.board = Board{2.84, 1.42};
    for (std::size_t i = 0; i < kPucks; ++i) {
      Puck puck;
      puck.name = std::string(1, static_cast<char>('a' + i));
      puck.radius_m = 0.06;
      puck.height_m = 0.04;
      puck.mass_kg = 0.2;
      puck.position_m = {-1.0 + 0.4 * static_cast<double>(i), i % 2 == 0 ? 0.3 : -0.3};
      setup.pucks.push_back(puck);
    }
    return setup;
  }

  std::mt19937 random_;
  Billiard game_;
  std::uint64_t number_ = 0;
  FrameState state_;
};

/// A page that reads the messages as app/page/live_game.h describes them.
class Reader {
 public:
  void take(const std::string& message) {
    ASSERT_EQ(message.size() % sizeof(double), 0U);
    numbers_.resize(message.size() / sizeof(double));
    std::memcpy(numbers_.data(), message.data(), message.size());
    at_ = 0;
    const bool isAnew = next() == 1.0;
    game = next();
    known_s = next();
    frame = next();
    at_ += 65 + 4;
    isAnew ? takeAll() : takeChanges();
    EXPECT_EQ(at_, numbers_.size()) << "the message is longer than it says";
  }

  std::vector<std::vector<std::vector<double>>> knots;  ///< of each body
  std::vector<std::vector<double>> events;
  double game = -1.0, known_s = 0.0, frame = -1.0;

 private:
  double next() { return at_ < numbers_.size() ? numbers_[at_++] : std::nan(""); }
  std::vector<double> some(std::size_t count) {
    std::vector<double> numbers;
    while (numbers.size() < count) numbers.push_back(next());
    return numbers;
  }
  void takeEvents() {
    for (double left = next(); left > 0.0; --left) {
      std::vector<double> event = some(7);
      for (double pucks = next(); pucks > 0.0; --pucks) event.push_back(next());
      events.push_back(event);
    }
  }
  void takeAll() {
    knots.clear();
    events.clear();
    for (double bodies = next(); bodies > 0.0; --bodies) {
      knots.emplace_back();
      for (double left = next(); left > 0.0; --left) knots.back().push_back(some(17));
    }
    takeEvents();
  }
  void takeChanges() {
    for (double changes = next(); changes > 0.0; --changes) {
      const double cut_s = next();
      for (std::size_t puck = 1; puck <= kPucks; ++puck)
        while (knots[puck].size() > 1 && knots[puck].back()[0] >= cut_s) knots[puck].pop_back();
      for (double left = next(); left > 0.0; --left) {
        const std::vector<double> knot = some(17);
        knots.at(static_cast<std::size_t>(next())).push_back(knot);
      }
      const double kept = next();
      while (!events.empty() && events.back()[0] >= kept) events.pop_back();
      takeEvents();
    }
  }

  std::vector<double> numbers_;
  std::size_t at_ = 0;
};

/// The reader's world lines are those of the game that was played.
void expectKnown(const Reader& reader, const Played& played) {
  ASSERT_EQ(reader.knots.size(), kPucks + 2);
  EXPECT_EQ(reader.knots.back().size(), 2U) << "a body that moves as told keeps its knots";
  for (std::size_t puck = 0; puck < kPucks; ++puck) {
    const auto expected = played.game().worldLines()[puck].knots();
    const auto& found = reader.knots[kFirstPuck + puck];
    ASSERT_EQ(found.size(), expected.size()) << puck;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Knot knot = expected[i];
      EXPECT_EQ(found[i][0], knot.turn.t_s) << puck << ", " << i;
      EXPECT_EQ(found[i][1], knot.turn.r_m.x) << puck << ", " << i;
      EXPECT_EQ(found[i][4], knot.u.x) << puck << ", " << i;
    }
  }
  const auto& events = played.game().events();
  ASSERT_EQ(reader.events.size(), events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(reader.events[i][3], events[i].at.t_s) << i;
    EXPECT_EQ(reader.events[i].size(), 7 + events[i].turns.size()) << i;
  }
}

TEST(LiveGame, TellsTheSameByItsNewsAndAnew) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Played played(seed);
    LiveGame live;
    live.begin(7, played.lines);
    Reader all, joiner;
    std::mt19937 random(seed);
    for (int frame = 0; frame < 1200; ++frame) {
      live.add(played.next());
      if (std::uniform_int_distribution(0, 2)(random) > 0) continue;
      const std::string news = live.more();
      ASSERT_FALSE(news.empty());
      all.take(news);
      if (frame > 600 && joiner.game < 0.0)
        joiner.take(live.whole());
      else if (frame > 600)
        joiner.take(news);
    }
    if (const std::string last = live.more(); !last.empty()) all.take(last);
    EXPECT_TRUE(live.more().empty()) << "no frame since";
    joiner.take(live.whole());
    EXPECT_EQ(all.game, 7.0);
    EXPECT_EQ(all.frame, 1200.0);
    EXPECT_EQ(all.known_s, 1200 * kFrame_s);
    expectKnown(all, played);
    expectKnown(joiner, played);
    EXPECT_GT(played.game().events().size(), 20U);
  }
}

TEST(LiveGame, BeginsAnotherGameAnew) {
  Played first(1), second(2);
  LiveGame live;
  live.begin(0, first.lines);
  EXPECT_TRUE(live.more().empty());
  EXPECT_TRUE(live.whole().empty());
  Reader reader;
  for (int frame = 0; frame < 300; ++frame) live.add(first.next());
  reader.take(live.more());
  live.add(first.next());  // nobody asks before the game ends
  live.begin(1, second.lines);
  EXPECT_TRUE(live.more().empty()) << "the new game has no frame yet";
  for (int frame = 0; frame < 300; ++frame) live.add(second.next());
  reader.take(live.more());
  EXPECT_EQ(reader.game, 1.0);
  expectKnown(reader, second);
}

}  // namespace
}  // namespace carom
