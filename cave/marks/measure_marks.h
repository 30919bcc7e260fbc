#pragma once
// Marks for measuring: a ruler with light running along it, the angles at which pucks part, and pulses of
// light. They rest on the board, and are drawn where the eye sees them.

#include <span>

#include "cave/marks/mark_context.h"
#include "cave/scene/scene.h"
#include "engine/light/light_path.h"

namespace carom {

/// Adds a metre divided into decimetres, with its length on a plate. Beside it are marks for the distance
/// that light travels in each tenth of a second, longer ones for each half second, and light that runs to and
/// fro along the ruler, one way in (1 m)/c, since board time 0. This light is seen as a pulse is.
void addRuler(const MarkContext& sight, const Ruler& ruler, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr double kRuler_m = 1.0;
/// At a higher speed of light, light along the ruler would only flicker, and it is left out.
inline constexpr double kFastestOnRuler_m_s = 12.0;

/// Adds, where the eye has seen two pucks part, an arc between their paths with the angle in degrees; if one
/// of them was at rest before, also thin arcs from the other's earlier path. They lie on the cloth, in the
/// board's frame. The last such event is always shown, earlier ones for kAngleShown_s.
void addAngles(const MarkContext& sight, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr double kAngleShown_s = 8.0;

/// Adds a glow where the eye sees each pulse, with a tail over the places where it was seen in the last
/// kPulseTail_s.
void addPulses(const MarkContext& sight, std::span<const LightPath> pulses, MarkBuffer& batch);
inline constexpr double kPulseTail_s = 0.15;

}  // namespace carom
