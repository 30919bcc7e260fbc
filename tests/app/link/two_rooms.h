#pragma once
// Two rooms of a linked game in one process, with a line in simulated time.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/link/linked_play.h"
#include "engine/game_digest.h"
#include "engine/linked/pace.h"
#include "engine/random_world.h"
#include "engine/three_pucks.h"

namespace carom::test {

inline constexpr double kC_m_s = 1.42, kFrame_s = 1.0 / 60.0;

inline LinkClock::time_point timeOf(double now_s) {
  return LinkClock::time_point{} +
         std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 * (1000.0 + now_s)));
}

inline BilliardSetup table() {
  BilliardSetup setup = threePucks();
  for (Puck& puck : setup.pucks) puck.beta *= 0.3;
  setup.rules.friction_m_s2 = 0.05;
  return setup;
}

inline ObserverStart place() { return {{-2.3, 0.0, -0.75}, 0.0, Vec3(0.0)}; }

/// One end of a line that delays messages, may be cut, and may change what it carries.
class FakeLine : public Line {
 public:
  FakeLine(const double& now_s, const double& late_s) : now_s_(now_s), late_s_(late_s) {}
  void connects(FakeLine& other) { other_ = &other; }

  void open(std::uint64_t connection) {
    isOpen_ = true;
    connection_ = connection;
    arrived_.push_back({now_s_, {LineNews::Kind::opened, connection, timeOf(now_s_), {}, "there"}});
  }
  void cut() {
    if (!isOpen_) return;
    isOpen_ = false;
    arrived_.push_back({now_s_, {LineNews::Kind::closed, connection_, timeOf(now_s_), {}, "the line broke"}});
  }
  bool isOpen() const { return isOpen_; }

  void take(std::vector<LineNews>& news) override {
    while (!arrived_.empty() && arrived_.front().at_s <= now_s_) {
      news.push_back(arrived_.front().news);
      news.back().at -= std::chrono::seconds(clockLate_s);
      arrived_.pop_front();
    }
  }
  void send(std::uint64_t connection, const LinkMessage& message) override {
    if (!isOpen_ || connection != connection_ || isSilent) return;
    LinkMessage sent = message;
    if (change) change(sent);
    arrive(sent);
    if (!repeats) return;
    sent_.push_back(sent);
    for (int i = 0; i < 10; ++i, ++repeated)
      arrive(sent_[static_cast<std::size_t>(repeats->in(0.0, 0.999999) * static_cast<double>(sent_.size()))]);
  }
  void present(std::uint64_t connection, const LinkPresent& present) override { send(connection, present); }
  void close(std::uint64_t connection, const std::string& reason) override {
    if (!isOpen_ || connection != connection_) return;
    send(connection, LinkBye{reason});
    closed.push_back(reason);
    other_->endAt_s_ = now_s_ + late_s_;
    isOpen_ = false;
  }
  RoundTrip roundTrip(std::uint64_t) const override {
    return {2.0 * late_s_, 2.0 * late_s_, 2.0 * late_s_, 10, 2.0 * late_s_, 0};
  }
  LineTraffic traffic() const override { return {}; }
  /// Ends the connection that the other end has closed.
  void look() {
    if (endAt_s_ < 0.0 || now_s_ < endAt_s_) return;
    endAt_s_ = -1.0;
    cut();
  }

  /// Brings a message on another connection.
  void tell(std::uint64_t connection, const LinkMessage& message) {
    arrived_.push_back({now_s_, {LineNews::Kind::message, connection, timeOf(now_s_), message, {}}});
  }

  bool isSilent = false;
  int clockLate_s = 0;        ///< of the computer
  Random* repeats = nullptr;  ///< ten messages of before follow each
  std::size_t repeated = 0;
  std::function<void(LinkMessage&)> change;
  std::vector<std::string> closed;

 private:
  void arrive(const LinkMessage& message) {
    other_->arrived_.push_back(
        {now_s_ + late_s_,
         {LineNews::Kind::message, other_->connection_, timeOf(now_s_ + late_s_), message, {}}});
  }

  struct Arrives {
    double at_s;
    LineNews news;
  };
  const double &now_s_, &late_s_;
  FakeLine* other_ = nullptr;
  bool isOpen_ = false;
  std::uint64_t connection_ = 0;
  std::deque<Arrives> arrived_;
  std::vector<LinkMessage> sent_;
  double endAt_s_ = -1.0;
};

