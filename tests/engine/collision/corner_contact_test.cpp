// Contacts of bodies with corners: exact cases from an oracle of 34 digits, and random pairs against dense
// sampling in the frame of equal speeds with boosts of its own.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "engine/collision/corner_contact.h"
#include "engine/collision/corner_cushion.h"
#include "engine/collision/corner_kick.h"
#include "engine/sampled_body.h"
#include "exact_cases.h"

namespace carom {
namespace {

using Json = nlohmann::json;
using test::boost;
using test::fourVelocityOf;
using test::Matrix;
using test::SampledBody;
using Vec2 = glm::dvec2;

// Written so that NaN fails.
#define EXPECT_WITHIN(value, expected, tolerance)            \
  EXPECT_TRUE(std::abs((value) - (expected)) <= (tolerance)) \
      << #value " = " << (value) << ", expected " << (expected)

std::vector<Vec2> regular(int corners, double radius, double angle = 0.0) {
  std::vector<Vec2> all;
  for (int k = 0; k < corners; ++k) {
    const double at = angle + 2.0 * M_PI * k / corners;
    all.push_back({radius * std::cos(at), radius * std::sin(at)});
  }
  return all;
}

std::vector<Vec2> rectangle(double length, double width) {
  return {{-0.5 * length, -0.5 * width},
          {0.5 * length, -0.5 * width},
          {0.5 * length, 0.5 * width},
          {-0.5 * length, 0.5 * width}};
}

MovingShape flight(const Vec2& place, const Vec2& beta, const Outline& outline, double turning = 0.0) {
  return {{0.0, place.x, place.y}, fourVelocityOf(beta), outline.radius(), &outline, 0.0, turning};
}

void expectCase(const Json& one) {
  SCOPED_TRACE(one["id"].get<std::string>());
  const Json &input = one["input"], &expected = one["expected"];
  const double c = input["c"];
  std::vector<Outline> outlines;
  for (const Json& body : input["bodies"]) {
    std::vector<Vec2> corners;
    for (const Json& corner : body["corners"]) corners.push_back({corner[0], corner[1]});
    ASSERT_FALSE(faultOf(corners)) << faultOf(corners)->what;
    outlines.emplace_back(corners);
  }
  std::array<MovingShape, 2> flights;
  std::array<LeveredBody, 2> bodies;
  for (int i = 0; i < 2; ++i) {
    const Json& body = input["bodies"][i];
    const Vec2 beta{body["v"][0].get<double>() / c, body["v"][1].get<double>() / c};
    flights[i] = flight({body["r"][0], body["r"][1]}, beta, outlines[i], body["omega"].get<double>() / c);
    const double mass = body["m"];
    bodies[i] = {{{mass, mass * body["k"].get<double>()}, 0.0, flights[i].u}, outlines[i].radius(), {}};
  }
  const Vec21 U = equalSpeedFrame(flights[0].u, flights[1].u);
  const std::string first = input["first_in"];
  const Vec21 order = first == "board" ? Vec21{1.0, 0.0, 0.0} : first == "A" ? flights[0].u : U;
  const auto found = findCornerContact(flights[0], flights[1], order);
  ASSERT_EQ(found.has_value(), expected["status"] == "contact" || expected["status"] == "tie");
  if (!found) return;
  const double within = one["tol"]["contact"];
  const Vec21& C = found->contact.event;
  EXPECT_WITHIN(C.t / c, expected["contact"][0].get<double>(), within);
  EXPECT_WITHIN(C.x, expected["contact"][1].get<double>(), within);
  EXPECT_WITHIN(C.y, expected["contact"][2].get<double>(), within);
  EXPECT_EQ(found->sideOnSide, expected["status"] == "tie");
  if (!expected.contains("kick")) return;
  for (int i = 0; i < 2; ++i) bodies[i].lever = C - flights[i].start;
  const auto kick = kickCorners(U, found->contact.n, bodies, {});
  ASSERT_TRUE(kick);
  const Json& outcome = expected["kick"];
  for (int i = 0; i < 2; ++i) {
    const Vec21& u = kick->centres.u[i];
    const double j = kick->j[i], perJ = bodies[i].radius * c;
    EXPECT_WITHIN(u.x / u.t * c, outcome["v"][i][0].get<double>(), one["tol"]["v"].get<double>());
    EXPECT_WITHIN(u.y / u.t * c, outcome["v"][i][1].get<double>(), one["tol"]["v"].get<double>());
    EXPECT_WITHIN(j * perJ, outcome["J"][i].get<double>(), one["tol"]["J"].get<double>());
    EXPECT_WITHIN(rimBeta(bodies[i].puck.body, j) * c / bodies[i].radius, outcome["omega"][i].get<double>(),
                  one["tol"]["omega"].get<double>());
  }
}

TEST(CornerContact, ExactCases) {
  for (const Json& one : test::exactCases("polygon_contacts.json")) expectCase(one);
}

// ---- The slow reference: sampled_body.h.

struct Pair {
  SampledBody first, second;
  Vec2 frame;  // velocity of the frame of equal speeds
};

Vec2 frameOf(const Vec2& beta1, const Vec2& beta2) {
  const Vec21 sum = fourVelocityOf(beta1) + fourVelocityOf(beta2);
  return {sum.x / sum.t, sum.y / sum.t};
}

class RandomPairs {
 public:
  explicit RandomPairs(unsigned seed) : random_(seed) {}

