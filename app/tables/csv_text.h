#pragma once
// Fields of the CSV files that the commands write.

#include <initializer_list>
#include <string>

namespace carom {

/// Returns the text as a CSV field (RFC 4180), quoted if necessary.
std::string csvField(const std::string& text);

/// Returns the numbers with 17 digits, each followed by a comma.
std::string csvNumbers(std::initializer_list<double> values);

}  // namespace carom
