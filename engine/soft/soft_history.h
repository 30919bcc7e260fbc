#pragma once
// The history of a soft body as it is drawn: rows of its nodes' places at board times, between which nodes
// move straight and evenly. c = 1, metres, board frame.
//
// A row is added where the straight way from the last one would miss a step of the simulation by a tenth of
// a millimetre, and at least every 20 mm of light while the body is awake (engine/soft/row_recorder.h). After
// a row that is `still` all nodes move with the row's velocity until the next row. Before the first row they
// do, too, if the body was soft from the beginning.
// Theory: app/doc/physics.md, Soft bodies.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// What a row holds of one node: 16 bytes.
struct SoftNode {
  float x = 0.0F, y = 0.0F;                ///< from the row's centre
  std::array<std::int16_t, 2> velocity{};  ///< in units of kVelocityUnit
  std::int16_t strain = 0;                 ///< how much longer or shorter the matter is, in its own frame
  std::int16_t heat = 0;                   ///< over the rest energy of the cold matter
  static constexpr double kVelocityUnit = 1.0 / 32767.0;
  static constexpr double kShareUnit = 1.0 / 8192.0;  ///< of strain and heat

  glm::dvec2 v() const { return kVelocityUnit * glm::dvec2(velocity[0], velocity[1]); }
  double strainShare() const { return kShareUnit * strain; }
  double heatShare() const { return kShareUnit * heat; }
};

/// The head of a row. Its nodes follow each other in a list beside the rows' list.
struct SoftRow {
  std::uint64_t body = 0;  ///< number among the histories that are kept together
  double time = 0.0;
  double centreX = 0.0, centreY = 0.0;      ///< of energy
  double velocityX = 0.0, velocityY = 0.0;  ///< of that centre
  double reach = 0.0;                       ///< of the farthest node from the centre
  std::uint32_t nodes = 0;                  ///< how many
  std::uint8_t isStill = 0;   ///< 1: from here on all nodes move with the centre, until the next row
  std::uint8_t wasRigid = 0;  ///< 1: the first row of a body that was rigid until then
  std::array<std::uint8_t, 2> unused{};

  glm::dvec2 centre() const { return {centreX, centreY}; }
  glm::dvec2 velocity() const { return {velocityX, velocityY}; }
};

/// The rows of one body. Memory grows with the rows that are kept, and is used again.
class SoftHistory {
 public:
  /// Adds a row. Throws std::invalid_argument, which says why, for a row that is not later than the last, has
  /// another number of nodes, or a node that reached light speed since the last; it keeps nothing then.
  void append(const SoftRow& row, std::span<const SoftNode> nodes);
  /// Removes the rows at or after a time.
  void truncateFrom(double time);
  /// Removes the rows before the last one at or before a time.
  void forgetBefore(double time);
  void clear();

  std::size_t rowCount() const { return rows_.size() - first_; }
  std::size_t nodeCount() const { return rowCount() == 0 ? 0 : row(0).nodes; }
  const SoftRow& row(std::size_t k) const { return rows_[first_ + k]; }
  std::span<const SoftNode> nodesOf(std::size_t k) const {
    return std::span(nodes_).subspan((first_ + k) * nodeCount(), nodeCount());
  }
  glm::dvec2 place(std::size_t k, std::size_t node) const {
    const SoftNode& at = nodesOf(k)[node];
    return row(k).centre() + glm::dvec2(at.x, at.y);
  }
  /// Returns the velocity with which a node goes on after a row until the next, if there is no next.
  glm::dvec2 velocityAfter(std::size_t k, std::size_t node) const {
    return row(k).isStill ? row(k).velocity() : nodesOf(k)[node].v();
  }

 private:
  std::vector<SoftRow> rows_;
  std::vector<SoftNode> nodes_;
  std::size_t first_ = 0;  // rows before it are forgotten
};

/// Rows of several bodies on their way from where they are made to where they are drawn.
struct SoftRows {
  std::vector<SoftRow> rows;
  std::vector<SoftNode> nodes;  ///< of the rows, one row's after the other's
  double truncatedFrom = std::numeric_limits<double>::infinity();  ///< earlier rows from there on are void

  void clear() { rows.clear(), nodes.clear(), truncatedFrom = std::numeric_limits<double>::infinity(); }
};

}  // namespace carom
