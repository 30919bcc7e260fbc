#pragma once
// The rows of numbers in which a page has knots and frames, in its file as in what it is told live.

#include <cstdint>
#include <vector>

#include "app/page/visit.h"

namespace carom {

/// Returns a knot as the seventeen numbers that the page's engine takes (app/page/engine/exchange.h).
std::vector<double> numbersOf(const Knot& knot);

/// Returns a frame: its number, its time, the visitor's own time, how black it is, the eyes and the
/// transforms headFromBoard and boardFromRoom.
std::vector<double> numbersOf(const VisitFrame& frame);

/// Returns the bits of the frame's effects, of its views and of the effects beside, and the lesson's phase.
std::vector<std::uint32_t> statesOf(const VisitFrame& frame);

}  // namespace carom
