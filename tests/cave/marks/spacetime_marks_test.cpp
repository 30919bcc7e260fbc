// Markers of events, light on its way and pucks' clocks and ways: when and where, in closed form.
#include "cave/marks/spacetime_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "cave/one_eye.h"
#include "cave/plate_words.h"
#include "engine/light/vertex_history.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
using test::observerAt;

constexpr double kFloat_m = 1e-5;  // of places a few metres away, in single precision

GameEvent flashAt(const Event& at) {
  GameEvent event;
  event.kind = EventKind::flash;
  event.at = at;
  return event;
}

struct Looked {
  MarkBuffer batch;
  double nearest_m = std::numeric_limits<double>::infinity();  ///< corner of a mark
  bool markerShown = false;                                    ///< a plate is there
};

Looked lookAt(const GameEvent& event, const Event& eye, const Lorentz& headFromBoard,
              const Switches& switches = {}) {
  const ObserverView observer = observerAt(eye, headFromBoard);
  Looked looked;
  const MarkContext sight{observer, observer.middle, switches, {}, 0, {}, {}, {&event, 1}, {}};
  LabelLayout crowd(sight);
  addEvents(sight, {}, {}, crowd, looked.batch);
  for (const MarkCorner& corner : looked.batch.corners()) {
    looked.nearest_m = std::min(looked.nearest_m, static_cast<double>(glm::length(corner.drawn_m)));
    looked.markerShown = looked.markerShown || corner.style > 0.5F;
  }
  return looked;
}

// The sphere arrives when c (t − t_e) = |r − r_e|, and at that moment the flash is seen; whoever looks. The
// eye is where two hoops of the sphere cross.
TEST(LightOfAFlash, ArrivesWhenTheFlashIsSeen) {
  test::Random random(71);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const GameEvent flash = flashAt({random.in(-5.0, 5.0), random.inBox(1.0)});
    const double distance_m = random.in(0.3, 5.0);
    const Vec3 eye_m = flash.at.r_m + distance_m * Vec3(std::sqrt(0.5), 0.0, std::sqrt(0.5));
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.9), kC_m_s);
    const double arrives_s = flash.at.t_s + distance_m / kC_m_s;
    SCOPED_TRACE(testing::Message() << "case " << i << ", " << distance_m << " m away");
    const Looked then = lookAt(flash, {arrives_s, eye_m}, headFromBoard);
    ASSERT_LT(then.nearest_m, 1e-3) << "thick as a hoop is seen";
    constexpr double kInstant_s = 1e-9;
    ASSERT_FALSE(lookAt(flash, {arrives_s - kInstant_s, eye_m}, headFromBoard).markerShown);
    ASSERT_TRUE(lookAt(flash, {arrives_s + kInstant_s, eye_m}, headFromBoard).markerShown);
    // A tenth of a second before, it is c · 0.1 s away: nothing of it nearer than Doppler's factor of that.
    const Vec3 u = headFromBoard.inverse().u();
    const double nearestScale = gammaFromU(u) - glm::length(u);
    const Looked before = lookAt(flash, {arrives_s - 0.1, eye_m}, headFromBoard);
    ASSERT_GT(before.nearest_m, 0.99 * nearestScale * 0.1 * kC_m_s);
  }
}

// For an eye at rest every corner of the sphere lies c (t − t_e) from the flash, and those of the ring on the
// cloth.
TEST(LightOfAFlash, IsSoFarFromItsPlaceAsLightHasGone) {
  const GameEvent flash = flashAt({1.0, {0.2, -0.1, 0.01}});
  const Event eye{2.0, {0.5, -3.0, 1.2}};  // not yet seen
  const Looked looked = lookAt(flash, eye, Lorentz(kC_m_s));
  ASSERT_FALSE(looked.markerShown);
  ASSERT_GT(looked.batch.corners().size(), 1000u);
  std::size_t onCloth = 0;
  for (const MarkCorner& corner : looked.batch.corners()) {
    const Vec3 place_m = eye.r_m + Vec3(corner.drawn_m);
    ASSERT_NEAR(glm::length(place_m - flash.at.r_m), kC_m_s * 1.0, 0.009)
        << "half a ring's or a hoop's width";
    onCloth += std::abs(place_m.z - 0.003) < kFloat_m ? 1 : 0;
  }
  EXPECT_GE(onCloth, 96u * 6u);
}

