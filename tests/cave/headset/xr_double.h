#pragma once
// A runtime of OpenXR that is a test's own: Debian's loader loads it where XR_RUNTIME_JSON names its
// manifest. It has no headset and no time of its own: a script says what each frame is, and what was
// submitted is kept. It is as strict as real runtimes are about the order of calls, and as rude as the
// rudest: it can leave errors of OpenGL, and another context current.

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include <openxr/openxr.h>

namespace carom::test {

struct XrDoubleHand {
  XrSpaceLocationFlags flags = 15;
  XrPosef aim{{0, 0, 0, 1}, {0, 1.2F, -0.3F}};
  float trigger = 0.0F;
  bool first = false, second = false, menu = false;
  XrVector2f stick{0, 0};
  float tipsApart_m =
      -1.0F;  ///< of a hand without a controller, whose palm is at `aim`; negative: none is seen
};

/// What the runtime says of one frame.
struct XrDoubleFrame {
  XrDuration step_ns = 11'111'111;
  bool shouldRender = true;
  XrViewStateFlags flags = 15;
  std::array<XrPosef, 2> eyes{{{{0, 0, 0, 1}, {-0.032F, 1.7F, 0}}, {{0, 0, 0, 1}, {0.032F, 1.7F, 0}}}};
  std::array<XrFovf, 2> fov{{{-0.8F, 0.7F, 0.75F, -0.75F}, {-0.7F, 0.8F, 0.75F, -0.75F}}};  // outwards wider
  XrSpaceVelocityFlags velocityFlags = 0;
  XrVector3f velocity{0, 0, 0};
  std::array<XrDoubleHand, 2> hands;
};

/// A frame as it was submitted.
struct XrDoubleEnd {
  XrTime displayTime = 0;
  std::uint32_t layers = 0;
  std::array<XrPosef, 2> eyes{};
  std::array<XrFovf, 2> fov{};
  std::array<std::vector<unsigned char>, 2> rgba{};  ///< rows from below; kept if `keepsPictures`
};

struct XrDouble {
  std::function<XrDoubleFrame(std::uint64_t)>
      script;  ///< of frame 0, 1, ...; none: every frame is the usual one
  bool hasHeadset = true, hasStage = true, hasHandProfile = true, hasOpenGl = true;
  bool seesHands = false;                             ///< without controllers
  std::vector<std::int64_t> formats{0x8C43, 0x8058};  ///< sRGB8_ALPHA8, RGBA8
  std::array<std::uint32_t, 2> size{64, 72};          ///< of a picture
  bool isRude = false;                                ///< changes the context and leaves errors
  bool keepsPictures = true;
  XrResult waitResult = XR_SUCCESS;   ///< of xrWaitFrame
  std::deque<XrSessionState> states;  ///< to be told
  bool recentres = false;             ///< with the next frame, told once

  // What was seen.
  std::vector<XrDoubleEnd> ends;
  std::vector<std::string> faults;  ///< calls out of order, and wrong arguments
  std::vector<std::pair<int, float>> knocks;
  int instances = 0, sessions = 0, chains = 0, spaces = 0, handTrackers = 0;  ///< that live

  /// Takes the headset off, and puts it on again; ends the session, as the system's menu does.
  void takeOff() {
    states.insert(states.end(), {XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_SYNCHRONIZED,
                                 XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_IDLE});
  }
  void putOn() { states.push_back(XR_SESSION_STATE_READY); }
  void quit() {
    takeOff();
    states.push_back(XR_SESSION_STATE_EXITING);
  }
};

// A program of its own is led by files: CAROM_XR_SCRIPT names one with a line for each frame,
//
//   step_ns shown flags  x y z qw qx qy qz of the head  trigger x y z stick of the right hand [event]
//
// where the stick is pushed forwards so far, `shown` is 1 for frames that are, `flags` are those of
// XrViewState, and the event is off (the headset is taken off before the next frame, and put on after three
// polls), recentre, unfocused, focused or lost. After the last line the system ends the session. What was
// submitted is appended to the file that CAROM_XR_SEEN names: of each frame, as 64-bit numbers, the display
// time, the number of layers, a thousand times the strongest vibration of a hand since the frame before, how
// many nanoseconds passed between the places of the eyes and the finished pictures, how often `new` was asked
// for since the frame before (0 unless counted_new_before is loaded before all others) and whether there are
// pictures; and then the poses, the angles and the pictures of both eyes. CAROM_XR_HABITS lists what else is
// peculiar to the runtime, in words:
//
//   no-headset  no-opengl  no-srgb  no-8-bits  no-velocity  no-hands  bare-hands (a pinch is the trigger)
//   rude silent (keeps no pictures)  large (pictures of 1024 × 1024)

/// Returns the runtime that the loader will load from the same library. Forgets all that was before if asked
/// to.
XrDouble& xrDouble(const std::string& library, bool anew);

}  // namespace carom::test
