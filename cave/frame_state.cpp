#include "cave/frame_state.h"

#include <cmath>
#include <stdexcept>

namespace carom {

void applyFrame(const FrameState& state, std::span<WorldLine> histories) {
  if (std::isfinite(state.record.truncateFrom_s)) {
    for (WorldLine& history : histories.subspan(1, state.record.pucks)) {
      history.truncateFrom(state.record.truncateFrom_s);
    }
  }
  for (const BodyKnot& knot : state.knots) {
    if (knot.body >= histories.size())
      throw std::out_of_range("frame record: a knot of a body that is not there");
    histories[knot.body].append(knot.knot);
  }
}

}  // namespace carom
