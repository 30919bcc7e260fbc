#pragma once
// One room's side of a linked game, frame by frame: who the other room is, joining, its news by the rule, and
// the end. It has no clock but the one that it is given, and it never waits. Two rooms play: one hosts (it
// listens), the other joins (it calls). engine/linked/promise.h has the rule.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/link/line.h"
#include "engine/linked/final_digest.h"
#include "engine/linked/other_room.h"
#include "engine/linked/own_room.h"
#include "engine/linked/seats.h"

namespace carom {

/// Who this room is.
struct LinkSelf {
  bool hosts = true;
  std::string room;                  ///< its name
  std::vector<std::string> viewers;  ///< their names
  Floor floor;
  double reach_m = 0.8;
  double gone_s = 6.0;
  std::optional<double>
      apart_m;          ///< between the rooms, beyond the scenario's places; empty: as the line needs
  std::string program;  ///< its version
};

/// The game that this room plays, for a room that joins.
struct LinkedGame {
  std::string scenario;  ///< text of its file
  std::vector<LinkWelcome::Mesh> meshes;
  BilliardSetup billiard;
  ObserverStart start;              ///< of the scenario
  std::vector<LinkStroke> strokes;  ///< so far
  std::string whyNot;               ///< why no room may join this game; empty: one may
};

enum class LinkState : std::uint8_t {
  alone,    ///< no other room is there, or it was refused
  joining,  ///< a room is there, and does not live in this game yet, or this one does not
  playing,  ///< both live in one game
};

/// Returns the word for a state in files.
constexpr const char* wordFor(LinkState state) {
  return state == LinkState::alone ? "alone" : state == LinkState::joining ? "joining" : "playing";
}

/// Something that has happened, in the words of the session file.
struct LinkNote {
  static constexpr std::string_view kPaired = "paired", kGone = "gone", kBack = "back",
                                    kMismatch = "mismatch", kResynchronised = "resynchronised";

  std::string what, value;  ///< those; or apart, broken, refused
};

/// News for the frame.
struct LinkHeard {
  std::vector<LinkStroke> strokes;  ///< to be played
  std::vector<LinkNote> notes;
  std::vector<LinkPresent> presents;       ///< taken from the other room
  std::optional<LinkSettings> settings{};  ///< another room has changed them

  void clear() {
    strokes.clear();
    notes.clear();
    presents.clear();
    settings.reset();
  }
};

class LinkedPlay {
 public:
  /// `line` must outlive this object.
  LinkedPlay(LinkSelf self, Line& line, std::uint64_t arithmetic);

  /// Begins a game as the host, or alone; a room that is there is invited to it.
  void play(LinkedGame game);
  /// Returns the game to which this room is invited, once.
  std::optional<LinkWelcome> takeInvitation() { return std::exchange(invitation_, {}); }
  /// Begins the game of an invitation.
  void join(const LinkWelcome& welcome, LinkedGame game);

  /// Takes all news. Must be called once a frame, before the frame is lived.
  void hear(LinkClock::time_point now);
  const LinkHeard& heard() const { return heard_; }

  /// Of a joiner before its first frame: the board time at which it begins, a round trip after the host's
  /// present; empty while nothing of the host is known.
  std::optional<double> begins_s(LinkClock::time_point now) const;
  /// Begins the people's lives, in the game's first frame.
  void begin(const Observers& observers, LinkClock::time_point now);
  /// Returns whether the people may live: those of a joiner wait until the host has accepted them.
  bool isLiving() const { return own_.has_value() && (!joins_ || isAccepted_); }

  /// Returns the pace that this room wishes: 1, or faster if it is behind.
  double pace(LinkClock::time_point now) const;
  /// Returns whether an eye may receive light at this event.
  bool allows(const Event& eye) const { return !other_ || other_->allows(eye); }

  /// All strokes of the game so far.
  std::span<const LinkStroke> strokes() const { return game_.strokes; }
  double lightSpeed_m_s() const { return game_.billiard.lightSpeed_m_s; }  ///< of the game
  double lightSpeedShown_m_s() const { return settings_.lightSpeedShown_m_s; }

  /// This room's own side, once it lives.
  OwnRoom* own() { return own_ ? &*own_ : nullptr; }
  /// Takes a stroke that was played here, and tells it. Returns it with its number.
  LinkStroke struck(std::uint32_t viewer, const Stroke& stroke);

  /// People as they are drawn for others, beside their events.
  using Persons = std::array<LinkPerson, kMostViewers>;
  /// Tells of the frame. `eyes`: all events at which eyes here have received its light. `waits`: the people
  /// did not live on.
  void tell(const Observers& observers, std::span<const Vec3> handsFromHeads_m, const Persons& persons,
            std::span<const Event> eyes, bool waits, LinkClock::time_point now);
  /// Compares the game with that of the other room, as far as nothing can change it any more. `pucks`: of the
  /// game, known at least until the eyes' events.
  void compare(std::span<const WorldLine> pucks);
  /// Tells the settings here. If two rooms change them, the newest hold, then the host's.
  void tellSettings(double lightSpeedShown_m_s, bool isFrozen);

