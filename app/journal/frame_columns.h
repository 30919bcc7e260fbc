#pragma once
// The columns of a frame's record, its knots and its events in a session file, in their order. Writing and
// reading use the same list: `visit(prefix, name, value)` is called for each column, whose name is `prefix`
// followed by `name`; a value that is not const may be changed.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "cave/frame/frame_state.h"

namespace carom {

using Part = std::string_view;  ///< part of a column's name

template <typename Visit, typename Place>
void visitPlace(Visit& visit, Part prefix, Place& place_m) {
  visit(prefix, "x_m", place_m.x);
  visit(prefix, "y_m", place_m.y);
  visit(prefix, "z_m", place_m.z);
}

/// Visits the components of a vector without unit.
template <typename Visit, typename Vector>
void visitVector(Visit& visit, Part prefix, Vector& v) {
  visit(prefix, "x", v.x);
  visit(prefix, "y", v.y);
  if constexpr (std::remove_const_t<Vector>::length() > 2) visit(prefix, "z", v.z);
}

template <typename Visit, typename AnEvent>
void visitEvent(Visit& visit, Part prefix, AnEvent& event) {
  visit(prefix, "t_s", event.t_s);
  visitPlace(visit, prefix, event.r_m);
}

template <typename Visit, typename APose>
void visitPose(Visit& visit, Part prefix, APose& pose) {
  visitPlace(visit, prefix, pose.position_m);
  visit(prefix, "qw", pose.orientation.w);
  visit(prefix, "qx", pose.orientation.x);
  visit(prefix, "qy", pose.orientation.y);
  visit(prefix, "qz", pose.orientation.z);
}

/// Visits the elements of the matrix that acts on (c t, x, y, z), named by row and column.
template <typename Visit, typename Transform>
void visitTransform(Visit& visit, Part prefix, Transform& transform) {
  constexpr std::array<Part, 16> kElements{"tt", "xt", "yt", "zt", "tx", "xx", "yx", "zx",
                                           "ty", "xy", "yy", "zy", "tz", "xz", "yz", "zz"};
  glm::dmat4 matrix = transform.matrix();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) visit(prefix, kElements[4 * column + row], matrix[column][row]);
  }
  if constexpr (!std::is_const_v<Transform>) transform = Lorentz(transform.lightSpeed_m_s(), matrix);
}

/// Visits one number with a bit for each flag, in the order of their names.
template <typename Visit, typename Named, typename Flags>
void visitBits(Visit& visit, Part name, const Named& named, Flags& flags) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (flags.*named[i].value) bits |= std::uint64_t{1} << i;
  }
  visit("", name, bits);
  if constexpr (!std::is_const_v<Flags>) {
    const std::uint64_t most = (std::uint64_t{1} << named.size()) - 1;
    if (bits > most) throw std::runtime_error(fmt::format("{} is {}, expected 0 to {}", name, bits, most));
    for (std::size_t i = 0; i < named.size(); ++i) flags.*named[i].value = bits >> i & 1U;
  }
}

template <typename Visit, typename Hand>
void visitCue(Visit& visit, Hand& hand) {
  visit("", "cue_shown", hand.shown);
  visit("", "cue_pulling", hand.pulling);
  visit("", "cue_target", hand.target);
  visitPlace(visit, "cue_from_", hand.from_m);
  visitPlace(visit, "cue_to_", hand.to_m);
  visitPlace(visit, "cue_target_", hand.target_m);
  visitVector(visit, "cue_towards_", hand.towards);
  visit("", "cue_u", hand.u);
}

template <typename Visit, typename Hand, typename PlatformMotion>
void visitHand(Visit& visit, Hand& hand, PlatformMotion& drive) {
  visitCue(visit, hand);
  visitVector(visit, "thrust_", drive.thrust);
  visit("", "drive_mode", drive.mode);
  visit("", "drive_at_limit", drive.atLimit);
}

