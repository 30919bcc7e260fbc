#pragma once
// Whether the texts of a language have room at their places: every entry of the catalogue and of the shipped
// games, at each place of a rig's front wall and windows where it is shown, with the widest values it can
// get.

#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/rig/rig.h"
#include "cave/hud/hud_line.h"

namespace carom {

/// What an entry says in a language; an entry with a count has one of these for each form.
struct EntryWords {
  std::string entry;  ///< "message.kStroke", "angles.toml lesson question", "angles.toml name slow"
  std::string words;
};

/// An entry at one of its places.
struct TextPlace {
  std::string entry;  ///< and the place: "tile.kHome: desk, tile"
  int width_px = 0;   ///< as it is drawn, in letters of at least kLeastLetter_px
  int room_px = 0;
  int over_px() const { return width_px > room_px ? width_px - room_px : 0; }
};

/// Returns the words of an entry with the widest values that its places can get: `name` for a place without a
/// format of words that people read in the room, else the number of kWidestValues (text_places.cpp).
std::string withWidestValues(std::string_view entry, std::string_view words, std::string_view name);

/// Returns the places of these entries on a rig. The words that the program adds to a lesson's are those of
/// the language in use. Pages in browsers and titles of windows have no measure: they are not among them.
std::vector<TextPlace> textPlaces(std::string_view rigName, const Rig& rig,
                                  std::span<const EntryWords> entries);

/// Returns the names of the rigs that are examined where none is given.
std::span<const char* const> examinedRigs();

/// Prints the places as a table in the columns entry, language, width, room, pixels over.
void printTextPlaces(std::string_view language, std::span<const TextPlace> places, std::FILE* out = stdout);

}  // namespace carom
