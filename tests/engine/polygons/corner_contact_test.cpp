// Contacts of bodies with corners: exact cases from an oracle of 34 digits, their signals, and what touches
// as flights begin.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_cushion.h"
#include "engine/polygons/corner_kick.h"
#include "engine/polygons/corner_pairs.h"
#include "exact_cases.h"

namespace carom {
namespace {

using Json = nlohmann::json;
using test::flight;
using test::RandomPairs;
using test::rectangle;
using Vec2 = glm::dvec2;

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

}  // namespace
}  // namespace carom
