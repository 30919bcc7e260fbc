#pragma once
// The link of a session of `carom cave` with another room.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/cave_options.h"
#include "app/journal_rows/journal_news.h"
#include "app/link/link_address.h"
#include "app/link/link_line.h"
#include "app/link/linked_play.h"
#include "app/live/linked_room.h"
#include "app/live/live_source.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/stage/handover.h"
#include "app/stage/session_setup.h"

namespace carom {

/// Returns why no other room may play a game; empty if one may.
std::string whyNotLinked(const Scenario& scenario);

/// Returns the floor on which the people of a rig walk: the box of its walls, or ± 1 m where there is one
/// wall.
Floor floorOf(const Rig& rig);

/// Returns the rig's key for a link. Throws std::runtime_error if the rig has no [link] or the key is
/// refused.
LinkKey linkKeyOf(const Rig& rig, const std::filesystem::path& file);

class CaveLink {
 public:
  /// Begins to listen or to call. Throws std::runtime_error if the rig has no [link], its key is refused, or
  /// the port is taken.
  CaveLink(const Rig& rig, const std::filesystem::path& rigFile, const LinkAddress& address);
  ~CaveLink() { play_.leave("the session has ended"); }
  CaveLink(const CaveLink&) = delete;
  CaveLink& operator=(const CaveLink&) = delete;

  bool joins() const { return !address_.listens; }
  LinkedRoom& room() { return room_; }

  /// Waits for an invitation, in a game in which time stands.
  void wait();
  /// Begins a game for this room and who joins it. Puts the room in its seat. `before`: the strokes of a game
  /// that goes on.
  void play(const InputFile& file, Scenario& scenario, const std::vector<HandStroke>* before = nullptr);
  /// Begins the game of the invitation, which `scenario` is. Returns why it cannot be played here; empty if
  /// it can.
  std::string join(Scenario& scenario);
  /// Begins a game with the other room, whose invitation `game` is, or one for it; waits on if the invitation
  /// cannot be followed.
  void begin(bool isInvited, const InputFile& game, Scenario& scenario);
  /// Returns whether this room may choose its next game; says so if another room does.
  bool mayChoose(LiveSource& source);
  /// Refuses the invitation.
  void refuse(const std::string& why) { play_.leave(why); }

  /// Returns the file as which the game of an invitation is played.
  static std::string invitedFile();

 private:
  LinkAddress address_;
  LinkLine line_;
  LinkedPlay play_;
  LinkedRoom room_;
};

/// Settles with which room this one is linked, as the rig says or the options. A room that calls another
/// plays that one's games. `wasLinked`: the session that goes on, if one does, has linked games.
void settleLink(CaveOptions& options, SetupOptions& inputs, bool wasLinked);

/// Opens the link, if another room plays, and begins its game or goes on with it, or waits for that of the
/// other.
std::unique_ptr<CaveLink> openLink(SessionSetup& setup, const CaveOptions& options,
                                   const SetupOptions& inputs);

}  // namespace carom
