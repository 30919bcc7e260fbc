#include "app/session/frame_loop.h"

namespace carom {
namespace {

/// Returns what lies over all windows: the question whether to end while it is asked, otherwise nothing.
std::function<void()> overAll(EndQuestion& ending) {
  if (!ending.isAsked()) return {};
  return [&ending] { ending.draw(); };
}

}  // namespace

bool runFrames(FrameContext& context) {
  Decision decision;  // reused, so that a steady frame allocates nothing
  const FrameState& frame = decision.frame;
  bool isAskedToEnd = false;
  while (!isAskedToEnd && !frame.record.last) {
    context.statistics.begin();
    const FrameTimes times = context.pacer.next();  // when the photons leave the walls
    const WindowInput& input = context.keyLock->pass(context.graphics.poll());  // since the previous frame
    const bool wantsToEnd = context.ending->take(input);
    context.graphics.setOverAll(overAll(*context.ending));
    context.director.decide(times, input, decision);  // rank 0: tracker, head, observer, game
    context.statistics.decided(decision.timing);
    context.cluster.share(decision.frame);  // every rank holds the same bytes
    context.statistics.mark(FramePart::share);
    applyFrame(frame, context.world);
    for (View* view : context.views) view->draw(frame.record, context.world);
    context.cluster.gatherDrawn(frame, context.world, wantsToEnd);
    context.pacer.awaitTick(decision.stay_s);
    isAskedToEnd = context.cluster.releaseSwap(context.world);  // all nodes swap now
    context.statistics.mark(FramePart::wait);
    for (View* view : context.views) view->swap();
    context.pacer.swapped();
    for (FrameListener* listener : context.listeners) listener->shown(decision);
  }
  context.graphics.setOverAll({});
  return isAskedToEnd;
}

}  // namespace carom
