#include "cave/headset/openxr.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace carom::openxr {

#define CAROM_XR_CALL(name) PFN_xr##name xr##name = nullptr;
CAROM_XR_CALLS(CAROM_XR_CALL)
#undef CAROM_XR_CALL

void load() {
  constexpr const char* kLibrary = "libopenxr_loader.so.1";
  void* const library = dlopen(kLibrary, RTLD_NOW);  // stays until the program ends
  if (!library)
    throw std::runtime_error(
        fmt::format("there is no OpenXR loader, expected the package libopenxr-loader1 ({})", dlerror()));
  const auto find = [&](const char* name) {
    if (void* const found = dlsym(library, name)) return found;
    throw std::runtime_error(fmt::format("{} lacks {}, expected OpenXR's loader 1.0", kLibrary, name));
  };
#define CAROM_XR_CALL(name) xr##name = reinterpret_cast<PFN_xr##name>(find("xr" #name));
  CAROM_XR_CALLS(CAROM_XR_CALL)
#undef CAROM_XR_CALL
}

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
