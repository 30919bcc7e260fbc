// World lines: see checkWorldLines.

#include "engine/game_checks.h"

namespace carom::test {

namespace {

void checkTurn(const GameRecord& game, std::size_t puck, std::size_t knot, Findings& found) {
  const CheckedLeg& before = game.legs[puck][knot - 1];
  const CheckedLeg& after = game.legs[puck][knot];
  const std::string& name = game.setup->pucks[puck].name;
  const CheckedLeg::LegState then = before.at(after.start.t);
  const Real tolerance = roundingAt(after.start);
  found.expect(after.start.t >= before.start.t, "world line", name, ": turn ", knot, " at ", after.start.t,
               " m of light lies before the last, ", before.start.t);
  const Real jump = lengthInPlane(after.start - then.x);
  found.expect(jump <= tolerance, "world line", name, ": jumps by ", jump, " m at ", after.start.t / game.c,
               " s");
  const Real clock = std::abs(after.properTime - then.properTime);
  found.expect(clock <= tolerance, "clock", name, ": its clock jumps by ", clock, " m of light at ",
               after.start.t / game.c, " s");
  found.expect(std::isfinite(after.u.t) && after.u.t < 1e8L, "world line", name, ": γ = ", after.u.t, " at ",
               after.start.t / game.c, " s");
  found.expect(game.partOfKnot[puck][knot] >= 0, "world line", name, ": turns at ", after.start.t / game.c,
               " s and no event says why");
}

// A leg is straight, braked or not: nothing between its ends is farther out than these.
void checkInside(const GameRecord& game, std::size_t puck, const Four& x, Findings& found) {
  const Real out = std::max(std::abs(x.x) - Real(game.setup->board->length_m) / 2,
                            std::abs(x.y) - Real(game.setup->board->width_m) / 2);
  found.expect(out <= roundingAt(x), "outside", game.setup->pucks[puck].name, ": its centre is ", out,
               " m outside the table at ", x.t / game.c, " s");
}

}  // namespace

void checkWorldLines(const GameRecord& game, Findings& found) {
  for (std::size_t puck = 0; puck < game.legs.size(); ++puck) {
    const auto& legs = game.legs[puck];
    for (std::size_t k = 0; k < legs.size(); ++k) {
      ++found.tally["legs"];
      if (k > 0) checkTurn(game, puck, k, found);
      if (!game.setup->board || legs[k].start.t > game.until) continue;
      checkInside(game, puck, legs[k].start, found);
      checkInside(game, puck, legs[k].at(std::min(legs[k].end, game.until)).x, found);
    }
    for (const Part& part : game.parts[puck]) {
      found.expect(part.knot > 0 || part.idle, "world line", game.setup->pucks[puck].name, ": event ",
                   part.event, " says that it turns at ", part.turn / game.c,
                   " s and its world line does not");
    }
  }
}

// Light crosses a thousandth of the radius in the time in which no puck may collide so often.
void checkProgress(const GameRecord& game, Findings& found) {
  constexpr std::size_t kOften = 512;
  for (std::size_t puck = 0; puck < game.legs.size(); ++puck) {
    const auto& legs = game.legs[puck];
    for (std::size_t k = kOften; k < legs.size(); k += kOften) {
      const Real spent = legs[k].start.t - legs[k - kOften].start.t;
      found.expect(spent > Real(1e-3) * game.radius(puck), "no progress", game.setup->pucks[puck].name, ": ",
                   kOften, " turns within ", spent / game.c, " s at ", legs[k].start.t / game.c, " s");
    }
  }
}

}  // namespace carom::test