inline LinkSelf self(bool hosts, const std::string& name) {
  LinkSelf self;
  self.hosts = hosts;
  self.room = name;
  self.viewers = {"viewer"};
  self.floor = {{-1.0, -1.0}, {1.0, 1.0}};
  self.program = "carom 1";
  return self;
}

class Room {
 public:
  Room(bool hosts, const std::string& name, Line& line, std::uint64_t arithmetic, std::uint64_t seed)
      : play(self(hosts, name), line, arithmetic), random_(seed) {
    if (hosts) begin({}, [&](LinkedGame its) { play.play(std::move(its)); });
  }

  void frame(double now_s) {
    const auto now = timeOf(now_s - clockLate_s);
    play.hear(now);
    for (const LinkNote& note : play.heard().notes) notes.push_back(note);
    for (const LinkStroke& stroke : play.heard().strokes) {
      if (game) game->strike(stroke.told.stroke);
      ++fromAfar;
    }
    if (play.heard().settings) {
      c_m_s = play.heard().settings->lightSpeedShown_m_s;
      isFrozen = play.heard().settings->isFrozen;
    }
    if (const auto welcome = play.takeInvitation()) {
      ++invitations;
      const ObserverStart seated = seat(place(), welcome->room, welcome->rooms, welcome->apart_m);
      begin(seated, [&](LinkedGame its) { play.join(*welcome, std::move(its)); });
      BilliardSetup setup = table();
      for (const LinkStroke& stroke : play.strokes()) setup.strokes.push_back(stroke.told.stroke);
      game.emplace(setup);
    }
    if (!game) return;
    if (!play.own()) start(now);
    const bool lived = play.isLiving() && !isFrozen && live(now);
    if (lived && strikes) strike();
    if (play.own()) tell(!lived, now);
  }

  bool has(const std::string& what) const {
    return std::ranges::any_of(notes, [&](const LinkNote& note) { return note.what == what; });
  }
  double board_s() const { return observers->headEvent().t_s; }
  void strikeNow() {
    nextStroke_s_ = 0.0;
    strike();
  }

  LinkedPlay play;
  std::optional<Billiard> game;
  std::optional<Observers> observers;
  std::vector<LinkNote> notes;
  std::size_t fromAfar = 0, made = 0, waits = 0, insidePromises = 0;
  int invitations = 0;
  bool strikes = true, isFrozen = false;
  double c_m_s = kC_m_s;
  int clockLate_s = 0;
  double bend = 0.0;  ///< the first turn after this board time is another one in its last bit
  double bent_s = 0.0;
  std::string bentName;

 private:
  std::vector<WorldLine> bentLines(const std::vector<WorldLine>& lines) {
    std::vector<WorldLine> bent = lines;
    std::pair<std::size_t, std::size_t> first{0, 0};  // puck and knot
    double first_s = 1e9;
    for (std::size_t puck = 0; puck < lines.size(); ++puck) {
      for (std::size_t i = 0; i < lines[puck].knots().size(); ++i) {
        const double t_s = lines[puck].knots()[i].turn.t_s;
        if (t_s > bend && t_s < first_s) {
          first_s = t_s;
          first = {puck, i};
        }
      }
    }
    if (first_s == 1e9) return bent;
    bent_s = first_s;
    bentName = table().pucks[first.first].name;
    const auto knots = lines[first.first].knots();
    WorldLine line(knots.front(), kC_m_s, lines[first.first].radius_m());
    for (std::size_t i = 1; i < knots.size(); ++i) {
      Knot knot = knots[i];
      if (i == first.second) knot.properTime_s = std::nextafter(knot.properTime_s, 1e9);
      line.append(knot);
    }
    bent[first.first] = line;
    return bent;
  }

