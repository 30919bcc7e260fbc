#pragma once
// Which languages a session in a room has, and in which of them each viewer begins.

#include <string>

#include "app/file_keys/session_languages.h"
#include "app/rig/rig.h"
#include "app/scenario/playlist.h"

namespace carom {

/// Returns the languages of a session in this room. Each viewer begins with the first of these that is
/// given: `option`, that of the command line; the viewer's own; the rig's; the first of `languages` of the
/// playlist or of the rig; English.
SessionLanguages languagesOf(const Rig& rig, const Playlist* playlist, const std::string& option);

}  // namespace carom
