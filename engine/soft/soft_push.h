#pragma once
// A stroke p that pushes the half of a soft body that faces it for T = 2R/c_s: node i takes the force w_i
// p/T, with
//     w_i = m_i max(0, −X_i·p̂) / Σ m_j max(0, −X_j·p̂)        X_i its relaxed place from the centre, as the
//     body is turned
// from the moment at which the light of the hand has reached the node; without a place of the hand all nodes
// at once. c = 1, metres, board frame. Theory: app/doc/physics.md, Soft bodies.

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/soft/far_sides.h"
#include "engine/soft/soft_player.h"

namespace carom {

struct SoftStroke {
  std::size_t body = 0;
  Vec21 hand;           ///< its event; without a place only the time counts
  double height = 0.0;  ///< of the hand above the board's plane of centres
  bool hasPlace = false;
  glm::dvec2 momentum{0.0};
};

class SoftPush {
 public:
  explicit SoftPush(const SoftStroke& stroke) : stroke_(stroke) {}

  std::size_t body() const { return stroke_.body; }
  bool isOver() const { return isOver_; }
  std::optional<double> began() const { return began_; }

  /// Returns whether light of the hand may reach a body by `end`, a slice of board time after `time`.
  bool reachesBefore(const SoftPlayer& player, double time, double slice, double end) const;
  /// Sets the forces on the body's nodes for the step that begins at a time, and tells the far sides when it
  /// begins.
  void act(SoftPlayer& player, double time, FarSides& farSides);
  /// Returns the earliest time after `time` at which its forces change and that is known; `end` if there is
  /// none before it.
  double nextChange(const SoftPlayer& player, double time, double end) const;

 private:
  void begin(const SoftPlayer& player, double time, FarSides& farSides);
  bool isLit(const SoftPlayer& player, std::size_t node, double time) const;

  SoftStroke stroke_;
  std::vector<double> shares_;  // of the nodes; none until it begins
  std::vector<double> begins_;  // when the light of the hand has reached the node
  std::optional<double> began_;
  bool isOver_ = false;
};

}  // namespace carom
