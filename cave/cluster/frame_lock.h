#pragma once
// What holds the swaps of all nodes together, and whether it does. Always: every node swaps once all have
// drawn (cave/cluster/cluster.h). With `swap-group` the graphics cards do the last step as well, by the
// extension GLX_NV_swap_group (https://registry.khronos.org/OpenGL/extensions/NV/GLX_NV_swap_group.txt):
// every window joins group 1 of its card, the group is bound to barrier 1, which the cards share by a cable,
// and a counter that all cards share counts the swaps.

#include <optional>
#include <string>
#include <vector>

#include "cave/frame/frame_timing.h"

namespace carom {

/// The entry points of GLX_NV_swap_group, for one screen. Each takes GLX's display first; 0 is failure.
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

/// Those of the driver, with a window's context current; none where the driver lacks the extension.
std::optional<SwapGroupCalls> swapGroupOfDriver();

/// The window whose context is current.
SwapGroupCalls::Drawable currentDrawable();

/// The lock of one node.
class NodeLock {
 public:
  /// By messages alone.
  NodeLock() = default;
  /// Asks for a swap group for these windows. Where there is none, `whyNot` says so and it stays with
  /// messages.
  NodeLock(const std::optional<SwapGroupCalls>& driver, std::vector<SwapGroupCalls::Drawable> windows);

  /// Looks after it; does so once a second, at the first swap after. `now_s`: of any steady clock.
  void swapped(double now_s);

  LockState state() const { return state_; }
  const std::string& whyNot() const { return whyNot_; }  ///< empty where nothing is missing

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