// The light of a flash in a puck has the puck's colour; the red one flashes here, not the blue one.
TEST(LightOfAFlash, HasTheColourOfThePuckThatFlashes) {
  const GameEvent flash = flashAt({1.0, {0.2, -0.1, 0.01}});
  const auto restsAt = [](const Vec3& place_m) {
    return WorldLine({{0.0, place_m}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.03);
  };
  const std::array<WorldLine, 3> lines{WorldLine(Knot{}, kC_m_s), restsAt({0.2, -0.1, 0.02}),
                                       restsAt({0.5, 0.0, 0.02})};
  const std::array<glm::vec3, 3> colours{glm::vec3(0.0F), {0.9F, 0.2F, 0.2F}, {0.2F, 0.2F, 0.9F}};
  const ObserverView observer = observerAt({1.5, {0.5, -3.0, 1.2}}, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {}, {}, 2, lines, {}, {&flash, 1}, {}};
  LabelLayout crowd(sight);
  MarkBuffer batch;
  addEvents(sight, colours, {}, crowd, batch);
  ASSERT_GT(batch.corners().size(), 1000u);
  for (const MarkCorner& corner : batch.corners()) ASSERT_GT(corner.colour.r, corner.colour.b);
}

TEST(EventMarkers, WithoutRetardationAreThereWhenItHappens) {
  GameEvent event = flashAt({3.0, {1.0, 0.0, 0.0}});
  event.kind = EventKind::puckPuck;
  const Vec3 eye_m(0.0, -2.0, 1.0);
  const Switches now{0, 1, 1};
  EXPECT_FALSE(lookAt(event, {2.999, eye_m}, Lorentz(kC_m_s), now).markerShown);
  EXPECT_TRUE(lookAt(event, {3.001, eye_m}, Lorentz(kC_m_s), now).markerShown);
  EXPECT_FALSE(lookAt(event, {3.001, eye_m}, Lorentz(kC_m_s)).markerShown);
  EXPECT_FALSE(lookAt(event, {3.001 + kEventShown_s, eye_m}, Lorentz(kC_m_s), now).markerShown)
      << "it has faded";
}

/// The numbers on the flags, from the one drawn first.
std::vector<int> flagsOf(const MarkBuffer& batch) {
  std::vector<int> numbers;
  for (const MarkCorner& corner : batch.corners()) {
    if (corner.style < 0.5F) continue;
    const int number = std::stoi(test::plateWords(corner));
    if ((numbers.empty() || numbers.back() != number)) numbers.push_back(number);
  }
  return numbers;
}

// Twelve events around an eye, in an order of numbers that is not that of their light.
TEST(EventMarkers, OnlyTheLatestSeenStayAndTheOlderAreFainter) {
  std::vector<GameEvent> events;
  for (int i = 0; i < 9; ++i) {
    GameEvent event = flashAt({1.0, {0.3 + 0.3 * ((4 * i) % 9), 0.2 * i, 0.0}});
    event.kind = EventKind::puckCushion;
    event.number = static_cast<std::uint64_t>(i);
    events.push_back(event);
  }
  const ObserverView observer = observerAt({4.0, Vec3(0.0)}, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, events, {}};
  LabelLayout crowd(sight);
  MarkBuffer batch;
  addEvents(sight, {}, {}, crowd, batch);
  std::sort(events.begin(), events.end(), [](const GameEvent& a, const GameEvent& b) {
    return glm::length(a.at.r_m) > glm::length(b.at.r_m);  // the furthest is seen last
  });
  const std::vector<int> shown = flagsOf(batch);
  ASSERT_EQ(shown.size(), kMostMarkers);
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_EQ(shown[i], static_cast<int>(events[i].number));
  float faintest = 1.0F;
  for (const MarkCorner& corner : batch.corners()) {
    if (corner.style < 0.5F) continue;
    EXPECT_LE(corner.colour.a, faintest);
    faintest = corner.colour.a;
  }
  EXPECT_LT(faintest, 0.3F);
}

// Plates at one place, as seen from between the eyes, stand one above the other.
TEST(LabelLayout, KeepsPlatesApart) {
  test::Random random(75);
  const ObserverView observer = observerAt({0.0, {0.0, -2.0, 1.0}}, Lorentz(kC_m_s));
  const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, {}, {}};
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    LabelLayout crowd(sight);
    std::vector<StandingPlate> plates;
    for (int k = 0; k < 12; ++k) {
      const Vec3 foot_m(random.in(-0.3, 0.3), random.in(-0.3, 0.3), random.in(0.0, 0.1));
      StandingPlate plate = standingPlate(sight, wholeNumber(17), PlateShape::flag, foot_m);
      plate.foot_m.z += crowd.raise_m(plate);
      ASSERT_GE(plate.foot_m.z, foot_m.z);
      for (const StandingPlate& other : plates) {
        const auto away = [&](const StandingPlate& p) { return std::hypot(p.foot_m.x, p.foot_m.y + 2.0); };
        const auto azimuth = [&](const StandingPlate& p) { return std::atan2(p.foot_m.x, p.foot_m.y + 2.0); };
        const auto low = [&](const StandingPlate& p) { return (p.foot_m.z - 1.0) / away(p); };
        const auto high = [&](const StandingPlate& p) { return low(p) + p.height_m() / away(p); };
        const bool beside = std::abs(azimuth(plate) - azimuth(other)) >=
                            0.5 * (plate.width_m() / away(plate) + other.width_m() / away(other)) - 1e-9;
        const bool aboveOrBelow = low(plate) >= high(other) - 1e-9 || low(other) >= high(plate) - 1e-9;
        ASSERT_TRUE(beside || aboveOrBelow) << "case " << i << ", plate " << k;
      }
      plates.push_back(plate);
    }
  }
}

