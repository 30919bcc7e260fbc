#pragma once
// A soft body in the play (engine/soft/soft_play.h): asleep while it flies freely, awake while it is followed
// step by step. c = 1, metres, board frame.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/soft/soft_body.h"

namespace carom {

/// A side of a rectangle that moves as a told body does.
struct SoftHold {
  /// The told body's motion from a time on, in the order of time; before the first it moves as the soft body.
  struct Turn {
    double time = 0.0;
    glm::dvec2 velocity{0.0};
  };
  bool isPlusX = false;  ///< the side +x; otherwise −x
  std::vector<Turn> turns;
};

/// A body as it comes into the play: relaxed.
struct SoftEntry {
  std::string name;
  std::shared_ptr<const SoftMesh> mesh;
  SoftMaterial material;
  double mass = 0.0;
  glm::dvec2 centre{0.0};
  Vec21 u{1.0, 0.0, 0.0};
  double clock = 0.0;
  std::vector<SoftHold> holds{};
};

/// A body with its state at a time, from which it flies on in its mean motion while it sleeps.
struct SoftPlayer {
  explicit SoftPlayer(std::shared_ptr<const SoftEntry> comes);

  std::shared_ptr<const SoftEntry> entry;
  SoftBody body;
  std::vector<std::vector<int>> heldNodes;  ///< of each hold
  bool isAwake = false;
  double since = 0.0;       ///< the time of the body's state
  double quietSince = 0.0;  ///< nothing has touched it since, and it has hardly moved in itself
  /// By the state: the centre of energy with its velocity, and the circle around it that holds the body.
  glm::dvec2 centre{0.0}, velocity{0.0};
  double reach = 0.0;
  bool hasStresses = false;  ///< of the state; a body that has been brought back has not
  /// Where the nodes were beside their places when it fell asleep: this fades away in the time R.
  std::vector<glm::dvec2> fade{};
  double fadesFrom = 0.0;

  void measure();  ///< sets what follows from the state
  void refresh();  ///< computes the stresses of the state, where it has none
  void wake(double time);
  /// Takes it for relaxed in its mean motion; `atOnce`, without a fade.
  void fallAsleep(bool atOnce);
  /// Returns whether it has been left alone for long enough to sleep, and notes whether it is now.
  bool isQuiet(double time);

  double soundTime() const;  ///< 2R/c_s
  double fadeAt(double time) const;
  glm::dvec2 centreAt(double time) const { return centre + (time - since) * velocity; }

  /// What brings it back to where it is now.
  struct State {
    std::shared_ptr<const SoftEntry> entry;
    SoftBody::State body;
    bool isAwake;
    double since, quietSince;
    std::vector<glm::dvec2> fade;
    double fadesFrom;
    glm::dvec2 centre, velocity;
    double reach;
  };
  State state() const;
  void restore(const State& state);
};

}  // namespace carom
