#include "app/console/diagram_window.h"

#include <imgui.h>

#include "cave/texts/texts.h"

namespace carom {
namespace {

const WindowPlacement kPlace{.size_px = {1000, 820}, .border = true};

}  // namespace

DiagramWindow::DiagramWindow(Graphics& graphics, const Scenario& scenario)
    : window_(graphics, texts::title::kDiagram, kPlace), diagram_(scenario) {}

void DiagramWindow::draw(const FrameRecord& record, const World& world) {
  diagram_.follow(record);
  window_.show({}, [&] {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    diagram_.draw(record, world, *ImGui::GetBackgroundDrawList(), {0.0F, 0.0F}, {size.x, size.y});
  });
}

}  // namespace carom
