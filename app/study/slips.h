#pragma once
// The slips of a study, which give each participant a code.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace carom {

/// Reads number,code: the number of each code. Throws InputErrors with the line of a code that is none, that
/// stands twice, or whose number the study does not have.
std::map<std::string, std::size_t> readSlips(const std::filesystem::path& file, std::size_t participants);

}  // namespace carom
