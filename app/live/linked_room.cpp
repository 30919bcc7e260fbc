#include "app/live/linked_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "cave/texts/saying.h"
#include "cave/texts/texts.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr double kNoticed_s = 0.3;  // a shorter stillness is not explained
constexpr double kMinute_s = 60.0;
constexpr double kGlide_s = 2.0;  // of board time, for which people who are gone are still there

/// Returns the turn of a motion, which is a turn and a boost after it, of a vector of the room.
Vec3 turned(const Lorentz& boardFromRoom, const Vec3& inRoom) {
  const Lorentz unboosted = Lorentz::boost(-boardFromRoom.u(), boardFromRoom.lightSpeed_m_s());
  return (unboosted * (boardFromRoom * Displacement{0.0, inRoom})).dr_m;
}

double azimuth_rad(const Vec3& onBoard) { return std::atan2(onBoard.y, onBoard.x); }

/// Returns a person's moment as it is drawn here.
ToldMoment momentOf(const LinkPresent& message, std::size_t i, const Lorentz& boardFromRoom) {
  const PersonTold& told = message.present.persons[i];
  const LinkPerson& person = message.persons[i];
  constexpr double kAtTheHead_m = 0.05;  // where there is none, the hand is told of as there
  ToldMoment moment;
  moment.person = i;
  moment.head = told.head;
  moment.hand = told.hand;
  moment.properTime_s = told.properTime_s;
  moment.facing_rad = azimuth_rad(turned(boardFromRoom, person.attitude * Vec3(0.0, 1.0, 0.0)));
  moment.hasHand = glm::distance(told.hand.r_m, told.head.r_m) > kAtTheHead_m ? 1 : 0;
  moment.hasCue = moment.hasHand && person.held > 0 && person.pull_m != Vec3(0.0) ? 1 : 0;
  moment.cue_rad = moment.hasCue ? azimuth_rad(turned(boardFromRoom, person.pull_m)) : 0.0;
  moment.caroms = person.caroms;
  return moment;
}

}  // namespace

void LinkedRoom::begin(bool isHall, bool goesOn) {
  isHall_ = isHall;
  invitation_.reset();
  shown_.clear();
  turns_ = LinkedTurns(play_.room());
  for (const LinkStroke& stroke : play_.strokes()) turns_.struck(stroke);
  shownTurn_ = {};
  own_ = {};
  isFirst_ = !goesOn;
  counted_ = {};
  waited_s_ = 0.0;
  kept_ = texts::Saying("-");
}

std::vector<Stroke> LinkedRoom::strokesBefore() const {
  std::vector<Stroke> strokes;
  for (const LinkStroke& stroke : play_.strokes()) strokes.push_back(stroke.told.stroke);
  return strokes;
}

/// Says what has happened, once where it happens again and again.
void LinkedRoom::say(const LinkNote& note, Announcements& announcements, Decision& decision) {
  const std::string words = note.what + ": " + note.value;
  if (words == said_) return;
  said_ = words;
  decision.link.notes.push_back({play_.otherNumber(), note.what, note.value});
  log::note("link: " + words);
  const std::string& other = play_.otherName();
  if (note.what == LinkNote::kPaired) {
    turns_.joined(static_cast<std::uint32_t>(
        std::ranges::count(play_.strokes(), 1U, [](const LinkStroke& stroke) { return stroke.room; })));
    announcements.say(texts::say(texts::message::kLinkPaired, other), decision);
  }
  if (note.what == LinkNote::kGone) announcements.say(texts::say(texts::message::kLinkGone, other), decision);
  if (note.what == LinkNote::kBack) announcements.say(texts::say(texts::message::kLinkBack, other), decision);
  if (note.what == LinkNote::kMismatch && play_.state() == LinkState::alone)
    announcements.say(texts::say(texts::message::kLinkMismatch, note.value), decision);
  if (note.what == LinkNote::kResynchronised)
    announcements.say(texts::say(texts::message::kLinkResynchronised, note.value), decision);
}

HandStroke LinkedRoom::rowOf(const LinkStroke& stroke) const {
  const auto& names = stroke.room == play_.room() ? play_.self().viewers : play_.otherViewers();
  const std::size_t viewer = stroke.told.viewer;
  return {stroke.told.stroke, viewer, stroke.room, stroke.told.number,
          viewer < names.size() ? names[viewer] : std::to_string(viewer + 1)};
}

