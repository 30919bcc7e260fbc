#include "cave/sculpture/sculpture_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/frame/event_mark.h"
#include "cave/gl/view_colours.h"
#include "cave/sculpture/order_table.h"
#include "engine/sculpture/sculpture_reach.h"

namespace carom {
namespace {

constexpr glm::vec3 kSeenColour(1.0F), kFrameColour(0.75F, 0.80F, 0.85F);
constexpr double kThin_rad = 0.0009, kLine_rad = 0.0012, kBright_rad = 0.0018;
constexpr std::size_t kMostFlags = 12;
constexpr double kFlag_m = 0.03;  // height of a plate at a metre

/// Returns the event between two events that is this share of the way from the first.
Event between(const Event& a, const Event& b, double share) {
  return {a.t_s + (b.t_s - a.t_s) * share, a.r_m + (b.r_m - a.r_m) * share};
}

glm::vec4 colourOf(OrderOf whose) {
  switch (whose) {
    case OrderOf::interval:
      return glm::vec4(kFlashColour, 1.0F);
    case OrderOf::table:
      return glm::vec4(kBoardNowColour, 1.0F);
    case OrderOf::me:
      return glm::vec4(kMyNowColour, 1.0F);
    case OrderOf::other:
      return glm::vec4(kMyNowColour, 0.6F);
  }
  return glm::vec4(1.0F);
}

/// Adds marks that are given as events.
class Pen {
 public:
  Pen(const SculptureSight& sight, MarkBuffer& batch)
      : sight_(sight),
        batch_(batch),
        up_(sight.map.place().roomFromFoot.orientation * Vec3(0.0, 0.0, 1.0)),
        points_(sight.memory.points_m),
        run_(sight.memory.run) {}

  glm::dvec3 drawn(const Vec3& model_m) const {
    const SculpturePlace& place = sight_.map.place();
    return place.roomFromFoot * (place.scale * model_m) - sight_.viewpoint_m;
  }
  bool isWithin(const Vec3& model_m) const { return model_m.z >= 0.0 && model_m.z <= sight_.map.top_m(); }

  /// Adds a line through points of the model, without what lies below its foot and above its top.
  void model(std::span<const Vec3> points_m, const glm::vec4& colour, double halfWidth_rad) {
    run_.clear();
    for (std::size_t i = 1; i < points_m.size(); ++i) {
      Vec3 a = points_m[i - 1], b = points_m[i];
      const bool wasCut = clip(a, b);
      const bool isGone = !(a.z < b.z) && !(a.z > b.z) && !isWithin(a);
      if (isGone) {
        flush(colour, halfWidth_rad);
        continue;
      }
      if (run_.empty()) run_.push_back(drawn(a));
      run_.push_back(drawn(b));
      if (wasCut && b != points_m[i]) flush(colour, halfWidth_rad);
    }
    flush(colour, halfWidth_rad);
  }
  void line(std::span<const Event> events, const glm::vec4& colour, double halfWidth_rad,
            bool isClosed = false) {
    points_.clear();
    for (const Event& event : events) points_.push_back(sight_.map.model_m(event));
    if (isClosed && !points_.empty()) points_.push_back(points_.front());
    model(points_, colour, halfWidth_rad);
  }
  /// Adds a bead, and above it a plate if it has one.
  void bead(const Event& event, const glm::vec4& colour, double radius_m, const PlateText* text = nullptr,
            PlateShape shape = PlateShape::flag) {
    const Vec3 model_m = sight_.map.model_m(event);
    if (!isWithin(model_m)) return;
    const glm::dvec3 middle = drawn(model_m);
    batch_.addDisc(middle, radius_m, colour);
    if (text) plate(middle + up_ * (1.4 * radius_m), *text, shape, colour);
  }
  /// Adds an upright plate that faces the eye, its lower border's middle at a place, or by so many of its
  /// widths to the right of it.
  void plate(const glm::dvec3& place, const PlateText& text, PlateShape shape, const glm::vec4& colour,
             double aside = 0.0) {
    const double height_m = kFlag_m * std::clamp(glm::length(place), 0.5, 4.0);
    const glm::dvec3 across = 0.6 * height_m * placesAcross(text, shape) * rightOf(place);
    const glm::dvec3 foot = place + aside * across;
    constexpr std::size_t kAcross = 5;
    std::array<glm::dvec3, kAcross> lower, upper;
    for (std::size_t i = 0; i < kAcross; ++i) {
      lower[i] = foot + (static_cast<double>(i) / (kAcross - 1) - 0.5) * across;
      upper[i] = lower[i] + height_m * up_;
    }
    batch_.addPlate(lower, upper, text, shape, colour);
  }
  /// Adds the table of a picked event: each row is a flag and beside it a box, to the right of a place.
  void table(const OrderTable& table, const glm::dvec3& corner) {
    const double height_m = kFlag_m * std::clamp(glm::length(corner), 0.5, 4.0), place_m = 0.6 * height_m;
    const glm::dvec3 right = rightOf(corner);
    double across = 0.0;
    for (const OrderRow& row : table.all())
      across = std::max(across, placesAcross(row.who, PlateShape::flag));
    glm::dvec3 foot = corner + right * (1.5 * place_m);
    for (std::size_t i = table.count; i-- > 0; foot += up_ * (1.15 * height_m)) {
      const OrderRow& row = table.rows[i];
      const double who = placesAcross(row.who, PlateShape::flag),
                   what = placesAcross(row.what, PlateShape::box);
      const glm::vec4 colour = colourOf(row.whose);
      plate(foot + right * (place_m * (across - 0.5 * who)), row.who, PlateShape::flag, colour);
      plate(foot + right * (place_m * (across + 0.3 + 0.5 * what)), row.what, PlateShape::box, colour);
    }
  }
  void thread(const glm::dvec3& from, const glm::dvec3& to, const glm::vec4& colour) {
    const std::array<glm::dvec3, 2> ends{from, to};
    batch_.addLine(ends, colour, kLine_rad);
  }

