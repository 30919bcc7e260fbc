#pragma once
// A headset by OpenXR: its session, its frames, what it says of eyes and hands, and the pictures it takes.
// One frame: poll, then nextFrame (which waits for the runtime), then draw the two eyes' pictures, then
// submit. Use from the main thread only, with the drawing context current. Source: The OpenXR
// Specification 1.0, chapters 8 to 11, Khronos Group.

#include <array>
#include <memory>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "cave/gl/graphics.h"
#include "cave/record/headset_frame.h"

namespace carom {

class Headset {
 public:
  enum class State {
    idle,     ///< taken off, or not ready: no frames
    running,  ///< frames are asked for
    ended     ///< by the runtime, or after askToEnd
  };

  /// Throws std::runtime_error, with what to do, if there is no runtime, no headset or none that OpenGL can
  /// draw for.
  explicit Headset(const Graphics& graphics);
  ~Headset();
  Headset(const Headset&) = delete;
  Headset& operator=(const Headset&) = delete;

  /// Takes note of what the runtime has said since the last call. Throws std::runtime_error if the headset is
  /// lost.
  State poll();
  State state() const;  ///< without taking note of more

  /// Waits until the runtime wants the next frame, and returns it; nothing while the session is idle. Each
  /// must be submitted before the next.
  std::optional<HeadsetFrame> nextFrame();

  /// Hands over the eyes' pictures (textures of encoded bytes, of `pixels()`), which are copied byte for
  /// byte; with null, or for a frame that is not seen, the frame ends without pictures. Does nothing where no
  /// frame was begun.
  void submit(const std::array<unsigned, 2>* pictures);

  /// Lets the controller of the hand that aims vibrate.
  void knock(double strength, double duration_s);

  /// Asks the runtime to end the session: frames go on until the state is `ended`.
  void askToEnd();

  glm::ivec2 pixels() const;           ///< of an eye's picture
  const std::string& runtime() const;  ///< name and version
  const std::string& system() const;   ///< name of the headset
  bool hasFloor() const;               ///< the room's origin is on the floor
  bool takesEncoded() const;           ///< pictures of sRGB; else it may show them too bright
  const std::string& whyEnded() const;

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

/// Returns a sentence about OpenXR on this machine for the operator: the runtime and headset there are, or
/// why not.
std::string aboutHeadsets();

}  // namespace carom
