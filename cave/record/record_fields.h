#pragma once
// The fields of a frame's record, its knots and its events, each listed once. The rules (record_rules.h), the
// digest (frame_digest.h) and the columns of the session file (app/journal_rows/frame_columns.h) are visitors
// of these lists: a new field is added to its struct and to the list of the struct, and nowhere else.
//
// visit(part, fields) calls fields(name, value, kind) for each field of `part`. A visitor derives from
// FieldVisitor. `name` is that of the column in the session file, or the beginning of several names, and ends
// with "_" then; a value that is not const may be changed.

#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "cave/record/effects.h"
#include "cave/record/frame_state.h"

namespace carom {

/// Where the session file has a field.
enum class Stored : std::uint8_t {
  asColumn,  ///< in the column of its name
  ofOthers,  ///< the same, for the viewers after the first; for the first one in the table `viewer`
  apart,     ///< in another table, or as the number of rows
  notAtAll,
};

/// What a field may hold. Whole numbers and choices are bounded by `most`.
struct FieldKind {
  double least = -std::numeric_limits<double>::max(), most = std::numeric_limits<double>::max();
  Stored stored = Stored::asColumn;
  bool isPlace = true;  ///< of a vector: in metres

  constexpr FieldKind in(Stored place) const {
    FieldKind kind = *this;
    kind.stored = place;
    return kind;
  }
};
inline constexpr FieldKind kFlag{0.0, 1.0};  ///< 0 or 1
inline constexpr FieldKind kCount{0.0};      ///< a whole number
inline constexpr FieldKind kNumber;          ///< a finite number, place, event, pose or transform
inline constexpr FieldKind kVector{kNumber.least, kNumber.most, Stored::asColumn, false};  ///< without unit
inline constexpr FieldKind kText;
inline constexpr FieldKind kTime{-std::numeric_limits<double>::infinity(),  ///< a time, which may be infinite
                                 std::numeric_limits<double>::infinity()};
/// A choice up to the last one.
template <typename Choice>
requires std::is_enum_v<Choice>
constexpr FieldKind upTo(Choice last) { return {0.0, static_cast<double>(last)}; }

/// The part of the digest to which the fields that follow belong (FrameDigest::kFields).
enum class FrameSection : std::uint8_t { number, displayTime, observer, switches, places, knots, events };

struct FieldVisitor {
  std::string_view prefix;  ///< of the names

