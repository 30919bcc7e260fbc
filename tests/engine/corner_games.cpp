#include "engine/corner_games.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "engine/billiard/collision_scheduler.h"
#include "engine/game/setup_check.h"
#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_kick.h"
#include "engine/sampled_body.h"

namespace carom::test {

namespace {

constexpr double kC_m_s = 1.42;
constexpr double kRounding_m = 1e-13;
constexpr double kSame = 1e-12;  // metres of light: rounding
constexpr double kSoon = 1.0;  // of the radii: until then light is on its way that tells a pair of a contact
constexpr double kNever = std::numeric_limits<double>::infinity();

std::vector<Vec2> regular(int corners, double radius_m, double angle_rad) {
  std::vector<Vec2> outline_m;
  for (int k = 0; k < corners; ++k) {
    const double at = angle_rad + 2.0 * M_PI * k / corners;
    outline_m.push_back({radius_m * std::cos(at), radius_m * std::sin(at)});
  }
  return outline_m;
}

/// A leg of one body, with c = 1.
struct PlayedLeg {
  SampledBody body;
  Vec21 u;
  SpinningPuck puck;
  double next = kNever;  // board time at which the next leg begins
};

std::vector<PlayedLeg> legsOf(const BilliardSetup& setup, const Billiard& game, std::size_t which) {
  const Puck& puck = setup.pucks[which];
  const double c = setup.lightSpeed_m_s;
  std::vector<PlayedLeg> legs;
  const SpinningBody material{puck.mass_kg, puck.inertia * puck.mass_kg};
  for (const Knot& knot : game.worldLines()[which].knots()) {
    const Vec21 u = fourVelocity(knot.u.x, knot.u.y);
    const Vec21 start{knot.turn.t_s * c, knot.turn.r_m.x, knot.turn.r_m.y};
    if (!legs.empty()) legs.back().next = start.t;
    // A disc that turns fills the same place.
    const double turning = puck.outline_m.empty() ? 0.0 : knot.spin.omega_rad_s / c;
    legs.push_back(
        {{puck.outline_m, start, {u.x / u.t, u.y / u.t}, turning, puck.radius_m, knot.spin.angle_rad},
         u,
         {material, spinOfRim(material, knot.spin.omega_rad_s / c * puck.radius_m), u}});
  }
  return legs;
}

MovingShape flightOn(const PlayedLeg& leg, const std::optional<Outline>& outline) {
  const SampledBody& body = leg.body;
  return {body.start, leg.u, body.radius, outline ? &*outline : nullptr, body.angle, body.turning};
}

/// Returns how fast two bodies that touch as the later leg begins close by the law of the kick, where they do
/// so fastest; 0 if nowhere. By the sides that count since an earlier contact.
double closingByLaw(const PlayedLeg& one, const PlayedLeg& other, const std::array<MovingShape, 2>& flights,
                    const PersistentContact* earlier) {
  const std::array<const PlayedLeg*, 2> legs{&one, &other};
  double fastest = 0.0;
  for (const TouchedPlace& place : touchedPlaces(flights[0], flights[1], 0.0, earlier)) {
    std::array<LeveredBody, 2> bodies;
    for (int i = 0; i < 2; ++i) {
      const Vec21 way = place.event - flights[i].start;
      bodies[i] = {legs[i]->puck, flights[i].radius, way - flights[i].u * dot(flights[i].u, way)};
    }
    const auto kick = kickCorners(equalSpeedFrame(one.u, other.u), place.n, bodies, {});
    if (kick) fastest = std::max(fastest, kick->centres.closing);
  }
  return fastest;
}

/// Returns how deep two bodies, of which at least one has corners, are in each other at a time of a frame.
double overlapAt(const SampledBody& one, const SampledBody& other, const Matrix& frame, double time) {
  if (one.corners.empty()) return overlapOfDisc(one, other, frame, time);
  if (other.corners.empty()) return overlapOfDisc(other, one, frame, time);
  return depthAt(one, other, frame, time);
}

/// How fast two bodies that touch go on into each other.
class ApproachCheck {
 public:
  ApproachCheck(const BilliardSetup& setup, const Billiard& game, double until_s, CornerTally& tally)
      : tally_(tally), until_(until_s * setup.lightSpeed_m_s), setup_(setup), again_(setup) {
    for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
      legs_.push_back(legsOf(setup, game, i));
      const std::vector<Vec2>& corners = setup.pucks[i].outline_m;
      outlines_.push_back(corners.empty() ? std::nullopt : std::optional<Outline>(corners));
    }
    playAgain();
  }

