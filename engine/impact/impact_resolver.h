#pragma once
// Commits the predicted events of a game, and their certain consequences: where each puck turns, the kicks of
// pucks and cushions, and strokes, after which kicks that are on their way act anew. c = 1.

#include <array>
#include <optional>

#include "engine/game/game_state.h"
#include "engine/impact/jam_resolver.h"
#include "engine/impact/shape_contacts.h"

namespace carom {

class ImpactResolver {
 public:
  ImpactResolver(GameState& game, GameHistory& history, const CellGrid& cells, Jam& jam)
      : game_(game), history_(history), jams_(game, history, cells, jam) {}

  /// Commits the meeting of two pucks. Returns until when this pair's contacts on the legs that they follow
  /// have been dealt with: for good, but where nothing comes of a contact of bodies that turn, up to this
  /// one.
  double collide(const PuckPair& who, const PredictedEvent& a);
  /// Commits the contact of a puck with the cushion `a.with`.
  void bounce(int i, const PredictedEvent& a);
  /// Commits a stroke. It changes the leg being followed. Kicks decided but still on their way keep their
  /// impulse (a cushion: its law) and act where their signal meets the new motion, or where the new motion
  /// itself has touched the cushion before. A cushion that the stroke keeps the puck from, or drives it away
  /// from, does nothing.
  void strike(int i, int stroke);

 private:
  struct Place {
    LegState turn;
    bool tooLate = false;  // a later turn has already been decided
    // For the signal of a cushion: the leg touched that cushion itself, and the signal of this came first.
    std::optional<CushionContact> touchedBefore;
  };
  void commitKick(const PuckPair& who, const GameContact& found, const std::array<LegState, 2>& turn,
                  const PairOutcome& outcome, const PredictedEvent& a);
  bool settlesJam(const PuckPair& who, const GameContact& found, const std::array<LegState, 2>& turn);
  void bounceAt(int i, int cushion, CushionContact contact, std::size_t foundOn);
  LegState turnOnFollowedLeg(int i, int which, const PairContact& contact, bool simultaneous) const;
  Place placeTurn(int i, const Vec21& signal, int cushion, const LegState& onFollowedLeg);
  Place whereSignalArrives(int i, const Vec21& signal, int cushion);
  std::optional<Vec21> cornerBefore(int cushion, const CushionContact& contact) const;
  void prevent(int i, const CommittedLeg& kick);
  void placeAnew(int i, CommittedLeg kick);
  void bounceAnew(int i, const LegState& turn, const Turning& turning, CommittedLeg& kick);
  void kickAnew(int i, const Vec21& u, const Turning& turning, CommittedLeg& kick) const;

  GameState& game_;
  GameHistory& history_;
  JamResolver jams_;
};

}  // namespace carom