TEST(Plates, SayNumbersAndTimes) {
  EXPECT_EQ(test::plateWords(wholeNumber(0)), "0");
  EXPECT_EQ(test::plateWords(wholeNumber(17)), "17");
  EXPECT_EQ(test::plateWords(wholeNumber(98765)), "98765");
  EXPECT_EQ(test::plateWords(wholeNumber(1234567890123)), "234567890123");
  EXPECT_EQ(test::plateWords(hundredthsOf(0.938)), "0.94");
  EXPECT_EQ(test::plateWords(hundredthsOf(-0.004)), "0.00");
  EXPECT_EQ(test::plateWords(hundredthsOf(-1.154)), "-1.15");
  EXPECT_EQ(test::plateWords(hundredthsOf(1e300)), "999.99");
  EXPECT_EQ(test::plateWords(tenthsOf(0.0)), "0.0");
  EXPECT_EQ(test::plateWords(tenthsOf(0.19)), "0.1");
  EXPECT_EQ(test::plateWords(tenthsOf(12.35)), "12.3");
  EXPECT_EQ(test::plateWords(tenthsOf(-0.01)), "-0.1");
  EXPECT_EQ(test::plateWords(tenthsOf(-12.21)), "-12.3");
  EXPECT_EQ(test::plateWords(tenthsOf(9999.95)), "9999.9");
  EXPECT_EQ(test::plateWords(tenthsOf(2004.95)), "2004.9");
  EXPECT_EQ(test::plateWords(tenthsOf(-264.25)), "-264.3");
  EXPECT_EQ(test::plateWords(tenthsOf(86399.95)), "86399.9");
  EXPECT_EQ(test::plateWords(tenthsOf(86400.0)), "86400.0");
  EXPECT_EQ(test::plateWords(tenthsOf(-86400.05)), "-86400.1");
  EXPECT_EQ(test::plateWords(tenthsOf(-1e300)), "-200000000.0") << "six years are the most";
  EXPECT_EQ(test::plateWords(measured(texts::Text(0, "{:.1f}°"), 78.96)), "79.0#");
  EXPECT_EQ(measured(texts::Text(0, "γ {:.2f}"), 1.25), plateText("γ 1.25"));
  EXPECT_EQ(test::plateWords(measured(texts::Text(0, "looks {:.2f} c"), 0.391)), "looks 0.39 c");
  EXPECT_EQ(test::plateWords(measured(texts::Text(0, "{:.2f} c"), -1.0)), "0.00 c");
  EXPECT_EQ(test::plateWords(measured(texts::Text(0, "length {:.2f}"), 1e300)), "length 9999.")
      << "twelve letters";
  EXPECT_EQ(test::plateWords(plateText("白 a\xff")), "? a?");
}