  /// Returns the fastest of a pair, over c.
  double check(std::size_t first, std::size_t second) {
    double fastest = 0.0;
    std::size_t from = 0;
    for (const PlayedLeg& one : legs_[first]) {
      const std::vector<PlayedLeg>& others = legs_[second];
      // In their frame simultaneous with one leg can be what the board shows before or after.
      const double slack = 4.0 * (one.body.radius + others[0].body.radius) * one.u.t;
      while (from + 1 < others.size() && others[from].next + slack * others[from].u.t < one.body.start.t)
        ++from;
      for (std::size_t k = from; k < others.size(); ++k) {
        if (others[k].body.start.t > one.next + slack * others[k].u.t) break;
        fastest = std::max(fastest, ofLegs(one, others[k], {first, second}));
      }
    }
    return fastest;
  }

 private:
  /// The leg that a puck follows.
  struct CurrentLeg {
    double since = 0.0;  ///< board time at which it began
    Vec21 u;
    bool awaitsTurn = false;  ///< which is decided and has not come
  };
  /// Two bodies that have come together and not parted since, and the contact.
  struct PersistentPair {
    std::array<std::size_t, 2> pucks;
    PersistentContact since;
  };
  /// What the game knows at one time, by the places in the setup.
  struct Instant {
    std::vector<CurrentLeg> followed;
    std::vector<PersistentPair> together;
  };
  static Instant instantOf(const GameState& state) {
    Instant instant;
    instant.followed.resize(state.pucks.size());
    for (std::size_t i = 0; i < state.pucks.size(); ++i) {
      const PuckState& puck = state.pucks[i];
      instant.followed[puck.file] = {state.discs[i].start.t, state.discs[i].u, !puck.decided.empty()};
      for (const PersistentPartner& one : puck.partners) {
        const std::size_t other = static_cast<std::size_t>(one.other);
        if (other >= i) instant.together.push_back({{puck.file, state.pucks[other].file}, one.contact});
      }
    }
    return instant;
  }
  // Plays the game again, from one beginning of a leg, or event, to the next.
  void playAgain() {
    std::vector<double> times;
    for (const std::vector<PlayedLeg>& legs : legs_)
      for (const PlayedLeg& leg : legs)
        if (leg.body.start.t <= until_) times.push_back(leg.body.start.t + kSame);
    std::sort(times.begin(), times.end());
    CollisionScheduler& game = again_;
    GameHistory history(setup_);
    for (const double time : times) {
      bool played = false;
      while (!played) {
        played = game.playUntil(time, history.eventCount() + 1, history);
        instants_.push_back(instantOf(game.state()));
      }
    }
  }
  // The first time at which both follow these legs; none if they never do.
  const Instant* bothOn(const PlayedLeg& one, const PlayedLeg& other,
                        const std::array<std::size_t, 2>& who) const {
    const std::array<const PlayedLeg*, 2> legs{&one, &other};
    const auto since = [&](const Instant& instant, int i) {
      return instant.followed[who[i]].since - legs[i]->body.start.t;
    };
    const auto at = std::partition_point(instants_.begin(), instants_.end(), [&](const Instant& instant) {
      return since(instant, 0) < -kSame || since(instant, 1) < -kSame;
    });
    // Several legs can begin, and end, at one time.
    for (auto instant = at; instant != instants_.end(); ++instant) {
      if (since(*instant, 0) > kSame || since(*instant, 1) > kSame) return nullptr;
      const auto follows = [&](int i) {
        const Vec21 differs = instant->followed[who[i]].u - legs[i]->u;
        return std::abs(differs.x) + std::abs(differs.y) < kSame * legs[i]->u.t;
      };
      if (follows(0) && follows(1)) return &*instant;
    }
    return nullptr;
  }
  static std::optional<PersistentContact> earlierOf(const Instant& instant,
                                                    const std::array<std::size_t, 2>& who) {
    for (const PersistentPair& pair : instant.together) {
      const PersistentContact& of = pair.since;
      if (pair.pucks == who) return of;
      if (pair.pucks == std::array{who[1], who[0]})
        return PersistentContact{{of.flights[1], of.flights[0]}, of.event, of.n * -1.0, of.behind};
    }
    return std::nullopt;
  }