  LinkState state() const { return state_; }
  std::uint32_t room() const { return room_; }             ///< this one's number; the host is 0
  std::uint32_t otherNumber() const { return 1 - room_; }  ///< of the other
  const OtherRoom* other() const { return other_ ? &*other_ : nullptr; }
  const std::string& otherName() const { return otherName_; }
  const std::vector<std::string>& otherViewers() const { return otherViewers_; }
  RoundTrip roundTrip() const { return connection_ ? line_->roundTrip(connection_) : lastRoundTrip_; }
  std::uint32_t sameUntil_s() const { return sameUntil_s_; }  ///< the games are the same up to here
  /// Nothing before this board time can change any more.
  double final_s() const;
  double slack_s() const;  ///< until this room would have to wait for the other
  double away_s() const;  ///< how long light takes between the nearest heads of both rooms, as they are known
  double apart_m() const { return apart_m_; }
  const LinkSelf& self() const { return self_; }

  /// Leaves the game and says so.
  void leave(const std::string& reason);
  /// Plays alone from now on, or lets another room play again.
  void stayOut(bool on) { staysOut_ = on; }
  bool staysOut() const { return staysOut_; }
  LineTraffic traffic() const { return line_->traffic(); }

 private:
  void hear(const LineNews& news);
  void hear(const LinkHello& hello, const LineNews& news);
  void hear(const LinkWelcome& welcome);
  void hear(const LinkReady& ready);
  void hear(const LinkPresent& message, LinkClock::time_point at);
  void hear(const LinkStroke& stroke);
  void hear(const LinkDigest& digest);
  void hear(const LinkTurns& turns);
  void hear(const LinkSettings& settings);
  void sayHello(std::uint64_t connection);
  std::string refusalOf(const LinkHello& hello) const;
  void adopt(std::uint64_t connection, const LinkHello& hello);
  void goOn(std::uint64_t connection, std::uint32_t heard);
  void invite(LinkClock::time_point now);
  void meets(const LinkPresent& first, LinkClock::time_point at);
  void paired();
  void lookWhetherGone(LinkClock::time_point now);
  void part(const char* what, const std::string& why);
  bool strikesTooOften(const StrokeTold& told) const;
  void judge(std::uint32_t second);
  void tellTurns(std::uint32_t second);
  void findDifference();
  void buildAnew(std::uint32_t second);
  std::uint64_t digestOfStrokes(std::uint32_t second) const;
  std::vector<Event> othersHeads() const;
  double nearest_m() const;
  std::uint32_t strokesOf(std::uint32_t room) const;

  static constexpr int kSettle = 60;

  LinkSelf self_;
  Line* line_;
  std::uint64_t arithmetic_;
  std::vector<LineNews> news_;
  LinkHeard heard_;

  // The game.
  LinkedGame game_;
  std::uint64_t number_ = 0;  ///< of the linked game; 0: none
  std::uint32_t room_ = 0;
  bool joins_ = false, isAccepted_ = false;
  double apart_m_ = 0.0;
  std::optional<OwnRoom> own_;
  std::vector<Event> eyes_;
  LinkPresent told_;
  std::vector<FinalDigest> digest_;  ///< one, with a game
  std::vector<std::uint64_t> digests_;
  std::map<std::uint32_t, std::uint64_t> others_;  ///< digests that wait for one's own
  std::uint32_t sameUntil_s_ = 0;
  std::map<std::uint32_t, std::vector<FinalTurn>> turns_;  ///< of the last minute's seconds
  std::optional<std::uint32_t> differs_;                   ///< the second before which the games differ
  std::optional<LinkTurns> turnsThere_;                    ///< as the other room has told them
  std::uint32_t turnsTold_ = 0;                            ///< the second whose turns were told
  bool isBuiltAnew_ = false;                               ///< in this game once

  // The other room.
  LinkState state_ = LinkState::alone;
  std::uint64_t connection_ = 0;
  std::string otherName_;
  std::vector<std::string> otherViewers_;
  Floor otherFloor_;
  std::optional<LinkWelcome> invitation_;
  std::uint64_t invitedTo_ = 0;       ///< the game of the newest invitation on this line
  bool isWaiting_ = false;            ///< it is invited, and has not joined yet; meanwhile have come:
  std::optional<LinkPresent> first_;  ///< the host's first present,
  std::vector<LinkStroke> early_;     ///< and strokes
  std::optional<OtherRoom> other_;
  LinkClock::time_point presentAt_{}, movedAt_{}, differsAt_{}, now_{};
  double newest_s_ = 0.0;  ///< board time of its newest present
  bool isInvited_ = false;
  bool staysOut_ = false;         ///< by the operator's wish
  std::set<std::string> banned_;  ///< rooms that broke a promise, or stood still too often, in this game
  int stood_ = 0;                 ///< how often another room stood still for too long
  RoundTrip lastRoundTrip_;
  LinkSettings settings_;
  int settling_ = 0;  ///< frames for which settings from afar may take to be shown here
};

}  // namespace carom