  std::vector<Vec2> outline() {
    const int kind = static_cast<int>(uniform(0.0, 4.0));
    const double size = uniform(0.02, 0.06);
    if (kind == 0) return rectangle(2.0 * size, size * std::pow(10.0, uniform(-3.0, 0.3)));
    if (kind == 1) return regular(3 + static_cast<int>(uniform(0.0, 7.0)), size, uniform(0.0, 6.0));
    std::vector<Vec2> star;  // not convex
    const int corners = 5 + static_cast<int>(uniform(0.0, 6.0));
    for (int k = 0; k < corners; ++k) {
      const double at = 2.0 * M_PI * (k + uniform(0.0, 0.8)) / corners, far = size * uniform(0.4, 1.0);
      star.push_back({far * std::cos(at), far * std::sin(at)});
    }
    return faultOf(star) ? outline() : star;
  }
  Vec2 beta() {
    const double at = uniform(0.0, 2.0 * M_PI), fast = uniform(0.0, 1.0);
    const double speed = fast < 0.2 ? 1.0 - std::pow(10.0, uniform(-3.0, -1.0)) : uniform(0.0, 0.95);
    return {speed * std::cos(at), speed * std::sin(at)};
  }
  // They come near each other, more or less, after about `when`.
  std::pair<Vec2, Vec2> placesFor(const Vec2& beta1, const Vec2& beta2) {
    const double when = uniform(0.15, 0.6);
    const Vec2 beside{uniform(-0.07, 0.07), uniform(-0.07, 0.07)};
    return {-beta1 * when, beside - beta2 * when};
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_;
};

struct Tally {
  int contacts = 0, none = 0, grazing = 0;
};

double distanceOfCentres(const Pair& pair, const Matrix& frame, double time) {
  const Vec21 apart =
      pair.first.eventAt({0.0, 0.0}, frame, time) - pair.second.eventAt({0.0, 0.0}, frame, time);
  return std::sqrt(std::max(0.0, -dot(apart, apart)));
}

// The contact found lies on both outlines and they go into each other after it. No sample before it, or at
// all where none is found, has a corner inside: a sample a millimetre of light, wherever the bodies can
// touch.
void expectAgreement(const Pair& pair, const std::optional<CornerContact>& found, Tally& tally) {
  const Matrix frame = boost(pair.frame);
  const double start = std::max((frame * pair.first.start).t, (frame * pair.second.start).t);
  const double reach = pair.first.radius + pair.second.radius;
  double until = start + 1.5;
  if (found) {
    const Vec21& C = found->contact.event;
    EXPECT_WITHIN(pair.first.depthOf(C), 0.0, 1e-10);
    EXPECT_WITHIN(pair.second.depthOf(C), 0.0, 1e-10);
    EXPECT_GT(C.t, 0.0);
    until = (frame * C).t;
    double deepest = -1.0;
    for (const double after : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
      deepest = std::max(deepest, depthAt(pair.first, pair.second, frame, until + after * reach));
    ++(deepest > 1e-12 ? tally.contacts : tally.grazing);
  } else {
    ++tally.none;
  }
  constexpr double kStep = 1e-3;
  for (double time = start + 0.5 * kStep; time < until; time += kStep) {
    const double apart = distanceOfCentres(pair, frame, time);
    if (apart > reach) {
      time += std::max(0.0, 0.5 * (apart - reach) - kStep);
      continue;
    }
    // The rim is sampled at 64 points; what lies inside only between them is found by the engine alone.
    const double depth = depthAt(pair.first, pair.second, frame, time);
    if (depth > 1e-7 && time < until - 1e-9) {
      ADD_FAILURE() << "a corner is " << depth << " m inside at " << time << " of " << until;
      return;
    }
  }
}

void expectRandomPairs(unsigned seed, int count, bool withDisc, double spinning) {
  RandomPairs random(seed);
  Tally tally;
  const auto tested = [&] { return tally.contacts + tally.none + tally.grazing; };
  for (int n = 0; tested() < count && !testing::Test::HasFailure(); ++n) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", pair " + std::to_string(n));
    const auto corners1 = random.outline();
    const auto corners2 = withDisc ? std::vector<Vec2>{} : random.outline();
    const Vec2 beta1 = random.beta(), beta2 = random.beta();
    const auto [place1, place2] = random.placesFor(beta1, beta2);
    const Outline outline1(corners1);
    const std::optional<Outline> outline2 = withDisc ? std::nullopt : std::optional<Outline>(corners2);
    const double radius2 = withDisc ? random.uniform(0.02, 0.05) : outline2->radius();
    const bool spins = random.uniform(0.0, 1.0) < spinning;
    const double turning1 = spins ? random.uniform(-0.99, 0.99) / outline1.radius() : 0.0;
    const double turning2 = spins && !withDisc ? random.uniform(-0.99, 0.99) / radius2 : 0.0;
    MovingShape first = flight(place1, beta1, outline1, turning1);
    MovingShape second{{0.0, place2.x, place2.y},
                       fourVelocityOf(beta2),
                       radius2,
                       withDisc ? nullptr : &*outline2,
                       0.0,
                       turning2};
    const Pair pair{{corners1, first.start, beta1, turning1, outline1.radius()},
                    {corners2, second.start, beta2, turning2, radius2},
                    frameOf(beta1, beta2)};
    const Matrix frame = boost(pair.frame);
    const double apart = (frame * Vec21{0.0, place1.x - place2.x, place1.y - place2.y}).t;
    // Only pairs that are apart as the later flight begins, whatever the frame.
    const double reach = outline1.radius() + radius2;
    if (glm::length(place1 - place2) < 2.0 * reach + std::abs(apart)) continue;
    expectAgreement(pair, findCornerContact(first, second), tally);
  }
  EXPECT_GT(tally.contacts, count / 10);
  EXPECT_GT(tally.none, count / 20);
  EXPECT_LT(tally.grazing, count / 200);
}

TEST(CornerContact, RandomPairsAsSampled) { expectRandomPairs(1, 6700, false, 0.0); }
TEST(CornerContact, RandomSpinningPairsAsSampled) { expectRandomPairs(2, 3300, false, 1.0); }
TEST(CornerContact, RandomPairsWithDiscsAsSampled) { expectRandomPairs(3, 1000, true, 0.33); }

// A side of a spinning body is straight in its own frame, and between its corners in the frame of equal
// speeds.
TEST(CornerContact, ManyCornersTouchAsADiscDoes) {
  constexpr double kRadius = 0.03;
  RandomPairs random(4);
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    const Outline many(regular(64, kRadius));
    const Vec2 beta1 = random.beta(), beta2 = random.beta();
    const auto [place1, place2] = random.placesFor(beta1, beta2);
    const MovingShape first = flight(place1, beta1, many), second = flight(place2, beta2, many);
    const Disc disc1{first.start, first.u, kRadius}, disc2{second.start, second.u, kRadius};
    const auto meeting = findMeeting(disc1, disc2, TurnConvention::signalAtCentre);
    const MovingShape rim{second.start, second.u, kRadius, nullptr, 0.0, 0.0};
    const auto found = findCornerContact(first, second), withRim = findCornerContact(first, rim);
    const double b = std::abs(dot(cross(first.u, second.u), second.start - first.start)) /
                     std::sqrt(std::pow(dot(first.u, second.u), 2) - 1.0);
    if (!meeting || b > 1.5 * kRadius || meeting->withoutDelay) continue;
    ASSERT_TRUE(found && withRim);
    const PairContact expected = contactOf(disc1, disc2, false);
    const double gamma = dot(first.u, second.u);
    for (const PairContact& contact : {found->contact, withRim->contact}) {
      // The outline lies up to R (1 − cos(π/64)) inside each disc.
      const Vec21 apart = contact.event - expected.event;
      EXPECT_WITHIN(dot(apart, expected.U), 0.0, 0.02 * kRadius * gamma);
      EXPECT_WITHIN(std::sqrt(std::max(0.0, dot(apart, apart) * -1.0)), 0.0, 0.12 * kRadius * gamma);
    }
  }
}

TEST(CornerContact, SquaresFaceToFaceTieInTheMiddle) {
  const Outline square(rectangle(0.08, 0.08));
  const MovingShape left = flight({-0.5, 0.01}, {0.6, 0.0}, square);
  const MovingShape right = flight({0.5, -0.01}, {-0.6, 0.0}, square);
  const auto found = findCornerContact(left, right);
  ASSERT_TRUE(found && found->sideOnSide);
  EXPECT_WITHIN(found->contact.event.x, 0.0, 1e-15);
  EXPECT_WITHIN(found->contact.event.y, 0.0, 1e-15);
  EXPECT_WITHIN(found->contact.event.t, (0.5 - 0.04 * 0.8) / 0.6, 1e-14);
  // Aligned, the levers vanish and nothing turns.
  const auto aligned =
      findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, square), flight({0.5, 0.0}, {-0.6, 0.0}, square));
  ASSERT_TRUE(aligned && aligned->sideOnSide);
  std::array<LeveredBody, 2> bodies;
  for (int i = 0; i < 2; ++i) {
    const MovingShape& one = i == 0 ? left : right;
    bodies[i] = {{{0.2, 0.1}, 0.0, one.u},
                 square.radius(),
                 aligned->contact.event - Vec21{0.0, i == 0 ? -0.5 : 0.5, 0.0}};
  }
  const auto kick = kickCorners(aligned->contact.U, aligned->contact.n, bodies, {});
  ASSERT_TRUE(kick);
  EXPECT_WITHIN(kick->j[0], 0.0, 1e-16);
  EXPECT_WITHIN(kick->centres.u[0].x, -left.u.x, 1e-15);
  // In a frame that moves along the sides one end is first, and it is no tie.
  const auto there = findCornerContact(left, right, fourVelocityOf({0.0, 0.3}));
  ASSERT_TRUE(there);
  EXPECT_FALSE(there->sideOnSide);
  EXPECT_WITHIN(std::abs(there->contact.event.y), 0.03, 1e-15);
}