  double ofLegs(const PlayedLeg& one, const PlayedLeg& other, const std::array<std::size_t, 2>& who) {
    if (one.body.corners.empty() && other.body.corners.empty()) return 0.0;
    const double later = std::max(one.body.start.t, other.body.start.t),
                 size = one.body.radius + other.body.radius;
    if (later > until_ || later == 0.0) return 0.0;
    // What was decided before turns one of them yet: until then no contact counts that comes before it, and
    // when it has turned they are looked at again.
    const Instant* const instant = bothOn(one, other, who);
    if (instant == nullptr || instant->followed[who[0]].awaitsTurn || instant->followed[who[1]].awaitsTurn)
      return 0.0;
    const Vec21 sum = one.u + other.u;
    const Matrix frame = boost({sum.x / sum.t, sum.y / sum.t});
    const double begin = std::max((frame * one.body.start).t, (frame * other.body.start).t);
    const double soon = 1e-6 * size;
    double end = kNever;
    for (const PlayedLeg* leg : {&one, &other}) {
      const double own = (leg->next - leg->body.start.t) / leg->u.t;
      if (own < kNever) end = std::min(end, (frame * (leg->body.start + leg->u * own)).t);
    }
    if (begin + kSoon * size >= end) return 0.0;
    const Vec21 way =
        one.body.eventAt({0.0, 0.0}, frame, begin) - other.body.eventAt({0.0, 0.0}, frame, begin);
    if (-dot(way, way) > size * size) return 0.0;
    const double depth = overlapAt(one.body, other.body, frame, begin);
    if (depth < -1e-10) return 0.0;
    ++tally_.touching;
    const double deeper = (overlapAt(one.body, other.body, frame, begin + soon) - depth) / soon;
    const std::array<MovingShape, 2> flights{flightOn(one, outlines_[who[0]]),
                                             flightOn(other, outlines_[who[1]])};
    const std::optional<PersistentContact> earlier = earlierOf(*instant, who);
    const double byLaw = closingByLaw(one, other, flights, earlier ? &*earlier : nullptr);
    if (earlier) ++tally_.inEachOther;
    // Where they turn, the law of the kick and the distance can differ in the sign of what is nearly at rest.
    return std::min(byLaw, deeper);
  }

  CornerTally& tally_;
  double until_;
  std::vector<std::vector<PlayedLeg>> legs_;
  std::vector<std::optional<Outline>> outlines_;
  BilliardSetup setup_;
  CollisionScheduler again_;
  std::vector<Instant> instants_;
};

void drawRules(unsigned seed, std::mt19937_64& random, PhysicsRules& rules) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  if (seed % 3 != 0) rules.puckRestitution = uniform(0.0, 1.0), rules.cushionRestitution = uniform(0.0, 1.0);
  if (seed % 2 != 0) rules.puckFriction = uniform(0.0, 1.0), rules.cushionFriction = uniform(0.0, 1.0);
  rules.tangentialRestitution = uniform(0.0, 1.0);
  if (seed % 5 == 4) rules.collisionEvent = CollisionEvent::contact;
}

void checkBalance(const Billiard& game, const Ledger& before, const std::string& name, CornerTally& tally) {
  const Ledger now = game.ledger();
  const double energy_j =
      now.motion.energy_j + now.radiated.energy_j + now.takenByCushions.energy_j - before.motion.energy_j;
  const Vec2 momentum = now.motion.momentum_kg_m_s + now.radiated.momentum_kg_m_s +
                        now.takenByCushions.momentum_kg_m_s - before.motion.momentum_kg_m_s;
  const double energy = std::abs(energy_j) / before.motion.energy_j;
  const double missing = glm::length(momentum) * kC_m_s / before.motion.energy_j;
  if (!(energy <= 1e-10) || !(missing <= 1e-10))
    tally.faults.push_back(name + ": four-momentum is not conserved: " + std::to_string(energy) + ", " +
                           std::to_string(missing));
  tally.worstEnergy = std::max(tally.worstEnergy, energy);
  tally.worstMomentum = std::max(tally.worstMomentum, missing);
}

}  // namespace

std::vector<Vec2> rectangle(double length_m, double width_m) {
  const double x = 0.5 * length_m, y = 0.5 * width_m;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

Puck bodyOf(const std::string& name, const std::vector<Vec2>& outline_m) {
  Puck puck;
  puck.name = name;
  puck.outline_m = outline_m;
  puck.radius_m = radiusOf_m(outline_m);
  puck.height_m = 0.02, puck.mass_kg = 0.2, puck.inertia = 0.3;
  return puck;
}

BilliardSetup cornerGame(unsigned seed, int most) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.84, 1.42};
  drawRules(seed, random, setup.rules);
  const int count = 2 + static_cast<int>(seed % static_cast<unsigned>(most - 1));
  for (int tries = 0; tries < 1000 && static_cast<int>(setup.pucks.size()) < count; ++tries) {
    const int kind = static_cast<int>(uniform(0.0, 4.0));
    std::vector<Vec2> outline_m;
    if (kind == 1) outline_m = rectangle(uniform(0.06, 0.12), uniform(0.01, 0.03));
    if (kind == 2)
      outline_m = regular(3 + static_cast<int>(uniform(0, 6)), uniform(0.02, 0.06), uniform(0, 6));
    if (kind == 3)
      outline_m = {{0.05, -0.04},  {0.05, 0.04},  {0.03, 0.04},  {0.03, -0.02},
                   {-0.03, -0.02}, {-0.03, 0.04}, {-0.05, 0.04}, {-0.05, -0.04}};
    std::string name = std::to_string(setup.pucks.size());
    name.insert(0, 3 - name.size(), '0');
    Puck puck = bodyOf(name, outline_m);
    if (kind == 0) puck.radius_m = uniform(0.02, 0.05);
    puck.mass_kg = std::pow(10.0, uniform(-2.0, 0.0)), puck.inertia = uniform(0.2, 1.0);
    puck.position_m = {uniform(-1.3, 1.3), uniform(-0.6, 0.6)};
    const double at = uniform(0.0, 2.0 * M_PI), speed = uniform(0.0, seed % 7 == 0 ? 0.95 : 0.8);
    puck.beta = {speed * std::cos(at), speed * std::sin(at)};
    puck.spin_kg_m2_s = spinOfRim_kg_m2_s(puck, uniform(-1.0, 1.0), kC_m_s);
    setup.pucks.push_back(puck);
    try {
      checkSetup(setup);
    } catch (const std::invalid_argument&) {
      setup.pucks.pop_back();
    }
  }
  return setup;
}

