#pragma once
// The connection to an OpenXR runtime, and what it says of its headset.

#include <string>

#include <glm/vec2.hpp>

#include "cave/headset/openxr.h"

namespace carom::openxr {

inline constexpr XrViewConfigurationType kStereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

class Instance {
 public:
  /// Throws std::runtime_error if there is no loader, no runtime or none for which OpenGL can draw.
  Instance();
  ~Instance() { xrDestroyInstance(handle_); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  operator XrInstance() const { return handle_; }

  /// Returns the headset that the runtime knows. Throws std::runtime_error if none is connected.
  XrSystemId system() const;
  std::string runtime() const;  ///< its name and version
  std::string nameOf(XrSystemId system) const;
  /// Returns whether the headset sees the joints of bare hands.
  bool followsHands(XrSystemId system) const;
  /// Returns the pixels of an eye's picture that the runtime recommends, the same for both eyes.
  glm::ivec2 recommendedPixels(XrSystemId system) const;

 private:
  XrInstance handle_ = XR_NULL_HANDLE;
  bool knowsHands_ = false;
};

}  // namespace carom::openxr