// The face of a square comes to a face half as long and, with its upper corner, to a slope above that. The
// slope is later by less than what counts as one time, so that the face is the first.
TEST(CornerContact, WhatTouchesAnotherSideAtThatTimeDoesNotMoveTheMiddle) {
  constexpr double kLater = 2e-11;
  const Outline square(rectangle(0.08, 0.08));
  const std::vector<Vec2> corners{{-0.04, -0.04},         {0.08, -0.04},          {0.08, 0.06},
                                  {-0.06 + kLater, 0.06}, {-0.02 + kLater, 0.02}, {-0.04, 0.0}};
  ASSERT_FALSE(faultOf(corners));
  const Outline notched(corners);
  const auto found =
      findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, square), flight({0.5, 0.0}, {-0.6, 0.0}, notched));
  ASSERT_TRUE(found && found->sideOnSide);
  EXPECT_WITHIN(found->contact.event.x, 0.0, 1e-12);
  EXPECT_WITHIN(found->contact.event.y, -0.02, 1e-12);
}

TEST(CornerContact, OverlappingBodiesThatApproachTouchAtOnce) {
  const Outline square(rectangle(0.08, 0.08));
  MovingShape left = flight({0.0, 0.0}, {0.3, 0.0}, square),
              right = flight({0.075, 0.03}, {-0.3, 0.0}, square);
  left.start.t = right.start.t = 1.0;
  const auto found = findCornerContact(left, right);
  ASSERT_TRUE(found && found->withoutDelay);
  EXPECT_WITHIN(found->contact.simultaneous[0], 0.0, 1e-15);
  EXPECT_GT(found->contact.n.x, 0.9);
  std::swap(left.u, right.u);
  EXPECT_FALSE(findCornerContact(left, right));
}

