#pragma once
// What OpenXR calls actions: the aim, trigger, buttons and stick of both hands, whichever controllers there
// are, or of bare hands.

#include <array>
#include <optional>

#include "cave/headset/bare_hands.h"
#include "cave/headset/openxr.h"
#include "cave/record/headset_frame.h"

namespace carom::openxr {

class HandActions {
 public:
  /// `seesHands`: a hand without a controller is followed by its joints; a pinch is its trigger.
  HandActions(XrInstance instance, XrSession session, bool seesHands);
  ~HandActions();
  HandActions(const HandActions&) = delete;
  HandActions& operator=(const HandActions&) = delete;

  /// Returns both hands as they will be at `time`, in the coordinates of `room`.
  std::array<HeadsetHand, 2> at(XrTime time, XrSpace room);

  void knock(int hand, double strength, double duration_s) const;

 private:
  XrAction action(XrActionType type, const char* name, const char* shownName);
  void suggest(const char* profile, const std::vector<std::pair<XrAction, const char*>>& inputs);
  void suggestAll();
  HeadsetHand handAt(std::size_t hand, XrTime time, XrSpace room);
  bool isPressed(XrAction action, std::size_t hand) const;
  double pulled(std::size_t hand) const;

  XrInstance instance_;
  XrSession session_;
  std::array<XrPath, 2> hands_{};
  XrActionSet set_ = XR_NULL_HANDLE;
  struct Actions {
    XrAction aim{}, trigger{}, select{}, first{}, second{}, menu{}, stick{}, knock{};
  };
  Actions actions_;
  std::array<XrSpace, 2> aims_{};
  std::array<bool, 2> wasHeld_{};
  std::optional<BareHands> bare_;
};

}  // namespace carom::openxr
