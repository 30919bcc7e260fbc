#pragma once
// The spacetime diagram of the running session, drawn by Dear ImGui into a rectangle of a window.

#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/report/spacetime_chart.h"
#include "cave/record/frame_state.h"

struct ImDrawList;

namespace carom {

class LiveDiagram {
 public:
  /// `viewers`: the names of the records' viewers.
  LiveDiagram(const Scenario& scenario, std::vector<std::string> viewers)
      : viewers_(std::move(viewers)), subject_(subjectOf(scenario)) {}

  /// Switches to another game.
  void play(const Scenario& scenario);

  /// Records the viewers' world lines; call with every frame, or many times per second.
  void follow(const FrameRecord& record);

  /// Draws the chart, which is updated about ten times per second. Draws nothing until the viewer's world
  /// line has some duration.
  void draw(const FrameRecord& record, const World& world, ImDrawList& list, const glm::vec2& origin_px,
            const glm::vec2& size_px);

 private:
  void make(const FrameRecord& record, const World& world);

  std::vector<std::string> viewers_;
  DiagramSubject subject_;
  Chart chart_;
  double made_s_ = -1.0;  ///< session clock
};

}  // namespace carom