void LinkedRoom::hear(Game& game, Announcements& announcements, Decision& decision) {
  if (isFirst_) {  // the game began with these
    for (const LinkStroke& stroke : play_.strokes()) decision.link.strokes.push_back(rowOf(stroke));
    if (play_.lightSpeedShown_m_s() > 0.0)
      decision.commands.emplace_back(SetLightSpeed{play_.lightSpeedShown_m_s()});
    isFirst_ = false;
  }
  play_.hear(LinkClock::now());
  const LinkHeard& heard = play_.heard();
  for (const LinkStroke& stroke : heard.strokes) {
    try {
      game.strike(stroke.told.stroke);
    } catch (const std::invalid_argument& error) {
      log::warn(fmt::format("link: a stroke of {} is void: {}", play_.otherName(), error.what()));
    }
    ++counted_.strokesIn;
    turns_.struck(stroke);
    decision.link.strokes.push_back(rowOf(stroke));
  }
  for (const LinkNote& note : heard.notes) say(note, announcements, decision);
  decision.frame.told.clear();
  for (const LinkPresent& present : heard.presents) show(present, decision.frame, decision.link);
  if (play_.state() == LinkState::alone) showGone(decision.frame, decision.link);
  if (heard.settings) {
    decision.commands.emplace_back(SetLightSpeed{heard.settings->lightSpeedShown_m_s});
    decision.commands.emplace_back(SetView{&TimeViews::frozen, heard.settings->isFrozen});
  }
  if (auto invitation = play_.takeInvitation()) {
    invitation_ = std::move(invitation);
    decision.commands.emplace_back(PlayScenario{invited_, true});
  }
}

/// Shows the people of a present.
void LinkedRoom::show(const LinkPresent& present, FrameState& frame, LinkNews& news) {
  const Lorentz boardFromRoom(play_.lightSpeed_m_s(), present.boardFromRoom);
  shown_.resize(std::max(shown_.size(), present.present.size));
  for (std::size_t i = 0; i < present.present.size; ++i) {
    ToldMoment moment = momentOf(present, i, boardFromRoom);
    moment.setName(play_.otherViewers().at(i));
    if (const std::uint32_t carom = present.persons[i].lastCarom)
      turns_.carom({present.room, static_cast<std::uint32_t>(i)}, carom - 1, moment.head);
    if (shown_[i].nameText().empty()) moment.kind = ToldKind::begins;
    shown_[i] = moment;
    frame.told.push_back(moment);
    news.persons.push_back({present.room, present.present.number, moment});
  }
}

/// Lets the people go who were there: they stay for a while as they were told of last, and vanish.
void LinkedRoom::showGone(FrameState& frame, LinkNews& news) {
  for (ToldMoment& last : shown_) {
    last.kind = ToldKind::ends;
    last.head.t_s += kGlide_s;
    last.hand.t_s += kGlide_s;
    frame.told.push_back(last);
    news.persons.push_back({play_.otherNumber(), 0, last});
  }
  shown_.clear();
}

std::optional<ObserverViews> LinkedRoom::move(const Scenario& scenario, RoomMotion& room,
                                              const RoomStep& step) {
  counted_.pace = 1.0;
  const auto now = LinkClock::now();
  if (!isHall_ && !play_.own()) {
    if (const std::optional<double> begins_s = play_.begins_s(now)) {
      if (*begins_s > 0.0) room.startAt(scenario.observer, *begins_s);
      play_.begin(room.viewers().observers(), now);
    }
  }
  if (!isLiving()) {
    room.viewers().follow(step.times);
    return std::nullopt;
  }
  const double hurry = play_.pace(now);
  const std::array paces{step.pace * hurry, step.pace};
  const std::size_t viewers = room.viewers().size();
  bool isHurry = true;
  const auto isAllowed = [&](const ObserverViews& views) {
    counted_.pace = std::exchange(isHurry, false) ? hurry : 1.0;
    for (std::size_t i = 0; i < viewers; ++i) {
      for (const EyeView& eye : views[i].all())
        if (!play_.allows(eye.observation)) return false;
    }
    return true;
  };
  return room.advanceIf(step, std::span(paces).subspan(hurry == 1.0 ? 1 : 0), isAllowed);
}

