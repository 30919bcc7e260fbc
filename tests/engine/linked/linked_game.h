#pragma once
// Two rooms at one table, far apart, in one process and in simulated time: people who walk and strike, a game
// computed in each room, and a line between them. In every frame it is looked whether the promises are kept.

#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/light/point_emission.h"
#include "engine/light_speed.h"
#include "engine/linked/other_room.h"
#include "engine/linked/own_room.h"
#include "engine/linked/pace.h"
#include "engine/linked/seats.h"
#include "engine/linked/shaper.h"
#include "engine/three_pucks.h"

namespace carom::test {

inline constexpr double kFrame_s = 1.0 / 60.0, kReach_m = 0.8;
/// How long a game is played on at the end: all strokes have arrived by then, of a room that has driven away,
/// too.
inline constexpr double kRest_s = 100.0;

/// A guard of the rule that is left out on purpose.
enum class Without {
  nothing,
  reach,         ///< the sender promises at the head, and strikes as far as before
  puttingOff,    ///< the sender strikes outside the promise
  count,         ///< presents do not say how many strokes came before
  waiting,       ///< the receiver lives on
  keptPromises,  ///< the sender promises anew even where that takes back a part
  drawnHand,     ///< the hand is drawn wherever it is
};

struct LinkedRules {
  double apart_m = 3.2;  ///< between the places round which the people of the rooms walk
  LineFaults line{};
  double reach_m = kReach_m;  ///< promised; hands strike up to kReach_m from the head
  std::size_t strokes = 90;   ///< of both rooms together; then the game ends
  double most_s = 400.0;      ///< of wall time
  std::size_t viewers = 1;    ///< in each room
  double beta = 0.0;          ///< of the platforms, away from each other
  double thrust_m_s2 = 0.0;   ///< of the platforms, to and fro across
  double joins_s = 0.0;       ///< when the second room joins
  Without without = Without::nothing;
  /// The receiver plays strokes that break a promise, too.
  bool isTrusting = false;
  std::uint64_t seed = 1;
};

struct Welcome {
  Present present;
  std::vector<StrokeTold> strokes;
};
struct Ready {
  Present present;
};
struct Accepted {};
using LineMessage = std::variant<Present, StrokeTold, Welcome, Ready, Accepted>;

/// What was counted.
struct LinkedCounts {
  std::size_t frames = 0, waits = 0, strokes = 0, fromAfar = 0, tooLate = 0, changed = 0, looks = 0,
              unknown = 0;
  std::size_t outsideOwn = 0, insideOthers = 0, broken = 0, putOff = 0, withoutDelay = 0, refused = 0;
  double mostPutOff_s = 0.0, mostPace = 1.0, nearest_m = 1e9;
  double waiting() const { return static_cast<double>(waits) / static_cast<double>(frames); }
};

/// Somebody who stands or walks within 1.2 m, and swings a hand at up to 3 m/s within 0.9 m of the head.
class Walker {
 public:
  Walker(const Vec3& home_m, std::uint64_t seed) : random_(seed), home_m_(home_m) {}
  /// Room frame: of the head.
  Vec3 place_m() const { return home_m_ + at_m_; }
  const Vec3& hand_m() const { return hand_m_; }  ///< from the head
  void step() {
    constexpr double kHalf_m = 0.6, kHand_m = 0.9;
    if (random_.in(0.0, 1.0) < kFrame_s / 4.0) {
      static const Vec3 kWays[] = {{0, 0, 0}, {0.7, 0, 0}, {-0.9, 0.2, 0}, {0.3, -1.1, 0}, {0, 0, 0}};
      way_m_s_ = kWays[static_cast<std::size_t>(random_.in(0.0, 4.999))];
    }
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(at_m_[axis] + way_m_s_[axis] * kFrame_s) >= kHalf_m) way_m_s_[axis] *= -1.0;
      at_m_[axis] += way_m_s_[axis] * kFrame_s;
    }
    if (random_.in(0.0, 1.0) < 2.0 * kFrame_s) swing_m_s_ = 3.0 / std::sqrt(3.0) * random_.inBox(1.0);
    if (const Vec3 next_m = hand_m_ + kFrame_s * swing_m_s_; glm::length(next_m) < kHand_m) hand_m_ = next_m;
  }
  Random& random() { return random_; }

 private:
  Random random_;
  Vec3 home_m_, at_m_{0.0}, way_m_s_{0.0}, hand_m_{0.3, 0.0, 0.0}, swing_m_s_{0.0};
};

