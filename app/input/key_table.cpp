#include "app/input/key_table.h"

#include "cave/gl/gui.h"

namespace carom {

void drawKeyTable(std::span<const KeyLine> map) {
  const std::size_t half = (map.size() + 1) / 2;
  if (!ImGui::BeginTable("##map", 4, ImGuiTableFlags_SizingFixedFit)) return;
  for (std::size_t row = 0; row < half; ++row) {
    ImGui::TableNextRow();
    for (const std::size_t line : {row, row + half}) {
      if (line >= map.size()) break;
      ImGui::TableNextColumn();
      ImGui::TextColored(kAccent, "%s", map[line].keys.c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted((map[line].does + "      ").c_str());
    }
  }
  ImGui::EndTable();
}

bool isKeySheetPressed(std::span<const KeyLine> map) {
  return isSheetPressed("##keys", [map] { drawKeyTable(map); });
}

}  // namespace carom
