#pragma once
// The report of a study: R runs the script config/studies/analyse.R.

#include <filesystem>

namespace carom {

/// Writes report.html and results.csv into the folder of an export. Returns the exit status of R. Throws
/// std::runtime_error that says what to install if R or its package lme4 is missing, or that the folder is
/// none.
int writeStudyReport(const std::filesystem::path& folder);

}  // namespace carom