 private:
  glm::dvec3 rightOf(const glm::dvec3& way) const {
    const glm::dvec3 right = glm::cross(way, up_);
    const double length = glm::length(right);
    return length > 0.0 ? right / length : glm::dvec3(1.0, 0.0, 0.0);
  }
  /// Cuts a segment to the heights that are shown; returns whether it was longer.
  bool clip(Vec3& a, Vec3& b) const {
    const double top_m = sight_.map.top_m();
    const Vec3 from = a, way = b - a;
    double begin = 0.0, end = 1.0;
    for (const auto& [z, slope] : {std::pair{from.z, way.z}, {top_m - from.z, -way.z}}) {
      if (slope == 0.0 && z < 0.0) return a = b, false;  // outside, and level
      if (slope > 0.0) begin = std::max(begin, -z / slope);
      if (slope < 0.0) end = std::min(end, -z / slope);
    }
    if (begin == 0.0 && end == 1.0) return false;
    if (begin >= end) return b = a = Vec3(0.0, 0.0, -1.0), true;
    a = from + way * begin;
    b = from + way * end;
    return true;
  }
  void flush(const glm::vec4& colour, double halfWidth_rad) {
    if (run_.size() > 1) batch_.addLine(run_, colour, halfWidth_rad);
    run_.clear();
  }

