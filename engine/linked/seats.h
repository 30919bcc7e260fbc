#pragma once
// Where the rooms of a linked game stand: round the board, and as far apart as the line between them needs.
// Theory: app/doc/physics.md, Linked rooms.

#include <cstddef>
#include <span>

#include <glm/vec2.hpp>

#include "engine/spacetime/observer.h"

namespace carom {

/// The most that rooms are moved apart for the sake of the line.
inline constexpr double kMostApart_m = 12.0;

/// The floor on which the people of a room walk: to the right and forward of its origin.
struct Floor {
  glm::dvec2 least_m{-1.0}, most_m{1.0};
};

/// Returns the start of room `room` of `rooms`: the scenario's, turned about the board's centre by
/// 360° · room/rooms, then moved outwards by half of `apart_m`. Outwards is away from the centre; of a start
/// at the centre, backwards.
ObserverStart seat(const ObserverStart& scenario, std::size_t room, std::size_t rooms, double apart_m);

/// Returns the least distance between the floors of two rooms on the board at their starts; 0 if they
/// overlap.
double floorsApart_m(const ObserverStart& first, const Floor& firstFloor, const ObserverStart& second,
                     const Floor& secondFloor);

/// Returns how far apart heads must be so that a line with this round trip (99 %) hardly makes them wait:
/// c · round trip/0.6, for people who come near reach 0.4 of their distance (reachBeside_m).
double distanceFor_m(double roundTrip_s, double c_m_s);

/// Returns by how much the rooms with these floors must be moved apart so that all floors are `wanted_m`
/// from each other; at most kMostApart_m.
double apartFor_m(const ObserverStart& scenario, std::span<const Floor> floors, double wanted_m);

}  // namespace carom
