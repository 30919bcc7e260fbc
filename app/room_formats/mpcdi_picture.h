#pragma once
// The pictures of an MPCDI room.

#include <string>

namespace carom {

/// Returns a PNG of shares of light, from one (its bytes) whose codes are light^(1/gamma). A gamma of 1
/// leaves it as it is. Throws std::runtime_error, in words that can follow a place, if it is no PNG, is
/// broken, or has over 16384 pixels each way or 2^26 in all.
std::string linearPicture(const std::string& png, double gamma);

}  // namespace carom