  const SculptureSight& sight_;
  MarkBuffer& batch_;
  glm::dvec3 up_;
  std::vector<Vec3>& points_;
  std::vector<glm::dvec3>& run_;
};

std::array<glm::dvec2, 5> aroundOf(const glm::dvec2& low, const glm::dvec2& high) {
  return {{low, {high.x, low.y}, high, {low.x, high.y}, low}};
}

/// Adds the border of a surface, and of the curved one some lines across it.
void addSurface(const SculptureSight& sight, std::size_t viewer, ViewTime moment, const glm::vec4& colour,
                Pen& pen) {
  const ObserverView& observer = sight.record.viewers[viewer].observer;
  const SculptureShape& shape = sight.shape;
  const std::size_t steps = moment == ViewTime::seen ? kSurfaceCells : 1;
  const auto side = [&](const glm::dvec2& from, const glm::dvec2& to, double rad, const glm::vec4& ink) {
    std::vector<Event>& events = sight.memory.events;
    events.clear();
    for (std::size_t i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(steps);
      events.push_back(surfaceEvent(observer, moment, from + (to - from) * share, shape.game().top_m));
    }
    pen.line(events, ink, rad);
  };
  const auto corners = aroundOf(shape.low_m(), shape.high_m());
  for (std::size_t i = 0; i < 4; ++i) side(corners[i], corners[i + 1], kLine_rad, colour);
  if (moment != ViewTime::seen) return;
  const glm::vec4 faint(glm::vec3(colour), 0.35F * colour.a);
  constexpr int kLines = 4;
  for (int k = 1; k < kLines; ++k) {
    const glm::dvec2 at =
        shape.low_m() + (shape.high_m() - shape.low_m()) * (static_cast<double>(k) / kLines);
    side({at.x, shape.low_m().y}, {at.x, shape.high_m().y}, kThin_rad, faint);
    side({shape.low_m().x, at.y}, {shape.high_m().x, at.y}, kThin_rad, faint);
  }
}

/// The frame of the board's corners, with the seconds of the frame that is shown along one of them.
void addFrame(const SculptureSight& sight, Pen& pen) {
  const SculptedGame& game = sight.shape.game();
  const auto corners = aroundOf(-game.half_m, game.half_m);
  const SculptureMap& map = sight.map;
  const double now_s = map.present().t_s, reach_s = sculptureReach_s(map.place(), map.lightSpeed_m_s());
  const glm::vec4 colour(kFrameColour, 0.6F);
  std::size_t nearest = 0;
  double least_m = 1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array<Event, 2> ends{Event{now_s - reach_s, {corners[i], game.top_m}},
                                    Event{now_s + reach_s, {corners[i], game.top_m}}};
    pen.line(ends, colour, kThin_rad);
    const double away_m = glm::length(pen.drawn(map.model_m({now_s, ends[0].r_m})));
    if (away_m < least_m) least_m = away_m, nearest = i;
  }
  // The board at the foot and at the top, where the frame that is shown has them level.
  for (const double height_m : {0.0, map.top_m()}) {
    std::array<Vec3, 5> around;
    for (std::size_t i = 0; i < 5; ++i) {
      const Vec3 now_m = map.model_m({now_s, {corners[i], game.top_m}});
      const Vec3 later_m = map.model_m({now_s + 1.0, {corners[i], game.top_m}});
      around[i] = now_m + (later_m - now_m) * ((height_m - now_m.z) / (later_m.z - now_m.z));
    }
    pen.model(around, colour, kThin_rad);
  }
  const Vec3 now_m = map.model_m({now_s, {corners[nearest], game.top_m}});
  const Vec3 way_m = map.model_m({now_s + 1.0, {corners[nearest], game.top_m}}) - now_m;
  const double second_m = map.lightSpeed_m_s();
  const int first = -static_cast<int>(map.present_m() / second_m),
            last = static_cast<int>((map.top_m() - map.present_m()) / second_m);
  for (int second = std::max(first, -60); second <= std::min(last, 60); ++second) {
    const double height_m = map.present_m() + second * second_m;
    const Vec3 at_m = now_m + way_m * ((height_m - now_m.z) / way_m.z);
    pen.plate(pen.drawn(at_m), tenthsOf(second), PlateShape::box, glm::vec4(kFrameColour, 0.9F), -0.6);
  }
}

/// The ring at the height of the present, by which a hand boosts it, and the velocity of the frame that is
/// shown: an arrow that reaches the ring at the speed of light.
void addRing(const SculptureSight& sight, Pen& pen) {
  constexpr std::size_t kParts = 64;
  const glm::vec4 colour(kMotionColour, sight.record.sculpture.held ? 1.0F : 0.8F);
  std::array<Vec3, kParts + 1> ring;
  for (std::size_t i = 0; i <= kParts; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / kParts;
    ring[i] = kSculptureRing_m * Vec3(std::cos(angle), std::sin(angle), 0.0);
    ring[i].z = sight.map.present_m();
  }
  pen.model(ring, colour, kBright_rad);
  const Vec3 beta = sight.map.place().beta;
  const double speed = glm::length(beta);
  if (!(speed > 0.0)) return;
  const Vec3 middle(0.0, 0.0, sight.map.present_m()), tip = middle + kSculptureRing_m * beta;
  const Vec3 back = beta * (-0.15 / speed), aside(-0.5 * back.y, 0.5 * back.x, 0.0);
  const std::array<Vec3, 5> arrow{middle, tip, tip + back + aside, tip + back - aside, tip};
  pen.model(arrow, colour, kBright_rad);
}

/// A viewer's own line, with a tick for each second of their own time.
void addOwnLine(const SculptureSight& sight, std::size_t viewer, const glm::vec4& colour, Pen& pen) {
  const std::span<const OwnEvent> line = sight.lines.of(viewer);
  const double top_m = sight.shape.game().top_m;
  const auto flat = [&](Event event) { return event.r_m.z = top_m, event; };
  std::vector<Event>& events = sight.memory.events;
  events.clear();
  for (const OwnEvent& own : line) events.push_back(flat(own.event));
  pen.line(events, colour, kLine_rad);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const OwnEvent &a = line[i - 1], &b = line[i];
    const double second = std::floor(b.properTime_s);
    if (!(second > a.properTime_s)) continue;
    const double share = (second - a.properTime_s) / (b.properTime_s - a.properTime_s);
    pen.bead(flat(between(a.event, b.event, share)), colour, 0.006);
  }
  if (!line.empty()) pen.bead(flat(line.back().event), colour, 0.014);
}

