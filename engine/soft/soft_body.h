#pragma once
// A body whose vertices move by their own equations: relativistic hyperelasticity on triangles. c = 1,
// metres, board frame.
//
// The rest energy of a piece of matter depends on its own-frame stretch alone (Carter and Quintana 1972; Beig
// and Schmidt 2003). With the principal stretches λ1, λ2 of a triangle, in its own frame, and a = (sound
// speed of relaxed matter)²,
//     W = (a/2)(λ1 + 1/λ1 − 2) + (a/2)(λ2 + 1/λ2 − 2) = (a/2)(I (1 + 1/D) − 4)      per rest mass
//     F' = L⁻¹ F,  F = Σ x_i ⊗ B_i,  D = det F',  I = λ1 + λ2 = sqrt(|F'|² + 2D),  L⁻¹ d = d + γ²/(γ+1) (v·d)
//     v P = dW/dF' = s F' + q cof F',   s = a (1 + 1/D)/(2I),   q = s − a I/(2D²)
// with B_i the gradients of the corners' shares and v the triangle's mean velocity. A viscous stress in the
// same frame settles ringing and makes shocks: with l = γ L⁻¹ (Σ v_i ⊗ B_i) F'⁻¹, d = sym l, h the triangle's
// altitude and λ the lesser stretch,
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

/// What a step is checked by (engine/soft/soft_group.h).
struct SoftSurvey {
  bool isSound = false;  ///< no node near light speed, no triangle turned over
  double longestStep =
      0.0;            ///< 0.3 of the least time in which light crosses a triangle, as the board sees it
  double heat = 0.0;  ///< as in SoftTotals
};

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

/// The state of a soft body between two steps, and one step of it without contacts. SoftGroup advances
/// bodies.
class SoftBody {
 public:
  /// Makes a relaxed, contracted body of this rest mass (kg) whose centre is at `centre` with the
  /// four-velocity `u`.
  SoftBody(std::shared_ptr<const SoftMesh> mesh, const SoftMaterial& material, double mass,
           const glm::dvec2& centre, const Vec21& u, InstructionSet instructions = bestInstructionSet());

  const SoftMesh& mesh() const { return *mesh_; }
  const SoftMaterial& material() const { return material_; }
  double mass() const { return mass_; }  ///< relaxed and cold
  std::size_t size() const { return state_.x.size(); }
  glm::dvec2 place(std::size_t node) const { return {state_.x[node], state_.y[node]}; }
  glm::dvec2 velocity(std::size_t node) const { return {state_.vx[node], state_.vy[node]}; }
  SoftTotals totals() const;

  SoftSurvey survey() const;
  /// Computes the stresses by the state alone: `survey` and `totals` read them, and steps leave those of
  /// their middles.
  void refresh() { gatherForces(state_.vx, state_.vy); }
  glm::dvec2 centre() const;  ///< of energy
  /// Returns the mean velocity P/E.
  glm::dvec2 meanVelocity() const;
  /// Returns the energy, over the mass, of what moves the nodes beside their mean velocity: stretches, and
  /// ½ Σ m_i w_i² with w_i the node's speed in the frame of P/E.
  double unrest() const;
  /// Returns how far the farthest node is from a place.
  double reachFrom(const glm::dvec2& place) const;
  /// A place of the relaxed body as it is now.
  glm::dvec2 place(const SoftMesh::Inside& inside) const;
  glm::dvec2 velocity(const SoftMesh::Inside& inside) const;
  /// Returns the own clock of a place; every node's shows 0 where the body was made.
  double clock(const SoftMesh::Inside& inside) const;
  void setClocks(double clock);
  /// Of a node: how much longer or shorter than relaxed the matter around it is in the direction of its
  /// largest deformation, in its own frame; and its heat over the rest energy of its cold matter.
  struct NodeState {
    double strain = 0.0, heat = 0.0;
  };
  std::vector<NodeState> nodeStates() const;
  /// Returns how the body is turned against its relaxed places: (cos, sin) of the angle that fits best in its
  /// own frame.
  glm::dvec2 turned() const;

