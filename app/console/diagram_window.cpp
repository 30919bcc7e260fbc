#include "app/console/diagram_window.h"

#include <imgui.h>

#include "cave/texts/texts.h"

namespace carom {
DiagramWindow::DiagramWindow(Graphics& graphics, const WindowPlacement& place, const Scenario& scenario,
                             std::vector<std::string> viewers)
    : window_(graphics, texts::title::kDiagram.words(), place), diagram_(scenario, std::move(viewers)) {}

void DiagramWindow::draw(const FrameRecord& record, const World& world) {
  diagram_.follow(record);
  window_.show({}, [&] {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    diagram_.draw(record, world, *ImGui::GetBackgroundDrawList(), {0.0F, 0.0F}, {size.x, size.y});
  });
}

}  // namespace carom
