#include "engine/spacetime/knot_store.h"

#include <gtest/gtest.h>

#include <memory_resource>
#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

Knot randomKnot(test::Random& random, bool onBoard) {
  Knot knot;
  knot.turn = {random.in(0.0, 10.0), random.inBox(1.0)};
  knot.u = random.u(0.9);
  knot.properTime_s = random.in(0.0, 10.0);
  knot.signal = {random.in(0.0, 10.0), random.inBox(1.0)};
  if (onBoard) {
    knot.turn.r_m.z = knot.signal.r_m.z = 0.01;
    knot.u.z = 0.0;
  } else {
    knot.deceleration_m_s2 = random.in(0.0, 1.0);
    knot.spin = {random.in(-3.0, 3.0), random.in(-9.0, 9.0), random.in(-1.0, 1.0), 0.1};
  }
  return knot;
}

void expectSame(const Knot& one, const Knot& other) {
  EXPECT_EQ(one.turn.t_s, other.turn.t_s);
  EXPECT_EQ(one.turn.r_m, other.turn.r_m);
  EXPECT_EQ(one.u, other.u);
  EXPECT_EQ(one.properTime_s, other.properTime_s);
  EXPECT_EQ(one.signal.t_s, other.signal.t_s);
  EXPECT_EQ(one.signal.r_m, other.signal.r_m);
  EXPECT_EQ(one.deceleration_m_s2, other.deceleration_m_s2);
  EXPECT_TRUE(one.spin == other.spin);
}

void expectSame(const KnotStore& store, const std::vector<Knot>& plain, const std::vector<double>& settled) {
  ASSERT_EQ(store.size(), plain.size());
  const Knots knots(store);
  std::size_t i = 0;
  for (const Knot& knot : knots) {
    expectSame(knot, plain[i]);
    EXPECT_EQ(store.turn_s(i), plain[i].turn.t_s);
    EXPECT_EQ(store.settling(i).after_s, settled[i]);
    ++i;
  }
  expectSame(store.back(), plain.back());
}

// Beside two plain arrays: knots of the board, and knots that differ in height, friction or spin.
TEST(KnotStore, HoldsWhatPlainArraysHold) {
  test::Random random(61);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const bool onBoard = random.in(0.0, 1.0) < 0.5;
    std::vector<Knot> plain{randomKnot(random, onBoard)};
    std::vector<double> settled{random.in(0.0, 1.0)};
    const Knot origin = plain[0];
    KnotStore store(origin, {settled[0], 0.0, true}, std::pmr::get_default_resource());
    for (int step = 0; step < 60; ++step) {
      const double choice = random.in(0.0, 1.0);
      const auto count = static_cast<std::size_t>(random.in(0.0, static_cast<double>(plain.size())));
      if (choice < 0.7) {
        plain.push_back(randomKnot(random, onBoard || random.in(0.0, 1.0) < 0.5));
        if (onBoard && random.in(0.0, 1.0) < 0.02) plain.back().deceleration_m_s2 = 0.5;
        settled.push_back(random.in(0.0, 1.0));
        store.push_back(plain.back(), {settled.back(), 0.0, true});
      } else if (choice < 0.85) {
        plain.resize(std::max<std::size_t>(1, count));
        settled.resize(plain.size());
        store.keepFirst(plain.size());
      } else {
        plain.erase(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(count));
        settled.erase(settled.begin(), settled.begin() + static_cast<std::ptrdiff_t>(count));
        store.dropFirst(count);
      }
      expectSame(store, plain, settled);
    }
    expectSame(store.origin(), origin);
  }
}

TEST(KnotStore, CopiesAreTheirOwn) {
  test::Random random(62);
  std::vector<Knot> plain{randomKnot(random, true)};
  std::vector<double> settled{0.5};
  KnotStore store(plain[0], {0.5, 0.0, true}, std::pmr::get_default_resource());
  for (int k = 0; k < 10; ++k) {
    plain.push_back(randomKnot(random, k % 3 != 0));
    settled.push_back(k);
    store.push_back(plain.back(), {static_cast<double>(k), 0.0, true});
  }
  KnotStore copy(store);
  store.push_back(randomKnot(random, true), {});
  expectSame(copy, plain, settled);
  copy = copy;
  expectSame(copy, plain, settled);
  KnotStore moved(std::move(copy));
  expectSame(moved, plain, settled);
  store = moved;
  expectSame(store, plain, settled);
  KnotStore another(plain[0], {}, std::pmr::get_default_resource());
  another = std::move(moved);
  expectSame(another, plain, settled);
}

TEST(KnotStore, PartsAndPlacesAreThoseOfAContainer) {
  test::Random random(63);
  KnotStore store(randomKnot(random, true), {}, std::pmr::get_default_resource());
  for (int k = 0; k < 9; ++k) store.push_back(randomKnot(random, true), {});
  const Knots all(store), rest = all.subspan(4);
  EXPECT_EQ(rest.size(), 6u);
  expectSame(rest.front(), all[4]);
  expectSame(*(all.end() - 1), all.back());
  EXPECT_EQ(all.end() - all.begin(), 10);
  EXPECT_LT(all.begin(), all.end());
}

}  // namespace
}  // namespace carom