// A flash with a short name carries it on its flag, every other event its number.
TEST(EventMarks, AFlashWithAShortNameShowsIt) {
  const ObserverView observer = observerAt({9.0, {0.0, -2.0, 1.0}}, Lorentz(kC_m_s));
  std::array<GameEvent, 3> events;
  for (std::size_t i = 0; i < 3; ++i) {
    events[i].number = i;
    events[i].which = static_cast<std::uint32_t>(2 - i);
    events[i].at = {5.0, {0.3 * static_cast<double>(i), 0.0, 0.0}};
  }
  events[1].kind = EventKind::stroke;
  const MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, events, {}};
  LabelLayout crowd(sight);
  MarkBuffer batch;
  const std::array<std::string, 3> names{"lamp", "B", "C"};
  addEvents(sight, {}, names, crowd, batch);
  std::set<std::string> said;
  for (const MarkCorner& corner : batch.corners())
    if (corner.style > 0.5F) said.insert(test::plateWords(corner));
  EXPECT_EQ(said, (std::set<std::string>{"1", "2", "C"}));
}

// A puck's plate shows the puck's own time where its light left, τ = τ_k + (t − t_k)/γ, and stands above it.
TEST(PuckClocks, ShowThePucksOwnTimeAsItIsSeen) {
  test::Random random(72);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.9);
    const Event start{random.in(-1.0, 1.0), random.inBox(1.0)};
    const double startTime_s = i % 2 == 0 ? random.in(-50.0, 50.0) : random.in(-9e4, 9e4);
    const std::array<WorldLine, 2> lines{WorldLine(Knot{}, kC_m_s),
                                         WorldLine({start, u, startTime_s, start, 0.0}, kC_m_s, 0.03)};
    const Event eye{random.in(0.0, 5.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.8), kC_m_s);
    const ObserverView observer = observerAt(eye, headFromBoard);
    std::array<BodyView, 2> views;
    for (std::size_t body = 0; body < 2; ++body) viewBody(lines[body], eye, headFromBoard, views[body]);
    const std::array<glm::vec3, 2> colours{};
    const std::array<double, 2> reach_m{0.0, 0.03};
    const MarkContext sight{observer, observer.middle, {}, {}, 1, lines, views, {}, {}};
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addPuckClocks(sight, {colours, reach_m, reach_m}, crowd, batch);
    ASSERT_FALSE(batch.corners().empty());
    const auto seen = emission(lines[1], Vec3(0.0), eye, headFromBoard);
    const double own_s = startTime_s + (seen->event.t_s - start.t_s) / gammaFromU(u);
    const PlateText expected = tenthsOf(own_s);
    int ofPlate = 0;
    for (const MarkCorner& corner : batch.corners()) {
      if (corner.style == 0.0F) continue;  // of its stem
      ++ofPlate;
      ASSERT_EQ(test::plateWords(corner), test::plateWords(expected))
          << "case " << i << ": " << own_s << " s";
    }
    ASSERT_GT(ofPlate, 0);
    // The middle of its lower border is where that point of the puck is seen.
    const glm::vec3 foot = glm::vec3(emission(lines[1], {0.0, 0.0, 0.04}, eye, headFromBoard)->seen.dr_m);
    double nearest_m = 1e9;
    for (const MarkCorner& corner : batch.corners())
      nearest_m = std::min(nearest_m, static_cast<double>(glm::length(corner.drawn_m - foot)));
    ASSERT_LT(nearest_m, kFloat_m * (1.0 + glm::length(seen->seen.dr_m))) << "case " << i;
  }
}

