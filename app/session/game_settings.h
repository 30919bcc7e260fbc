#pragma once
// The settings with which a game begins: the first, the next one, and that of the next visitor.

#include <memory>
#include <optional>
#include <string>

#include "app/operator/operator_settings.h"
#include "app/rig/rig.h"
#include "app/scenario/playlist.h"
#include "app/scenario/scenario.h"
#include "app/session/programme.h"

namespace carom {

/// The settings with which a session begins, beyond those of its rig and scenario.
struct Beginning {
  Switches switches;
  TimeViews views;
  std::optional<LessonPhase> lesson;         ///< the phase in which a lesson begins; empty: the usual one
  bool asks = true;                          ///< the usual one is the question
  std::shared_ptr<const Playlist> playlist;  ///< null: every game may be played
  std::shared_ptr<const SessionLanguages> languages{};  ///< null: English alone
};

/// Returns the settings that rig and scenario give.
OperatorSettings settingsAtStart(const Rig& rig, const Scenario& scenario);

/// Returns the settings with which the scenario of this file begins a session.
OperatorSettings settingsOf(const Rig& rig, const Scenario& scenario, const std::string& file,
                            const Beginning& beginning);

/// Returns the settings of the next game. A different game starts with the program's initial settings, except
/// those of the room. The same game keeps all settings, unless it is to begin afresh; a lesson in its phase
/// `shows` stays there, and one that was explained starts again with its question. For the next visitor, and
/// for games that attract, everything is as the session began, except the operator's console.
OperatorSettings settingsOfNext(const OperatorSettings& before, const NextGame& next, const Rig& rig,
                                const Scenario& scenario, const Beginning& beginning);

}  // namespace carom
