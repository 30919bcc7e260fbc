#include "cave/cluster/frame_lock.h"

#include <gtest/gtest.h>

#include <map>

namespace carom {
namespace {

/// A graphics card with a sync card, as GLX_NV_swap_group shows it.
struct Card {
  unsigned groups = 1, barriers = 1;
  bool lets = true;  ///< windows join
  std::map<SwapGroupCalls::Drawable, unsigned> groupOf;
  unsigned barrierOfGroup = 0;
  unsigned count = 0;
  int queries = 0;
};
Card card;

SwapGroupCalls callsOfCard() {
  card = {};
  SwapGroupCalls calls;
  calls.maxima = [](void*, int, unsigned* groups, unsigned* barriers) {
    *groups = card.groups;
    *barriers = card.barriers;
    return 1;
  };
  calls.join = [](void*, SwapGroupCalls::Drawable window, unsigned group) {
    if (card.lets) card.groupOf[window] = group;
    return card.lets ? 1 : 0;
  };
  calls.bind = [](void*, unsigned group, unsigned barrier) {
    if (card.lets && group == 1) card.barrierOfGroup = barrier;
    return card.lets ? 1 : 0;
  };
  calls.query = [](void*, SwapGroupCalls::Drawable window, unsigned* group, unsigned* barrier) {
    ++card.queries;
    *group = card.groupOf[window];
    *barrier = *group == 1 ? card.barrierOfGroup : 0;
    return 1;
  };
  calls.frameCount = [](void*, int, unsigned* count) {
    *count = card.count;
    return 1;
  };
  return calls;
}

/// A second of frames at 60 Hz, the cards' counter going on or not.
void play(NodeLock& lock, double& now_s, bool counts) {
  for (int i = 0; i < 61; ++i) {
    now_s += 1.0 / 60.0;
    if (counts) ++card.count;
    lock.swapped(now_s);
  }
}

TEST(FrameLock, JoinedPendingLostAndBack) {
  NodeLock lock(callsOfCard(), {11, 12});
  EXPECT_EQ(card.groupOf, (std::map<SwapGroupCalls::Drawable, unsigned>{{11, 1}, {12, 1}}));
  EXPECT_EQ(card.barrierOfGroup, 1U);
  EXPECT_EQ(lock.whyNot(), "");
  double now_s = 100.0;
  lock.swapped(now_s);
  EXPECT_EQ(lock.state(), LockState::pending);
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::joined);
  play(lock, now_s, false);  // the cable is out
  EXPECT_EQ(lock.state(), LockState::lost);
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::joined);

  card.groupOf[12] = 0;  // the driver has let go of one window
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::lost);
  EXPECT_EQ(card.groupOf[12], 1U) << "it joins again";
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::joined);

  card.barrierOfGroup = 0;
  card.lets = false;
  play(lock, now_s, true);
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::lost) << "while it cannot be bound again";
  card.lets = true;
  play(lock, now_s, true);
  play(lock, now_s, true);
  EXPECT_EQ(lock.state(), LockState::joined);
}

TEST(FrameLock, TheDriverIsAskedOnceASecond) {
  NodeLock lock(callsOfCard(), {11});
  double now_s = 0.0;
  for (int second = 0; second < 5; ++second) play(lock, now_s, true);
  EXPECT_EQ(card.queries, 5);
}

TEST(FrameLock, WhatIsMissingIsSaidAndTheSoftwareLockStays) {
  EXPECT_EQ(NodeLock().state(), LockState::software);
  EXPECT_EQ(NodeLock().whyNot(), "");
  const auto whyNot = [](const std::optional<SwapGroupCalls>& driver,
                         std::vector<SwapGroupCalls::Drawable> windows) {
    NodeLock lock(driver, std::move(windows));
    EXPECT_EQ(lock.state(), LockState::software);
    for (int i = 0; i < 5; ++i) lock.swapped(i);
    EXPECT_EQ(lock.state(), LockState::software);
    return lock.whyNot();
  };
  EXPECT_EQ(whyNot(std::nullopt, {11}), "the driver lacks GLX_NV_swap_group");
  EXPECT_EQ(whyNot(callsOfCard(), {}), "there is no window");
  SwapGroupCalls calls = callsOfCard();
  card.groups = 0;
  EXPECT_EQ(whyNot(calls, {11}), "the graphics card has no swap group");
  calls = callsOfCard();
  card.barriers = 0;
  EXPECT_EQ(whyNot(calls, {11}), "the graphics card has no swap barrier: is a sync card built in?");
  calls = callsOfCard();
  card.lets = false;
  EXPECT_EQ(whyNot(calls, {11}), "the driver does not let the windows join a swap group and its barrier");
}

}  // namespace
}  // namespace carom