// A rim clock stands on the rim, not on the shadow's, and shows that point's own time where its light left:
// by the point's own world line.
TEST(PuckClocks, ThoseOnARimShowTheRimsOwnTimes) {
  test::Random random(75);
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const double rim_m = random.in(0.25, 0.5), rim = random.in(0.1, 0.9);
    const Event start{0.0, random.inBox(1.0)};
    Knot knot{start, Vec3(0.0), 0.0, start, 0.0};
    knot.spin.omega_rad_s = rim * kC_m_s / rim_m;
    const std::array<WorldLine, 2> lines{WorldLine(Knot{}, kC_m_s), WorldLine(knot, kC_m_s, 1.2 * rim_m)};
    const Event eye{random.in(6.0, 20.0), start.r_m + Vec3(random.in(-1.0, 1.0), random.in(-1.0, 1.0), 1.5)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.5), kC_m_s);
    const ObserverView observer = observerAt(eye, headFromBoard);
    std::array<BodyView, 2> views;
    for (std::size_t body = 0; body < 2; ++body) viewBody(lines[body], eye, headFromBoard, views[body]);
    const std::array<glm::vec3, 2> colours{};
    const std::array<double, 2> reach_m{0.0, 1.2 * rim_m}, rims_m{0.0, rim_m};
    const MarkContext sight{observer, observer.middle, {}, {}, 1, lines, views, {}, {}};
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addPuckClocks(sight, {colours, reach_m, rims_m}, crowd, batch);
    std::vector<std::string> drawn;
    for (const MarkCorner& corner : batch.corners()) {
      if (corner.style == 0.0F) continue;  // of a stem
      drawn.push_back(test::plateWords(corner));
    }
    for (int k = 0; k < 6; ++k) {
      const double angle_rad = std::numbers::pi * k / 3.0;
      const Vec3 foot_m(rim_m * std::cos(angle_rad), rim_m * std::sin(angle_rad), 0.0);
      const auto history = vertexHistory(lines[1], foot_m);
      const double left_s = eventOnPastCone(history, eye, kC_m_s).t_s;
      const double own_s = properTimeAt(pieceAt(history, left_s), left_s, kC_m_s);
      const double tenth = std::remainder(10.0 * own_s, 1.0);
      if (std::abs(tenth) < 1e-3) continue;  // rounding decides the digit
      ASSERT_EQ(std::count(drawn.begin(), drawn.end(), test::plateWords(tenthsOf(own_s))) > 0, true)
          << "case " << i << ", clock " << k << ": " << own_s << " s";
      double nearest_m = 1e9;
      const glm::vec3 seen(emission(lines[1], foot_m, eye, headFromBoard)->seen.dr_m);
      for (const MarkCorner& corner : batch.corners())
        nearest_m = std::min(nearest_m, static_cast<double>(glm::length(corner.drawn_m - seen)));
      ASSERT_LT(nearest_m, 0.01) << "case " << i << ", clock " << k << ": half as thick as its stem";
    }
  }
}

