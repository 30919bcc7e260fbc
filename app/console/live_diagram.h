#pragma once
// The spacetime diagram of the running session, drawn by Dear ImGui into a rectangle of a window.

#include <glm/vec2.hpp>

#include "app/report/spacetime_chart.h"
#include "cave/frame/frame_state.h"

struct ImDrawList;

namespace carom {

class LiveDiagram {
 public:
  explicit LiveDiagram(const Scenario& scenario) : subject_(subjectOf(scenario)) {}

  /// Switches to another game.
  void play(const Scenario& scenario);

  /// Records the viewer's world line; call with every frame, or many times per second.
  void follow(const FrameRecord& record);

  /// Draws the chart, which is updated about ten times per second. Draws nothing until the viewer's world
  /// line has some duration.
  void draw(const FrameRecord& record, const World& world, ImDrawList& list, const glm::vec2& origin_px,
            const glm::vec2& size_px);

 private:
  void make(const FrameRecord& record, const World& world);

  DiagramSubject subject_;
  Chart chart_;
  double made_s_ = -1.0;  ///< session clock
};

}  // namespace carom
