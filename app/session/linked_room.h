#pragma once
// The stage of a live frame that links this room with another one: strokes from afar, the frame that is tried
// before it is lived, and the news for the other room.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/files/scenario.h"
#include "app/link/linked_play.h"
#include "app/play/game.h"
#include "app/session/announcements.h"
#include "app/session/decision.h"
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
  void begin(bool isHall);

  /// Plays the strokes that have come from afar, and says what has happened.
  void hear(Game& game, Announcements& announcements, Decision& decision);
  /// Lives on as far as the other room's promises allow. Returns nothing if the people here have to wait.
  std::optional<ObserverViews> move(const Scenario& scenario, RoomMotion& room, const RoomStep& step);
  /// Says why the people wait, if they have waited for long enough to notice, or who is there as the first
  /// viewer's `eye` sees them.
  void tellWaiting(bool waits, double step_s, const World& world, const Event& eye,
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
  /// Nothing before this board time can change any more.
  double final_s() const { return play_.final_s(); }
  /// The strokes of the game that came before this room joined.
  std::vector<Stroke> strokesBefore() const;

  /// Of a room that joins: returns why it may not choose the next game, in words for people; empty if it may.
  std::string whyNotChoose() const;

  LinkReport report() const;

 private:
  void show(const LinkPresent& present, FrameState& frame, LinkNews& news);
  void showGone(FrameState& frame, LinkNews& news);
  std::string markOf(const World& world, const Event& eye) const;
  void say(const LinkNote& note, Announcements& announcements, Decision& decision);
  void addRows(Decision& decision) const;

  HandStroke rowOf(const LinkStroke& stroke) const;

  LinkedPlay& play_;
  std::string invited_;
  glm::dquat roomFromPerson_;  ///< turns x right, y forward, z up
  std::optional<LinkWelcome> invitation_;
  std::vector<ToldMoment> shown_;  ///< the last moment of each of the people who are shown
  bool isHall_ = false, isFirst_ = true;
  double waited_s_ = 0.0;
  std::uint64_t frames_ = 0, strokesIn_ = 0, strokesOut_ = 0, putOff_ = 0;
  double pace_ = 1.0, waiting_ = 0.0, own_s_ = 0.0;
  std::string said_, kept_;
};

}  // namespace carom
