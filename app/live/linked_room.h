#pragma once
// The stage of a live frame that links this room with another one: strokes from afar, the frame that is tried
// before it is lived, and the news for the other room.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/link/linked_play.h"
#include "app/link/linked_turns.h"
#include "app/live/announcements.h"
#include "app/live/decision.h"
#include "app/play/game.h"
#include "app/scenario/scenario.h"
#include "app/viewer/room_motion.h"

namespace carom {

/// Another room, for the operator.
struct LinkReport {
  std::string room, other;  ///< names
  LinkState state = LinkState::alone;
  RoundTrip roundTrip;
  double slack_s = 0.0, apart_m = 0.0;
  double pace = 1.0;     ///< how much faster this room lives than alone
  double waiting = 0.0;  ///< share of the last minute in which it did not live on
  std::uint64_t strokesIn = 0, strokesOut = 0, putOff = 0;
  double sent_kB_s = 0.0, received_kB_s = 0.0;  ///< in the last second
  bool staysOut = false;                        ///< the operator has left the game
  std::uint32_t sameUntil_s = 0;
  double own_s = 0.0, others_s = 0.0;  ///< the clocks of the first viewers, as far as they are known here
};

class LinkedRoom {
 public:
  /// `play` must outlive this object.
  /// `invited`: the file name under which the game of an invitation is played; `axes`: of the room's frame.
  LinkedRoom(LinkedPlay& play, std::string invited, const RoomAxes& axes)
      : play_(play),
        invited_(std::move(invited)),
        roomFromPerson_(glm::quat_cast(glm::dmat3(axes.right, axes.forward, axes.up))) {}

  /// Begins another game of this room; of one that joins and waits for an invitation, `isHall`: time stands.
  /// `goesOn`: the session file has its strokes so far.
  void begin(bool isHall, bool goesOn = false);

  /// Plays the strokes that have come from afar, and says what has happened.
  void hear(Game& game, Announcements& announcements, Decision& decision);
  /// Lives on as far as the other room's promises allow. Returns nothing if the people here have to wait.
  std::optional<ObserverViews> move(const Scenario& scenario, RoomMotion& room, const RoomStep& step);
  /// Says why the people wait, if they have waited for long enough to notice, or whose turn it is and who is
  /// there, as the first viewer of the frame's record sees it. `world`: as it was shown.
  void tellWaiting(bool waits, double step_s, const World& world, const FrameRecord& record,
                   Announcements& announcements);
  /// Tells the other room of this frame, whose record has its viewers and hands. `waits`: the people did not
  /// live on.
  void tell(const RoomMotion& room, const Game& game, const OperatorSettings& settings, bool waits,
            Decision& decision);

  /// The promises that strokes are put off to keep; null before the people live.
  const OwnRoom* promises() const { return play_.own(); }
  /// Numbers and tells a stroke that was played here.
  HandStroke struck(std::size_t viewer, const Stroke& stroke, bool isPutOff);

  /// Returns whether somebody else plays this game: then no time may be replayed.
  bool isShared() const { return play_.state() == LinkState::playing; }
  /// Returns whether the people here live, or may as soon as the other room's promises allow.
  bool isLiving() const { return !isHall_ && play_.isLiving(); }
  /// Returns the game to which this room is invited, until another one begins.
  const std::optional<LinkWelcome>& invitation() const { return invitation_; }
  /// Leaves the game with the other room, or lets it be joined again.
  void stay(bool on) { play_.stayOut(!on); }
  /// Nothing before this board time can change any more.
  double final_s() const { return play_.final_s(); }
  /// The strokes of the game that came before this room joined.
  std::vector<Stroke> strokesBefore() const;

  /// Of a room that joins: returns why it may not choose the next game, in words for people; empty if it may.
  texts::Saying whyNotChoose() const;

  LinkReport report() const;

 private:
  void show(const LinkPresent& present, FrameState& frame, LinkNews& news);
  void showGone(FrameState& frame, LinkNews& news);
  void lookAtCaroms(const FrameRecord& record);
  LinkedPlayer turn() const;
  std::string nameOf(const LinkedPlayer& player) const;
  texts::Saying markOf(const World& world, const Event& eye) const;
  void say(const LinkNote& note, Announcements& announcements, Decision& decision);
  void addRows(Decision& decision);
  void measureTraffic(LinkClock::time_point now);

  HandStroke rowOf(const LinkStroke& stroke) const;

  LinkedPlay& play_;
  std::string invited_;
  glm::dquat roomFromPerson_;  ///< turns x right, y forward, z up
  std::optional<LinkWelcome> invitation_;
  std::vector<ToldMoment> shown_;  ///< the last moment of each of the people who are shown
  LinkedTurns turns_{0};
  LinkedPlayer shownTurn_;  ///< as the walls say it
  struct Own {              ///< of a viewer here
    std::uint64_t caroms = 0;
    std::uint32_t stroke = 0,
                  lastCarom = 0;  ///< 1 + number of the newest stroke, and of that which became one
  };
  std::array<Own, kMostViewers> own_{};
  bool isHall_ = false, isFirst_ = true, isMarked_ = false;  ///< marked: the walls say who is there
  double waited_s_ = 0.0;
  std::uint64_t frames_ = 0;
  LinkReport counted_;  ///< its counts and measurements; the rest is empty
  struct Measured {
    LineTraffic traffic;  ///< all until then
    LinkClock::time_point at{};
  } measured_;
  std::string said_;
  texts::Saying kept_;
};

}  // namespace carom
