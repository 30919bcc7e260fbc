#pragma once
// Marks by which a person measures: a ruler with light's way along it, the angles at which pucks part, and
// pulses of light on their way. At rest on the board, where the eye sees them.

#include <span>

#include "cave/render/mark_context.h"
#include "cave/scene/scene.h"
#include "engine/light/light_path.h"

namespace carom {

/// A metre in decimetres, with its length on a plate; beside it a mark for each tenth of a second of light's
/// way, longer every half second; and light that runs to and fro along it, one way in (1 m)/c, since board
/// time 0. The light is seen as a pulse is.
void addRuler(const MarkContext& sight, const Ruler& ruler, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr double kRuler_m = 1.0;
/// Above this, light along the ruler would only flicker and is left out.
inline constexpr double kFastestOnRuler_m_s = 12.0;

/// Where the eye has seen two pucks part, an arc between their ways, and its degrees; where one of them
/// rested before, thin arcs from the other's way before. On the cloth, in the board's frame. Of the last such
/// event always, of others for kAngleShown_s.
void addAngles(const MarkContext& sight, LabelLayout& crowd, MarkBuffer& batch);
inline constexpr double kAngleShown_s = 8.0;

/// A glow where the eye sees each pulse, with a tail: where it was seen during kPulseTail_s before.
void addPulses(const MarkContext& sight, std::span<const LightPath> pulses, MarkBuffer& batch);
inline constexpr double kPulseTail_s = 0.15;

}  // namespace carom
