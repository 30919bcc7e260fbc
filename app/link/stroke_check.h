#pragma once
// Strokes of another room, against the game that they are for.

#include <span>
#include <string>

#include "engine/linked/told.h"

namespace carom {

/// Returns why no hand can make this stroke, in words for people; empty if one can: on no puck, harder than
/// kStrongestU, or beside the puck.
std::string strokeFault(const Stroke& stroke, std::span<const Puck> pucks, double lightSpeed_m_s);

}  // namespace carom
