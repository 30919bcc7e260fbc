#include "cave/cluster/frame_lock.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace carom {
namespace {

constexpr unsigned kGroup = 1, kBarrier = 1;
constexpr double kBetweenLooks_s = 1.0;
constexpr int kGlxScreen = 0x800C;  // GLX_SCREEN, of glXQueryContext

template <typename Function>
Function lookUp(const char* name) {
  return reinterpret_cast<Function>(glfwGetProcAddress(name));
}

}  // namespace

std::optional<SwapGroupCalls> swapGroupOfDriver() {
  if (!glfwExtensionSupported("GLX_NV_swap_group")) return std::nullopt;
  const auto currentDisplay = lookUp<void* (*)()>("glXGetCurrentDisplay");
  const auto currentContext = lookUp<void* (*)()>("glXGetCurrentContext");
  const auto queryContext = lookUp<int (*)(void*, void*, int, int*)>("glXQueryContext");
  SwapGroupCalls calls;
  calls.maxima = lookUp<decltype(calls.maxima)>("glXQueryMaxSwapGroupsNV");
  calls.join = lookUp<decltype(calls.join)>("glXJoinSwapGroupNV");
  calls.bind = lookUp<decltype(calls.bind)>("glXBindSwapBarrierNV");
  calls.query = lookUp<decltype(calls.query)>("glXQuerySwapGroupNV");
  calls.frameCount = lookUp<decltype(calls.frameCount)>("glXQueryFrameCountNV");
  const bool all = currentDisplay && currentContext && queryContext && calls.maxima && calls.join &&
                   calls.bind && calls.query && calls.frameCount;
  if (!all) return std::nullopt;
  calls.display = currentDisplay();
  queryContext(calls.display, currentContext(), kGlxScreen, &calls.screen);
  return calls;
}

std::string whyNoSwapGroup(const std::optional<SwapGroupCalls>& driver) {
  if (!driver) return "the driver lacks GLX_NV_swap_group";
  unsigned groups = 0, barriers = 0;
  if (!driver->maxima(driver->display, driver->screen, &groups, &barriers) || groups < kGroup)
    return "the graphics card has no swap group";
  return barriers < kBarrier ? "the graphics card has no swap barrier: is a sync card built in?" : "";
}

SwapGroupCalls::Drawable currentDrawable() {
  const auto current = lookUp<SwapGroupCalls::Drawable (*)()>("glXGetCurrentDrawable");
  return current ? current() : 0;
}

NodeLock::NodeLock(const std::optional<SwapGroupCalls>& driver, std::vector<SwapGroupCalls::Drawable> windows)
    : windows_(std::move(windows)) {
  whyNot_ = windows_.empty() ? "there is no window" : whyNoSwapGroup(driver);
  if (!whyNot_.empty()) return;
  calls_ = *driver;
  if (!join()) {
    whyNot_ = "the driver does not let the windows join a swap group and its barrier";
    return;
  }
  state_ = LockState::pending;
  counted_ = count();
}

bool NodeLock::join() {
  for (const SwapGroupCalls::Drawable window : windows_) {
    if (!calls_.join(calls_.display, window, kGroup)) return false;
  }
  return calls_.bind(calls_.display, kGroup, kBarrier) != 0;
}

bool NodeLock::isMember() const {
  for (const SwapGroupCalls::Drawable window : windows_) {
    unsigned group = 0, barrier = 0;
    if (!calls_.query(calls_.display, window, &group, &barrier)) return false;
    if (group != kGroup || barrier != kBarrier) return false;
  }
  return true;
}

std::optional<unsigned> NodeLock::count() const {
  unsigned count = 0;
  if (!calls_.frameCount(calls_.display, calls_.screen, &count)) return std::nullopt;
  return count;
}

void NodeLock::swapped(double now_s) {
  if (state_ == LockState::software) return;
  if (!looked_s_) looked_s_ = now_s;
  if (now_s - *looked_s_ < kBetweenLooks_s) return;
  looked_s_ = now_s;
  const std::optional<unsigned> before = std::exchange(counted_, count());
  const bool counts = before && counted_ && *before != *counted_;
  if (!isMember()) {
    state_ = LockState::lost;
    if (join()) counted_ = count();
  } else if (counts) {
    state_ = LockState::joined;
  } else {
    state_ = LockState::lost;
  }
}

}  // namespace carom
