#pragma once
// The spacetime diagram of the session at hand, drawn by Dear ImGui into a rectangle of a window.

#include <glm/vec2.hpp>

#include "app/report/spacetime_chart.h"
#include "cave/frame/frame_state.h"

struct ImDrawList;

namespace carom {

class LiveDiagram {
 public:
  explicit LiveDiagram(const Scenario& scenario) : subject_(subjectOf(scenario)) {}

  /// Another game.
  void play(const Scenario& scenario);

  /// Remembers my way: with every frame, or many times a second.
  void follow(const FrameRecord& record);

  /// Draws the chart, made anew some ten times a second; nothing while I have no way behind me.
  void draw(const FrameRecord& record, const World& world, ImDrawList& list, const glm::vec2& origin_px,
            const glm::vec2& size_px);

 private:
  void make(const FrameRecord& record, const World& world);

  DiagramSubject subject_;
  Chart chart_;
  double made_s_ = -1.0;  ///< session clock
};

}  // namespace carom
