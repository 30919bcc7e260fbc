#pragma once
// The catalogue's texts of linked rooms (cave/texts/texts.h).

#include <array>

#include "cave/texts/texts.h"

namespace carom::texts::link {

inline constexpr Text kTab = "Link";
inline constexpr std::array<Text, 3> kStates{"alone", "joining", "playing"};
inline constexpr Text kHeading = "{} and {}: {}", kNobody = "nobody";
inline constexpr Text kRoundTrip = "Round trip: {:.0f} ms, 99 % within {:.0f} ms";
inline constexpr Text kSlack = "Slack: {:.2f} s, {:.2f} m of light";
inline constexpr Text kPace = "Pace: {:.2f}    waited in the last minute: {:.1f} %";
inline constexpr Text kStrokes = "Strokes: {} in, {} out, {} of them put off";
inline constexpr Text kSame = "The same game up to {} s";
inline constexpr Text kClocks = "Clocks: {:.1f} s here, {:.1f} s there, as far as is known";
inline constexpr Text kTraffic = "Line: {:.1f} kB/s out, {:.1f} kB/s in";
inline constexpr Text kLeave = "Leave the game", kJoinAgain = "Play together again";
inline constexpr Text kApart = "Moved apart for the line: {:.2f} m";
inline constexpr Text kTip =
    "Slack is how much later news may come before this room has to wait. Light on this table is slower than "
    "the "
    "network.";

}  // namespace carom::texts::link