BilliardSetup mirrored(const BilliardSetup& setup, const Vec2& signs) {
  BilliardSetup image = setup;
  for (Puck& puck : image.pucks) {
    puck.position_m *= signs, puck.beta *= signs, puck.spin_kg_m2_s *= -1.0;
    for (Vec2& corner : puck.outline_m) corner *= signs;
    std::reverse(puck.outline_m.begin(), puck.outline_m.end());
  }
  return image;
}

std::vector<double> eventDigits(const Billiard& game, const Vec2& signs) {
  std::vector<double> digits;
  for (const GameEvent& event : game.events()) {
    digits.insert(digits.end(),
                  {event.at.t_s, signs.x * event.at.r_m.x, signs.y * event.at.r_m.y, event.heat_j});
    for (const Turn& turn : event.turns)
      digits.insert(digits.end(), {static_cast<double>(turn.puck), turn.event.t_s, signs.x * turn.betaAfter.x,
                                   signs.y * turn.betaAfter.y, signs.x * signs.y * turn.spinAfter_kg_m2_s});
  }
  return digits;
}

void checkCornerGame(const BilliardSetup& setup, double until_s, const std::string& name,
                     CornerTally& tally) {
  Billiard game(setup);
  const Ledger before = game.ledger();
  game.advanceTo(until_s);
  checkBalance(game, before, name, tally);
  for (const GameEvent& event : game.events()) {
    if (event.kind == EventKind::puckPuck || event.kind == EventKind::puckCushion) ++tally.collisions;
    if (event.kind == EventKind::jam) ++tally.jams;
    if (event.withoutDelay) ++tally.withoutDelay;
    if (!(event.heat_j >= 0.0))
      tally.faults.push_back(name + ": heat below 0: " + std::to_string(event.heat_j));
  }
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const WorldLine& line = game.worldLines()[i];
    std::vector<Event> places;
    for (const Knot& knot : line.knots()) places.push_back(knot.turn);
    places.push_back(line.at(until_s).event);
    for (const Event& place : places) {
      if (!(std::abs(place.r_m.x) <= 0.5 * setup.board->length_m + kRounding_m) ||
          !(std::abs(place.r_m.y) <= 0.5 * setup.board->width_m + kRounding_m))
        tally.faults.push_back(name + ": puck " + setup.pucks[i].name + " is off the table at " +
                               std::to_string(place.t_s) + " s");
    }
  }
  ApproachCheck approach(setup, game, until_s, tally);
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    for (std::size_t k = i + 1; k < setup.pucks.size(); ++k) {
      const double fastest = approach.check(i, k);
      if (fastest > 1e-6) ++tally.approaching;
      tally.fastestApproach = std::max(tally.fastestApproach, fastest);
    }
  }
}

std::string otherBits(const Billiard& game, const Billiard& reversed, double until_s) {
  const std::size_t count = game.worldLines().size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto &one = game.worldLines()[i].knots(), &other = reversed.worldLines()[count - 1 - i].knots();
    for (std::size_t k = 0; k < one.size() && one[k].turn.t_s <= until_s; ++k) {
      const bool same = k < other.size() && one[k].turn.t_s == other[k].turn.t_s &&
                        one[k].turn.r_m == other[k].turn.r_m && one[k].u == other[k].u &&
                        one[k].properTime_s == other[k].properTime_s &&
                        one[k].spin.angle_rad == other[k].spin.angle_rad &&
                        one[k].spin.omega_rad_s == other[k].spin.omega_rad_s;
      if (!same) return "puck " + std::to_string(i) + ", leg " + std::to_string(k);
    }
  }
  return {};
}

}  // namespace carom::test
