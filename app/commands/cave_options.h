#pragma once
// The options of `carom cave`.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/file_keys/session_languages.h"
#include "app/scenario/playlist.h"
#include "app/stage/desk_windows.h"
#include "app/stage/recording.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"
#include "engine/light/switches.h"

namespace CLI {
class App;
}

namespace carom {

struct CaveOptions {
  std::filesystem::path rig;
  /// The first game; with `resume` that of later visitors, or empty: the one at hand.
  std::filesystem::path scenario;
  bool isUsualGame = false;                 ///< no scenario was asked for
  std::filesystem::path playlist;           ///< empty: the rig's, if it has one
  std::shared_ptr<const Playlist> games{};  ///< the playlist that was read
  bool byMouse = false;                     ///< mouse and keys move heads and wands, in place of trackers
  /// Number of frames to play in simulated time; if empty, real time without limit.
  std::optional<std::uint64_t> frames;
  RecordingOptions recording;                    ///< images and movie
  std::optional<std::filesystem::path> session;  ///< the session file to write
  bool resume = false;       ///< continue from the end of `session`, with its rig and scenario
  bool resumeOrNew = false;  ///< continue the newest game of `session` if there is one
  std::optional<std::filesystem::path> status;  ///< rank 0 says here once a second how the session goes
  std::vector<int> withoutNodes;                ///< of the rig, whose computers are missing
  bool noWindow = false;
  bool silent = false;       ///< no sounds
  std::string pin;           ///< opens the lock of the keys (app/input/key_lock.h); empty: there is none
  bool hasClass = false;     ///< a class answers by phone
  bool takes = false;        ///< after a game the wall offers its page
  bool follows = false;      ///< phones may follow the game live
  std::string classAddress;  ///< on which its server listens; empty: as the rig says
  std::optional<std::uint16_t> classPort;  ///< 0: any that is free; none: as the rig says
  std::string link;                   ///< with which room, as app/link/link_address.h; empty: as the rig says
  std::filesystem::path study;        ///< a study whose participants come one after the other; empty: none
  std::filesystem::path slips;        ///< the codes of its participants
  bool isAmended = false;             ///< the study was changed after its first participant
  std::optional<LessonPhase> lesson;  ///< the phase in which a lesson begins; empty: the usual one
  bool hideRight = false;             ///< lessons do not tell the right answer
  double textSize = 1.0;              ///< of the walls' words, a factor
  std::string language;               ///< of the words; empty: as the rig says
  std::shared_ptr<const SessionLanguages> languages{};  ///< of the session, settled when it begins
  Switches switches;                                    ///< at the start
  TimeViews views;                                      ///< at the start
  ExtraWindows extra;                                   ///< what rank 0 also shows
  std::optional<double> unattended_s;  ///< the next visitor is welcomed after so long without a sign of life
};

/// Adds the options to the command. They are complete once it has been parsed and `chooseRest` was called.
std::shared_ptr<CaveOptions> addCaveOptions(CLI::App& command);

/// Chooses the rig and the game where none is named: those for somebody who watches, or for pictures and
/// numbers.
void chooseRest(CaveOptions& options);

/// Returns the options that these arguments of `carom cave` name. Throws CLI::ParseError.
CaveOptions caveOptionsOf(std::vector<std::string> arguments);

}  // namespace carom