/// Takes the caroms that the people here have just seen.
void LinkedRoom::lookAtCaroms(const FrameRecord& record) {
  for (std::uint32_t i = 0; i < record.viewerCount; ++i) {
    Own& own = own_[i];
    const std::uint64_t before = std::exchange(own.caroms, record.viewers[i].score.caroms);
    if (own.caroms <= before || own.stroke == 0) continue;
    own.lastCarom = own.stroke;
    turns_.carom({play_.room(), i}, own.lastCarom - 1, record.viewers[i].observer.middle.observation);
  }
}

LinkedPlayer LinkedRoom::turn() const {
  std::array<std::uint32_t, 2> people{};
  people[play_.room()] = static_cast<std::uint32_t>(play_.self().viewers.size());
  people[play_.otherNumber()] = static_cast<std::uint32_t>(play_.otherViewers().size());
  return turns_.turn(people);
}

/// Returns a person's name; who has none is called as their room.
std::string LinkedRoom::nameOf(const LinkedPlayer& player) const {
  const bool isHere = player.room == play_.room();
  const auto& names = isHere ? play_.self().viewers : play_.otherViewers();
  const std::string& room = isHere ? play_.self().room : play_.otherName();
  const bool isNamed = player.viewer < names.size() && names[player.viewer] != kUnnamed;
  return isNamed ? names[player.viewer] : room;
}

/// Returns whose turn it is, the people of the other room as their light tells of them, and where they are.
texts::Saying LinkedRoom::markOf(const World& world, const Event& eye) const {
  const bool isOwn = shownTurn_.room == play_.room() && play_.self().viewers.size() == 1;
  texts::Saying words = isOwn ? texts::Saying(texts::message::kLinkYourTurn)
                              : texts::say(texts::message::kLinkTheirTurn, nameOf(shownTurn_));
  // What would be cut is left out.
  const auto add = [&](const texts::Saying& more) {
    const texts::Saying both = words + more;
    if (both.english().size() < Notice().english.text.size()) words = both;
  };
  for (const ToldPath& path : world.people) {
    const auto seen =
        path.at([&](const Event& event) { return afterLightOf_s(event, eye, play_.lightSpeed_m_s()); });
    if (!seen) continue;
    const LinkedPlayer player{play_.otherNumber(), static_cast<std::uint32_t>(seen->moment->person)};
    add(texts::say(texts::message::kLinkPerson, nameOf(player), seen->properTime_s, seen->moment->caroms,
                   turns_.strokes(player)));
  }
  add(texts::say(texts::message::kLinkMark, play_.otherName(), play_.away_s()));
  return words;
}

void LinkedRoom::tellWaiting(bool waits, double step_s, const World& world, const FrameRecord& record,
                             Announcements& announcements) {
  const Event& eye = record.viewers.front().observer.middle.observation;
  lookAtCaroms(record);
  turns_.look(eye, play_.lightSpeed_m_s());
  waited_s_ = waits ? waited_s_ + step_s : 0.0;
  texts::Saying words;
  if (isHall_ || !play_.own()) {
    words = play_.otherName().empty() ? texts::Saying(texts::message::kLinkCalls)
                                      : texts::say(texts::message::kLinkWaitsFor, play_.otherName());
  } else if (waited_s_ > kNoticed_s) {
    words = texts::say(texts::message::kLinkStill, play_.otherName());
  } else if (play_.state() == LinkState::playing) {
    // Once a second is often enough for numbers.
    const bool isRecent = isMarked_ && frames_ % 60 != 0 && turn() == shownTurn_;
    shownTurn_ = turn();
    words = isRecent ? kept_ : markOf(world, eye);
  }
  isMarked_ = play_.state() == LinkState::playing && waited_s_ <= kNoticed_s;
  if (words == kept_) return;
  kept_ = words;
  announcements.keep(words);
}

HandStroke LinkedRoom::struck(std::size_t viewer, const Stroke& stroke, bool isPutOff) {
  ++counted_.strokesOut;
  counted_.putOff += isPutOff ? 1 : 0;
  const LinkStroke made = play_.struck(static_cast<std::uint32_t>(viewer), stroke);
  turns_.struck(made);
  own_[viewer].stroke = made.told.number + 1;
  return {stroke, viewer, made.room, made.told.number, {}};
}

