#pragma once
// A body whose vertices move by their own equations: relativistic hyperelasticity on triangles. c = 1, metres, board frame.
//
// The rest energy of a piece of matter depends on its own-frame stretch alone (Carter and Quintana 1972; Beig and Schmidt 2003).
// With the principal stretches λ1, λ2 of a triangle, in its own frame, and a = (sound speed of relaxed matter)²,
//     W = (a/2)(λ1 + 1/λ1 − 2) + (a/2)(λ2 + 1/λ2 − 2) = (a/2)(I (1 + 1/D) − 4)      per rest mass
//     F' = L⁻¹ F,  F = Σ x_i ⊗ B_i,  D = det F',  I = λ1 + λ2 = sqrt(|F'|² + 2D),  L⁻¹ d = d + γ²/(γ+1) (v·d) v
//     P = dW/dF' = s F' + q cof F',   s = a (1 + 1/D)/(2I),   q = s − a I/(2D²)
// with B_i the gradients of the corners' shares and v the triangle's mean velocity. A viscous stress in the same frame settles
// ringing and makes shocks: with l = γ L⁻¹ (Σ v_i ⊗ B_i) F'⁻¹, d = sym l, h the triangle's altitude and λ the lesser stretch,
//     P += ν d F'⁻ᵀ,   ν = h λ (z c_loc + h λ |d|),   c_loc² = (a/D)/(1 − a + a/D)
// Everything is in the energies E_i and momenta π_i of the nodes, so that totals are telescoping sums:
//     f_ic = −(m_c/γ) L⁻¹ P B_i,   Σ_i f_ic = 0        dπ_i/dt = Σ_c f_ic
//     dE_i/dt = Σ_c (f_ic·v_i − ⅓ Σ_j f_jc·v_j)        τ_i = Σ_c (m_c/3) P F'ᵀ
//     v = (π + L(v) τ v)/E,  three steps of this fixed point, L(v) d = d − γ/(γ+1) (v·d) v
// Sound is slower than light by the material; contraction is a consequence and not an input.
// Theory: app/doc/physics.md, Soft bodies.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/instruction_set.h"
#include "engine/soft/soft_mesh.h"
#include "engine/spacetime/minkowski.h"

namespace carom {

struct SoftMaterial {
  double soundSpeed = 0.5;  ///< of relaxed matter, above 0, at most kStiffestSound
  double viscosity = 0.3;   ///< z
};
inline constexpr double kStiffestSound = 0.7;

/// Sums over a body, on the board's slice of simultaneity.
struct SoftTotals {
  Vec21 momentum;           ///< (E, P)
  glm::dvec2 centre{};      ///< of energy
  double spin = 0.0;        ///< angular momentum about it
  double heat = 0.0;        ///< of the nodes' own frames
  double elastic = 0.0;     ///< energy of the triangles' stretches
  double restMass() const;  ///< sqrt(E² − P²)
};

/// The deformation of a triangle in one frame.
struct SoftBodyDeformation {
  double xx, xy, yx, yy;  ///< F'
  double area;            ///< D, of the relaxed area
  double sum, least;      ///< of the principal stretches
};

/// The state of a soft body between two steps, and one step of it without contacts. SoftGroup advances bodies.
class SoftBody {
 public:
  /// Makes a relaxed, contracted body of this rest mass (kg) whose centre is at `centre` with the four-velocity `u`.
  SoftBody(std::shared_ptr<const SoftMesh> mesh, const SoftMaterial& material, double mass,
           const glm::dvec2& centre, const Vec21& u, InstructionSet instructions = bestInstructionSet());

  const SoftMesh& mesh() const { return *mesh_; }
  const SoftMaterial& material() const { return material_; }
  double mass() const { return mass_; }  ///< relaxed and cold
  std::size_t size() const { return state_.x.size(); }
  glm::dvec2 place(std::size_t node) const { return {state_.x[node], state_.y[node]}; }
  glm::dvec2 velocity(std::size_t node) const { return {state_.vx[node], state_.vy[node]}; }
  SoftTotals totals() const;

  /// Returns the longest step that the state allows: 0.3 of the least time in which sound at light speed crosses a triangle, as
  /// the board sees it.
  double longestStep() const;

  /// The parts of a step, in their order (soft_group.cpp). All nodes drift with their velocities.
  void drift(double dt);
  /// Computes the forces at the places and the velocities of the start (`middle` false) or of the middle of the step, and the
  /// momenta and velocities with which the step would end.
  void tryStep(double dt, bool middle);
  /// Takes the mean of the velocities at the start and at the end as those of the middle.
  void setMiddle();
  /// Ends the step with the momenta tried last.
  void commit(double dt);

  /// What a contact may change while a step is tried: momentum, energy and velocity of a node at its end.
  struct Trial {
    double &px, &py, &e, &ux, &uy;
  };
  Trial trial(std::size_t node) {
    return {tried_.px[node], tried_.py[node], tried_.e[node], tried_.vx[node], tried_.vy[node]};
  }
  /// Returns the part of a node's momentum that its stress carries at a velocity, L(v) τ v.
  glm::dvec2 stressMomentum(std::size_t node, const glm::dvec2& v) const;
  double energy(std::size_t node) const { return state_.e[node]; }
  /// Sets the velocity of a node that a told body carries along.
  void carry(std::size_t node, const glm::dvec2& v) { state_.vx[node] = v.x, state_.vy[node] = v.y; }
  /// Adds an outer force on a node, for the step that is about to be tried.
  void push(std::size_t node, const glm::dvec2& force);
  void endPushes();

  /// Whether the state can be followed: no node near light speed, no triangle turned over.
  bool isSound() const;
  struct State {
    std::vector<double> x, y, px, py, e, vx, vy;
  };
  const State& state() const { return state_; }
  void restore(const State& state) { state_ = state; }

 private:
  void invert(const std::vector<double>& px, const std::vector<double>& py, const std::vector<double>& e,
              std::vector<double>& vx, std::vector<double>& vy) const;
  SoftBodyDeformation deformationAt(std::size_t triangle, double vx, double vy) const;
  /// Returns the deformation of a triangle in its own frame.
  SoftBodyDeformation ownDeformation(std::size_t triangle) const;
  /// Returns the energy of a triangle's stretch, in its own frame.
  double elasticEnergy(std::size_t triangle) const;
  /// Returns the energy of a node in its own frame beyond its mass: heat, and its share of the stretch.
  double heatAndStretchOf(std::size_t node) const;
  void gatherForces(const std::vector<double>& vx, const std::vector<double>& vy);

  /// The mesh as the loop over triangles reads it, and what that loop gives.
  struct Triangles {
    std::array<std::vector<int>, 3> node;
    std::array<std::vector<double>, 3> gradientX, gradientY;
    std::vector<double> mass, altitude;
    std::array<std::vector<double>, 3> forceX, forceY;  ///< on the corners
    std::vector<double> stressXX, stressXY, stressYY;   ///< (m_c/3) P F'ᵀ
  };

  std::shared_ptr<const SoftMesh> mesh_;
  SoftMaterial material_;
  double mass_ = 0.0;
  InstructionSet instructions_;
  Triangles triangles_;
  State state_, tried_;
  std::vector<double> middleX_, middleY_;  // velocities
  std::vector<double> forceX_, forceY_;    // on the nodes
  std::vector<double> stressXX_, stressXY_, stressYY_;
  std::vector<double> pushX_, pushY_;
};

}  // namespace carom