// Each centre hears of the contact when its light is there, and turns without delay where it is simultaneous
// with it in the frame of equal speeds.
TEST(CornerContact, SignalsGoAtTheSpeedOfLightAndSimultaneousMeansAtRightAngles) {
  RandomPairs random(8);
  int contacts = 0;
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE("seed 8, pair " + std::to_string(n));
    const Outline outlines[]{Outline(random.outline()), Outline(random.outline())};
    const Vec2 betas[]{random.beta(), random.beta()};
    const auto [place1, place2] = random.placesFor(betas[0], betas[1]);
    const MovingShape flights[]{flight(place1, betas[0], outlines[0], 1.0),
                                flight(place2, betas[1], outlines[1], -2.0)};
    const auto found = findCornerContact(flights[0], flights[1]);
    if (!found) continue;
    ++contacts;
    const Vec21 U = equalSpeedFrame(flights[0].u, flights[1].u);
    for (int i = 0; i < 2; ++i) {
      const auto since = [&](double own) {
        return flights[i].start + flights[i].u * own - found->contact.event;
      };
      const Vec21 signal = since(found->contact.signal[i]);
      EXPECT_GT(signal.t, 0.0);
      EXPECT_WITHIN(signal.t - std::hypot(signal.x, signal.y), 0.0, 1e-11);
      EXPECT_WITHIN(dot(U, since(found->contact.simultaneous[i])), 0.0, 1e-11);
    }
  }
  EXPECT_GT(contacts, 100);
}

