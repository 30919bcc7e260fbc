#include "engine/linked/final_digest.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>

#include "engine/base/xxh3.h"
#include "engine/billiard/billiard.h"

namespace carom {

FinalDigest::FinalDigest(std::span<const std::string> names) : order_(names.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, {}, [&](std::size_t puck) { return names[puck]; });
}

void FinalDigest::add(std::span<const WorldLine> pucks, double final_s) {
  while (second_ + 1.0 <= final_s) {
    const double from_s = second_, to_s = second_ + 1.0;
    turns_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const auto knots = pucks[order_[i]].knots();
      auto knot = std::ranges::lower_bound(knots, from_s, {}, [](const Knot& k) { return k.turn.t_s; });
      for (; knot != knots.end() && knot->turn.t_s < to_s; ++knot) {
        turns_.push_back({static_cast<double>(i), knot->turn.t_s, knot->turn.r_m.x, knot->turn.r_m.y,
                          knot->u.x, knot->u.y, knot->properTime_s, knot->spin.omega_rad_s,
                          knot->spin.angle_rad});
      }
    }
    value_ = XXH3_64bits_withSeed(turns_.data(), turns_.size() * sizeof(FinalTurn), value_);
    ++second_;
  }
}

std::optional<TurnDifference> firstDifference(std::span<const FinalTurn> here,
                                              std::span<const FinalTurn> there) {
  const auto byPuck = [](std::span<const FinalTurn> turns) {
    std::map<double, std::vector<const FinalTurn*>> all;
    for (const FinalTurn& turn : turns) all[turn[0]].push_back(&turn);
    return all;
  };
  auto ours = byPuck(here), theirs = byPuck(there);
  for (const auto& [puck, turns] : theirs) ours[puck];  // those who turn there alone
  std::optional<TurnDifference> first;
  for (const auto& [puck, turns] : ours) {
    const std::vector<const FinalTurn*>& others = theirs[puck];
    for (std::size_t i = 0; i < std::max(turns.size(), others.size()); ++i) {
      const FinalTurn* const one = i < turns.size() ? turns[i] : nullptr;
      const FinalTurn* const other = i < others.size() ? others[i] : nullptr;
      if (one && other && std::memcmp(one, other, sizeof(FinalTurn)) == 0) continue;
      const double t_s = std::min(one ? (*one)[1] : (*other)[1], other ? (*other)[1] : (*one)[1]);
      if (!first || t_s < first->t_s) first = {static_cast<std::size_t>(puck), i + 1, t_s};
      break;
    }
  }
  return first;
}

namespace {

constexpr double kFingerprint_s = 20.0;

/// Discs and a table that are not elastic and rough, and strokes; or, with corners, a bar among discs.
BilliardSetup fingerprintGame(bool hasCorners) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{1.6, 0.9};
  setup.rules.puckRestitution = 0.97;
  setup.rules.cushionRestitution = 0.95;
  setup.rules.puckFriction = 0.2;
  setup.rules.cushionFriction = 0.15;
  setup.rules.tangentialRestitution = 0.3;
  setup.pucks = {{"a", 0.03, 0.02, 0.2, {-0.6, 0.1}, {0.7, 0.13}},
                 {"b", 0.04, 0.02, 0.3, {0.3, -0.2}, {-0.4, 0.35}},
                 {"c", 0.03, 0.02, 0.2, {0.55, 0.21}, {-0.2, -0.61}},
                 {"d", 0.05, 0.02, 0.4, {0.0, 0.3}, {0.1, -0.3}}};
  setup.pucks[0].spin_kg_m2_s = 0.001;
  if (hasCorners) {
    Puck& bar = setup.pucks[3];
    bar.outline_m = {{-0.05, -0.02}, {0.05, -0.02}, {0.05, 0.02}, {-0.05, 0.02}};
    bar.radius_m = radiusOf_m(bar.outline_m);
  } else {
    setup.rules.friction_m_s2 = 0.02;
    setup.rules.spinDeceleration_m_s2 = 0.05;
  }
  for (int i = 0; i < 12; ++i) {
    const double way = 0.05 + 0.01 * i;
    setup.strokes.push_back({static_cast<std::size_t>(i % 4),
                             1.0 + 1.5 * i,
                             Vec3(0.1 * i - 0.6, -0.8, 0.4),
                             {way, 0.2 - way},
                             0.01});
  }
  return setup;
}

std::uint64_t digestOfGame(const BilliardSetup& setup) {
  Billiard game(setup);
  game.advanceTo(kFingerprint_s);
  std::vector<std::string> names;
  for (const Puck& puck : setup.pucks) names.push_back(puck.name);
  FinalDigest digest(names);
  digest.add(game.worldLines(), kFingerprint_s);
  return digest.value();
}

}  // namespace

std::uint64_t arithmeticFingerprint() {
  const std::uint64_t games[] = {digestOfGame(fingerprintGame(false)), digestOfGame(fingerprintGame(true))};
  return XXH3_64bits(games, sizeof games);
}

}  // namespace carom
