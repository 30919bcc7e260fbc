#include "cave/frame_state.h"

#include <cmath>
#include <stdexcept>

#include "engine/vertex_history.h"

namespace carom {

void applyFrame(const FrameState& state, std::span<WorldLine> histories) {
  if (state.record.pucks >= histories.size()) {
    throw std::out_of_range("frame record: more pucks than there are histories");
  }
  if (std::isfinite(state.record.truncateFrom_s)) {
    for (WorldLine& history : histories.subspan(1, state.record.pucks)) {
      history.truncateFrom(state.record.truncateFrom_s);
    }
  }
  for (const BodyKnot& knot : state.knots) {
    if (knot.body >= histories.size())
      throw std::out_of_range("frame record: a knot of a body that is not there");
    WorldLine& history = histories[knot.body];
    history.append(knot.knot);
    if (!history.settlesBeforeNext(history.knots().size() - 2) && knot.knot.deceleration_m_s2 == 0.0) {
      history.settlesAfter(joinedAfter_s(history));
    }
  }
  if (std::isfinite(state.record.forgetBefore_s)) {
    for (WorldLine& history : histories.subspan(1, state.record.pucks)) {
      history.forgetBefore(state.record.forgetBefore_s);
    }
  }
}

}  // namespace carom
