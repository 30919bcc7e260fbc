#pragma once
// OpenXR as the parts of this folder use it. Not for others: it names X11's and OpenGL's macros.
// Source: The OpenXR Specification 1.0, Khronos Group.

#include <GL/glew.h>
#include <GL/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#define XR_NO_PROTOTYPES
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <string>
#include <vector>

#include "engine/base/pose.h"

namespace carom::openxr {

// The functions of OpenXR that are used. They are those of the loader, a library that is looked for when a
// headset is: the program runs where there is none.
// clang-format off
#define CAROM_XR_CALLS(X)                                                                            \
  X(AcquireSwapchainImage) X(ApplyHapticFeedback) X(AttachSessionActionSets) X(BeginFrame)           \
  X(BeginSession) X(CreateAction) X(CreateActionSet) X(CreateActionSpace) X(CreateInstance)          \
  X(CreateReferenceSpace) X(CreateSession) X(CreateSwapchain) X(DestroyActionSet) X(DestroyInstance) \
  X(DestroySession) X(DestroySwapchain) X(EndFrame) X(EndSession)                                    \
  X(EnumerateInstanceExtensionProperties) X(EnumerateReferenceSpaces) X(EnumerateSwapchainFormats)   \
  X(EnumerateSwapchainImages) X(EnumerateViewConfigurationViews) X(GetActionStateBoolean)            \
  X(GetActionStateFloat) X(GetActionStateVector2f) X(GetInstanceProcAddr) X(GetInstanceProperties)   \
  X(GetSystem) X(GetSystemProperties) X(LocateSpace) X(LocateViews) X(PollEvent)                     \
  X(ReleaseSwapchainImage) X(RequestExitSession) X(ResultToString) X(StringToPath)                   \
  X(SuggestInteractionProfileBindings) X(SyncActions) X(WaitFrame) X(WaitSwapchainImage)
// clang-format on
#define CAROM_XR_CALL(name) extern PFN_xr##name xr##name;
CAROM_XR_CALLS(CAROM_XR_CALL)
#undef CAROM_XR_CALL

/// Finds these functions. Throws std::runtime_error if there is no loader; call it before all others.
void load();

/// Throws std::runtime_error that says what could not be done ("the headset has no ...") and OpenXR's name of
/// the fault, unless the result is a success.
void check(XrInstance instance, XrResult result, const char* whatFailed);

/// Returns a function of an extension, or null.
template <typename Function>
Function entry(XrInstance instance, const char* name) {
  PFN_xrVoidFunction found = nullptr;
  if (XR_FAILED(xrGetInstanceProcAddr(instance, name, &found))) return nullptr;
  return reinterpret_cast<Function>(found);
}

/// Returns all items of a list that OpenXR gives in two calls: the first asks how many there are.
/// `call(capacity, count, items)` returns an XrResult. Empty if it fails.
template <typename Item, typename Call>
std::vector<Item> listOf(const Item& empty, const Call& call) {
  std::uint32_t count = 0;
  if (XR_FAILED(call(0, &count, nullptr))) return {};
  std::vector<Item> items(count, empty);
  if (count > 0 && XR_FAILED(call(count, &count, items.data()))) return {};
  items.resize(count);
  return items;
}

/// Returns a structure that says which it is, and nothing else.
template <typename Info>
Info infoOf(XrStructureType type) {
  Info info{};
  info.type = type;
  return info;
}

XrPath pathOf(XrInstance instance, const char* text);
Pose poseOf(const XrPosef& pose);

}  // namespace carom::openxr
