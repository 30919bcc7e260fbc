#pragma once
// The list of keys as a Dear ImGui table.

#include <span>

#include <imgui.h>

#include "app/input/keys.h"

namespace carom {

/// The colour of keys and headings.
inline const ImVec4 kAccent{0.33F, 0.62F, 0.82F, 1.0F};

/// Draws the list of keys in two columns.
void drawKeyTable(std::span<const KeyLine> map);

/// Draws the same list as a sheet in the upper left corner of a wall's window, between begin and end of a
/// Gui. Returns whether it was pressed.
bool isKeySheetPressed(std::span<const KeyLine> map);

}  // namespace carom
