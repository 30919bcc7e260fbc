// What the sentences of the shipped lessons claim is in their pictures: each thing that a sentence names is
// on the wall, uncovered, large enough, at the place that other equations give (lesson_sight.h), in its
// colour; plates say the number that is computed here; and what the sentence says of them holds there.
//
// In 600 lines all lessons are looked at, and in 1080 those with the most plates; all with CAROM_LESSONS=1.
// With CAROM_LESSON=NAME that one alone; with CAROM_LESSON_PICTURES=FOLDER the pictures are kept.
#include <cstdlib>
#include <filesystem>

#include "app/stage/lesson_check.h"
#include "engine/colour/doppler_colour.h"

namespace carom {
namespace {

using test::LessonCheck;
using test::LessonMoment;
using test::PlateWanted;

/// A sentence, or a part of it, and what must be seen while it stands on the wall.
struct Claim {
  const char* lesson;
  LessonPhase phase;
  const char* says;
  void (*holds)(const LessonCheck&);
};

constexpr LessonPhase kShows = LessonPhase::shows, kExplains = LessonPhase::explains;

std::string speed(double beta) { return fmt::format("speed {:.2f} c", beta); }

/// The speed with which a puck is seen to move, over c: from two moments of an eye at rest.
double apparent(const LessonCheck& check, const std::string& body) {
  constexpr double kApart_s = 1e-4;
  const WorldLine& line = check.moment.line(body);
  const auto seenAt = [&](double t_s) {
    double early_s = t_s - 40.0, late_s = t_s;
    for (int i = 0; i < 80; ++i) {
      const double middle_s = 0.5 * (early_s + late_s);
      const Vec3 at_m = line.at(middle_s).event.r_m;
      const bool isBefore = check.moment.c_m_s() * (t_s - middle_s) > glm::distance(at_m, check.eye.at().r_m);
      (isBefore ? early_s : late_s) = middle_s;
    }
    return line.at(early_s).event.r_m;
  };
  const double t_s = check.eye.at().t_s;
  return glm::distance(seenAt(t_s + kApart_s), seenAt(t_s - kApart_s)) /
         (2.0 * kApart_s * check.moment.c_m_s());
}

void comesAndGoes(const LessonCheck& check) {
  check.puck("white");
  check.gauge("white", fmt::format("looks {:.2f} c", apparent(check, "white")));
}

/// The table's time of what is simultaneous with an event, for the observer: t + β·Δr/c.
double simultaneous_s(const LessonCheck& check, const Event& with, double x_m) {
  return with.t_s + check.eye.beta().x * (x_m - with.r_m.x) / check.moment.c_m_s();
}

PlateWanted clockOn(const LessonCheck& check, const Event& with, double x_m) {
  return {Vec3(x_m, with.r_m.y, 0.07), fmt::format("{:.2f}", simultaneous_s(check, with, x_m)),
          PlateShape::clock};
}

void seenAtOnceExplains(const LessonCheck& check) {
  check.puck("left lamp");
  check.puck("right lamp");
  const Event right = check.moment.flash("right flash"), left = check.moment.flash("left flash");
  for (const double x_m : {-0.7, -0.35, 0.0, 0.35, 0.7}) check.plate(clockOn(check, right, x_m));
  check.stopwatch("Right to left flash, your frame",
                  check.eye.gamma() * check.eye.beta().x * (right.r_m.x - left.r_m.x) / check.moment.c_m_s());
}

void seenAtOnceShows(const LessonCheck& check) {
  check.puck("left lamp");
  check.puck("right lamp");
}

/// How long a thing looks along its motion, over its length at rest: light of its two ends, a millimetre
/// from its middle each, arrives together.
double seenLength(const LessonCheck& check, const std::string& body) {
  constexpr double kHalf_m = 1e-3;
  const WorldLine& line = check.moment.line(body);
  const auto endAt_m = [&](double half_m) {
    const Vec3 offset_m(half_m, 0.0, 0.0);
    const Motion motion = check.eye.emitting(line, offset_m);
    return motion.event.r_m + test::LessonEye::contracted(motion, offset_m);
  };
  return glm::distance(endAt_m(kHalf_m), endAt_m(-kHalf_m)) / (2.0 * kHalf_m);
}

void seenLengths(const LessonCheck& check) {
  for (const char* body : {"moving", "at rest"}) {
    check.puck(body);
    check.gauge(body, fmt::format("length {:.2f}", seenLength(check, body)));
  }
  for (const ClothLine& line : check.moment.plan().lines) check.clothLine(line);
}

void parallelTracks(const LessonCheck& check) {
  for (const char* body : {"slow", "walking", "brisk", "fast", "fastest"}) check.puck(body);
  check.clothLine(check.moment.plan().lines.at(0));
  // The slowest is seen on the line, the others before it, the farther the later.
  double last_m = 0.02;
  for (const char* body : {"slow", "walking", "brisk", "fast", "fastest"}) {
    const double x_m = check.eye.emitting(check.moment.line(body)).event.r_m.x;
    EXPECT_LT(x_m, last_m) << body;
    last_m = x_m;
  }
  EXPECT_NEAR(last_m, -0.72, 0.005);
}

void parallelTracksShows(const LessonCheck& check) {
  parallelTracks(check);
  for (const char* body : {"slow", "walking", "brisk"}) check.ghost(body, false);
}

void parallelTracksExplains(const LessonCheck& check) {
  parallelTracks(check);
  check.stopwatch("Light's travel time: near lane", 1.07);
  check.stopwatch("far lane", 1.55);
}

double speedSeen(const LessonCheck& check, const std::string& body) {
  return check.eye.speedOf(check.eye.emitting(check.moment.line(body)));
}

void sameLaws(const LessonCheck& check) {
  for (const char* body : {"white", "red"}) {
    check.puck(body);
    check.gauge(body, speed(speedSeen(check, body)));
  }
}

/// Plates with the table's times of what is simultaneous with the right hit, where the ghosts are.
void twoCushionsExplains(const LessonCheck& check) {
  const Event right = check.moment.flash("right hit"), left = check.moment.flash("left hit");
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    PlateWanted wanted = clockOn(check, right, glm::mix(-1.42, 1.42, share));
    wanted.at_s = simultaneous_s(check, right, wanted.foot_m.x);
    check.plate(wanted);
  }
  check.ghost("white", true);
  check.ghost("red", true);
  check.stopwatch("From the right hit to the left hit, in your frame",
                  check.eye.gamma() * check.eye.beta().x * (right.r_m.x - left.r_m.x) / check.moment.c_m_s());
  // The right ghost touches its cushion, the left one does not.
  const auto gap_px = [&](const char* puck, double way, const char* cushion) {
    return glm::distance(check.eye.forMeNow(check.moment.line(puck), {way * 0.12, 0.0, 0.0}),
                         check.eye.forMeNow(check.moment.line(cushion), {-way * 0.02, way * 0.25, 0.0}));
  };
  EXPECT_LT(gap_px("white", 1.0, "right cushion"), 0.01 * check.picture.size_px.y);
  EXPECT_GT(gap_px("red", -1.0, "left cushion"), LessonCheck::kLeastThing * check.picture.size_px.y);
}

void twoCushionsShows(const LessonCheck& check) {
  check.ghost("white", true);
  check.ghost("red", true);
}

void barsMeet(const LessonCheck& check) {
  for (const char* bar : {"near bar", "far bar"}) check.ghostBar(bar, 0.4, 0.015);
  const auto apart_px = [&](double x_m) {
    return glm::distance(check.eye.forMeNow(check.moment.line("near bar"), {x_m, 0.015, 0.015}),
                         check.eye.forMeNow(check.moment.line("far bar"), {x_m, -0.015, 0.015}));
  };
  EXPECT_LT(apart_px(0.4), 0.01 * check.picture.size_px.y) << "the right ends touch";
  EXPECT_GT(apart_px(-0.4), 0.5 * LessonCheck::kLeastThing * check.picture.size_px.y)
      << "the left ones do not";
  check.stopwatch("From right ends to left ends, in your frame",
                  check.eye.gamma() * check.eye.beta().x * 0.8 / check.moment.c_m_s());
}

void barsShow(const LessonCheck& check) {
  for (const char* bar : {"near bar", "far bar"}) check.ghostBar(bar, 0.4, 0.015);
}

void cause(const LessonCheck& check) {
  for (const char* puck : {"white", "yellow", "red"}) check.puck(puck);
  for (const char* letter : {"A", "B", "C"}) check.label(letter);
  check.ring("A", lightOf(glm::vec3(0.64F, 0.62F, 0.57F)));
  // The ring is where c (t − t_A) from A is: beyond B, short of C.
  const double reach_m = check.moment.c_m_s() * (check.moment.moment_s() - check.moment.flash("A").t_s);
  const Vec3 a_m = check.moment.flash("A").r_m;
  EXPECT_GT(reach_m, glm::distance(a_m, check.moment.flash("B").r_m) + 0.08) << "beyond the puck";
  EXPECT_LT(reach_m, glm::distance(a_m, check.moment.flash("C").r_m) - 0.08) << "short of the puck";
}

void causeExplains(const LessonCheck& check) {
  cause(check);
  const auto elapsed_s = [&](const char* to) {
    const Event a = check.moment.flash("A"), b = check.moment.flash(to);
    return check.eye.gamma() *
           (b.t_s - a.t_s - check.eye.beta().x * (b.r_m.x - a.r_m.x) / check.moment.c_m_s());
  };
  check.stopwatch("From A to B, your frame", elapsed_s("B"));
  check.stopwatch("From A to C, your frame", elapsed_s("C"));
}

void oneSpacetime(const LessonCheck& check) {
  for (const char* puck : {"white", "yellow", "red"}) check.puck(puck);
}

/// The beads of the flashes stand beside the game: in the glass, time is up, c Δt as high as c Δt is long.
void oneSpacetimeShows(const LessonCheck& check) {
  oneSpacetime(check);
  const SpacetimeSetup setup = check.moment.scenario.spacetime.value();
  const double present_m = 0.8 * setup.height_m;
  for (const char* flash : {"A", "B", "C"}) {
    const Event at = check.moment.flash(flash);
    const double up_m = present_m + setup.scale * check.moment.c_m_s() * (at.t_s - check.moment.moment_s());
    const Vec3 room_m = setup.place_m.value() + Vec3(setup.scale * at.r_m.x, up_m, -setup.scale * at.r_m.y);
    // From the room's axes to those of an observer at rest who faces +y.
    const glm::dvec2 at_px = check.eye.pixelIn({room_m.x, -room_m.z, room_m.y - test::kEyes_m});
    check.onWall(at_px, fmt::format("bead {}", flash));
    check.isThere(std::array{at_px}, {}, kFlashColour, fmt::format("bead {}", flash), 1.0);
  }
}

void lightClocks(const LessonCheck& check) {
  check.gauge("resting clock", "5");
  check.gauge("flying clock", "4");
}

void twins(const LessonCheck& check) {
  check.puck("home");
  check.isWritten("8.00 s");
  check.isWritten("10.32 s");
  check.isWritten("9.25 s");
}

void walkers(const LessonCheck& check) { check.isWritten("A clock that stands"); }

void pairs(const LessonCheck& check) {
  for (const char* puck : {"left 1", "right 1"}) {
    check.puck(puck);
    check.gauge(puck, speed(speedSeen(check, puck)));
  }
}

void angles(const LessonCheck& check) {
  for (const char* puck : {"slow", "struck slowly", "fast", "struck fast"}) check.puck(puck);
}

std::string gammaSeen(const LessonCheck& check, const std::string& body) {
  const double beta = speedSeen(check, body);
  return fmt::format("γ {:.2f}", 1.0 / std::sqrt(1.0 - beta * beta));
}

/// Both pucks have met and glow by their heat, a quarter of their rest energy, which outshines their colours.
void massEnergy(const LessonCheck& check) {
  const glm::vec3 glow = colour_kernel::seenGlow(0.25F, 1.0F, false, false);
  for (const char* puck : {"white", "red"}) {
    check.puck(puck, codeOf(glow / glow.r));
    check.gauge(puck, gammaSeen(check, puck));
  }
  if (check.moment.phase == kExplains) check.label("hot: 2.5 M");
}

void heavier(const LessonCheck& check) {
  for (const char* puck : {"resting", "half", "fast", "fastest"}) {
    check.puck(puck);
    check.gauge(puck, gammaSeen(check, puck));
  }
}

/// Where a point of the wheel is seen: in the hub's rest frame it runs around the hub, by
///   t = γ (t' + β x'/c), x = x_0 + γ (x' + β c t'), y = y_0 + y'
/// on the board, and its light arrives now, by bisection.
glm::dvec2 onWheel_px(const LessonCheck& check, double radius_m, double angle_rad, double up_m) {
  const Puck& hub = check.moment.scenario.billiard.pucks.at(0);
  const double omega_rad_s = check.moment.line("wheel").knots().front().spin.omega_rad_s;
  const double c_m_s = check.moment.c_m_s(), beta = hub.beta.x, gamma = 1.0 / std::sqrt(1.0 - beta * beta);
  const auto eventAt = [&](double hub_s) {
    const double angle = angle_rad + omega_rad_s * hub_s;
    const double x_m = radius_m * std::cos(angle), y_m = radius_m * std::sin(angle);
    return Event{gamma * (hub_s + beta * x_m / c_m_s),
                 {hub.position_m.x + gamma * (x_m + beta * c_m_s * hub_s), hub.position_m.y + y_m,
                  0.5 * hub.height_m + up_m}};
  };
  double early_s = -10.0, late_s = check.eye.at().t_s;
  for (int i = 0; i < 80; ++i) {
    const double middle_s = 0.5 * (early_s + late_s);
    const Event at = eventAt(middle_s);
    const bool isBefore = c_m_s * (check.eye.at().t_s - at.t_s) > glm::distance(at.r_m, check.eye.at().r_m);
    (isBefore ? early_s : late_s) = middle_s;
  }
  return check.eye.seen(eventAt(early_s).r_m);
}

/// The spokes are seen, in turn in the wheel's colour and pale, and the rim beyond each the other way round;
/// some are bent: their middles are beside the straight line between their ends.
void wheel(const LessonCheck& check) {
  check.isLarge(check.rim_px("wheel", 1.0), "wheel");
  const glm::vec3 own = codeOf(colourOf("wheel", 0)), pale = codeOf(glm::vec3(0.75F));
  constexpr double kSpoke_m = 0.008, kRim_m = 0.015;  // heights of their upper faces, from the middle
  double most_px = 0.0;
  for (int k = 0; k < 8; ++k) {
    const auto at = [&](double radius_m) {
      const bool isRim = radius_m > 0.222;
      const double up_m = isRim ? kRim_m : k == 2 ? 0.012 : kSpoke_m;  // the wedge is thicker
      return onWheel_px(check, radius_m, std::numbers::pi * k / 4.0, up_m);
    };
    const std::array spoke_px{at(0.10), at(0.13), at(0.16)};
    const std::array rim_px{at(0.232), at(0.236), at(0.240)};
    check.isThere(spoke_px, rim_px, k % 2 == 0 ? own : pale, fmt::format("spoke {}", k));
    check.isThere(rim_px, spoke_px, k % 2 == 0 ? pale : own, fmt::format("rim beyond spoke {}", k));
    const glm::dvec2 along = glm::normalize(at(0.2) - at(0.04)), aside = at(0.12) - at(0.04);
    most_px = std::max(most_px, std::abs(along.x * aside.y - along.y * aside.x));
  }
  EXPECT_GT(most_px, 0.01 * check.picture.size_px.y) << "no spoke is seen bent";
}

/// A clock on the rim at an angle of the disc: where its light left it, and what it showed then, by bisection
/// on a circle.
std::pair<Vec3, double> rimClock(const LessonCheck& check, double angle_rad, double up_m) {
  const Puck& disc = check.moment.scenario.billiard.pucks.at(0);
  const double omega_rad_s = check.moment.line("turning").knots().front().spin.omega_rad_s;
  const double beta = omega_rad_s * disc.radius_m / check.moment.c_m_s();
  const auto at_m = [&](double t_s) {
    const double angle = angle_rad + omega_rad_s * t_s;
    return Vec3(disc.position_m, 0.0) + disc.radius_m * Vec3(std::cos(angle), std::sin(angle), 0.0) +
           Vec3(0.0, 0.0, 0.5 * disc.height_m + up_m);
  };
  double early_s = 0.0, late_s = check.eye.at().t_s;
  for (int i = 0; i < 80; ++i) {
    const double middle_s = 0.5 * (early_s + late_s);
    const bool isBefore = check.moment.c_m_s() * (check.eye.at().t_s - middle_s) >
                          glm::distance(at_m(middle_s), check.eye.at().r_m);
    (isBefore ? early_s : late_s) = middle_s;
  }
  return {at_m(early_s), early_s * std::sqrt(1.0 - beta * beta)};
}

std::string tenths(double t_s) { return fmt::format("{:.1f}", std::floor(10.0 * t_s) / 10.0); }

void spinningDisc(const LessonCheck& check) {
  check.puck("turning");
  check.puck("at rest");
  const Vec3 middle_m = check.eye.emitting(check.moment.line("turning")).event.r_m;
  for (int k = 0; k < 6; ++k) {
    // The plate's light left its foot, 5 cm above the rim, at another time than the clock's.
    const double angle_rad = std::numbers::pi * k / 3.0;
    check.plate({rimClock(check, angle_rad, 0.05).first, tenths(rimClock(check, angle_rad, 0.0).second),
                 PlateShape::clock, 1.0, middle_m});
  }
}

/// A soft body's upper face at a place of the board, and the colour of its strain there.
constexpr glm::vec3 kPressed(0.35F, 0.45F, 0.9F), kRelaxed(0.75F, 0.74F, 0.72F),
    kStretched(1.0F, 0.3F, 0.15F);

void strained(const LessonCheck& check, double x_m, double y_m, const glm::vec3& strain,
              const std::string& what) {
  std::vector<glm::dvec2> places;
  for (int i = -2; i <= 2; ++i) places.push_back(check.eye.seen({x_m + 0.004 * i, y_m + 0.006 * i, 0.04}));
  for (const glm::dvec2& at_px : places) check.onWall(at_px, what);
  check.isThere(places, {}, strain, what);
}

/// The pushed ends are pressed, the other ends rest and have not heard of it.
void rodsShow(const LessonCheck& check) {
  strained(check, -0.45, 0.25, kPressed, "left end, behind");
  strained(check, 0.03, 0.25, kRelaxed, "right end, behind");
  strained(check, -0.42, -0.25, kPressed, "left end, in front");
  strained(check, 0.07, -0.2, kRelaxed, "right end, in front");
}

/// The shock runs slower than light: by ℓ/v, with v from the file's own flashes.
void rods(const LessonCheck& check) {
  rodsShow(check);
  for (const char* rod : {"behind", "in front"}) {
    const Event from = check.moment.flash(fmt::format("push, {}", rod)),
                to = check.moment.flash(fmt::format("start, {}", rod));
    EXPECT_GT(check.moment.c_m_s() * (to.t_s - from.t_s), glm::distance(to.r_m, from.r_m))
        << "slower than light";
    check.isWritten(fmt::format("{:.2f} s", to.t_s - from.t_s));
  }
}

void string(const LessonCheck& check) {
  strained(check, -0.72, 0.0, kPressed, "rear");
  strained(check, -0.52, 0.0, kRelaxed, "middle");
  strained(check, -0.1, 0.0, kStretched, "front");
}
void softAndRigid(const LessonCheck& check) {
  check.puck("rigid");
  check.gauge("rigid", speed(speedSeen(check, "rigid")));
}
/// Both doors of the tunnel are shut: each leaf stands as a ghost in its half of the opening.
void doorsShut(const LessonCheck& check) {
  for (const char* door : {"near door", "far door"}) {
    for (const double side : {1.0, -1.0}) {
      const std::string leaf = fmt::format("{}, {}", door, side > 0.0 ? "left" : "right");
      const double gap_m = std::abs(check.moment.line(leaf).at(check.eye.at().t_s).event.r_m.y);
      EXPECT_LT(gap_m, 1e-3) << leaf << " is shut";
      for (const double up_m : {0.05, 0.15})
        check.onWall(check.eye.onBoardNow(check.moment.line(leaf), {0.0, side * 0.07, up_m}), leaf);
    }
  }
}

/// The ghost of the train is as long as its contracted length, and stands between the doors.
void trainInTunnel(const LessonCheck& check) {
  const WorldLine& line = check.moment.line("train");
  std::vector<glm::dvec2> roof, ground;
  for (int i = -10; i <= 10; ++i) roof.push_back(check.eye.onBoardNow(line, {0.07 * i, -0.02, 0.06}));
  for (int i = -10; i <= 10; ++i) ground.push_back(check.eye.seen({0.05 * i, -0.25, 0.0}));
  check.isLarge(roof, "train");
  check.isTinted(roof, ground, kBoardNowColour, "ghost of the train");
  const auto end_m = [&](double way) {
    const Motion now = line.at(check.eye.at().t_s);
    return (now.event.r_m + test::LessonEye::contracted(now, {way * 0.75, 0.0, 0.0})).x;
  };
  EXPECT_NEAR(end_m(1.0) - end_m(-1.0), 0.9, 1e-9);
  EXPECT_LT(end_m(1.0), 0.5) << "before the far door";
  EXPECT_GT(end_m(-1.0), -0.5) << "behind the near door";
}

void trainShows(const LessonCheck& check) {
  trainInTunnel(check);
  doorsShut(check);
}

void trainExplains(const LessonCheck& check) {
  trainShows(check);
  check.stopwatch("train's frame", (5.0 / 3.0) * 0.8 * 1.0 / check.moment.c_m_s());
}

/// The ghost of the tunnel is 0.6 of its length, and shorter than the train.
void trainAboard(const LessonCheck& check) {
  const auto end_px = [&](const char* body, double x_m) {
    return check.eye.forMeNow(check.moment.line(body), {x_m, 0.0, 0.0});
  };
  for (const double x_m : {-0.75, 0.75}) check.onWall(end_px("train", x_m), "train");
  for (const double x_m : {-0.5, 0.5}) check.onWall(end_px("tunnel", x_m), "tunnel");
  std::vector<glm::dvec2> portals, ground;
  for (const double x_m : {-0.5, 0.5})
    for (const double up_m : {0.04, 0.08, 0.12})
      portals.push_back(check.eye.forMeNow(check.moment.line("tunnel"), {x_m, -0.12, up_m}));
  for (int i = -5; i <= 5; ++i)
    ground.push_back(check.eye.forMeNow(check.moment.line("tunnel"), {0.1 * i, -0.35, 0.0}));
  check.isTinted(portals, ground, kMyNowColour, "ghost of the tunnel");
  EXPECT_LT(glm::distance(end_px("tunnel", 0.5), end_px("tunnel", -0.5)),
            0.7 * glm::distance(end_px("train", 0.75), end_px("train", -0.75)));
}

void trainAboardExplains(const LessonCheck& check) {
  trainAboard(check);
  check.stopwatch("Far door opens → near door shuts: for you",
                  (5.0 / 3.0) * 0.8 * 1.0 / check.moment.c_m_s());
}

const std::vector<Claim> kClaims{
    {"comes-and-goes", kShows, "Read the plate", comesAndGoes},
    {"comes-and-goes", kExplains, "Its plate: 1.22 c", comesAndGoes},
    {"seen-at-once", kShows, "Watch the light", seenAtOnceShows},
    {"seen-at-once", kExplains, "0.81 s earlier", seenAtOnceExplains},
    {"seen-length", kShows, "Compare the moving puck with the one at rest between the yellow lines",
     seenLengths},
    {"seen-length", kExplains, "1.80 and 1.00", seenLengths},
    {"parallel-tracks", kShows, "yellow line", parallelTracksShows},
    {"parallel-tracks", kExplains, "0.72 m before the line", parallelTracksExplains},
    {"same-laws", kShows, "white strike red", sameLaws},
    {"same-laws", kExplains, "white moves at 0.60 c and red at 0.00 c (plates", sameLaws},
    {"two-cushions", kShows, "pink ghosts", twoCushionsShows},
    {"two-cushions", kExplains, "Its ghost touches the cushion, the left one not yet", twoCushionsExplains},
    {"bar-meets-bar", kShows, "pink ghosts", barsShow},
    {"bar-meets-bar", kExplains, "the right ends of the ghosts touch, the left ones not yet", barsMeet},
    {"cause", kShows, "Has A's ring passed B when B's starts", cause},
    {"cause", kExplains, "A's ring has passed it, but is still short of C", causeExplains},
    {"one-spacetime", kShows, "beads of the flashes", oneSpacetimeShows},
    {"one-spacetime", kExplains, "0.43 s before A", oneSpacetime},
    {"light-clock", kShows, "plates count the ticks", lightClocks},
    {"light-clock", kExplains, "5 ticks of 0.60 s, 4 of 0.75 s", lightClocks},
    {"twins", kShows, "clock at home", twins},
    {"twins", kExplains, "10.32 s at home, 8.00 s for you", twins},
    {"twins-in-one-room", kShows, "clocks below", walkers},
    {"twins-in-one-room", kExplains, "20.0 s pass for you", walkers},
    {"train-in-tunnel", kShows, "at that moment it is wholly inside", trainShows},
    {"train-in-tunnel", kExplains, "0.9 m fits into 1 m", trainExplains},
    {"train-aboard", kShows, "pink ghosts", trainAboard},
    {"train-aboard", kExplains, "0.6 m long", trainAboardExplains},
    {"pairs-4", kShows, "The plates show the speeds", pairs},
    {"pairs-4", kExplains, "0.00 c and the right one at 0.88 c", pairs},
    {"angles", kShows, "slow pair", angles},
    {"angles", kExplains, "89.7°", angles},
    {"mass-energy", kShows, "meet and stop", massEnergy},
    {"mass-energy", kExplains, "2.5 M, not 2 M", massEnergy},
    {"heavier", kShows, "plates show γ", heavier},
    {"heavier", kExplains, "γ", heavier},
    {"rolling-wheel", kShows, "The spokes look bent", wheel},
    {"rolling-wheel", kExplains, "2.30 s on the table and 1.84 s", wheel},
    {"spinning-disc", kShows, "clocks on the rim", spinningDisc},
    {"spinning-disc", kExplains, "5.8 to 6.1 s", spinningDisc},
    {"solid", kShows, "both ends", rodsShow},
    {"solid", kExplains, "0.84 s later", rods},
    {"bell-string", kShows, "two ends of the string", string},
    {"bell-string", kExplains, "stretched 1.048 times", string},
    {"soft-and-rigid", kShows, "rigid puck and of the soft one", softAndRigid},
    {"soft-and-rigid", kExplains, "The rigid one leaves at 0.6 c", softAndRigid},
};

class LessonClaims : public testing::Test {
 protected:
  void look(int lines, const std::function<bool(std::string_view)>& isChosen) {
    const Rig rig = test::deskOf(lines);
    const char* only = std::getenv("CAROM_LESSON");
    for (const std::string_view name : kLessons) {
      if (only ? name != only : !isChosen(name)) continue;
      std::optional<test::LessonStage> stage;
      for (const LessonPhase phase : {kShows, kExplains}) {
        const LessonMoment moment(rig, std::string(name), phase);
        if (!stage) stage.emplace(graphics_, rig, moment.scenario);
        const Image picture = stage->draw(moment);
        const std::string stem = fmt::format("{}-{}-{}", name, lines, phase == kShows ? "shows" : "explains");
        SCOPED_TRACE(stem);
        if (const char* folder = std::getenv("CAROM_LESSON_PICTURES"))
          writePng(picture, std::filesystem::path(folder) / (stem + ".png"));
        const LessonCheck check(moment, rig.walls.at(0), picture);
        int claims = 0;
        for (const Claim& claim : kClaims) {
          if (claim.lesson != name || claim.phase != phase) continue;
          ++claims;
          const LessonWords& words = moment.scenario.lesson->words;
          const std::string said = phase == kShows ? words.todo + " " + words.notice : words.number;
          EXPECT_NE(said.find(claim.says), std::string::npos) << claim.says << " is not said: " << said;
          claim.holds(check);
        }
        check.arrows();
        EXPECT_GT(claims, 0) << "nothing tells whether the sentences of this lesson are seen";
      }
    }
  }
  Graphics graphics_;
};

TEST_F(LessonClaims, AreSeenOn600Lines) {
  look(600, [](std::string_view) { return true; });
}

TEST_F(LessonClaims, AreSeenOn1080Lines) {
  const bool all = std::getenv("CAROM_LESSONS") != nullptr;
  look(1080, [&](std::string_view name) {
    return all || name == "cause" || name == "seen-length" || name == "spinning-disc";
  });
}

}  // namespace
}  // namespace carom
