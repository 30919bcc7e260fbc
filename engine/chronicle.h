#pragma once
// What a game has delivered so far: the pucks' world lines and the list of collisions, in SI units and in the
// order of the setup. The game itself works with c = 1 and with the pucks in the order of their names.

#include <vector>

#include "engine/billiard.h"
#include "engine/puck_leg.h"

namespace carom {

class Chronicle {
 public:
  explicit Chronicle(const BilliardSetup& setup);

  /// Adds a leg to a puck's world line, with the next `complete`; `news` is the event from which the rest of
  /// the puck learns of it.
  void addLeg(std::size_t puck, const Leg& leg, const Vec21& news);
  /// Brings the world lines up to date.
  void complete();
  /// Forgets all legs of a puck but the first `legs`, counted from the start of the game.
  void keepLegs(std::size_t puck, std::size_t legs);
  std::size_t legs(std::size_t puck) const { return forgottenLegs_[puck] + lines_[puck].knots().size(); }

  /// Returns the collision's number, counted from the start of the game.
  std::size_t addCollision(std::optional<Cushion> cushion, const Vec21& contact, double heat_j);
  void addTurn(std::size_t collision, std::size_t puck, const Moment& before, const Vec21& uAfter);
  /// Replaces the turn of a puck in a collision; nothing if the collision is already forgotten.
  void changeTurn(std::size_t collision, std::size_t puck, const Moment& before, const Vec21& uAfter);
  void addHeat(std::size_t collision, double heat_j);
  void keepCollisions(std::size_t count);
  std::size_t collisionCount() const { return forgottenCollisions_ + collisions_.size(); }

  /// Forgets legs that ended and collisions that were over before board time `t_s`.
  void forgetBefore(double t_s);

  std::span<const WorldLine> worldLines() const { return lines_; }
  std::span<const Collision> collisions() const { return collisions_; }

 private:
  struct NewLeg {
    std::size_t puck = 0;
    Leg leg;
    Vec21 news;
  };
  Event eventOf(std::size_t puck, const Vec21& x) const;
  Turn turnOf(std::size_t puck, const Moment& before, const Vec21& uAfter) const;

  double c_m_s_;
  double friction_m_s2_;
  std::vector<double> height_m_;  // of each puck's centre
  std::vector<WorldLine> lines_;
  std::vector<NewLeg> newLegs_;  // not in the lines yet
  std::vector<Collision> collisions_;
  std::vector<std::size_t> forgottenLegs_;
  std::size_t forgottenCollisions_ = 0;
};

}  // namespace carom