// In the order of the game's events a contact has the moment at which the nearest centre could hear of it;
// one without delay has it by the turn that does not wait.
TEST(CornerContact, TheGameOrdersByTurnsThatDoNotWaitForAnySignal) {
  const Outline bar(rectangle(0.3, 0.02));
  const MovingShape first = flight({0.0, 0.0}, {0.6, 0.0}, bar),
                    second = flight({0.4, 0.0}, {-0.8, 0.0}, bar);
  CornerContact found;
  found.contact.simultaneous = {0.3, 0.5};
  found.contact.signal = {0.4, 0.7};
  const auto momentsOf = [&](const std::array<double, 2>& turn, double before) {
    return std::array{first.u.t * (turn[0] - before), second.u.t * (turn[1] - before)};
  };
  for (const bool withoutDelay : {false, true}) {
    SCOPED_TRACE(withoutDelay);
    found.withoutDelay = withoutDelay;
    const Meeting delayed = meetingOf(first, second, found, TurnConvention::signalAtCentre);
    EXPECT_EQ(delayed.ownTime,
              momentsOf(withoutDelay ? found.contact.simultaneous : found.contact.signal, bar.radius()));
    EXPECT_EQ(delayed.withoutDelay, withoutDelay);
    const Meeting atOnce = meetingOf(first, second, found, TurnConvention::simultaneousWithContact);
    EXPECT_EQ(atOnce.ownTime, momentsOf(found.contact.simultaneous, 0.0));
  }
}

