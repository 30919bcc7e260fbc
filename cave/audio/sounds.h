#pragma once
// The clicks of a game, played through OpenAL when the light of each event arrives (cave/audio/heard.h): on
// loudspeakers around the room, or on headphones of a person who looks forward in it.

#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"

namespace carom {

/// The person's directions in the room's axes: unit vectors.
struct SoundAxes {
  glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
};

class Sounds {
 public:
  /// Opens the system's sound device. If there is none, says so on standard error and remains silent.
  explicit Sounds(const SoundAxes& axes);
  ~Sounds();
  Sounds(const Sounds&) = delete;
  Sounds& operator=(const Sounds&) = delete;

  /// Plays the events that are seen in this frame, now on the walls, and were not in the one before. Does not
  /// wait: OpenAL mixes on a thread of its own.
  void shown(const FrameRecord& record, const std::vector<GameEvent>& events);

 private:
  struct Device;
  std::unique_ptr<Device> device_;  // null: silent
};

/// Returns the name of the system's sound device; empty if there is none.
std::string soundDeviceName();

/// Returns a click, 16 bit, one channel; always the same for a kind.
inline constexpr int kSoundRate_hz = 44100;
std::vector<short> clickOf(EventKind kind);

}  // namespace carom
