#pragma once
// The contacts and kicks of two bodies, at least one a polygon, and of a polygon and a cushion.
// Theory: app/doc/physics.md, Polygons.

#include <vector>

#include "engine/impact/shape_contacts.h"

namespace carom {

class PolygonPair final : public PairContacts {
 public:
  std::optional<Meeting> meetingOf(const GameState& game, const PuckPair& who) const override;
  /// Never: bodies that turn may meet with other corners.
  bool haveMet(const GameState&, int, int) const override { return false; }
  GameContact contactOf(const GameState& game, const PuckPair& who, bool withoutDelay) const override;
  bool recede(const GameState& game, const PuckPair& who, bool withoutDelay,
              GameContact& found) const override;
  std::optional<SpinningPairKick> kick(const GameState& game, const PuckPair& who, const PairContact& contact,
                                       const std::array<Vec21, 2>& u, const std::array<double, 2>& j,
                                       double restitution) const override;
  void kickElsewhere(const GameState& game, const PuckPair& who, const PairContact& contact,
                     PairOutcome& outcome) const override;
  void sendBack(const GameState& game, const PuckPair& who, const PairContact& contact,
                const std::array<LegState, 2>& turn, PairOutcome& outcome) const override;
  void noteContact(GameState& game, const PuckPair& who, const PairContact& contact) const override;
  /// Forgets the contacts of a puck with others from which it has parted.
  void forgetParted(GameState& game, int i) const;
  bool isStruckAgain(const GameState& game, int i, int other) const override;
  std::optional<JamContact> jamContactOf(const GameState& game, const JamBody& one,
                                         const JamBody& other) const override;
};

class PolygonAtCushion final : public CushionContacts {
 public:
  constexpr PolygonAtCushion() : CushionContacts(true) {}
  std::optional<CushionContact> touchOf(const GameState& game, int i, const Leg& leg, const Turning& turning,
                                        int cushion) const override;
  std::optional<SpinningCushionKick> kick(const GameState& game, int i, int cushion, const Vec21& touch,
                                          const LegState& turn, double j, double restitution) const override;
  bool liesAt(const GameState& game, int i, int cushion) const override;
  bool touches(const JamBody& body, const CushionPlane& cushion) const override;
};

}  // namespace carom
