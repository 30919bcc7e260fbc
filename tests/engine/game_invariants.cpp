#include "engine/game_invariants.h"

#include <exception>

#include "engine/game_checks.h"

namespace carom::test {

namespace {

using Account = Ledger::Account;

Account balanceOf(const Ledger& now) {
  return {now.motion.energy_j + now.radiated.energy_j + now.takenByCushions.energy_j +
              now.lostToFriction.energy_j - now.givenByStrokes.energy_j,
          now.motion.momentum_kg_m_s + now.radiated.momentum_kg_m_s + now.takenByCushions.momentum_kg_m_s +
              now.lostToFriction.momentum_kg_m_s - now.givenByStrokes.momentum_kg_m_s};
}

// The largest sum that has been in the books: what a rounding is a part of.
double turnover_j(const Ledger& now) {
  double sum_j = 0.0;
  for (const Account* account :
       {&now.motion, &now.radiated, &now.takenByCushions, &now.lostToFriction, &now.givenByStrokes})
    sum_j += std::abs(account->energy_j);
  return sum_j;
}

}  // namespace

// Every event rounds each account once or twice.
void checkLedger(Billiard& billiard, const BilliardSetup& setup, double until_s, std::size_t mostEvents,
                 Findings& found) {
  const double c = setup.lightSpeed_m_s, step_s = until_s / 64.0;
  const Account start = balanceOf(billiard.ledger());
  double most_j = turnover_j(billiard.ledger());
  for (int step = 1; step <= 64 && billiard.events().size() <= 2 * mostEvents; ++step) {
    billiard.advanceTo(step < 64 ? step * step_s : until_s);
    const Ledger now = billiard.ledger();
    const Account balance = balanceOf(now);
    most_j = std::max(most_j, turnover_j(now));
    const double tolerance_j =
        2.3e-16 * most_j * (64.0 + 16.0 * static_cast<double>(billiard.events().size()));
    const double energy_j = std::abs(balance.energy_j - start.energy_j);
    const double momentum_j = glm::length(balance.momentum_kg_m_s - start.momentum_kg_m_s) * c;
    found.expect(energy_j <= tolerance_j && momentum_j <= tolerance_j, "balance", "at ", step * step_s,
                 " s the books are wrong by ", energy_j, " J and ", momentum_j, " J/c of ", most_j, " J");
    if (!(energy_j <= tolerance_j && momentum_j <= tolerance_j)) return;
  }
}

std::vector<Violation> violationsOf(const BilliardSetup& setup, double until_s, std::size_t mostEvents,
                                    Tally& tally) {
  Findings found(tally);
  try {
    Billiard billiard(setup);
    checkLedger(billiard, setup, until_s, mostEvents, found);
    const GameRecord game(setup, billiard, until_s);
    checkWorldLines(game, found);
    checkProgress(game, found);
    if (billiard.events().size() > 4 * mostEvents) return found.all;
    checkCollisions(game, found);
    checkNoneMissed(game, found);
    checkSameBits(setup, until_s, found);
  } catch (const std::exception& error) {
    found.expect(false, "exception", error.what());
  }
  return found.all;
}

}  // namespace carom::test