inline BilliardSetup linkedTable() {
  BilliardSetup setup = threePucks();
  for (Puck& puck : setup.pucks) puck.beta *= 0.3;
  setup.rules.friction_m_s2 = 0.05;
  return setup;
}

/// One of the rooms.
class LinkedRoom {
 public:
  using Line = Shaper<LineMessage>;

  /// `side`: −1 or 1, where it stands on the x axis. A joiner begins when it is welcomed.
  LinkedRoom(const LinkedRules& rules, double side)
      : rules_(rules), side_(side), setup_(linkedTable()), game_(setup_) {
    const auto name = static_cast<std::uint64_t>(2.0 + side);
    for (std::size_t i = 0; i < rules.viewers; ++i)
      walkers_.emplace_back(Vec3(0.0, 0.5 * static_cast<double>(i), 0.85), 97 * rules.seed + 10 * name + i);
    nextStroke_s_.resize(rules.viewers, 0.0);
    for (std::size_t i = 0; i < rules.viewers; ++i) nextStroke_s_[i] = walkers_[i].random().in(1.0, 4.0);
  }

  void begin(double board_s) {
    const Lorentz boardFromRoom = Lorentz::boost(uFromBeta(Vec3(side_ * rules_.beta, 0.0, 0.0)), kC_m_s);
    const Event origin{board_s, {side_ * 0.5 * rules_.apart_m, 0.0, 0.0}};
    observers_.emplace(boardFromRoom, origin, heads());
    own_.emplace(rules_.reach_m, *observers_, othersHeads());
    isLiving_ = true;
  }

  void knows(const Present& first) { other_.emplace(first, kC_m_s); }
  const Present& told() const { return own_->present(); }
  bool isLiving() const { return isLiving_; }
  std::size_t strokes() const { return counts_.strokes; }
  Billiard& game() { return game_; }
  const LinkedCounts& counts() const { return counts_; }
  const std::vector<StrokeTold>& made() const { return made_; }
  double board_s() const { return observers_->headEvent().t_s; }

  void hear(double now_s, Line& from, Line& to) {
    from.take(now_s, [&](const LineMessage& message) {
      if (const auto* present = std::get_if<Present>(&message)) heard(*present, now_s);
      if (const auto* stroke = std::get_if<StrokeTold>(&message)) heard(*stroke);
      if (const auto* welcome = std::get_if<Welcome>(&message)) join(*welcome, now_s, to);
      if (const auto* ready = std::get_if<Ready>(&message)) accept(*ready, now_s, to);
      if (std::get_if<Accepted>(&message)) isLiving_ = true;
    });
  }

  void ask(double now_s, Line& to) { to.send(now_s, Welcome{own_->present(), made_}, true); }

  void frame(double now_s, bool mayStrike, Line& to) {
    if (!observers_) return;
    for (Walker& walker : walkers_) walker.step();
    const bool lived = isLiving_ && live(now_s);
    if (isLiving_) {
      ++counts_.frames;
      counts_.waits += lived ? 0 : 1;
    }
    if (lived) {
      look();
      for (std::size_t i = 0; mayStrike && i < walkers_.size(); ++i) strike(i, now_s, to);
    }
    tell(!lived, now_s, to);
  }

 private:
  std::vector<Head> heads() const {
    std::vector<Head> heads;
    for (const Walker& walker : walkers_) heads.push_back({{walker.place_m(), {1, 0, 0, 0}}, Vec3(0.0)});
    return heads;
  }
  std::vector<Event> othersHeads() const {
    std::vector<Event> heads;
    for (std::size_t i = 0; other_ && i < other_->present().size; ++i)
      heads.push_back(other_->present().persons[i].head);
    return heads;
  }
  /// How far the nearest head is that is known of the other room.
  double nearest_m() const {
    double nearest_m = 1e9;
    for (const Event& head : othersHeads()) {
      for (std::size_t i = 0; i < observers_->size(); ++i)
        nearest_m = std::min(nearest_m, glm::distance(head.r_m, observers_->headEvent(i).r_m));
    }
    return nearest_m;
  }