/// Visits all fields except the number and those that are not stored: for another viewer, or when a session
/// is continued, more may be seen than was seen originally, so nothing is ever discarded.
template <typename Visit, typename Record>
void visitRecord(Visit& visit, Record& record) {
  auto& observer = record.observer;
  auto &left = observer.left, &right = observer.right, &middle = observer.middle;
  visit("", "display_s", record.display_s);
  visit("", "proper_time_s", observer.properTime_s);
  visitEvent(visit, "", middle.observation);
  visitBits(visit, "switches", kNamedSwitches, record.switches);
  visitBits(visit, "views", kNamedViews, record.views);
  visitBits(visit, "beside", kNamedSwitches, record.views.beside);
  visit("", "truncate_from_s", record.truncateFrom_s);
  visit("", "pucks", record.pucks);
  visit("", "events_kept", record.eventsKept);
  visit("", "last", record.last);
  visit("", "light_speed_m_s", record.lightSpeed_m_s);
  visitEvent(visit, "left_", left.observation);
  visitEvent(visit, "right_", right.observation);
  visitPlace(visit, "left_in_room_", left.positionInRoom_m);
  visitPlace(visit, "right_in_room_", right.positionInRoom_m);
  visitPlace(visit, "middle_in_room_", middle.positionInRoom_m);
  visitPlace(visit, "left_seen_from_", left.seenFromInRoom_m);
  visitPlace(visit, "right_seen_from_", right.seenFromInRoom_m);
  visitPlace(visit, "middle_seen_from_", middle.seenFromInRoom_m);
  visitTransform(visit, "head_from_board_", observer.headFromBoard);
  visitTransform(visit, "board_from_room_", record.boardFromRoom);
  visit("", "shown", record.controls.shown);
  visit("", "blank", record.controls.blank);
  visit("", "eyes_swapped", record.controls.eyesSwapped);
  visit("", "tracker_cross", record.controls.trackerCross);
  visit("", "latency", record.controls.latency);
  visit("", "head_known", record.tracked.headKnown);
  visitPose(visit, "head_sensor_", record.tracked.roomFromHeadSensor);
  visit("", "hand_known", record.tracked.handKnown);
  visitPose(visit, "hand_", record.tracked.roomFromHand);
  visitHand(visit, record.hand, record.drive);
  visit("", "lesson_phase", record.lesson.phase);
  visit("", "lesson_answer", record.lesson.answer);
  visit("", "notice", record.notice);
  visit("", "cue_offset_m", record.hand.offset_m);
  visit("", "comfort", record.controls.comfort);
  visit("", "caroms", record.score.caroms);
  visit("", "strokes", record.score.strokes);
  visit("", "fade", record.fade);
}

/// Visits the stored fields of a viewer after the first.
template <typename Visit, typename Viewer>
void visitViewer(Visit& visit, Viewer& viewer) {
  auto& observer = viewer.observer;
  visit("", "proper_time_s", observer.properTime_s);
  for (const auto& [eye, prefix] :
       {std::pair(&observer.left, "left_"), {&observer.right, "right_"}, {&observer.middle, "middle_"}}) {
    const std::string name(prefix);
    visitEvent(visit, name, eye->observation);
    visitPlace(visit, name + "in_room_", eye->positionInRoom_m);
    visitPlace(visit, name + "seen_from_", eye->seenFromInRoom_m);
  }
  visitTransform(visit, "head_from_board_", observer.headFromBoard);
  visitPlace(visit, "room_", viewer.placeInRoom_m);
  visit("", "lapse", viewer.lapse);
  visit("", "head_known", viewer.tracked.headKnown);
  visitPose(visit, "head_sensor_", viewer.tracked.roomFromHeadSensor);
  visit("", "hand_known", viewer.tracked.handKnown);
  visitPose(visit, "hand_", viewer.tracked.roomFromHand);
  visitCue(visit, viewer.hand);
  visit("", "cue_offset_m", viewer.hand.offset_m);
  visit("", "notice", viewer.notice);
  visit("", "caroms", viewer.score.caroms);
  visit("", "strokes", viewer.score.strokes);
  visit("", "has_turn", viewer.hasTurn);
}

