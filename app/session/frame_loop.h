#pragma once
// The frame loop: from the tracker samples to the displayed image.

#include <vector>

#include "app/input/end_question.h"
#include "app/input/key_lock.h"
#include "app/session/director.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_statistics.h"
#include "app/session/view.h"
#include "cave/cluster/cluster.h"
#include "cave/frame/pacer.h"
#include "cave/gl/graphics.h"

namespace carom {

/// Everything that the frame loop uses on one rank. On ranks other than 0 the pacer never waits and the
/// director decides nothing.
struct FrameContext {
  Cluster& cluster;
  Graphics& graphics;
  World& world;  ///< empty if there is no game
  FramePacer& pacer;
  Director& director;
  FrameStatistics& statistics;
  std::vector<View*> views;               ///< in the order of drawing and swapping
  std::vector<FrameListener*> listeners;  ///< in the order of their calls
  KeyLock* keyLock;                       ///< not null; without a PIN all keys work
  EndQuestion* ending;                    ///< not null
};

/// Runs frames until the last one or until someone asks to quit. Returns true if someone asked to quit.
bool runFrames(FrameContext& context);

}  // namespace carom