// Each puck that moves carries a plate with the speed with which it is seen to move: β/(1 + β cos α), where α
// is between its way and that of the eye's look. One that rests has none.
TEST(SeenSpeeds, AreThoseThatAreSeen) {
  test::Random random(77);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double beta = random.in(0.05, 0.95);
    const Vec3 along = glm::normalize(Vec3(random.in(-1.0, 1.0), random.in(-1.0, 1.0), 0.0));
    const std::array<WorldLine, 3> lines{
        WorldLine(Knot{}, kC_m_s),
        WorldLine({{0.0, random.inBox(1.0)}, uFromBeta(beta * along), 0.0, {}, 0.0}, kC_m_s, 0.03),
        WorldLine({{0.0, random.inBox(1.0)}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.03)};
    const Event eye{random.in(0.0, 3.0), random.inBox(2.0)};
    const ObserverView observer = observerAt(eye, Lorentz(kC_m_s));
    const MarkContext sight{observer, observer.middle, {}, {}, 2, lines, {}, {}, {}};
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addSeenSpeeds(sight, std::array{0.0, 0.04, 0.04}, crowd, batch);
    std::set<std::string> said;
    for (const MarkCorner& corner : batch.corners())
      if (corner.style > 0.5F) said.insert(test::plateWords(corner));
    // By differences: where it is seen a moment earlier and later.
    const auto seenAt = [&](double t_s) { return centreSeen(lines[1], {t_s, eye.r_m}).event.r_m; };
    constexpr double kMoment_s = 1e-4;
    const double speed_m_s =
        glm::distance(seenAt(eye.t_s + kMoment_s), seenAt(eye.t_s - kMoment_s)) / (2.0 * kMoment_s);
    const double looks = speed_m_s / kC_m_s;
    if (std::abs(std::remainder(100.0 * looks - 0.5, 1.0)) < 0.05) continue;  // rounding decides the digit
    EXPECT_EQ(said,
              std::set<std::string>{test::plateWords(measured(texts::Text(0, "looks {:.2f} c"), looks))})
        << "case " << i;
  }
}

// Labels stand where they are told, and some of them only while the lesson explains.
TEST(LessonMarks, LabelsStandThereInEachPhase) {
  const ObserverView observer = observerAt({1.0, {0.0, -2.0, 1.0}}, Lorentz(kC_m_s));
  MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, {}, {}};
  LessonPlan plan;
  plan.labels = {{"A", {0.1, 0.2, 0.0}, false}, {"2.5 M", {0.5, 0.0, 0.0}, true}};
  for (const auto& [phase, expected] : {std::pair{LessonPhase::none, std::set<std::string>{}},
                                        {LessonPhase::asks, {"A"}},
                                        {LessonPhase::shows, {"A"}},
                                        {LessonPhase::explains, {"A", "2.5 M"}}}) {
    sight.lesson.phase = phase;
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addLessonMarks(sight, plan, {}, crowd, batch);
    std::set<std::string> said;
    for (const MarkCorner& corner : batch.corners())
      if (corner.style > 0.5F) said.insert(test::plateWords(corner));
    EXPECT_EQ(said, expected);
  }
}

/// Returns the corner of the marks that is nearest to a place in the picture, and how far from it (radians).
double nearestMark_rad(const MarkBuffer& batch, const glm::dvec3& drawn_m) {
  double nearest_rad = 1e9;
  for (const MarkCorner& corner : batch.corners())
    nearest_rad = std::min(
        nearest_rad, glm::distance(glm::normalize(glm::dvec3(corner.drawn_m)), glm::normalize(drawn_m)));
  return nearest_rad;
}

// An arrow ends a little above where the eye sees the body, or at its place, in the phase that it is of; for
// moving heads, too.
TEST(LessonMarks, ArrowsEndAtWhatTheyAreAbout) {
  test::Random random(77);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const Event eye{random.in(0.0, 3.0), {random.in(-0.5, 0.5), random.in(-2.5, -1.5), random.in(0.4, 1.2)}};
    const Lorentz boardFromRoom = Lorentz::boost(random.u(0.8), kC_m_s);
    const ObserverView observer = observerAt(eye, boardFromRoom.inverse());
    const Vec3 start_m(random.in(-1.0, 1.0), random.in(-0.5, 0.5), 0.0), beta(random.in(-0.7, 0.7), 0.0, 0.0);
    const WorldLine resting({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.1);
    const WorldLine moving({{0.0, start_m}, uFromBeta(beta), 0.0, {}, 0.0}, kC_m_s, 0.1);
    const std::array<WorldLine, 2> histories{resting, moving};
    MarkContext sight{observer, observer.middle, {}, {}, 1, histories, {}, {}, {}};
    LessonPlan plan;
    const Vec3 place_m(random.in(-1.0, 1.0), random.in(-0.5, 0.5), 0.2);
    plan.arrows = {{1, {}, false}, {{}, place_m, true}};
    constexpr std::array kTops_m{0.0, 0.05};
    const Resting draw(sight);
    const Vec3 body_m = centreSeen(moving, eye, {}).event.r_m + Vec3(0.0, 0.0, kTops_m[1]);
    for (const auto& [phase, end_m] : {std::pair{LessonPhase::asks, std::optional<Vec3>()},
                                       {LessonPhase::shows, std::optional(body_m)},
                                       {LessonPhase::explains, std::optional(place_m)}}) {
      sight.lesson.phase = phase;
      LabelLayout crowd(sight);
      MarkBuffer batch;
      addLessonMarks(sight, plan, kTops_m, crowd, batch);
      ASSERT_EQ(batch.corners().empty(), !end_m) << "case " << i;
      if (!end_m) continue;
      const glm::dvec3 above_m = draw(*end_m + Vec3(0.0, 0.0, 0.015));
      const double off_rad = nearestMark_rad(batch, above_m);
      ASSERT_LT(off_rad, 1e-5) << "case " << i << ": the tip, within rounding";
    }
  }
}