/// The light of a stroke or a flash, from where it enters the plane of the tops.
void addLight(const SculptureSight& sight, const GameEvent& event, Pen& pen) {
  const double top_m = sight.shape.game().top_m, c_m_s = sight.map.lightSpeed_m_s();
  const glm::vec4 colour(kFlashColour, 0.9F);
  if (event.kind == EventKind::stroke && event.turns.size() > 0) {
    const Event arrival = event.turns.begin()->event;
    const double above_m = event.at.r_m.z - top_m, way_m = event.at.r_m.z - arrival.r_m.z;
    const double enters = above_m > 0.0 && way_m > 0.0 ? std::min(1.0, above_m / way_m) : 0.0;
    const std::array<Event, 2> ends{between(event.at, arrival, enters), arrival};
    return pen.line(ends, colour, kLine_rad);
  }
  if (event.kind != EventKind::flash) return;
  constexpr int kRods = 8, kSteps = 8;
  constexpr double kReach_m = 0.3;
  const double above_m = std::abs(event.at.r_m.z - top_m);
  for (int rod = 0; rod < kRods; ++rod) {
    const double angle = 2.0 * std::numbers::pi * rod / kRods;
    std::array<Event, kSteps + 1> path;
    for (int step = 0; step <= kSteps; ++step) {
      const double rho_m = kReach_m * step / kSteps;
      path[static_cast<std::size_t>(step)] = {
          event.at.t_s + std::hypot(above_m, rho_m) / c_m_s,
          {event.at.r_m.x + rho_m * std::cos(angle), event.at.r_m.y + rho_m * std::sin(angle), top_m}};
    }
    pen.line(path, colour, kThin_rad);
  }
}

/// The future and the past cone of an event, as rays and a ring at each end.
void addDoubleCone(const SculptureSight& sight, Event event, Pen& pen) {
  const double top_m = sight.shape.game().top_m, c_m_s = sight.map.lightSpeed_m_s();
  event.r_m.z = top_m;
  constexpr int kRays = 24;
  const double reach_m = 0.6 * glm::length(sight.shape.game().half_m);
  const glm::vec4 colour(kFlashColour, 0.45F);
  for (const double direction : {-1.0, 1.0}) {
    std::array<Event, kRays + 1> ring;
    for (int ray = 0; ray <= kRays; ++ray) {
      const double angle = 2.0 * std::numbers::pi * ray / kRays;
      ring[static_cast<std::size_t>(ray)] =
          event + Displacement{direction * reach_m / c_m_s,
                               {reach_m * std::cos(angle), reach_m * std::sin(angle), 0.0}};
      const std::array<Event, 2> ends{event, ring[static_cast<std::size_t>(ray)]};
      pen.line(ends, colour, kThin_rad);
    }
    pen.line(ring, colour, kLine_rad);
  }
}

