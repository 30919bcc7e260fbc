#pragma once
// The frame loop: from the tracker to the photons.

#include <vector>

#include "app/session/director.h"
#include "app/session/frame_listener.h"
#include "app/session/frame_statistics.h"
#include "app/session/view.h"
#include "cave/cluster/cluster.h"
#include "cave/frame/pacer.h"
#include "cave/gl/graphics.h"

namespace carom {

/// What a rank's frames go through. Ranks other than 0 have a pacer that never waits and a director that decides
/// nothing.
struct FrameContext {
  Cluster& cluster;
  Graphics& graphics;
  World& world;  ///< empty where there is no game
  FramePacer& pacer;
  Director& director;
  FrameStatistics& statistics;
  std::vector<View*> views;               ///< in the order in which they are drawn and swapped
  std::vector<FrameListener*> listeners;  ///< in the order in which they are told
};

/// Frame after frame until the last, or until somebody wants to end: returns whether somebody does.
bool runFrames(FrameContext& context);

}  // namespace carom