// The plates of a line of simultaneity show the board times of events with one time in the head's frame, and
// stand where these events are there: x' = γ (x − β c t) along the motion.
TEST(LessonMarks, ALineOfSimultaneityIsDrawnWhereItsEventsAreForTheObserver) {
  test::Random random(76);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double beta = random.in(-0.8, 0.8), gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    const Event eye{random.in(0.0, 3.0), random.inBox(2.0)};
    const Lorentz boardFromRoom = Lorentz::boost(uFromBeta({beta, 0.0, 0.0}), kC_m_s);
    const ObserverView observer = observerAt(eye, boardFromRoom.inverse());
    MarkContext sight{observer, observer.middle, {}, {}, 0, {}, {}, {}, {}};
    sight.lesson.phase = LessonPhase::explains;
    sight.views.myNow = 1;
    sight.boardFromRoom = boardFromRoom;
    LessonPlan plan;
    const Event with{random.in(0.0, 3.0), {random.in(-1.0, 1.0), random.in(-0.5, 0.5), 0.02}};
    plan.simultaneous.push_back({with, {}, -1.0, 1.0});
    LabelLayout crowd(sight);
    MarkBuffer batch;
    addLessonMarks(sight, plan, {}, crowd, batch);
    for (int k = 0; k < 5; ++k) {
      const Vec3 place_m(-1.0 + 0.5 * k, with.r_m.y, 0.0);
      const double t_s = with.t_s + beta * (place_m.x - with.r_m.x) / kC_m_s;
      const Vec3 way_m = place_m - eye.r_m;
      const glm::vec3 expected(gamma * (way_m.x - beta * kC_m_s * (t_s - eye.t_s)), way_m.y, way_m.z);
      float nearest_m = 1e9F;
      bool told = std::abs(std::remainder(100.0 * t_s, 1.0)) < 1e-6;  // rounding decides the digit
      for (const MarkCorner& corner : batch.corners()) {
        if (corner.style == 0.0F)
          nearest_m = std::min(nearest_m, glm::length(corner.drawn_m - expected));
        else
          told |= test::plateWords(corner) == test::plateWords(hundredthsOf(t_s));
      }
      ASSERT_LT(nearest_m, 0.007F) << "case " << i << ", clock " << k << ": half as wide as the line";
      ASSERT_TRUE(told) << "case " << i << ", clock " << k << ": " << t_s << " s";
    }
  }
}

