#include "app/study_data/lesson_behaviour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <string>

#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"

namespace carom {
namespace {

constexpr double kRate_Hz = 60.0, kCutoff_Hz = 2.0;
constexpr double kNear_deg = 15.0;

/// A low-pass filter of second order (S. Butterworth 1930) by the bilinear transform: with
/// K = tan(π f_c/f_s), H(z) = K² (1 + z⁻¹)² / (1 + √2 K + K² + 2 (K² − 1) z⁻¹ + (1 − √2 K + K²) z⁻²).
class Butterworth {
 public:
  /// Begins as if `at` had lasted for ever.
  explicit Butterworth(const Vec3& at) : in_{at, at}, out_{at, at} {}

  Vec3 next(const Vec3& in) {
    const double k = std::tan(std::numbers::pi * kCutoff_Hz / kRate_Hz), root = std::numbers::sqrt2 * k;
    const double norm = 1.0 / (1.0 + root + k * k);
    const Vec3 out = norm * (k * k * (in + 2.0 * in_[0] + in_[1]) - 2.0 * (k * k - 1.0) * out_[0] -
                             (1.0 - root + k * k) * out_[1]);
    in_ = {in, in_[0]};
    out_ = {out, out_[0]};
    return out;
  }

 private:
  std::array<Vec3, 2> in_, out_;
};

/// Filters forwards and backwards, so that nothing is delayed. Before and after the path it goes on as its
/// mirror image in its ends, so that they are not drawn inwards.
void filter(std::vector<Vec3>& positions_m) {
  const std::size_t pad = std::min<std::size_t>(positions_m.size() - 1, 60);
  std::vector<Vec3> padded;
  for (std::size_t i = pad; i > 0; --i) padded.push_back(2.0 * positions_m.front() - positions_m[i]);
  padded.insert(padded.end(), positions_m.begin(), positions_m.end());
  for (std::size_t i = 1; i <= pad; ++i)
    padded.push_back(2.0 * positions_m.back() - positions_m[positions_m.size() - 1 - i]);
  for (int pass = 0; pass < 2; ++pass) {
    Butterworth lowPass(padded.front());
    for (Vec3& position : padded) position = lowPass.next(position);
    std::reverse(padded.begin(), padded.end());
  }
  std::copy_n(padded.begin() + static_cast<std::ptrdiff_t>(pad), positions_m.size(), positions_m.begin());
}

/// Returns the positions at 60 Hz, on straight lines between those that there are.
std::vector<Vec3> resampled(std::span<const double> times_s, std::span<const Vec3> positions_m) {
  std::vector<Vec3> even;
  const auto count = static_cast<std::size_t>((times_s.back() - times_s.front()) * kRate_Hz + 1e-6) + 1;
  even.reserve(count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t_s = times_s.front() + static_cast<double>(i) / kRate_Hz;
    while (at + 2 < times_s.size() && times_s[at + 1] <= t_s) ++at;
    const double step_s = times_s[at + 1] - times_s[at];
    const double share = step_s > 0.0 ? std::clamp((t_s - times_s[at]) / step_s, 0.0, 1.0) : 1.0;
    even.push_back(positions_m[at] + share * (positions_m[at + 1] - positions_m[at]));
  }
  return even;
}

constexpr const char* kFrames =
    "SELECT f.display_s, f.lesson_phase, f.blank, f.light_speed_m_s, v.room_x_m, v.room_y_m, v.room_z_m, "
    "v.celerity_x_m_s, v.celerity_y_m_s, v.celerity_z_m_s, v.known, v.x_m, v.y_m, v.z_m, f.head_sensor_qw, "
    "f.head_sensor_qx, f.head_sensor_qy, f.head_sensor_qz, f.board_from_room_xx, f.board_from_room_xy, "
    "f.board_from_room_xz, f.board_from_room_yx, f.board_from_room_yy, f.board_from_room_yz, "
    "f.board_from_room_zx, f.board_from_room_zy, f.board_from_room_zz FROM frame f JOIN viewer v ON v.frame "
    "= f.number WHERE f.number >= ? AND f.number < ? AND v.name = (SELECT value FROM session WHERE key = "
    "'viewer') ORDER BY f.number";

struct FrameRow {
  double display_s = 0.0;
  LessonPhase phase = LessonPhase::none;
  bool isBlank = false, isLost = false;
  double beta = 0.0;
  Vec3 head_m{}, towardsTable{}, forward{};  ///< in the room
};

FrameRow readFrame(SQLite::Statement& row, const HeadInRoom& head) {
  const auto number = [&](int column) { return row.getColumn(column).getDouble(); };
  const auto vector = [&](int column) {
    return Vec3(number(column), number(column + 1), number(column + 2));
  };
  FrameRow frame;
  frame.display_s = number(0);
  frame.phase = static_cast<LessonPhase>(row.getColumn(1).getInt());
  frame.isBlank = row.getColumn(2).getInt() != 0;
  const double u = glm::length(vector(7)) / number(3);  // celerity in units of the light speed: γβ
  frame.beta = u / std::sqrt(1.0 + u * u);
  frame.isLost = row.getColumn(10).getString() == "lost";
  frame.head_m = vector(4);
  // The columns name the row, then the column of the transform to the board; its inverse turns back.
  const glm::dmat3 boardFromRoom(number(18), number(21), number(24), number(19), number(22), number(25),
                                 number(20), number(23), number(26));
  frame.towardsTable = glm::transpose(boardFromRoom) * -vector(11);
  const glm::dquat sensor(number(14), number(15), number(16), number(17));
  frame.forward = sensor * (head.axesOfSensor * head.forward);
  return frame;
}

bool pointsAt(const Vec3& forward, const Vec3& towards) {
  const double lengths = glm::length(forward) * glm::length(towards);
  return lengths > 0.0 &&
         glm::dot(forward, towards) >= std::cos(kNear_deg * std::numbers::pi / 180.0) * lengths;
}

void addTime(LessonBehaviour& all, const FrameRow& frame, double step_s) {
  if (frame.phase == LessonPhase::asks) all.ask_s += step_s;
  if (frame.phase == LessonPhase::shows) all.show_s += step_s;
  if (frame.phase == LessonPhase::explains) all.explain_s += step_s;
  all.hasExplained = all.hasExplained || frame.phase == LessonPhase::explains;
  if (frame.isBlank) all.blank_s += step_s;
  if (frame.isLost) all.lost_s += step_s;
}

/// Adds the actions, from the tables of inputs and strokes.
void addInputs(SQLite::Database& session, std::int64_t first, std::int64_t end, LessonBehaviour& all) {
  SQLite::Statement input(
      session, "SELECT what, value FROM input WHERE frame >= ? AND frame < ? ORDER BY frame, rowid");
  input.bind(1, first);
  input.bind(2, end);
  while (input.executeStep()) {
    const std::string what = input.getColumn(0).getString(), value = input.getColumn(1).getString();
    const auto isView = [&](const NamedView& view) { return what == view.name; };
    if (std::any_of(kNamedViews.begin(), kNamedViews.end(), isView)) ++all.viewsSwitched;
    if (what != "lesson") continue;
    if (const std::size_t at = value.find("velocity "); at != std::string::npos) {
      const int velocity = std::atoi(value.c_str() + at + 9);
      if (all.velocities.empty() || all.velocities.back() != velocity) all.velocities.push_back(velocity);
    }
  }
  SQLite::Statement strokes(session, "SELECT count(*) FROM stroke WHERE frame >= ? AND frame < ?");
  strokes.bind(1, first);
  strokes.bind(2, end);
  if (strokes.executeStep()) all.strokes = strokes.getColumn(0).getInt();
}

}  // namespace

double pathLength_m(std::span<const double> times_s, std::span<const Vec3> positions_m) {
  if (times_s.size() < 2) return 0.0;
  std::vector<Vec3> even = resampled(times_s, positions_m);
  filter(even);
  double length_m = 0.0;
  for (std::size_t i = 1; i < even.size(); ++i) length_m += glm::distance(even[i - 1], even[i]);
  return length_m;
}

LessonBehaviour behaviourIn(SQLite::Database& session, std::int64_t first, std::int64_t end,
                            const HeadInRoom& head) {
  LessonBehaviour all;
  std::vector<double> times_s;
  std::vector<Vec3> heads_m;
  double total_s = 0.0, beta_s = 0.0, table_s = 0.0, panel_s = 0.0;
  SQLite::Statement row(session, kFrames);
  row.bind(1, first);
  row.bind(2, end);
  std::optional<FrameRow> before;
  while (row.executeStep()) {
    const FrameRow frame = readFrame(row, head);
    const double step_s = before ? std::max(0.0, frame.display_s - before->display_s) : 0.0;
    addTime(all, frame, step_s);
    if (before && frame.phase == LessonPhase::shows && before->phase == LessonPhase::explains) ++all.repeats;
    total_s += step_s;
    beta_s += frame.beta * step_s;
    all.betaMost = std::max(all.betaMost, frame.beta);
    if (pointsAt(frame.forward, frame.towardsTable)) table_s += step_s;
    if (head.panelMiddle_m && pointsAt(frame.forward, *head.panelMiddle_m - frame.head_m)) panel_s += step_s;
    times_s.push_back(frame.display_s);
    heads_m.push_back(frame.head_m);
    before = frame;
  }
  if (total_s > 0.0) {
    all.betaMean = beta_s / total_s;
    all.towardsTable = table_s / total_s;
    if (head.panelMiddle_m) all.towardsPanel = panel_s / total_s;
  }
  all.path_m = pathLength_m(times_s, heads_m);
  addInputs(session, first, end, all);
  return all;
}

}  // namespace carom
