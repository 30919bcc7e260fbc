// What the engine is built without where it runs in a page: exceptions end it (the page says so and goes on
// showing its picture), and a game that is played on in a page has no soft pucks, which take more than a
// phone has.

#include <cstddef>
#include <memory>

#include "engine/billiard/soft_game.h"

extern "C" {
void* __cxa_allocate_exception(std::size_t) { __builtin_trap(); }
void __cxa_throw(void*, void*, void (*)(void*)) { __builtin_trap(); }
}

namespace carom {

class SoftAhead::Player {};
SoftAhead::~SoftAhead() = default;

// The page asks only for games without soft pucks.
struct SoftGame::Snapshot {};
SoftGame::SoftGame(const BilliardSetup&, CollisionScheduler&, GameHistory&, SoftRowBook&) : play_({}) {
  __builtin_trap();
}
void SoftGame::playSlice(CollisionScheduler&, GameHistory&) { __builtin_trap(); }
void SoftGame::addStroke(std::size_t, const Stroke&) { __builtin_trap(); }
void SoftGame::playAhead() { __builtin_trap(); }
void SoftGame::addTo(Ledger&) const { __builtin_trap(); }
std::vector<FrozenPuck> SoftGame::frozen() const { __builtin_trap(); }
SoftMoment SoftGame::at(double, std::span<const SoftPoint>) { __builtin_trap(); }
void SoftGame::forgetBefore(double) { __builtin_trap(); }
std::shared_ptr<const SoftGame::Snapshot> SoftGame::snapshot(GameHistory&) const { __builtin_trap(); }
void SoftGame::restore(const Snapshot&, GameHistory&) { __builtin_trap(); }

}  // namespace carom