  void section(FrameSection) {}
};

/// A part of type `Whole`, const or not.
template <typename Part, typename Whole>
concept PartOf = std::is_same_v<std::remove_const_t<Part>, Whole>;

/// Visits a part whose names have a prefix. Prefixes are not nested.
template <typename Part, typename Fields>
void visitWith(std::string_view prefix, Part& part, Fields& fields) {
  const std::string_view before = std::exchange(fields.prefix, prefix);
  visit(part, fields);
  fields.prefix = before;
}

template <PartOf<EyeView> Eye, typename Fields>
void visit(Eye& eye, Fields& fields) {
  fields("", eye.observation, kNumber);
  fields("in_room_", eye.positionInRoom_m, kNumber);
  fields("seen_from_", eye.seenFromInRoom_m, kNumber);
}

template <PartOf<ObserverView> Observer, typename Fields>
void visit(Observer& observer, Fields& fields) {
  fields("proper_time_s", observer.properTime_s, kNumber);
  visitWith("left_", observer.left, fields);
  visitWith("right_", observer.right, fields);
  visitWith("middle_", observer.middle, fields);
  fields("head_from_board_", observer.headFromBoard, kNumber);
}

template <PartOf<Tracked> ATracked, typename Fields>
void visit(ATracked& tracked, Fields& fields) {
  fields("head_known", tracked.headKnown, kFlag);
  fields("head_sensor_", tracked.roomFromHeadSensor, kNumber);
  fields("hand_known", tracked.handKnown, kFlag);
  fields("hand_", tracked.roomFromHand, kNumber);
}

template <PartOf<HandView> Hand, typename Fields>
void visit(Hand& hand, Fields& fields) {
  fields("cue_shown", hand.shown, kFlag);
  fields("cue_pulling", hand.pulling, kFlag);
  fields("cue_target", hand.target, kCount);
  fields("cue_from_", hand.from_m, kNumber);
  fields("cue_to_", hand.to_m, kNumber);
  fields("cue_target_", hand.target_m, kNumber);
  fields("cue_towards_", hand.towards, kVector);
  fields("cue_u", hand.u, kNumber);
  fields("cue_offset_m", hand.offset_m, kNumber);
}

/// The session file has a table of its own for force devices.
template <PartOf<ForceView> Force, typename Fields>
void visit(Force& force, Fields& fields) {
  fields("is_shown", force.shown, kFlag.in(Stored::apart));
  fields("scale", force.scale, kNumber);
  fields("place_", force.place_m, kNumber);
  fields("force_n_", force.force_n, kVector);
}

template <PartOf<Score> AScore, typename Fields>
void visit(AScore& score, Fields& fields) {
  fields("caroms", score.caroms, kCount);
  fields("strokes", score.strokes, kCount);
}

template <PartOf<ViewerState> Viewer, typename Fields>
void visit(Viewer& viewer, Fields& fields) {
  fields.section(FrameSection::observer);
  visit(viewer.observer, fields);
  fields("room_", viewer.placeInRoom_m, kNumber.in(Stored::ofOthers));
  fields("lapse", viewer.lapse, kNumber.in(Stored::ofOthers));
  fields.section(FrameSection::places);
  visit(viewer.tracked, fields);
  visit(viewer.hand, fields);
  fields.section(FrameSection::switches);
  fields("notice", viewer.notice.english, kText);
  fields("notice_said", viewer.notice.said, kText);
  visit(viewer.score, fields);
  fields("has_turn", viewer.hasTurn, kFlag.in(Stored::ofOthers));
  fields("language", viewer.language, FieldKind{0.0, kMostLanguages - 1});
}

template <PartOf<WallControls> Walls, typename Fields>
void visit(Walls& walls, Fields& fields) {
  fields("shown", walls.shown, upTo(Shown::alignmentPattern));
  fields("blank", walls.blank, kFlag);
  fields("eyes_swapped", walls.eyesSwapped, kFlag);
  fields("tracker_cross", walls.trackerCross, kFlag);
  fields("latency", walls.latency, kFlag);
  fields("comfort", walls.comfort, kFlag);
}

template <PartOf<SculptureView> Sculpture, typename Fields>
void visit(Sculpture& sculpture, Fields& fields) {
  fields("spacetime_", sculpture.place.roomFromFoot, kNumber);
  fields("spacetime_height_m", sculpture.place.height_m, FieldKind{0.0, 100.0});
  fields("spacetime_scale", sculpture.place.scale, FieldKind{0.0, 100.0});
  fields("spacetime_past_s", sculpture.place.past_s, FieldKind{0.0, kLongestSculpture_s});
  fields("spacetime_beta_", sculpture.place.beta, kVector);
  fields("spacetime_picked", sculpture.picked, kCount);
  fields("spacetime_compared", sculpture.compared, kCount);
  fields("spacetime_held", sculpture.held, kFlag);
}

template <PartOf<DriveView> Drive, typename Fields>
void visit(Drive& drive, Fields& fields) {
  fields("thrust_", drive.thrust, kVector);
  fields("thrust_m_s2", drive.thrust_m_s2, kNumber.in(Stored::apart));
  fields("drive_mode", drive.mode, upTo(DriveMode::tour));
  fields("drive_at_limit", drive.atLimit, kFlag);
}

template <PartOf<LessonState> Lesson, typename Fields>
void visit(Lesson& lesson, Fields& fields) {
  fields("lesson_phase", lesson.phase, upTo(LessonPhase::explains));
  fields("lesson_answer", lesson.answer, FieldKind{0.0, kMostAnswers});
}

template <PartOf<ClassView> Class, typename Fields>
void visit(Class& classroom, Fields& fields) {
  fields("class_phase", classroom.phase, upTo(ClassPhase::explained).in(Stored::notAtAll));
  fields("class_round", classroom.round, FieldKind{0.0, kVotes, Stored::notAtAll});
  fields("class_choices", classroom.choices, FieldKind{0.0, kMostAnswers, Stored::notAtAll});
  fields("class_right", classroom.right, FieldKind{0.0, kMostAnswers, Stored::notAtAll});
  fields("class_answered", classroom.answered, kCount.in(Stored::notAtAll));
  fields("class_phones", classroom.phones, kCount.in(Stored::notAtAll));
  for (auto& round : classroom.counts) {
    for (auto& count : round) fields("class_count", count, kCount.in(Stored::notAtAll));
  }
  fields("class_address", classroom.address, kText.in(Stored::notAtAll));
  fields("class_word", classroom.word, kText.in(Stored::notAtAll));
}

template <PartOf<EyeFrustum> Frustum, typename Fields>
void visit(Frustum& frustum, Fields& fields) {
  fields("tan_left", frustum.left, kNumber);
  fields("tan_right", frustum.right, kNumber);
  fields("tan_down", frustum.down, kNumber);
  fields("tan_up", frustum.up, kNumber);
}

template <PartOf<HeadsetEye> Eye, typename Fields>
void visit(Eye& eye, Fields& fields) {
  fields("", eye.roomFromEye, kNumber);
  visit(eye.frustum, fields);
}

/// The session file has a table of its own for a headset.
template <PartOf<HeadsetState> Headset, typename Fields>
void visit(Headset& headset, Fields& fields) {
  fields("is_worn", headset.isWorn, kFlag.in(Stored::apart));
  fields("velocity_", headset.runtimeVelocity_m_s, kNumber);
  fields("velocity_known", headset.velocityKnown, kFlag);
  visitWith("left_", headset.eyes[0], fields);
  visitWith("right_", headset.eyes[1], fields);
}

/// Visits the fields that are not those of a viewer nor of the headset.
template <PartOf<FrameRecord> Record, typename Fields>
void visit(Record& record, Fields& fields) {
  fields.section(FrameSection::number);
  fields("number", record.number, kCount.in(Stored::apart));
  fields("last", record.last, kFlag);
  fields.section(FrameSection::displayTime);
  fields("display_s", record.display_s, kNumber);
  fields.section(FrameSection::observer);
  fields("viewers", record.viewerCount, FieldKind{1.0, kMostViewers, Stored::apart});
  fields("first_of_room", record.firstOfRoom, FieldKind{0.0, kMostViewers - 1, Stored::notAtAll});
  fields("room_s", record.room_s, kNumber.in(Stored::apart));
  fields("board_from_room_", record.boardFromRoom, kNumber);
  fields.section(FrameSection::switches);
  fields("switches", record.switches, kNamedSwitches);
  fields("views", record.views, kNamedViews);
  fields("beside", record.views.beside, kNamedSwitches);
  fields("light_speed_m_s", record.lightSpeed_m_s, kNumber);
  visit(record.sculpture, fields);
  visit(record.controls, fields);
  visit(record.lesson, fields);
  visit(record.classroom, fields);
  fields("fade", record.fade, FieldKind{0.0, 1.0});
  fields("languages_on_tile", record.languagesOnTile, FieldKind{0.0, kMostLanguages});
  fields.section(FrameSection::places);
  visit(record.drive, fields);
  fields.section(FrameSection::knots);
  fields("truncate_from_s", record.truncateFrom_s, kTime);
  fields("pucks", record.pucks, kCount);
  // When a session is continued, or seen by another viewer, more may be seen than was seen at first, so
  // nothing is ever discarded.
  fields("forget_before_s", record.forgetBefore_s, kTime.in(Stored::notAtAll));
  // Rows are not stored at all: a game that is played anew makes them again
  // (engine/billiard/soft_row_book.h).
  fields("rows_from_m", record.rowsFrom_m, kTime.in(Stored::notAtAll));
  fields("rows_forgotten_before_m", record.rowsForgottenBefore_m, kTime.in(Stored::notAtAll));
  fields.section(FrameSection::events);
  fields("events_kept", record.eventsKept, kCount);
}

/// Visits all fields of a record that have a meaning: those of the viewers who are in the room.
template <PartOf<FrameRecord> Record, typename Fields>
void visitAll(Record& record, Fields& fields) {
  visit(record, fields);
  visit(record.headset, fields);
  for (auto& viewer : record.present()) {
    visit(viewer, fields);
    visit(viewer.force, fields);
  }
}

template <PartOf<Knot> AKnot, typename Fields>
void visit(AKnot& knot, Fields& fields) {
  fields("", knot.turn, kNumber);
  fields("u_", knot.u, kVector);
  fields("proper_time_s", knot.properTime_s, kNumber);
  fields("signal_", knot.signal, kNumber);
  fields("deceleration_m_s2", knot.deceleration_m_s2, kNumber);
  fields("angle_rad", knot.spin.angle_rad, kNumber);
  fields("spin_rad_s", knot.spin.omega_rad_s, kNumber);
  fields("rim_u", knot.spin.rim_u, kNumber);
  fields("spin_slowing_1_s", knot.spin.slowing_1_s, kNumber);
}

/// The session file has a person's number and name, head and own time in columns of their own.
template <PartOf<ToldMoment> Moment, typename Fields>
void visit(Moment& moment, Fields& fields) {
  fields("kind", moment.kind, upTo(ToldKind::ends));
  fields("hand_", moment.hand, kNumber);
  fields("facing_rad", moment.facing_rad, kNumber);
  fields("has_hand", moment.hasHand, kFlag);
  fields("has_cue", moment.hasCue, kFlag);
  fields("cue_rad", moment.cue_rad, kNumber);
  fields("caroms", moment.caroms, kCount);
}

template <PartOf<Turn> ATurn, typename Fields>
void visit(ATurn& turn, Fields& fields) {
  fields("puck", turn.puck, kCount);
  fields("", turn.event, kNumber);
  fields("beta_before_", turn.betaBefore, kVector);
  fields("beta_after_", turn.betaAfter, kVector);
  fields("proper_time_s", turn.properTime_s, kNumber);
}

/// Visits the rest of a turn. Files have the columns of both turns' spins after all others.
template <PartOf<Turn> ATurn, typename Fields>
void visitSpin(ATurn& turn, Fields& fields) {
  fields("spin_before_kg_m2_s", turn.spinBefore_kg_m2_s, kNumber);
  fields("spin_after_kg_m2_s", turn.spinAfter_kg_m2_s, kNumber);
}

template <PartOf<GameEvent> AnEvent, typename Fields>
void visit(AnEvent& event, Fields& fields) {
  fields("number", event.number, kCount);
  fields("kind", event.kind, upTo(kLastEventKind));
  fields("cushion", event.cushion, upTo(Cushion::minusY));
  fields("which", event.which, kCount);
  fields("", event.at, kNumber);
  fields("without_delay", event.withoutDelay, kFlag);
  fields("heat_j", event.heat_j, kNumber);
  fields.turns(event.turns);
  fields("side_on_side", event.sideOnSide, kFlag);
}

/// Calls f(suffix, number) for each number of a value of several, with the end of its column's name.
template <typename Vector, typename F>
requires(Vector::length() <= 3) void eachNumber(Vector& v, const FieldKind& kind, F&& f) {
  constexpr const char* kPlaces[]{"x_m", "y_m", "z_m"};
  constexpr const char* kComponents[]{"x", "y", "z"};
  for (int axis = 0; axis < std::remove_const_t<Vector>::length(); ++axis)
    f(kind.isPlace ? kPlaces[axis] : kComponents[axis], v[axis]);
}
template <PartOf<Event> AnEvent, typename F>
void eachNumber(AnEvent& event, const FieldKind& kind, F&& f) {
  f("t_s", event.t_s);
  eachNumber(event.r_m, kind, f);
}
template <PartOf<Pose> APose, typename F>
void eachNumber(APose& pose, const FieldKind& kind, F&& f) {
  eachNumber(pose.position_m, kind, f);
  f("qw", pose.orientation.w);
  f("qx", pose.orientation.x);
  f("qy", pose.orientation.y);
  f("qz", pose.orientation.z);
}
/// Of a transform, the elements of the matrix that acts on (c t, x, y, z), named by row and column.
template <PartOf<Lorentz> Transform, typename F>
void eachNumber(Transform& transform, const FieldKind&, F&& f) {
  constexpr const char* kElements[]{"tt", "xt", "yt", "zt", "tx", "xx", "yx", "zx",
                                    "ty", "xy", "yy", "zy", "tz", "xz", "yz", "zz"};
  glm::dmat4 matrix = transform.matrix();
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) f(kElements[4 * column + row], matrix[column][row]);
  }
  if constexpr (!std::is_const_v<Transform>) transform = Lorentz(transform.lightSpeed_m_s(), matrix);
}

/// A value of several numbers.
template <typename Value>
concept Compound = requires(Value& value, void (*f)(const char*, double&)) {
  eachNumber(value, kNumber, f);
};

}  // namespace carom