  // ------------------------------------------------------------ a frame
  std::vector<Event> eyes(const Observers& observers) const {
    std::vector<Event> eyes;
    for (std::size_t i = 0; i < observers.size(); ++i) {
      for (const EyeView& eye : observers.view(0.064, i).all()) eyes.push_back(eye.observation);
    }
    return eyes;
  }

  bool live(double now_s) {
    double pace = 1.0;
    if (other_) {
      const Present& present = other_->newest();
      const double age_s = present.waits ? 0.0 : rules_.line.late_s;
      pace = hurry(behind_s(board_s(), present.persons[0].head.t_s, age_s,
                            slack_s(nearest_m(), own_->reach_m(0), kC_m_s)));
    }
    Vec3 thrust(0.0);
    if (rules_.thrust_m_s2 != 0.0) thrust.y = rules_.thrust_m_s2 * std::cos(now_s * side_);
    Observers tried = *observers_;
    const std::vector<Head> heads = this->heads();
    const auto isAllowed = [&](double at) {
      tried = *observers_;
      tried.beginFrame();
      tried.step(kFrame_s, heads, at, thrust);
      if (!other_ || rules_.without == Without::waiting) return true;
      const std::vector<Event> eyes = this->eyes(tried);
      return std::ranges::all_of(eyes, [&](const Event& eye) { return other_->allows(eye); });
    };
    const std::optional<double> lived = livablePace(pace, isAllowed);
    if (!lived) return false;
    counts_.mostPace = std::max(counts_.mostPace, *lived);
    observers_ = tried;
    return true;
  }

  // What an eye sees lies in its past; what is known of the others must reach beyond.
  void look() {
    for (std::size_t i = 0; i < observers_->size(); ++i) views_.push_back(observers_->view(0.064, i));
    while (views_.size() > 60 * walkers_.size()) views_.pop_front();
    double latest_s = board_s();
    for (const Event& eye : eyes(*observers_)) {
      latest_s = std::max(latest_s, eye.t_s);
      for (std::size_t i = 0; other_ && i < other_->present().size; ++i) {
        const PersonTold& person = other_->present().persons[i];
        counts_.insideOthers += reaches(person.promise, eye) ? 1 : 0;
        counts_.unknown += reaches(person.head, eye) || reaches(person.hand, eye) ? 1 : 0;
      }
    }
    game_.advanceTo(latest_s);
    if (other_) counts_.nearest_m = std::min(counts_.nearest_m, nearest_m());
  }

  /// Whether light of an event has reached another: squared, unlike the function that is tested.
  static bool reaches(const Event& from, const Event& to) {
    return to.t_s >= from.t_s && !(interval_m2(to - from, kC_m_s) < 0.0);
  }

  /// The same, but for rounding: an act that was put off lies on the promise's light.
  static bool keeps(const Event& promise, const Event& act) {
    constexpr double kRounding_s = 1e-9;
    return reaches(promise - Displacement{kRounding_s, Vec3(0.0)}, act);
  }

  void strike(std::size_t viewer, double now_s, Line& to) {
    if (observers_->properTime_s(viewer) < nextStroke_s_[viewer]) return;
    Random& random = walkers_[viewer].random();
    nextStroke_s_[viewer] = observers_->properTime_s(viewer) + random.in(1.0, 3.0);
    const Vec3 hand_m = walkers_[viewer].hand_m();
    const Event act = observers_->headEvent(viewer) +
                      observers_->boardFromRoom() *
                          Displacement{0.0, glm::length(hand_m) > kReach_m ? 0.8 * hand_m : hand_m};
    Stroke stroke;
    stroke.puck = static_cast<std::size_t>(random.in(0.0, 2.999));
    stroke.at_s = act.t_s;
    stroke.from_m = act.r_m;
    const Vec3 way = random.direction();
    stroke.momentum_kg_m_s = 0.2 * kC_m_s * random.in(0.1, 0.8) * Vec2(way.x, way.y);
    StrokeTold told = own_->strike(static_cast<std::uint32_t>(viewer), stroke, observers_->boardFromRoom());
    const double off_s = told.stroke.at_s - stroke.at_s;
    counts_.putOff += off_s > 0.0 ? 1 : 0;
    counts_.mostPutOff_s = std::max(counts_.mostPutOff_s, off_s);
    if (rules_.without == Without::reach || rules_.without == Without::puttingOff) told.stroke = stroke;
    counts_.outsideOwn += keeps(lastTold_.persons[viewer].promise, told.event()) ? 0 : 1;
    ++counts_.strokes;
    made_.push_back(told);
    game_.strike(told.stroke);
    to.send(now_s, told, true);
  }

