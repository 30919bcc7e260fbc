#include "cave/headset/openxr.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace carom::openxr {

void check(XrInstance instance, XrResult result, const char* whatFailed) {
  if (XR_SUCCEEDED(result)) return;
  std::array<char, XR_MAX_RESULT_STRING_SIZE> name{};
  if (instance == XR_NULL_HANDLE || XR_FAILED(xrResultToString(instance, result, name.data())))
    name[0] = '\0';
  throw std::runtime_error(name[0]
                               ? fmt::format("{} ({})", whatFailed, name.data())
                               : fmt::format("{} (OpenXR's error {})", whatFailed, static_cast<int>(result)));
}

XrPath pathOf(XrInstance instance, const char* text) {
  XrPath path = XR_NULL_PATH;
  check(instance, xrStringToPath(instance, text, &path), "the headset's runtime refuses a name");
  return path;
}

Pose poseOf(const XrPosef& pose) {
  const glm::dquat turned(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  return {{pose.position.x, pose.position.y, pose.position.z}, glm::normalize(turned)};
}

}  // namespace carom::openxr