/// Visits the stored fields of a headset.
template <typename Visit, typename Headset>
void visitHeadset(Visit& visit, Headset& headset) {
  visitPlace(visit, "velocity_", headset.runtimeVelocity_m_s);
  visit("", "velocity_known", headset.velocityKnown);
  for (const auto& [eye, prefix] : {std::pair(&headset.eyes[0], "left_"), {&headset.eyes[1], "right_"}}) {
    const std::string name(prefix);
    visitPose(visit, name, eye->roomFromEye);
    visit(name, "tan_left", eye->frustum.left);
    visit(name, "tan_right", eye->frustum.right);
    visit(name, "tan_down", eye->frustum.down);
    visit(name, "tan_up", eye->frustum.up);
  }
}

template <typename Visit, typename AKnot>
void visitKnot(Visit& visit, AKnot& knot) {
  visitEvent(visit, "", knot.turn);
  visitVector(visit, "u_", knot.u);
  visit("", "proper_time_s", knot.properTime_s);
  visitEvent(visit, "signal_", knot.signal);
  visit("", "deceleration_m_s2", knot.deceleration_m_s2);
  visit("", "angle_rad", knot.spin.angle_rad);
  visit("", "spin_rad_s", knot.spin.omega_rad_s);
  visit("", "rim_u", knot.spin.rim_u);
  visit("", "spin_slowing_1_s", knot.spin.slowing_1_s);
}

template <typename Visit, typename ATurn>
void visitTurn(Visit& visit, Part prefix, ATurn& turn) {
  visit(prefix, "puck", turn.puck);
  visitEvent(visit, prefix, turn.event);
  std::string name(prefix);
  visitVector(visit, name + "beta_before_", turn.betaBefore);
  visitVector(visit, name + "beta_after_", turn.betaAfter);
  visit(prefix, "proper_time_s", turn.properTime_s);
}

template <typename Visit, typename ATurn>
void visitTurnedSpin(Visit& visit, Part prefix, ATurn& turn) {
  visit(prefix, "spin_before_kg_m2_s", turn.spinBefore_kg_m2_s);
  visit(prefix, "spin_after_kg_m2_s", turn.spinAfter_kg_m2_s);
}

template <typename Visit, typename AnEvent>
void visitGameEvent(Visit& visit, AnEvent& event) {
  constexpr bool kReads = !std::is_const_v<AnEvent>;
  visit("", "number", event.number);
  visit("", "kind", event.kind);
  // 0 means none.
  std::uint8_t cushion = event.cushion ? static_cast<std::uint8_t>(1 + static_cast<int>(*event.cushion)) : 0;
  visit("", "cushion", cushion);
  visit("", "which", event.which);
  visitEvent(visit, "", event.at);
  std::uint8_t withoutDelay = event.withoutDelay ? 1 : 0;
  visit("", "without_delay", withoutDelay);
  visit("", "heat_j", event.heat_j);
  std::array<Turn, 2> turns;
  auto count = static_cast<std::uint8_t>(event.turns.size());
  std::copy(event.turns.begin(), event.turns.end(), turns.begin());
  visit("", "turns", count);
  visitTurn(visit, "first_", turns[0]);
  visitTurn(visit, "second_", turns[1]);
  visitTurnedSpin(visit, "first_", turns[0]);
  visitTurnedSpin(visit, "second_", turns[1]);
  std::uint8_t sideOnSide = event.sideOnSide ? 1 : 0;
  visit("", "side_on_side", sideOnSide);
  if constexpr (kReads) {
    if (withoutDelay > 1 || sideOnSide > 1 || count > turns.size())
      throw std::runtime_error("no such event can be");
    if (cushion > 0) event.cushion = static_cast<Cushion>(cushion - 1);
    event.withoutDelay = withoutDelay == 1;
    event.sideOnSide = sideOnSide == 1;
    for (std::uint8_t turn = 0; turn < count; ++turn) event.turns.push_back(turns[turn]);
  }
}

}  // namespace carom