void addEventBeads(const SculptureSight& sight, Pen& pen) {
  constexpr double kBead_m = 0.012;
  std::size_t flags = 0;
  for (auto event = sight.events.rbegin(); event != sight.events.rend(); ++event) {
    Event at = event->at;
    at.r_m.z = sight.shape.game().top_m;
    if (!(sight.map.model_m(at).z >= 0.0)) continue;
    addLight(sight, *event, pen);
    const bool isPicked = sight.record.sculpture.picked == event->number + 1 ||
                          sight.record.sculpture.compared == event->number + 1;
    const bool isLight = event->kind == EventKind::flash || event->kind == EventKind::stroke;
    const glm::vec4 colour(isPicked || isLight ? kFlashColour : kEventColour, 1.0F);
    const bool hasFlag = ++flags <= kMostFlags || isPicked;
    const PlateText text = hasFlag ? plateText(eventMark(*event, sight.shape.game().flashes)) : PlateText{};
    pen.bead(at, colour, isPicked ? 1.5 * kBead_m : kBead_m, hasFlag ? &text : nullptr);
    if (isPicked) addDoubleCone(sight, at, pen);
    if (sight.record.sculpture.picked != event->number + 1) continue;
    const Vec3 model_m = sight.map.model_m(at);
    if (pen.isWithin(model_m))
      pen.table(orderTable(sight.record, sight.viewer, sight.events, sight.shape.game().flashes),
                pen.drawn(model_m));
  }
}

}  // namespace

void addSculpture(const SculptureSight& sight, MarkBuffer& batch) {
  Pen pen(sight, batch);
  addFrame(sight, pen);
  addRing(sight, pen);
  for (std::size_t person = 0; person < sight.record.viewerCount; ++person) {
    const std::size_t viewer = sight.record.ofRoom(person);
    const float strength = viewer == sight.viewer ? 1.0F : 0.45F;
    addSurface(sight, viewer, ViewTime::seen, glm::vec4(kSeenColour, 0.6F * strength), pen);
    addSurface(sight, viewer, ViewTime::myNow, glm::vec4(kMyNowColour, 0.9F * strength), pen);
    addOwnLine(sight, viewer, glm::vec4(kMyNowColour, strength), pen);
  }
  addSurface(sight, sight.record.ofRoom(0), ViewTime::boardNow, glm::vec4(kBoardNowColour, 0.9F), pen);
  for (const TubeCut& cut : sight.shape.cuts()) {
    const float strength = cut.viewer == sight.viewer ? 1.0F : 0.5F;
    const glm::vec3 colour = cut.moment == ViewTime::seen    ? kSeenColour
                             : cut.moment == ViewTime::myNow ? kMyNowColour
                                                             : kBoardNowColour;
    pen.line(cut.events, glm::vec4(colour, strength), cut.moment == ViewTime::seen ? kBright_rad : kLine_rad,
             true);
  }
  addEventBeads(sight, pen);
}

void addThread(const SculptureSight& sight, const TubeCut& cut, const glm::dvec3& drawn_m,
               MarkBuffer& batch) {
  if (cut.events.empty()) return;
  Vec3 sum_m(0.0);
  for (const Event& event : cut.events) sum_m += sight.map.model_m(event);
  const Vec3 middle_m = sum_m / static_cast<double>(cut.events.size());
  Pen pen(sight, batch);
  if (!pen.isWithin(middle_m)) return;
  pen.thread(pen.drawn(middle_m), drawn_m, glm::vec4(kSeenColour, 0.55F));
}

}  // namespace carom
