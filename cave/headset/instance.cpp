#include "cave/headset/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace carom::openxr {

Instance::Instance() {
  setenv("XR_LOADER_DEBUG", "none", 0);  // it would write pages where one line says it here
  load();
  const auto offered =
      listOf(infoOf<XrExtensionProperties>(XR_TYPE_EXTENSION_PROPERTIES),
             [](std::uint32_t capacity, std::uint32_t* count, XrExtensionProperties* items) {
               return xrEnumerateInstanceExtensionProperties(nullptr, capacity, count, items);
             });
  const auto offers = [&](const char* name) {
    return std::any_of(offered.begin(), offered.end(), [&](const XrExtensionProperties& extension) {
      return std::strcmp(extension.extensionName, name) == 0;
    });
  };
  if (offered.empty())
    throw std::runtime_error(
        "no OpenXR runtime is active, expected one such as Monado or SteamVR (XR_RUNTIME_JSON names another "
        "than the installed one)");
  if (!offers(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME))
    throw std::runtime_error("the headset's runtime lacks XR_KHR_opengl_enable, which drawing needs");
  std::vector<const char*> wanted{XR_KHR_OPENGL_ENABLE_EXTENSION_NAME};
  knowsHands_ = offers(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  if (knowsHands_) wanted.push_back(XR_EXT_HAND_TRACKING_EXTENSION_NAME);
  auto create = infoOf<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
  std::strcpy(create.applicationInfo.applicationName, "Carom");
  create.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  create.enabledExtensionCount = static_cast<std::uint32_t>(wanted.size());
  create.enabledExtensionNames = wanted.data();
  check(XR_NULL_HANDLE, xrCreateInstance(&create, &handle_), "the headset's runtime does not start");
}

XrSystemId Instance::system() const {
  auto get = infoOf<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
  get.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  XrSystemId system = XR_NULL_SYSTEM_ID;
  check(handle_, xrGetSystem(handle_, &get, &system),
        "no headset is connected, expected one that is switched on");
  return system;
}

std::string Instance::runtime() const {
  auto about = infoOf<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
  if (XR_FAILED(xrGetInstanceProperties(handle_, &about))) return "an unknown runtime";
  return fmt::format("{} {}.{}.{}", about.runtimeName, XR_VERSION_MAJOR(about.runtimeVersion),
                     XR_VERSION_MINOR(about.runtimeVersion), XR_VERSION_PATCH(about.runtimeVersion));
}

std::string Instance::nameOf(XrSystemId system) const {
  auto about = infoOf<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
  check(handle_, xrGetSystemProperties(handle_, system, &about), "the headset says nothing of itself");
  return about.systemName;
}

bool Instance::followsHands(XrSystemId system) const {
  if (!knowsHands_) return false;
  auto hands = infoOf<XrSystemHandTrackingPropertiesEXT>(XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT);
  auto about = infoOf<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
  about.next = &hands;
  return XR_SUCCEEDED(xrGetSystemProperties(handle_, system, &about)) && hands.supportsHandTracking;
}

glm::ivec2 Instance::recommendedPixels(XrSystemId system) const {
  const auto views =
      listOf(infoOf<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW),
             [&](std::uint32_t capacity, std::uint32_t* count, XrViewConfigurationView* items) {
               return xrEnumerateViewConfigurationViews(handle_, system, kStereo, capacity, count, items);
             });
  constexpr std::uint32_t kMost = 8192;
  if (views.size() != 2 || views[0].recommendedImageRectWidth - 1 >= kMost ||
      views[0].recommendedImageRectHeight - 1 >= kMost)
    throw std::runtime_error("the headset has no two displays, expected one for each eye");
  return {static_cast<int>(views[0].recommendedImageRectWidth),
          static_cast<int>(views[0].recommendedImageRectHeight)};
}

}  // namespace carom::openxr