// A bar that has been turned away from another just now does not touch it where it would have come from.
TEST(CornerContact, WhatALegWouldHaveDoneBeforeItBeganDoesNotCount) {
  const Outline bar(rectangle(0.3, 0.02));
  const MovingShape rests = flight({0.0, 0.0}, {0.0, 0.0}, bar);
  MovingShape leaves = flight({0.0, 0.1}, {0.1, 0.6}, bar);
  leaves.start.t = 2.0;
  EXPECT_FALSE(findCornerContact(rests, leaves));
  EXPECT_FALSE(findCornerContact(leaves, rests));
  leaves.u = fourVelocityOf({0.1, -0.6});
  const auto found = findCornerContact(rests, leaves);
  ASSERT_TRUE(found);
  EXPECT_GT(found->contact.event.t, leaves.start.t);
}

// A point of a triangle comes to a square that rests and has turned since before the triangle's flight: in
// the square's own time, which is the board's.
TEST(CornerContact, TheNormalLiesAsTheTouchedBodyHasTurnedByThen) {
  const Outline square(regular(4, 0.1)), triangle(regular(3, 0.02, M_PI));
  constexpr double kBegin = -0.3, kAngle = 0.2, kTurning = 2.0;
  const MovingShape turns{{kBegin, 0.0, 0.0}, {1.0, 0.0, 0.0}, square.radius(), &square, kAngle, kTurning};
  const MovingShape comes = flight({0.5, 0.012}, {-0.6, 0.0}, triangle);
  const auto found = findCornerContact(turns, comes, equalSpeedFrame(turns.u, comes.u));
  ASSERT_TRUE(found);
  const Vec21& n = found->contact.n;
  const double angle = kAngle + kTurning * (found->contact.event.t - kBegin);
  double nearest = -1.0;
  for (const Outline::Side& side : square.sides()) {
    const Vec2 normal{side.normal.x * std::cos(angle) - side.normal.y * std::sin(angle),
                      side.normal.x * std::sin(angle) + side.normal.y * std::cos(angle)};
    nearest = std::max(nearest, glm::dot(normal, Vec2{n.x, n.y}));
  }
  EXPECT_WITHIN(n.t, 0.0, 1e-12);
  EXPECT_WITHIN(nearest, 1.0, 1e-12);
}

TEST(CornerContact, TurningBarsThatRestBesideEachOtherMeet) {
  const Outline bar(rectangle(0.12, 0.02));
  const MovingShape still = flight({0.0, 0.0}, {0.0, 0.0}, bar);
  const MovingShape turns = flight({0.09, 0.0}, {0.0, 0.0}, bar, 3.0);
  ASSERT_FALSE(findCornerContact(still, flight({0.13, 0.0}, {0.0, 0.0}, bar, 3.0)));
  MovingShape upright = turns;
  upright.angle = M_PI / 2;
  const auto found = findCornerContact(still, upright);
  ASSERT_TRUE(found);
  // The corner of the bar that stands comes down on the other's end.
  EXPECT_GT(found->contact.event.t, 0.1);
  EXPECT_LT(found->contact.event.t, M_PI / 3.0);
}

