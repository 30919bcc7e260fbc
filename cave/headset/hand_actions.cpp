#include "cave/headset/hand_actions.h"

#include <algorithm>
#include <cstring>

namespace carom::openxr {
namespace {

XrActionStateGetInfo stateOf(XrAction action, XrPath hand) {
  auto info = infoOf<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  info.action = action;
  info.subactionPath = hand;
  return info;
}

}  // namespace

HandActions::HandActions(XrInstance instance, XrSession session, bool seesHands)
    : instance_(instance), session_(session) {
  hands_ = {pathOf(instance, "/user/hand/left"), pathOf(instance, "/user/hand/right")};
  auto set = infoOf<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
  std::strcpy(set.actionSetName, "carom");
  std::strcpy(set.localizedActionSetName, "Carom");
  check(instance, xrCreateActionSet(instance, &set, &set_), "the headset's runtime takes no actions");
  actions_.aim = action(XR_ACTION_TYPE_POSE_INPUT, "aim", "Aim the cue");
  actions_.trigger = action(XR_ACTION_TYPE_FLOAT_INPUT, "cue", "Draw the cue");
  actions_.select = action(XR_ACTION_TYPE_BOOLEAN_INPUT, "select", "Draw the cue (button)");
  actions_.first = action(XR_ACTION_TYPE_BOOLEAN_INPUT, "first", "First button");
  actions_.second = action(XR_ACTION_TYPE_BOOLEAN_INPUT, "second", "Second button");
  actions_.menu = action(XR_ACTION_TYPE_BOOLEAN_INPUT, "menu", "Menu");
  actions_.stick = action(XR_ACTION_TYPE_VECTOR2F_INPUT, "drive", "Drive");
  actions_.knock = action(XR_ACTION_TYPE_VIBRATION_OUTPUT, "knock", "Feel the stroke");
  suggestAll();
  auto attach = infoOf<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
  attach.countActionSets = 1;
  attach.actionSets = &set_;
  check(instance, xrAttachSessionActionSets(session, &attach), "the headset's runtime takes no actions");
  for (std::size_t hand = 0; hand < 2; ++hand) {
    auto space = infoOf<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
    space.action = actions_.aim;
    space.subactionPath = hands_[hand];
    space.poseInActionSpace.orientation.w = 1.0F;
    check(instance, xrCreateActionSpace(session, &space, &aims_[hand]),
          "the headset's runtime follows no hands");
  }
  if (seesHands) bare_.emplace(instance, session);
}

HandActions::~HandActions() { xrDestroyActionSet(set_); }

XrAction HandActions::action(XrActionType type, const char* name, const char* shownName) {
  auto info = infoOf<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
  std::strcpy(info.actionName, name);
  std::strcpy(info.localizedActionName, shownName);
  info.actionType = type;
  info.countSubactionPaths = static_cast<std::uint32_t>(hands_.size());
  info.subactionPaths = hands_.data();
  XrAction made = XR_NULL_HANDLE;
  check(instance_, xrCreateAction(set_, &info, &made), "the headset's runtime takes no actions");
  return made;
}

/// Suggests which input does what, for both hands; "left/…" and "right/…" are of one hand. A runtime that
/// does not know the kind of controller refuses, which does no harm.
void HandActions::suggest(const char* profile, const std::vector<std::pair<XrAction, const char*>>& inputs) {
  std::vector<XrActionSuggestedBinding> bindings;
  for (const auto& [action, input] : inputs) {
    for (const char* hand : {"left/", "right/"}) {
      const std::string_view name(input);
      const bool isOfOne = name.starts_with("left/") || name.starts_with("right/");
      if (isOfOne && !name.starts_with(hand)) continue;
      const std::string path = std::string("/user/hand/") + (isOfOne ? "" : hand) + input;
      bindings.push_back({action, pathOf(instance_, path.c_str())});
    }
  }
  auto info = infoOf<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
  info.interactionProfile = pathOf(instance_, profile);
  info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
  info.suggestedBindings = bindings.data();
  xrSuggestInteractionProfileBindings(instance_, &info);
}

/// The profiles are those of the specification, chapter 6.4.
void HandActions::suggestAll() {
  const std::pair<XrAction, const char*> aim{actions_.aim, "input/aim/pose"},
      knock{actions_.knock, "output/haptic"}, trigger{actions_.trigger, "input/trigger/value"},
      stick{actions_.stick, "input/thumbstick"};
  suggest("/interaction_profiles/khr/simple_controller",
          {aim, knock, {actions_.select, "input/select/click"}, {actions_.menu, "input/menu/click"}});
  suggest("/interaction_profiles/oculus/touch_controller", {aim,
                                                            knock,
                                                            trigger,
                                                            stick,
                                                            {actions_.first, "left/input/x/click"},
                                                            {actions_.first, "right/input/a/click"},
                                                            {actions_.second, "left/input/y/click"},
                                                            {actions_.second, "right/input/b/click"},
                                                            {actions_.menu, "left/input/menu/click"}});
  suggest(
      "/interaction_profiles/valve/index_controller",
      {aim, knock, trigger, stick, {actions_.first, "input/a/click"}, {actions_.second, "input/b/click"}});
  suggest("/interaction_profiles/htc/vive_controller",
          {aim, knock, trigger, {actions_.stick, "input/trackpad"}, {actions_.menu, "input/menu/click"}});
  suggest("/interaction_profiles/microsoft/motion_controller",
          {aim, knock, trigger, stick, {actions_.menu, "input/menu/click"}});
}

bool HandActions::isPressed(XrAction action, std::size_t hand) const {
  const XrActionStateGetInfo info = stateOf(action, hands_[hand]);
  auto state = infoOf<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
  return XR_SUCCEEDED(xrGetActionStateBoolean(session_, &info, &state)) && state.isActive &&
         state.currentState;
}

/// Returns how far the trigger is pulled, 0 to 1; a controller with a button in its place pulls all the way.
double HandActions::pulled(std::size_t hand) const {
  const XrActionStateGetInfo info = stateOf(actions_.trigger, hands_[hand]);
  auto state = infoOf<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
  if (XR_SUCCEEDED(xrGetActionStateFloat(session_, &info, &state)) && state.isActive)
    return static_cast<double>(state.currentState);
  return isPressed(actions_.select, hand) ? 1.0 : 0.0;
}

HeadsetHand HandActions::handAt(std::size_t hand, XrTime time, XrSpace room) {
  HeadsetHand state;
  auto place = infoOf<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
  constexpr XrSpaceLocationFlags kWhole =
      XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  if (XR_SUCCEEDED(xrLocateSpace(aims_[hand], room, time, &place)) &&
      (place.locationFlags & kWhole) == kWhole) {
    state.isTracked = true;
    state.roomFromAim = poseOf(place.pose);
  }
  double pull = pulled(hand);
  if (!state.isTracked && bare_) {
    const BareHand& bare = bare_->at(hand, time, room);
    state.isTracked = bare.isSeen;
    state.roomFromAim = bare.roomFromPalm;
    pull = std::max(pull, bare.pinched);
  }
  wasHeld_[hand] = state.trigger = isHeld(wasHeld_[hand], pull);
  state.first = isPressed(actions_.first, hand);
  state.second = isPressed(actions_.second, hand);
  state.menu = isPressed(actions_.menu, hand);
  const XrActionStateGetInfo info = stateOf(actions_.stick, hands_[hand]);
  auto stick = infoOf<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
  if (XR_SUCCEEDED(xrGetActionStateVector2f(session_, &info, &stick)) && stick.isActive)
    state.stick = {stick.currentState.x, stick.currentState.y};
  return state;
}

std::array<HeadsetHand, 2> HandActions::at(XrTime time, XrSpace room) {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  auto sync = infoOf<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  if (xrSyncActions(session_, &sync) != XR_SUCCESS) {  // others have the focus
    wasHeld_ = {};
    return {};
  }
  return {handAt(0, time, room), handAt(1, time, room)};
}

void HandActions::knock(int hand, double strength, double duration_s) const {
  auto info = infoOf<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
  info.action = actions_.knock;
  info.subactionPath = hands_[static_cast<std::size_t>(hand)];
  auto vibration = infoOf<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
  vibration.amplitude = static_cast<float>(strength);
  vibration.duration = static_cast<XrDuration>(1e9 * duration_s);
  vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
  xrApplyHapticFeedback(session_, &info, reinterpret_cast<const XrHapticBaseHeader*>(&vibration));
}

}  // namespace carom::openxr