  void tell(bool waits, double now_s, Line& to) {
    std::vector<Vec3> hands_m;
    for (const Walker& walker : walkers_) hands_m.push_back(walker.hand_m());
    Present present = own_->tell(*observers_, hands_m, othersHeads(), waits);
    for (std::size_t i = 0; i < present.size; ++i) {
      PersonTold& person = present.persons[i];
      const Lorentz& boardFromRoom = observers_->boardFromRoom();
      if (rules_.without == Without::reach) person.promise = person.hand = person.head;
      if (rules_.without == Without::keptPromises)
        person.promise = Promise(person.head, boardFromRoom, own_->reach_m(i)).event();
      if (rules_.without == Without::drawnHand)
        person.hand = person.head + boardFromRoom * Displacement{0.0, hands_m[i]};
      const PersonTold& before = lastTold_.persons[i];
      if (lastTold_.size > 0) {
        counts_.outsideOwn += keeps(before.promise, person.promise) ? 0 : 1;
        counts_.outsideOwn += keeps(before.head, person.head) ? 0 : waits ? 0 : 1;
      }
      counts_.outsideOwn += keeps(person.promise, person.head) ? 0 : 1;
      counts_.outsideOwn += keeps(person.promise, person.hand) ? 0 : 1;
    }
    if (rules_.without == Without::count) present.strokes = 0;
    lastTold_ = present;
    to.send(now_s, present, false);
  }

  // ------------------------------------------------------------ news
  void heard(const Present& present, double) {
    if (other_) counts_.broken += other_->hear(present) == Judgement::broken ? 1 : 0;
  }

  void heard(const StrokeTold& told) {
    if (!other_) return;
    const Judgement judged = other_->hear(told);
    counts_.broken += judged == Judgement::broken ? 1 : 0;
    if (judged == Judgement::taken) playFromAfar(told.stroke);
    if (judged != Judgement::broken || !rules_.isTrusting) return;
    StrokeTold harmless = told;  // what a receiver that looks away would take
    harmless.stroke.at_s += 1000.0;
    other_->hear(harmless);
    playFromAfar(told.stroke);
  }

  void playFromAfar(const Stroke& stroke) {
    ++counts_.fromAfar;
    const auto isSeenBy = [&](const ObserverView& view) {
      return std::ranges::any_of(view.all(), [&](const EyeView& eye) {
        return reaches({stroke.at_s, *stroke.from_m}, eye.observation);
      });
    };
    counts_.tooLate += std::ranges::any_of(views_, isSeenBy) ? 1 : 0;
    const std::vector<WorldLine> before(game_.worldLines().begin(), game_.worldLines().end());
    const auto kicks = [&] {
      return std::ranges::count_if(game_.events(), [](const GameEvent& event) { return event.withoutDelay; });
    };
    const auto had = kicks();
    game_.strike(stroke);
    if (kicks() != had) {  // they outrun light by themselves, as in a room alone
      ++counts_.withoutDelay;
      return;
    }
    for (std::size_t puck = 0; puck < before.size(); ++puck) {
      if (before[puck].knots().size() == game_.worldLines()[puck].knots().size() &&
          before[puck].knots().back().turn.t_s == game_.worldLines()[puck].knots().back().turn.t_s)
        continue;
      for (const double side : {-1.0, 0.0, 1.0})
        expectSeenTheSame(before[puck], game_.worldLines()[puck], side);
    }
  }