// The earliest corner by the body's own time, by dense sampling with explicit boosts.
TEST(CornerContact, CushionsAsSampled) {
  RandomPairs random(5);
  int contacts = 0, atCorners = 0;
  for (int n = 0; n < 500; ++n) {
    SCOPED_TRACE(n);
    const auto corners = random.outline();
    const Outline outline(corners);
    const Vec2 beta = random.beta();
    const double turning = n % 2 == 0 ? 0.0 : random.uniform(-0.9, 0.9) / outline.radius();
    const Vec2 place{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
    const CushionPlane plane{n % 4 < 2 ? 0 : 1, random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0, 0.4};
    const MovingShape body = flight(place, beta, outline, turning);
    const auto found = findCornerContact(body, 0.0, plane, TurnConvention::signalAtCentre);
    const double speed = plane.sign * (plane.axis == 0 ? beta.x : beta.y);
    ASSERT_TRUE(found || !(speed > 0.05));
    if (!found) continue;
    ++contacts;
    const SampledBody sampled(corners, body.start, beta, turning, outline.radius());
    EXPECT_WITHIN(plane.inside(found->contact.event), 0.0, 1e-15);
    // The centre turns when the light of the contact reaches it.
    const Vec21 signal = found->contact.turn.x - found->contact.event;
    EXPECT_WITHIN(dot(signal, signal), 0.0, 1e-13);
    EXPECT_GT(signal.t, 0.0);
    EXPECT_GE(plane.inside(found->contact.turn.x), 0.0);
    const double own = sampled.restPlace(found->contact.event).t;
    // Where a corner's news would come too late, the contact is straight ahead of the centre, after the
    // corner's.
    bool atCorner = found->sideOnSide;
    for (const Vec2& d : corners)
      atCorner = atCorner || std::abs(glm::length(d) - (found->contact.turn.properTime - own)) < 1e-9;
    if (!atCorner) continue;
    ++atCorners;
    EXPECT_TRUE(found->sideOnSide || std::abs(sampled.depthOf(found->contact.event)) <= 1e-10);
    for (int k = 0; k < 300; ++k) {
      const double s = own * (k + 0.5) / 300.0;
      for (const Vec2& d : corners) {
        EXPECT_GT(plane.inside(sampled.eventOf(d, s)), -1e-9);
      }
    }
  }
  EXPECT_GT(contacts, 200);
  EXPECT_GT(atCorners, contacts * 3 / 4);
}

TEST(CornerContact, ManyCornersMeetACushionAsADiscDoes) {
  const Outline many(regular(256, 0.03));
  const CushionPlane plane{0, 1.0, 0.5};
  const MovingShape body = flight({0.0, 0.0}, {0.8, 0.3}, many);
  for (const TurnConvention convention :
       {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
    const auto disc = findContact({body.start, body.u, 0.0, 0.0}, 0.03, plane, convention);
    const auto found = findCornerContact(body, 0.0, plane, convention);
    ASSERT_TRUE(disc && found);
    EXPECT_WITHIN(found->contact.turn.x.t, disc->turn.x.t, 1e-4);
    EXPECT_WITHIN(found->contact.event.y, disc->event.y, 2e-3);
  }
}

// What touches at board time 0 has been there before, and is no contact; a moment later it is one. In numbers
// without rounding: at u = 3/4, γ = 5/4 a corner 5/32 ahead of its centre is 1/8 ahead on the board.
TEST(CornerContact, NothingTouchesAtBoardTimeZero) {
  constexpr double kAhead = 0.15625, kOnBoard = 0.125;
  const Vec21 u{1.25, -0.75, 0.0};
  const Outline square(rectangle(0.125, 0.125));
  const Outline diamond(std::vector<Vec2>{{kAhead, 0.0}, {0.0, kAhead}, {-kAhead, 0.0}, {0.0, -kAhead}});
  const Outline triangle(std::vector<Vec2>{{kAhead, 0.0625}, {-0.0625, 0.0625}, {-0.0625, -0.0625}});
  const CushionPlane plane{0, 1.0, 0.5};
  for (const double gap : {0.0, 0x1p-20}) {  // in metres of light
    SCOPED_TRACE(gap);
    const double away = kOnBoard + 0.6 * gap;
    const MovingShape still = flight({0.0, 0.0}, {0.0, 0.0}, square);
    const MovingShape comes{{0.0, 0.0625 + away, 0.0}, u, kAhead, &diamond, 0.0, 0.0};
    const auto found = findCornerContact(still, comes);
    ASSERT_TRUE(found);  // if not of this corner, later of the square's corners
    EXPECT_EQ(std::abs(found->contact.event.t - gap) < 1e-15, gap > 0.0) << found->contact.event.t;
    // At a cushion the contact is then that of the place straight ahead of the centre, which comes later.
    const MovingShape falls{
        {0.0, 0.5 - away, 0.0}, {1.25, 0.75, 0.0}, triangle.radius(), &triangle, 0.0, 0.0};
    const auto touch = findCornerContact(falls, 0.0, plane, TurnConvention::signalAtCentre);
    ASSERT_TRUE(touch);
    EXPECT_EQ(std::abs(touch->contact.event.y - 0.0625) < 1e-12, gap > 0.0) << touch->contact.event.y;
  }
}

// Corner on corner: it lies on the end of two sides, and rounding must not let it pass between them.
TEST(CornerContact, CornersThatMeetExactlyDoNotPassBetweenTheSides) {
  RandomPairs random(6);
  for (int n = 0; n < 2000; ++n) {
    SCOPED_TRACE("seed 6, pair " + std::to_string(n));
    const double angle = random.uniform(0.0, 2.0 * M_PI), radius = random.uniform(0.02, 0.06),
                 speed = random.uniform(0.1, 0.95);
    const int corners = 3 + n % 5;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const Outline one(regular(corners, radius, angle)), other(regular(corners, radius, angle + M_PI));
    const double apart = random.uniform(0.2, 0.5);
    const auto found =
        findCornerContact(flight(-apart * way, speed * way, one), flight(apart * way, -speed * way, other));
    ASSERT_TRUE(found);
    const Vec21& C = found->contact.event;
    EXPECT_WITHIN(C.t, (apart - radius * std::sqrt(1.0 - speed * speed)) / speed, 1e-12);
    EXPECT_WITHIN(std::hypot(C.x, C.y), 0.0, 1e-13);
  }
}

// Corner on corner, in numbers without rounding: of all that happens at once the first body's corner counts,
// on the side of the second that comes first in its outline.
TEST(CornerContact, OfEqualPiercingsTheFirstCounts) {
  const Vec2 east{0.125, 0.0}, north{0.0, 0.125}, west{-0.125, 0.0}, south{0.0, -0.125};
  const Outline diamond(std::vector<Vec2>{east, north, west, south}),
      turned(std::vector<Vec2>{north, west, south, east});
  const auto normalOf = [](const Outline& first, const Outline& second) {
    const auto found =
        findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, first), flight({0.5, 0.0}, {-0.6, 0.0}, second));
    EXPECT_TRUE(found && !found->sideOnSide);
    return found ? Vec2{found->contact.n.x, found->contact.n.y} : Vec2{0.0};
  };
  // The second's sides at its western corner: from north to west before that from west to south.
  EXPECT_LT(normalOf(diamond, diamond).y, -0.1);
  EXPECT_LT(normalOf(turned, diamond).y, -0.1);
  const Outline fromWest(std::vector<Vec2>{west, south, east, north});  // its first side leads to the south
  EXPECT_GT(normalOf(diamond, fromWest).y, 0.1);
}

}  // namespace
}  // namespace carom
