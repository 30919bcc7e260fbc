#pragma once
// How long the data of a study may be kept.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "app/study/study.h"

namespace carom {

/// Returns a warning if the last day of keeping the data of a study is over, and nothing before.
std::string overdueWords(const Study& study, std::chrono::year_month_day today);

/// Returns such warnings for the session files of a folder, each with the name of its file. Passes over files
/// that cannot be read or have no study.
std::vector<std::string> overdueSessions(const std::filesystem::path& folder,
                                         std::chrono::year_month_day today);

/// Returns the day, UTC.
std::chrono::year_month_day todayUtc();

}  // namespace carom