  /// Counts what eyes of the last second would now see otherwise, bit for bit.
  void expectSeenTheSame(const WorldLine& before, const WorldLine& after, double side) {
    const Vec3 offset_m(side * before.radius_m(), 0.0, 0.0);
    const PointEmission had(before, offset_m), has(after, offset_m);
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (i % 10 != 0 && i + walkers_.size() < views_.size()) continue;
      for (const EyeView& eye : views_[i].all()) {
        const auto then = had.seenAt(eye.observation, views_[i].headFromBoard);
        const auto now = has.seenAt(eye.observation, views_[i].headFromBoard);
        ++counts_.looks;
        const bool isSame =
            then.has_value() == now.has_value() &&
            (!then || (then->event.t_s == now->event.t_s && then->event.r_m == now->event.r_m &&
                       then->doppler == now->doppler && then->properTime_s == now->properTime_s));
        counts_.changed += isSame ? 0 : 1;
      }
    }
  }

  // ------------------------------------------------------------ joining
  /// The joiner begins a round trip later than it is told, and lives once that is accepted.
  void join(const Welcome& welcome, double now_s, Line& to) {
    if (isLiving_) return;
    knows(welcome.present);
    for (const StrokeTold& told : welcome.strokes) game_.strike(told.stroke);
    begin(welcome.present.persons[0].head.t_s + 2.0 * rules_.line.late_s);
    isLiving_ = false;
    to.send(now_s, Ready{own_->present()}, true);
  }

  void accept(const Ready& ready, double now_s, Line& to) {
    if (other_) return;
    OtherRoom other(ready.present, kC_m_s);
    const std::vector<Event> eyes = this->eyes(*observers_);
    if (!std::ranges::all_of(eyes, [&](const Event& eye) { return other.allows(eye); })) {
      ++counts_.refused;
      return;
    }
    other_ = other;
    to.send(now_s, Accepted{}, true);
  }

  const LinkedRules rules_;
  double side_;
  BilliardSetup setup_;
  Billiard game_;
  std::vector<Walker> walkers_;
  std::vector<double> nextStroke_s_;
  std::optional<Observers> observers_;
  std::optional<OwnRoom> own_;
  std::optional<OtherRoom> other_;
  bool isLiving_ = false;
  Present lastTold_{};
  std::deque<ObserverView> views_;  ///< of the last second
  std::vector<StrokeTold> made_;
  LinkedCounts counts_;
};

/// Both rooms and the line.
class LinkedGame {
 public:
  explicit LinkedGame(const LinkedRules& rules)
      : rules_(rules),
        rooms_{LinkedRoom(rules, -1.0), LinkedRoom(rules, 1.0)},
        lines_{LinkedRoom::Line(rules.line, rules.seed + 100),
               LinkedRoom::Line(rules.line, rules.seed + 200)} {
    rooms_[0].begin(0.0);
    if (rules.joins_s > 0.0) return;
    rooms_[1].begin(0.0);
    rooms_[0].knows(rooms_[1].told());
    rooms_[1].knows(rooms_[0].told());
  }

  void play() {
    double now_s = 0.0;
    bool isAsked = rules_.joins_s == 0.0;
    const auto struck = [&] { return rooms_[0].strokes() + rooms_[1].strokes(); };
    for (; now_s < rules_.most_s && struck() < rules_.strokes; now_s += kFrame_s) {
      if (!isAsked && now_s >= rules_.joins_s) {
        isAsked = true;
        rooms_[0].ask(now_s, lines_[0]);
      }
      for (std::size_t i : {0U, 1U}) {
        rooms_[i].hear(now_s, lines_[1 - i], lines_[i]);
        rooms_[i].frame(now_s, true, lines_[i]);
      }
    }
    for (std::size_t i : {0U, 1U}) rooms_[i].hear(now_s + 1000.0, lines_[1 - i], lines_[i]);
    const double end_s = std::max(rooms_[0].board_s(), rooms_[1].board_s()) + kRest_s;
    for (LinkedRoom& room : rooms_) room.game().advanceTo(end_s);
  }

  LinkedRoom& room(std::size_t i) { return rooms_[i]; }

  /// The game with all strokes known from the start, in an order of their own.
  Billiard asKnownFromTheStart() {
    BilliardSetup setup = linkedTable();
    for (std::size_t i : {1U, 0U}) {
      for (const StrokeTold& told : rooms_[i].made())
        setup.strokes.insert(setup.strokes.begin(), told.stroke);
    }
    Billiard game(setup);
    game.advanceTo(std::max(rooms_[0].board_s(), rooms_[1].board_s()) + kRest_s);
    return game;
  }

 private:
  LinkedRules rules_;
  std::array<LinkedRoom, 2> rooms_;
  std::array<LinkedRoom::Line, 2> lines_;  ///< from each room
};

}  // namespace carom::test