// The pin of a ghost stands on its centre: at the head's moment that is at rest in the head's frame from the
// eye, x' with t' = 0; on the board where light would have come straight from.
TEST(Beacons, StandOnTheirGhosts) {
  test::Random random(74);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const Vec3 beta = betaFromU(random.u(0.9)), start_m = random.inBox(1.0);
    const WorldLine line({{0.0, start_m}, uFromBeta(beta), 0.0, {}, 0.0}, kC_m_s, 0.03);
    const std::array<WorldLine, 2> lines{WorldLine(Knot{}, kC_m_s), line};
    const Event eye{random.in(0.0, 5.0), random.inBox(2.0)};
    const Lorentz headFromBoard = Lorentz::boost(random.u(0.8), kC_m_s);
    const ObserverView observer = observerAt(eye, headFromBoard);
    const bool mine = i % 2 == 1;
    std::array<BodyView, 2> views;
    for (std::size_t body = 0; body < 2; ++body)
      viewBody(lines[body], eye, headFromBoard, views[body], {}, mine ? ViewTime::myNow : ViewTime::boardNow);
    MarkContext sight{observer, observer.middle, {}, {}, 1, lines, {}, {}, {}};
    (mine ? sight.ghosts.myNow : sight.ghosts.boardNow) = views;
    const std::array<double, 2> tops_m{0.0, 0.03};
    MarkBuffer batch;
    addBeacons(sight, std::array<glm::vec3, 2>{}, tops_m, batch);
    // At the head's moment t = t_o + β_h·(r − r_o)/c.
    const Vec3 headBeta = betaFromU(headFromBoard.inverse().u());
    const Vec3 atObservation_m = start_m + beta * kC_m_s * eye.t_s;
    const double ahead_m =
        mine ? glm::dot(headBeta, atObservation_m - eye.r_m) / (1.0 - glm::dot(headBeta, beta)) : 0.0;
    const Vec3 way_m = atObservation_m + beta * ahead_m - eye.r_m;
    const double time_s = mine ? ahead_m / kC_m_s : -glm::length(way_m) / kC_m_s;
    const glm::vec3 expected(glm::vec3((headFromBoard * Displacement{time_s, way_m}).dr_m));
    float nearest_m = 1e9F;
    for (const MarkCorner& corner : batch.corners())
      nearest_m = std::min(nearest_m, glm::length(corner.drawn_m - expected));
    ASSERT_LT(nearest_m, 0.001F * glm::length(expected) + 1e-5F)
        << "case " << i << ": thick as the pin is seen";
  }
}

// Corners of a way lie half its width aside of where the centre is at their time, through bounces and
// friction, and after a day of board time too: their times are counted from shortly before.
TEST(PathRibbons, LieAlongTheCentresWay) {
  test::Random random(73);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double game_s = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 3600.0 : 86400.0, base_s = game_s + 100.0;
    WorldLine line({{game_s, {0.1, 0.2, 0.01}}, uFromBeta({0.6, 0.3, 0.0}), 0.0, {}, i % 2 == 0 ? 0.0 : 0.2},
                   kC_m_s, 0.03);
    for (const double turn_s : {game_s + 0.7, game_s + 1.5}) {
      const Motion motion = motionOnLeg(line.knots().back(), turn_s, kC_m_s);
      const double angle_rad = random.in(0.0, 6.28), beta = random.in(0.1, 0.9);
      Knot knot{motion.event, uFromBeta({beta * std::cos(angle_rad), beta * std::sin(angle_rad), 0.0}),
                motion.properTime_s, motion.event, i % 2 == 0 ? 0.0 : 0.2};
      line.append(knot);
    }
    std::vector<PathRibbons::Corner> corners;
    addWay(line, game_s - 1.0, game_s + 3.0, base_s, corners);
    ASSERT_GT(corners.size(), 100u);
    double first_s = 1e9, last_s = -1e9;
    for (const PathRibbons::Corner& corner : corners) {
      const double t_s = base_s + corner.time_s;
      first_s = std::min(first_s, t_s);
      last_s = std::max(last_s, t_s);
      const Motion there = line.at(t_s);
      // At a turn, which leg's corner it is, nobody can say; its place is the same.
      const double off_m = glm::length(glm::dvec2(corner.place_m) - glm::dvec2(there.event.r_m));
      ASSERT_NEAR(off_m, PathRibbons::kHalfWidth_m, 3e-5) << "case " << i << " at " << t_s << " s";
    }
    ASSERT_NEAR(first_s, game_s, 1e-4) << "nothing before the game";
    ASSERT_NEAR(last_s, game_s + 3.0, 1e-4);
  }
}

}  // namespace
}  // namespace carom
