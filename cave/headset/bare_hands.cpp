#include "cave/headset/bare_hands.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace carom::openxr {
namespace {

using Joints = std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT>;

bool isKnown(const XrHandJointLocationEXT& joint) {
  constexpr XrSpaceLocationFlags kWhole =
      XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  return (joint.locationFlags & kWhole) == kWhole;
}

/// Takes what the joints say of a hand; false if its palm or a finger of the pinch is not known.
bool take(const Joints& joints, BareHand& hand) {
  const XrHandJointLocationEXT &palm = joints[XR_HAND_JOINT_PALM_EXT],
                               &thumb = joints[XR_HAND_JOINT_THUMB_TIP_EXT],
                               &index = joints[XR_HAND_JOINT_INDEX_TIP_EXT];
  if (!isKnown(palm) || !isKnown(thumb) || !isKnown(index)) return false;
  hand.roomFromPalm = poseOf(palm.pose);
  hand.pinched = pinchedAt(glm::distance(poseOf(thumb.pose).position_m, poseOf(index.pose).position_m));
  return true;
}

}  // namespace

double pinchedAt(double apart_m) {
  constexpr double kTouch_m = 0.005, kOpen_m = 0.055;
  return std::clamp((kOpen_m - apart_m) / (kOpen_m - kTouch_m), 0.0, 1.0);
}

BareHands::BareHands(XrInstance instance, XrSession session)
    : locate_(entry<PFN_xrLocateHandJointsEXT>(instance, "xrLocateHandJointsEXT")),
      destroy_(entry<PFN_xrDestroyHandTrackerEXT>(instance, "xrDestroyHandTrackerEXT")) {
  const auto create = entry<PFN_xrCreateHandTrackerEXT>(instance, "xrCreateHandTrackerEXT");
  const bool isWhole = create && locate_ && destroy_;
  for (std::size_t hand = 0; hand < 2; ++hand) {
    auto info = infoOf<XrHandTrackerCreateInfoEXT>(XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
    info.hand = hand == 0 ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
    info.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
    check(instance, isWhole ? create(session, &info, &trackers_[hand]) : XR_ERROR_FUNCTION_UNSUPPORTED,
          "the headset's runtime follows no bare hands though it says so");
  }
}

BareHands::~BareHands() {
  for (const XrHandTrackerEXT tracker : trackers_) destroy_(tracker);
}

const BareHand& BareHands::at(std::size_t hand, XrTime time, XrSpace room) {
  auto where = infoOf<XrHandJointsLocateInfoEXT>(XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
  where.baseSpace = room;
  where.time = time;
  Joints joints{};
  auto found = infoOf<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
  found.jointCount = static_cast<std::uint32_t>(joints.size());
  found.jointLocations = joints.data();
  BareHand& known = hands_[hand];
  known.isSeen =
      XR_SUCCEEDED(locate_(trackers_[hand], &where, &found)) && found.isActive && take(joints, known);
  return known;
}

}  // namespace carom::openxr
