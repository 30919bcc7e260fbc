#pragma once
// Finds the contacts and kicks that belong to the shapes of a game's pucks (shape_contacts.h).

#include "engine/impact/disc_contacts.h"
#include "engine/impact/polygon_contacts.h"

namespace carom {

inline constexpr DiscPair kDiscPair;
inline constexpr PolygonPair kPolygonPair;
inline constexpr DiscAtCushion kDiscAtCushion;
inline constexpr PolygonAtCushion kPolygonAtCushion;

inline const PairContacts& contactsOf(const GameState& game, int first, int second) {
  if (game.outlineOf(first) == nullptr && game.outlineOf(second) == nullptr) return kDiscPair;
  return kPolygonPair;
}

inline const CushionContacts& cushionContactsOf(const GameState& game, int i) {
  if (game.outlineOf(i) == nullptr) return kDiscAtCushion;
  return kPolygonAtCushion;
}

/// Forgets the contacts of a puck with others from which it has parted.
inline void forgetParted(GameState& game, int i) {
  if (game.rules.outlines != nullptr) kPolygonPair.forgetParted(game, i);
}

}  // namespace carom
