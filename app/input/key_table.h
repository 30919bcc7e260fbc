#pragma once
// What the keys do, as a table of Dear ImGui's.

#include <span>

#include <imgui.h>

#include "app/input/keys.h"

namespace carom {

/// The colour of keys and headings.
inline const ImVec4 kAccent{0.33F, 0.62F, 0.82F, 1.0F};

/// Draws what the keys do, in two columns.
void drawKeyTable(std::span<const KeyLine> map);

/// Draws the same in the upper left corner of a wall's window, within a Gui's begin and end.
void drawKeysOver(std::span<const KeyLine> map);

}  // namespace carom
