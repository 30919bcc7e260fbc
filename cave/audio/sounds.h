#pragma once
// The clicks of a game, played by OpenAL when the light of each comes (cave/audio/heard.h): on loudspeakers
// around the room, or on headphones of someone who looks ahead in it.

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/frame_state.h"
#include "engine/billiard/game_event.h"

namespace carom {

/// The person's directions in the room's axes: unit vectors.
struct SoundAxes {
  glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
};

class Sounds {
 public:
  /// Opens the system's sound device. Where there is none it says so on standard error and is silent.
  explicit Sounds(const SoundAxes& axes);
  ~Sounds();
  Sounds(const Sounds&) = delete;
  Sounds& operator=(const Sounds&) = delete;

  /// The frame has come onto the walls: what is seen in it and was not in the one before is heard. Waits for
  /// nothing: OpenAL mixes on a thread of its own.
  void shown(const FrameRecord& record, const std::vector<GameEvent>& events);

 private:
  struct Device;
  std::unique_ptr<Device> device_;  // none: silent
};

/// A click, 16 bit, one channel; deterministic.
inline constexpr int kSoundRate_hz = 44100;
std::vector<short> clickOf(EventKind kind);

}  // namespace carom
