#pragma once
// The mechanism that keeps the swaps of all nodes together, and its state. In every case, each node swaps
// once all have drawn (cave/cluster/cluster.h). With `swap-group`, the graphics cards perform the last step
// together as well, by the extension GLX_NV_swap_group
// (https://registry.khronos.org/OpenGL/extensions/NV/GLX_NV_swap_group.txt): every window joins group 1 of
// its card, the group is bound to barrier 1, which the cards share through a cable, and a counter that all
// cards share counts the swaps.

#include <optional>
#include <string>
#include <vector>

#include "cave/frame/frame_timing.h"

namespace carom {

/// The entry points of GLX_NV_swap_group, for one screen. Each takes GLX's display first and returns 0 on
/// failure.
struct SwapGroupCalls {
  using Display = void*;
  using Drawable = unsigned long;

  Display display = nullptr;
  int screen = 0;
  int (*maxima)(Display, int screen, unsigned* groups, unsigned* barriers) = nullptr;
  int (*join)(Display, Drawable, unsigned group) = nullptr;
  int (*bind)(Display, unsigned group, unsigned barrier) = nullptr;
  int (*query)(Display, Drawable, unsigned* group, unsigned* barrier) = nullptr;
  int (*frameCount)(Display, int screen, unsigned* count) = nullptr;
};

/// Returns the driver's entry points, or none if it lacks the extension. A window's context must be current.
std::optional<SwapGroupCalls> swapGroupOfDriver();

/// Returns why windows cannot join a swap group and its barrier by these calls; empty if they can.
std::string whyNoSwapGroup(const std::optional<SwapGroupCalls>& driver);

/// Returns the window whose context is current.
SwapGroupCalls::Drawable currentDrawable();

/// The frame lock of one node.
class NodeLock {
 public:
  /// Creates a lock by messages alone.
  NodeLock() = default;
  /// Asks for a swap group for these windows. If there is none, `whyNot` says why and the lock remains one by
  /// messages.
  NodeLock(const std::optional<SwapGroupCalls>& driver, std::vector<SwapGroupCalls::Drawable> windows);

  /// Checks the lock at the first swap of every second. `now_s`: time of any steady clock.
  void swapped(double now_s);

  LockState state() const { return state_; }
  const std::string& whyNot() const { return whyNot_; }  ///< empty if nothing is missing

 private:
  bool join();
  bool isMember() const;
  std::optional<unsigned> count() const;

  SwapGroupCalls calls_;
  std::vector<SwapGroupCalls::Drawable> windows_;
  LockState state_ = LockState::software;
  std::string whyNot_;
  std::optional<unsigned> counted_;
  std::optional<double> looked_s_;
};

}  // namespace carom
