#pragma once
// Tracker samples of a lesson as files of BIDS (motion and its events), without a time of day.

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>

#include "app/journal/session_games.h"
#include "app/study/study_tables.h"

namespace carom {

/// Writes, for each tracker and sensor of a participant's lesson, its samples as they were recorded, into the
/// folder sub-CODE/motion below `folder`. Times begin with the lesson's first frame. `end`: the number of the
/// first frame after the lesson.
void exportMotion(SQLite::Database& session, const ParticipationRow& lesson, const SessionGame& game,
                  std::int64_t end, const std::filesystem::path& folder);

}  // namespace carom
