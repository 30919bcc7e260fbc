#pragma once
// Whose turn it is at the table of two rooms, as the people of one room may know it: what those of the other
// room did counts here when its light is here. So the rooms may differ for as long as light is on its way,
// and agree once it has arrived. The rule is that of one room (app/play/match.h): a stroke passes the turn to
// the next person, and who sees their own stroke become a carom has the turn again, unless a later stroke has
// been made; later by the board's time, which is the same in both rooms.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/link/link_message.h"
#include "engine/base/limits.h"

namespace carom {

/// A person of one of two rooms.
struct LinkedPlayer {
  std::uint32_t room = 0, viewer = 0;
  bool operator==(const LinkedPlayer&) const = default;
};

class LinkedTurns {
 public:
  /// `room`: the number of this one, whose people know at once what they do.
  explicit LinkedTurns(std::uint32_t room) : room_(room) {}

  /// A room has joined: the people of room 1 begin their scores, after so many strokes of that room.
  void joined(std::uint32_t before);
  /// Knows of a stroke.
  void struck(const LinkStroke& stroke);
  /// Knows that a person saw at this event that their stroke of this number became a carom. Told again, it
  /// changes nothing.
  void carom(const LinkedPlayer& player, std::uint32_t stroke, const Event& seenAt);
  /// Counts all whose light has reached the eye.
  void look(const Event& eye, double lightSpeed_m_s);

  /// Returns the person who has the turn, as far as it has been seen here. `people`: their number in each
  /// room.
  LinkedPlayer turn(const std::array<std::uint32_t, 2>& people) const;
  /// Returns how many strokes of a person have been seen here.
  std::uint32_t strokes(const LinkedPlayer& player) const {
    return isPossible(player) ? strokes_[player.room][player.viewer] : 0;
  }

 private:
  using OfPlayers = std::array<std::array<std::uint32_t, kMostViewers>, 2>;
  struct Carom {
    LinkedPlayer player;
    std::uint32_t stroke = 0;
    Event seenAt;
  };

  static bool isPossible(const LinkedPlayer& player) {
    return player.room < 2 && player.viewer < kMostViewers;
  }
  void count(const LinkStroke& stroke);
  void count(const Carom& carom) { caroms_[carom.player.room][carom.player.viewer] = carom.stroke + 1; }

  std::uint32_t room_;
  std::vector<LinkStroke> strokesAhead_;  ///< whose light is still on its way
  std::vector<Carom> caromsAhead_;
  std::uint32_t before_ = 0;            ///< first strokes of room 1, which do not count
  OfPlayers strokes_{};                 ///< that were seen
  OfPlayers caroms_{}, caromsKnown_{};  ///< 1 + the number of the newest stroke that became a carom
  std::optional<LinkStroke> latest_;    ///< of those that were seen
};

}  // namespace carom
