#pragma once
// Fields of the CSV files that the commands write.

#include <initializer_list>
#include <string>

namespace carom {

/// Text as a field (RFC 4180): quoted where it must be.
std::string csvField(const std::string& text);

/// Numbers in 17 digits, a comma behind each.
std::string csvNumbers(std::initializer_list<double> values);

}  // namespace carom