  template <typename Begin>
  void begin(const std::optional<ObserverStart>& seated, Begin&& begins) {
    LinkedGame its;
    its.scenario = "a table";
    its.billiard = table();
    its.start = place();
    start_ = seated.value_or(place());
    observers.reset();
    game.emplace(table());
    begins(std::move(its));
  }
  void start(LinkClock::time_point now) {
    const auto begins_s = play.begins_s(now);
    if (!begins_s) return;
    observers.emplace(Lorentz(kC_m_s), Event{*begins_s, start_.position_m},
                      Head{{Vec3(0.0, 0.0, 1.6), {1, 0, 0, 0}}, Vec3(0.0)});
    play.begin(*observers, now);
    nextStroke_s_ = board_s() + 1.0;
  }
  std::vector<Event> eyes(const Observers& of) const {
    std::vector<Event> eyes;
    for (const EyeView& eye : of.view(0.064).all()) eyes.push_back(eye.observation);
    return eyes;
  }
  bool live(LinkClock::time_point now) {
    walk_s_ += kFrame_s;
    const Head head{{Vec3(0.4 * std::sin(walk_s_), 0.3 * std::cos(0.7 * walk_s_), 1.6), {1, 0, 0, 0}},
                    Vec3(0.0)};
    const auto pace = livablePace(play.pace(now), [&](double at) {
      Observers tried = *observers;
      tried.beginFrame();
      tried.step(kFrame_s, {&head, 1}, at);
      if (!std::ranges::all_of(eyes(tried), [&](const Event& eye) { return play.allows(eye); })) return false;
      observers = tried;
      return true;
    });
    waits += pace ? 0 : 1;
    if (!pace) return false;
    game->advanceTo(board_s() + 0.1);
    for (const Event& eye : eyes(*observers)) insidePromises += play.allows(eye) ? 0 : 1;
    return true;
  }
  void strike() {
    if (board_s() < nextStroke_s_) return;
    nextStroke_s_ = board_s() + random_.in(1.0, 3.0);
    Stroke stroke;
    stroke.puck = static_cast<std::size_t>(random_.in(0.0, 2.999));
    const Event act = observers->headEvent() + Displacement{0.0, {0.2, 0.3, -0.4}};
    stroke.at_s = act.t_s;
    stroke.from_m = act.r_m;
    const Vec3 way = random_.direction();
    stroke.momentum_kg_m_s = 0.2 * kC_m_s * random_.in(0.1, 0.6) * Vec2(way.x, way.y);
    stroke = play.own()->putOff(0, stroke, observers->boardFromRoom());
    game->strike(stroke);
    play.struck(0, stroke);
    ++made;
  }
  void tell(bool isWaiting, LinkClock::time_point now) {
    const Vec3 hand(0.2, 0.3, -0.4);
    play.tell(*observers, {&hand, 1}, {}, eyes(*observers), isWaiting, now);
    game->advanceTo(board_s() + 0.1);
    const std::vector<WorldLine> lines(game->worldLines().begin(), game->worldLines().end());
    play.compare(bend > 0.0 ? bentLines(lines) : lines);
    play.tellSettings(c_m_s, isFrozen);
  }

  Random random_;
  ObserverStart start_;
  double nextStroke_s_ = 0.0, walk_s_ = 0.0;
};

struct Two {
  explicit Two(double late = 0.1, const std::string& name = "lyon", std::uint64_t arithmetic = 7)
      : late_s(late),
        lines{FakeLine(now_s, late_s), FakeLine(now_s, late_s)},
        host(true, "grenoble", lines[0], 7, 1),
        joiner(false, name, lines[1], arithmetic, 2) {
    lines[0].connects(lines[1]);
    lines[1].connects(lines[0]);
  }
  void connect() {
    ++connections;
    for (FakeLine& line : lines) line.open(connections);
  }
  void cut() {
    for (FakeLine& line : lines) line.cut();
  }
  /// Plays on; who has joined calls again if nobody does otherwise.
  void play(double for_s, bool callsAgain = true) {
    const double end_s = now_s + for_s;
    for (; now_s < end_s; now_s += kFrame_s) {
      for (FakeLine& line : lines) line.look();
      if (callsAgain && !lines[0].isOpen() && !lines[1].isOpen()) connect();
      host.frame(now_s);
      joiner.frame(now_s);
    }
  }
  void expectOneGame() {
    EXPECT_EQ(host.play.state(), LinkState::playing);
    EXPECT_EQ(joiner.play.state(), LinkState::playing);
    host.strikes = joiner.strikes = false;
    play(3.0 * late_s + 1.0);
    EXPECT_EQ(host.insidePromises + joiner.insidePromises, 0U);
    const double end_s = std::max(host.board_s(), joiner.board_s()) + 60.0;
    host.game->advanceTo(end_s);
    joiner.game->advanceTo(end_s);
    EXPECT_EQ(digestOf(*host.game), digestOf(*joiner.game));
    EXPECT_GT(host.play.sameUntil_s(), 5U);
    EXPECT_NEAR(host.play.sameUntil_s(), joiner.play.sameUntil_s(), 3);
    EXPECT_LT(std::abs(host.board_s() - joiner.board_s()), 2.0);
  }

  double now_s = 0.0, late_s;
  std::uint64_t connections = 0;
  std::array<FakeLine, 2> lines;
  Room host, joiner;
};

}  // namespace carom::test