void LinkedRoom::tell(const RoomMotion& room, const Game& game, const OperatorSettings& settings, bool waits,
                      Decision& decision) {
  ++frames_;
  const FrameRecord& record = decision.frame.record;
  const double share = std::min(1.0, 1.0 / (60.0 * kMinute_s));
  counted_.waiting += share * ((waits ? 1.0 : 0.0) - counted_.waiting);
  measureTraffic(LinkClock::now());
  if (!play_.own()) return;
  const Viewers& viewers = room.viewers();
  std::array<Vec3, kMostViewers> hands_m{};
  LinkedPlay::Persons persons{};
  std::array<Event, 3 * kMostViewers> eyes{};
  for (std::size_t i = 0; i < viewers.size(); ++i) {
    const ViewerState& viewer = record.viewers[i];
    const EyeView& middle = viewer.observer.middle;
    if (viewer.hand.shown) hands_m[i] = viewer.hand.from_m - middle.positionInRoom_m;
    const HeadEstimate& head = viewers.head(i);
    persons[i] = {glm::normalize(head.pose.orientation * roomFromPerson_),
                  head.celerity_m_s,
                  static_cast<std::uint32_t>(viewer.hand.target),
                  viewer.hand.pulling ? viewer.hand.towards : Vec3(0.0),
                  static_cast<std::uint32_t>(viewer.score.caroms),
                  own_[i].lastCarom};
    std::size_t eye = 3 * i;
    for (const EyeView& view : viewer.observer.all()) eyes[eye++] = view.observation;
  }
  play_.tell(viewers.observers(), std::span(hands_m).first(viewers.size()), persons,
             std::span(eyes).first(3 * viewers.size()), waits, LinkClock::now());
  play_.compare(game.pucks());
  play_.tellSettings(settings.lightSpeed_m_s, settings.views.frozen != 0);
  counted_.own_s = viewers.observers().properTime_s();
  addRows(decision);
}

void LinkedRoom::measureTraffic(LinkClock::time_point now) {
  const double since_s = std::chrono::duration<double>(now - measured_.at).count();
  if (since_s < 1.0) return;
  const LineTraffic before = std::exchange(measured_, {play_.traffic(), now}).traffic;
  const LineTraffic& all = measured_.traffic;
  counted_.sent_kB_s = 1e-3 * static_cast<double>(all.sentBytes - before.sentBytes) / since_s;
  counted_.received_kB_s = 1e-3 * static_cast<double>(all.receivedBytes - before.receivedBytes) / since_s;
}

/// Also of whose turn it is among those here: while there is another room, the walls say it of both.
void LinkedRoom::addRows(Decision& decision) {
  const OtherRoom* const other = play_.other();
  if (!other) return;
  for (ViewerState& viewer : decision.frame.record.present()) viewer.hasTurn = 0;
  const Present& present = other->present();
  for (std::size_t i = 0; i < present.size && i < play_.otherViewers().size(); ++i) {
    decision.link.rows.push_back({play_.otherNumber(), wordFor(play_.state()), other->newest().number,
                                  play_.roundTrip().median_s, present.persons[i].promise,
                                  play_.otherViewers()[i], play_.own()->present().waits, counted_.pace,
                                  play_.sameUntil_s()});
  }
}

texts::Saying LinkedRoom::whyNotChoose() const {
  if (play_.state() == LinkState::alone && isLiving()) return {};
  return play_.otherName().empty() ? texts::Saying(texts::message::kLinkCalls)
                                   : texts::say(texts::message::kLinkHostChooses, play_.otherName());
}

LinkReport LinkedRoom::report() const {
  LinkReport report = counted_;
  report.room = play_.self().room;
  report.other = play_.otherName();
  report.state = play_.state();
  report.roundTrip = play_.roundTrip();
  report.slack_s = play_.slack_s();
  report.apart_m = play_.apart_m();
  report.staysOut = play_.staysOut();
  report.sameUntil_s = play_.sameUntil_s();
  if (play_.other()) report.others_s = play_.other()->newest().persons[0].properTime_s;
  return report;
}

}  // namespace carom
