#pragma once
// The messages between linked rooms, as values and as bytes:
//
//   u16 type, u32 length, body; little endian, doubles as they are
//
// What is read is bounded and checked as far as one message alone can be: every number is finite, every place
// within 1 km, every attitude a rotation. Whether it keeps the promises told before,
// engine/linked/other_room.h judges.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "engine/linked/final_digest.h"
#include "engine/linked/seats.h"
#include "engine/linked/told.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

inline constexpr std::uint32_t kLinkProtocol = 3;
/// The most bytes of a message, of a welcome, of its scenario, and of a name.
inline constexpr std::size_t kMostLinkBytes = 64 << 10, kMostWelcomeBytes = 2 << 20;
inline constexpr std::size_t kMostScenarioBytes = 256 << 10, kMostLinkName = 24;
/// The most rooms of a game, and meshes of a scenario.
inline constexpr std::uint32_t kMostRooms = 4, kMostLinkMeshes = 64;
/// The most turns of a second that are told.
inline constexpr std::uint32_t kMostTurnsTold = 800;
/// Nothing is farther from the board.
inline constexpr double kMostLinkPlace_m = 1000.0;

/// The first message of either side.
struct LinkHello {
  std::uint32_t protocol = kLinkProtocol;
  std::uint64_t arithmetic = 0;  ///< fingerprint of the program's arithmetic
  std::string program, room;     ///< the program's version; the room's name
  std::vector<std::string> viewers;
  Floor floor;
  std::uint64_t game = 0;   ///< the linked game that it still plays, as the welcome named it; 0: none
  std::uint32_t heard = 0;  ///< how many of the receiver's strokes of that game are here
};
struct LinkPing {
  std::uint64_t number = 0;
  std::int64_t sent_ns = 0;  ///< of the sender's own clock; comes back in the answer
};
struct LinkPong {
  LinkPing ping;
};
/// A stroke, and the room in which it was made.
struct LinkStroke {
  std::uint32_t room = 0;  ///< 0: the host
  StrokeTold told;
};
/// The game that a joiner is to play, from the host.
struct LinkWelcome {
  struct Mesh {
    std::string name;  ///< of a file, without a folder
    std::uint64_t digest = 0;
  };
  std::uint64_t game = 0;  ///< a number of its own for this game of these rooms; not 0
  std::uint32_t room = 1, rooms = 2;
  double apart_m = 0.0, lightSpeedShown_m_s = 0.0, board_s = 0.0;
  std::string scenario;
  std::vector<Mesh> meshes;
  std::vector<LinkStroke> strokes;  ///< so far, of all rooms
};
/// Beside the promise, how a person is drawn.
struct LinkPerson {
  glm::dquat attitude{1.0, 0.0, 0.0, 0.0};  ///< roomFromHead, of a head with x right, y forward, z up
  Vec3 celerity_m_s{0.0};                   ///< room frame
  std::uint32_t held = 0;                   ///< the puck for which the cue is held, from 1 on; 0: none
  Vec3 pull_m{0.0};  ///< the way in which the cue would strike, room frame; 0: it is not drawn back
  std::uint32_t caroms = 0;
  std::uint32_t lastCarom = 0;  ///< 1 + the number of their newest stroke that they saw become one; 0: none
};
/// A room after one of its frames.
struct LinkPresent {
  std::uint32_t room = 0;
  Present present;
  std::array<LinkPerson, kMostViewers> persons;
  glm::dmat4 boardFromRoom{1.0};
};
/// The joiner's first present: it lives once all rooms have accepted it.
struct LinkReady {
  LinkPresent first;
};
struct LinkAccept {
  std::uint32_t room = 0;  ///< that accepts
};
/// The digest of all events before a board second that nothing can change any more.
struct LinkDigest {
  std::uint32_t second = 0;
  std::uint64_t digest = 0;
};
/// The turns of a second before which two games have differed for the first time, by which it is found out
/// where.
struct LinkTurns {
  std::uint32_t second = 0;
  std::uint64_t strokes = 0;  ///< digest of all strokes of the game before it
  std::vector<FinalTurn> turns;
};
struct LinkSettings {
  std::uint32_t number = 0;  ///< the newest counts
  double lightSpeedShown_m_s = 0.0;
  bool isFrozen = false;
};
struct LinkBye {
  std::string reason;
};
using LinkMessage = std::variant<LinkHello, LinkPing, LinkPong, LinkWelcome, LinkReady, LinkAccept,
                                 LinkPresent, LinkStroke, LinkDigest, LinkSettings, LinkBye, LinkTurns>;

/// The line can be used no more; what() says what was read, in words for people.
class BrokenLink : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends a message to `bytes`.
void append(const LinkMessage& message, std::vector<std::uint8_t>& bytes);

/// Returns the number of bytes of the whole message that begins here; none if its head is not whole. Throws
/// BrokenLink for a type that there is not, and for one that is too long.
std::optional<std::size_t> sizeOfLinkMessage(std::span<const std::uint8_t> bytes);

/// Returns the message that these bytes are, to the last. Throws BrokenLink if they are none.
LinkMessage linkMessageOf(std::span<const std::uint8_t> bytes);

}  // namespace carom
