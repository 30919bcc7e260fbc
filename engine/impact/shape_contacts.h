#pragma once
// How bodies meet each other and cushions, and kick each other: two interfaces, with an implementation for
// each pair of shapes (disc_contacts.h, polygon_contacts.h). A game gets the one for its pucks from
// contact_finder.h, so that nothing else asks which shapes they have. c = 1; of two pucks the one with the
// smaller number comes first.

#include <array>
#include <optional>

#include "engine/collision/cushion_contact.h"
#include "engine/collision/puck_contact.h"
#include "engine/collision/rim_friction.h"
#include "engine/game/game_state.h"
#include "engine/impact/jam_solver.h"

namespace carom {

/// How the contact of two pucks that others press comes to rest.
enum class JamLaw {
  none,        ///< it is a kick as ever
  plastic,     ///< with all that touch it, without rebound
  everywhere,  ///< with all that touch it, at all places at which bodies lie on each other
};

/// A contact on the legs that two pucks follow, as it is found again to be committed.
struct GameContact {
  PairContact contact;
  std::array<double, 2> touchAt{};  ///< with friction, board times: `BrakedMeeting::touchAt`
  /// Up to when the contacts of this pair of legs are dealt with if nothing comes of this one, in the bodies'
  /// frame, and if it kicks them.
  double until = kNever, untilAfterKick = kNever;
  JamLaw jam = JamLaw::none;
  bool unfinished = false, sideOnSide = false;  ///< see `CornerContact`
};

/// The result of a contact, in one kick or several.
struct PairOutcome {
  SpinningPairKick kick;
  double restitution = 1.0;
  std::array<Vec21, 2> radiated;

  PairOutcome(const SpinningPairKick& first, double e) : kick(first), restitution(e) {
    for (int k = 0; k < 2; ++k) radiated[k] = first.centres.u[k] * first.centres.heat[k];
  }
  void add(const SpinningPairKick& next) {
    for (int k = 0; k < 2; ++k) {
      radiated[k] = radiated[k] + next.centres.u[k] * next.centres.heat[k];
      kick.centres.heat[k] += next.centres.heat[k];
      kick.centres.u[k] = next.centres.u[k];
      kick.j[k] = next.j[k];
    }
  }
};

/// The contacts and kicks of two bodies of certain shapes.
class PairContacts {
 public:
  /// Returns their next meeting on the legs that both follow.
  virtual std::optional<Meeting> meetingOf(const GameState& game, const PuckPair& who) const = 0;
  /// Returns whether nothing more comes of these legs, because they have led to a collision.
  virtual bool haveMet(const GameState& game, int i, int other) const = 0;
  /// Returns the contact of the meeting that was found last.
  virtual GameContact contactOf(const GameState& game, const PuckPair& who, bool withoutDelay) const = 0;
  /// Returns whether they recede from each other by the momenta that are decided. Where they approach at
  /// another place, this becomes the contact.
  virtual bool recede(const GameState& game, const PuckPair& who, bool withoutDelay,
                      GameContact& found) const = 0;
  /// Returns the kick at a contact of two with these velocities and spins; none if they recede.
  virtual std::optional<SpinningPairKick> kick(const GameState& game, const PuckPair& who,
                                               const PairContact& contact, const std::array<Vec21, 2>& u,
                                               const std::array<double, 2>& j, double restitution) const = 0;
  /// Adds the kicks at other places that belong to the impact.
  virtual void kickElsewhere(const GameState&, const PuckPair&, const PairContact&, PairOutcome&) const {}
  /// Adds the kick without which they would part on another side than that on which they touch, once they
  /// have turned. After `noteContact`.
  virtual void sendBack(const GameState&, const PuckPair&, const PairContact&, const std::array<LegState, 2>&,
                        PairOutcome&) const {}
  /// Notes a contact that kicks them.
  virtual void noteContact(GameState&, const PuckPair&, const PairContact&) const {}
  /// Returns whether the last contact of either is with the other, at another place, and its signal on its
  /// way.
  virtual bool isStruckAgain(const GameState&, int, int) const { return false; }
  /// Returns how two bodies near each other touch in a jam; none if they do not.
  virtual std::optional<JamContact> jamContactOf(const GameState& game, const JamBody& one,
                                                 const JamBody& other) const = 0;

 protected:
  ~PairContacts() = default;
};

/// The contacts and kicks of a body of a certain shape and a cushion.
class CushionContacts {
 public:
  /// Returns whether a body with this velocity can come to touch the cushion: a corner can turn into it.
  bool mayTouch(const CushionPlane& cushion, const Vec21& u) const {
    return hasSides_ || cushion.towards(u) > 0.0;
  }
  /// Returns the contact of a leg with a cushion.
  virtual std::optional<CushionContact> touchOf(const GameState& game, int i, const Leg& leg,
                                                const Turning& turning, int cushion) const = 0;
  /// Returns the kick at `touch`; none if what touches the cushion does not move towards it.
  virtual std::optional<SpinningCushionKick> kick(const GameState& game, int i, int cushion,
                                                  const Vec21& touch, const LegState& turn, double j,
                                                  double restitution) const = 0;
  /// Whether the body can lie on a cushion. One that cannot stops where it comes to it almost at rest.
  bool canLie() const { return hasSides_; }
  /// Returns whether it touches with a side on the leg that it follows.
  virtual bool liesAt(const GameState&, int, int) const { return false; }
  /// Returns whether a body that is near a cushion touches it.
  virtual bool touches(const JamBody& body, const CushionPlane& cushion) const = 0;

 protected:
  constexpr explicit CushionContacts(bool hasSides) : hasSides_(hasSides) {}
  ~CushionContacts() = default;

 private:
  bool hasSides_;
};

}  // namespace carom
