#pragma once
// A person of another room, as they were told: moments one after the other, and what of them is seen or has
// happened by some moment here. Nothing is ever guessed: between two moments they went straight, and beyond
// the last one they stay where it told of them. Theory: app/doc/physics.md, Linked rooms.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

/// How a moment follows the one before.
enum class ToldKind : std::uint64_t {
  goesOn,
  begins,  ///< the person appears; moments of another one in this place are void
  ends,    ///< the person is gone, and vanishes
};

/// A moment of a person of another room. Board frame. Without padding: its bytes are shared and digested.
struct ToldMoment {
  std::uint64_t person = 0;  ///< counts the people of the other room from 0; below kMostViewers
  ToldKind kind = ToldKind::goesOn;
  Event head, hand;
  double properTime_s = 0.0;
  double facing_rad = 0.0;    ///< the way in which the head looks, anticlockwise from the board's x
  std::uint64_t hasHand = 0;  ///< 1: the hand points
  std::uint64_t hasCue = 0;   ///< 1: the cue is drawn back
  double cue_rad = 0.0;       ///< the way in which it would strike, anticlockwise from the board's x
  std::uint64_t caroms = 0;
  std::array<char, 32> name{};  ///< ends with a zero

  std::string_view nameText() const { return name.data(); }
  void setName(std::string_view text);
};
static_assert(std::is_trivially_copyable_v<ToldMoment> && sizeof(ToldMoment) == 160);

/// A person at one place of their path.
struct ToldView {
  Event head, hand;
  Vec3 u{0.0};  ///< γβ of the person, from the last moments
  double properTime_s = 0.0;
  double appears_s = 0.0;                  ///< board time of the first moment
  const ToldMoment* moment = nullptr;      ///< the last before the head's event; valid until the path changes
  const ToldMoment* handMoment = nullptr;  ///< and before the hand's
};

class ToldPath {
 public:
  explicit ToldPath(double lightSpeed_m_s) : c_m_s_(lightSpeed_m_s) {}

  /// Adds a moment. Leaves out a moment that nobody could have reached from the last: an earlier one, or one
  /// that only a motion faster than light would reach.
  void add(const ToldMoment& moment);
  /// Forgets the moments before `board_s` but the last of them.
  void forgetBefore(double board_s);

  /// Returns the person as of a moment here. `since_s(event)` is how long ago an event was by then: of a
  /// person who is seen, how long their light has been here (afterLightOf_s of engine/linked/promise.h); it
  /// must grow less along the path. Returns nothing before the first moment and after the end.
  std::optional<ToldView> at(const std::function<double(const Event&)>& since_s) const;

  const std::vector<ToldMoment>& moments() const { return moments_; }

 private:
  using Since = std::function<double(const Event&)>;
  Vec3 uAfter(std::size_t moment) const;
  std::size_t handBefore(const Since& since_s, std::size_t head) const;

  double c_m_s_;
  std::vector<ToldMoment> moments_;
};

}  // namespace carom
