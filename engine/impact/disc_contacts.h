#pragma once
// The contacts and kicks of two discs, and of a disc and a cushion, with friction of the cloth or without.
// Theory: app/doc/physics.md, The frame of a contact.

#include "engine/impact/shape_contacts.h"

namespace carom {

class DiscPair final : public PairContacts {
 public:
  std::optional<Meeting> meetingOf(const GameState& game, const PuckPair& who) const override;
  bool haveMet(const GameState& game, int i, int other) const override;
  GameContact contactOf(const GameState& game, const PuckPair& who, bool withoutDelay) const override;
  bool recede(const GameState& game, const PuckPair& who, bool withoutDelay,
              GameContact& found) const override;
  std::optional<SpinningPairKick> kick(const GameState& game, const PuckPair& who, const PairContact& contact,
                                       const std::array<Vec21, 2>& u, const std::array<double, 2>& j,
                                       double restitution) const override;
  std::optional<JamContact> jamContactOf(const GameState&, const JamBody&, const JamBody&) const override {
    return JamContact{};
  }
};

class DiscAtCushion final : public CushionContacts {
 public:
  constexpr DiscAtCushion() : CushionContacts(false) {}
  std::optional<CushionContact> touchOf(const GameState& game, int i, const Leg& leg, const Turning& turning,
                                        int cushion) const override;
  std::optional<SpinningCushionKick> kick(const GameState& game, int i, int cushion, const Vec21& touch,
                                          const LegState& turn, double j, double restitution) const override;
  bool touches(const JamBody&, const CushionPlane&) const override { return true; }
};

}  // namespace carom
