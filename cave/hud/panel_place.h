#pragma once
// Where words and buttons have their place on the front wall.

#include <algorithm>

#include <glm/geometric.hpp>

#include "cave/room/off_axis.h"
#include "cave/room/wall.h"

namespace carom {

struct PanelPlace {
  static constexpr double kCapital_m = 0.04;  ///< height of a capital: 1.5° from 1.5 m, as in printed text
  static constexpr double kMargin = 0.04;    ///< fraction of the wall's height, from its left and upper edges
  static constexpr double kHighest_m = 2.2;  ///< above the floor: the panel's upper edge at most
  /// The largest fractions of the wall's width and height that the panel may take, to leave room for the game
  /// beside it. If the text needs more, its letters get smaller.
  static constexpr double kMostOfWidth = 0.4, kMostOfHeight = 0.4;
  /// The band stands above the height of the eyes over the floor, as far as the wall reaches; a long text may
  /// go down to the second height, above a table in the room.
  static constexpr double kEyes_m = 1.7, kLowest_m = 1.35;
  /// The height of a capital of the band, as a fraction of the picture's height.
  static constexpr double kBandCapital = 1.0 / 40.0;
  static constexpr double kCapitalOfLetters =
      0.72;  ///< a capital's height, as a fraction of the nominal height

  /// Returns the nominal height of the band's letters, as a fraction of the picture's height.
  static double bandLetter(const Wall& wall) { return wall.textSize * kBandCapital / kCapitalOfLetters; }

  /// Returns the height of a wall's lower edge above the floor, in a room whose floor is at height 0.
  static double foot_m(const Wall& wall) {
    return glm::dot(wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m) / sizeOf_m(wall).y;
  }

  /// Returns the height of the panel's upper edge above the wall's lower edge.
  static double top_m(const Wall& wall, double margin_m) {
    const double height_m = sizeOf_m(wall).y;
    return std::min(height_m - margin_m, std::max(kHighest_m - foot_m(wall), 0.5 * height_m));
  }

  /// Returns the fraction of the wall's height that the band may take.
  static double mostOfBand(const Wall& wall) {
    return std::max(kMostOfHeight, 1.0 - (kLowest_m - foot_m(wall)) / sizeOf_m(wall).y);
  }
};

}  // namespace carom