  /// Flies on freely, for as long as its nodes keep their velocities: exact for a relaxed body.
  void coast(double duration);
  /// Makes the body relaxed, turned as it is, with the same energy, momentum and centre of energy: what else
  /// it has of energy becomes heat, spread evenly.
  void settle();

  /// The parts of a step, in their order (soft_group.cpp). All nodes drift with their velocities.
  void drift(double dt);
  /// Computes the forces at the places and the velocities of the start (`middle` false) or of the middle of
  /// the step, and the momenta, energies and velocities with which the step would end.
  void tryStep(double dt, bool middle);
  /// Takes the mean of the velocities at the start and at the end as those of the middle.
  void setMiddle();
  /// Ends the step with the momenta tried last.
  void commit(double dt);

  /// A node at the end of the step that is tried: its momentum and velocity, which a contact may change, its
  /// energy without contacts, and the energy that contacts give it.
  struct Trial {
    double &px, &py;
    const double& e;
    double &gained, &ux, &uy;
  };
  Trial trial(std::size_t node) {
    return {tried_.px[node], tried_.py[node], tried_.e[node],
            gained_[node],   tried_.vx[node], tried_.vy[node]};
  }
  /// Returns the part of a node's momentum that its stress carries at a velocity, L(v) τ v.
  glm::dvec2 stressMomentum(std::size_t node, const glm::dvec2& v) const;
  double energy(std::size_t node) const { return state_.e[node]; }
  /// Sets the velocity of a node that a told body carries along.
  void carry(std::size_t node, const glm::dvec2& v) { state_.vx[node] = v.x, state_.vy[node] = v.y; }
  /// Adds an outer force on a node, for the step that is about to be tried.
  void push(std::size_t node, const glm::dvec2& force);
  void endPushes();

  struct State {
    std::vector<double> x, y, px, py, e, vx, vy;
    std::vector<double> clock;  ///< own time of the nodes
    Vec21 pushed;               ///< energy and momentum that outer forces have given
  };
  const State& state() const { return state_; }
  void restore(const State& state) { state_ = state; }  ///< the stresses stay

 private:
  void invert(const std::vector<double>& px, const std::vector<double>& py, const std::vector<double>& e,
              std::vector<double>& vx, std::vector<double>& vy) const;
  SoftBodyDeformation deformationAt(std::size_t triangle, double vx, double vy) const;
  /// Returns the deformation of a triangle in its own frame.
  SoftBodyDeformation ownDeformation(std::size_t triangle) const;
  /// Returns the energy of a triangle's stretch, in its own frame.
  double elasticEnergy(const SoftBodyDeformation& f, std::size_t triangle) const;
  /// Returns the energy of a node in its own frame beyond its mass: heat, and its share of the stretch.
  double heatAndStretchOf(std::size_t node) const;
  void gatherForces(const std::vector<double>& vx, const std::vector<double>& vy);

  /// The mesh as the loop over triangles reads it, and what that loop gives.
  struct Triangles {
    std::array<std::vector<int>, 3> node;
    std::array<std::vector<double>, 3> gradientX, gradientY;
    std::vector<double> mass, altitude;
    std::array<std::vector<double>, 3> forceX, forceY;  ///< on the corners
    std::vector<double> power;                          ///< ⅓ Σ_j f_jc·v_j
    std::vector<double> stressXX, stressXY, stressYY;   ///< (m_c/3) P F'ᵀ
  };

  std::shared_ptr<const SoftMesh> mesh_;
  SoftMaterial material_;
  double mass_ = 0.0;
  InstructionSet instructions_;
  Triangles triangles_;
  State state_, tried_;
  std::vector<double> middleX_, middleY_;  // velocities
  /// What the triangles do to the nodes.
  struct OnNodes {
    std::vector<double> forceX, forceY, power;
    std::vector<double> stressXX, stressXY, stressYY;
  } on_;
  std::vector<double> gained_;  // energy of the nodes, from contacts
  std::vector<double> pushX_, pushY_;
  bool isPushed_ = false;
};

}  // namespace carom
