#include "engine/soft/soft_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kStepShare = 0.3;   // of the time in which light crosses a triangle
constexpr double kFastest = 0.999;   // a node beyond this cannot be followed
constexpr double kLeastArea = 1e-4;  // of a triangle, of its relaxed area
constexpr int kInversions = 3;       // of v = (π + L(v) τ v)/E, each from the last v

using Deformation = SoftBodyDeformation;

[[gnu::always_inline]] inline Deformation deformationOf(double xx, double xy, double yx, double yy) {
  const double area = xx * yy - xy * yx;
  const double squares = xx * xx + xy * xy + yx * yx + yy * yy;
  const double apart = squares - 2.0 * area;
  const double sum = std::sqrt(squares + 2.0 * area);
  return {xx, xy, yx, yy, area, sum, 0.5 * (sum - std::sqrt(apart > 0.0 ? apart : 0.0))};
}

/// What the loop over triangles reads and writes.
struct Arrays {
  std::size_t count;
  const int *n0, *n1, *n2;
  const double *b0x, *b0y, *b1x, *b1y, *b2x, *b2y, *mass, *altitude;
  const double *x, *y, *vx, *vy;
  double a, z;
  double *f0x, *f0y, *f1x, *f1y, *f2x, *f2y, *sxx, *sxy, *syy, *power;
};

/// The equations of soft_body.h, one triangle after the other, in vectors where the processor has them.
[[gnu::always_inline]] inline void forcesOn(const Arrays& in) {
#pragma GCC ivdep
  for (std::size_t t = 0; t < in.count; ++t) {
    const int i = in.n0[t], j = in.n1[t], k = in.n2[t];
    const double b0x = in.b0x[t], b0y = in.b0y[t], b1x = in.b1x[t], b1y = in.b1y[t], b2x = in.b2x[t],
                 b2y = in.b2y[t];
    const double v0x = in.vx[i], v0y = in.vy[i], v1x = in.vx[j], v1y = in.vy[j], v2x = in.vx[k],
                 v2y = in.vy[k];
    const double vx = (v0x + v1x + v2x) * (1.0 / 3.0), vy = (v0y + v1y + v2y) * (1.0 / 3.0);
    const double gamma = 1.0 / std::sqrt(1.0 - vx * vx - vy * vy);
    const double stretch = gamma * gamma / (gamma + 1.0);
    // F, and L⁻¹ applied to its columns.
    const double x0 = in.x[i], x1 = in.x[j], x2 = in.x[k], y0 = in.y[i], y1 = in.y[j], y2 = in.y[k];
    double fxx = x0 * b0x + x1 * b1x + x2 * b2x, fxy = x0 * b0y + x1 * b1y + x2 * b2y;
    double fyx = y0 * b0x + y1 * b1x + y2 * b2x, fyy = y0 * b0y + y1 * b1y + y2 * b2y;
    const double alongX = stretch * (vx * fxx + vy * fyx), alongY = stretch * (vx * fxy + vy * fyy);
    const Deformation f =
        deformationOf(fxx + alongX * vx, fxy + alongY * vx, fyx + alongX * vy, fyy + alongY * vy);
    const double inverse = 1.0 / f.area;
    const double s = in.a * (1.0 + inverse) / (2.0 * f.sum);
    const double q = s - 0.5 * in.a * f.sum * inverse * inverse;
    // Rate of strain: d = sym (γ L⁻¹ G F'⁻¹).
    const double gxx = v0x * b0x + v1x * b1x + v2x * b2x, gxy = v0x * b0y + v1x * b1y + v2x * b2y;
    const double gyx = v0y * b0x + v1y * b1x + v2y * b2x, gyy = v0y * b0y + v1y * b1y + v2y * b2y;
    const double rateX = stretch * (vx * gxx + vy * gyx), rateY = stretch * (vx * gxy + vy * gyy);
    const double hxx = gxx + rateX * vx, hxy = gxy + rateY * vx, hyx = gyx + rateX * vy,
                 hyy = gyy + rateY * vy;
    const double scale = gamma * inverse;
    const double dxx = scale * (hxx * f.yy - hxy * f.yx), dyy = scale * (hyy * f.xx - hyx * f.xy);
    const double dxy = 0.5 * scale * ((hxy * f.xx - hxx * f.xy) + (hyx * f.yy - hyy * f.yx));
    const double size = std::sqrt(dxx * dxx + dyy * dyy + 2.0 * dxy * dxy);
    const double local = std::sqrt(in.a * inverse / (1.0 - in.a + in.a * inverse));
    const double across = in.altitude[t] * f.least;
    const double nu = across * (in.z * local + across * size) * inverse;
    // P = s F' + q cof F' + ν d F'⁻ᵀ.
    const double pxx = s * f.xx + q * f.yy + nu * (dxx * f.yy - dxy * f.xy);
    const double pxy = s * f.xy - q * f.yx + nu * (dxy * f.xx - dxx * f.yx);
    const double pyx = s * f.yx - q * f.xy + nu * (dxy * f.yy - dyy * f.xy);
    const double pyy = s * f.yy + q * f.xx + nu * (dyy * f.xx - dxy * f.yx);
    const double third = in.mass[t] * (1.0 / 3.0);
    in.sxx[t] = third * (pxx * f.xx + pxy * f.xy);
    in.sxy[t] = third * (pxx * f.yx + pxy * f.yy);
    in.syy[t] = third * (pyx * f.yx + pyy * f.yy);
    // f = −(m/γ) L⁻¹ P B.
    const double pushX = stretch * (vx * pxx + vy * pyx), pushY = stretch * (vx * pxy + vy * pyy);
    const double weight = -in.mass[t] / gamma;
    const double qxx = weight * (pxx + pushX * vx), qxy = weight * (pxy + pushY * vx);
    const double qyx = weight * (pyx + pushX * vy), qyy = weight * (pyy + pushY * vy);
    const double f0x = qxx * b0x + qxy * b0y, f0y = qyx * b0x + qyy * b0y;
    const double f1x = qxx * b1x + qxy * b1y, f1y = qyx * b1x + qyy * b1y;
    in.f0x[t] = f0x;
    in.f0y[t] = f0y;
    in.f1x[t] = f1x;
    in.f1y[t] = f1y;
    in.f2x[t] = -(f0x + f1x);
    in.f2y[t] = -(f0y + f1y);
    in.power[t] =
        (f0x * (v0x - v2x) + f0y * (v0y - v2y) + f1x * (v1x - v2x) + f1y * (v1y - v2y)) * (1.0 / 3.0);
  }
}

void forcesBaseline(const Arrays& in) { forcesOn(in); }
CAROM_AVX2 void forcesAvx2(const Arrays& in) { forcesOn(in); }
CAROM_AVX512 void forcesAvx512(const Arrays& in) { forcesOn(in); }

/// γ/(γ+1) of a velocity: L(v) d = d − this (v·d) v.
[[gnu::always_inline]] inline double contraction(double vx, double vy) {
  const double root = std::sqrt(1.0 - vx * vx - vy * vy);  // 1/γ
  return 1.0 / (1.0 + root);
}

/// Returns L⁻¹ F for F on the board.
inline Deformation seenFrom(const Deformation& board, double vx, double vy) {
  const double gamma = 1.0 / std::sqrt(1.0 - vx * vx - vy * vy), stretch = gamma * gamma / (gamma + 1.0);
  const double alongX = stretch * (vx * board.xx + vy * board.yx),
               alongY = stretch * (vx * board.xy + vy * board.yy);
  return deformationOf(board.xx + alongX * vx, board.xy + alongY * vx, board.yx + alongX * vy,
                       board.yy + alongY * vy);
}

/// Returns the mean velocity of a triangle's corners.
inline glm::dvec2 meanOf(const std::array<std::vector<int>, 3>& nodes, const SoftBody::State& state,
                         std::size_t triangle) {
  glm::dvec2 sum(0.0);
  for (const std::vector<int>& corner : nodes) {
    const auto i = static_cast<std::size_t>(corner[triangle]);
    sum += glm::dvec2(state.vx[i], state.vy[i]);
  }
  return (1.0 / 3.0) * sum;
}

/// What the inversion of the momenta reads and writes, by node.
struct NodeArrays {
  std::size_t count;
  const double *px, *py, *e, *sxx, *sxy, *syy;
  double *vx, *vy;
};

/// v = (π + L(v) τ v)/E, from the v that stands there.
[[gnu::always_inline]] inline void invertOn(const NodeArrays& in) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < in.count; ++i) {
    const double px = in.px[i], py = in.py[i], sxx = in.sxx[i], sxy = in.sxy[i], syy = in.syy[i];
    const double inverse = 1.0 / in.e[i];
    double x = in.vx[i], y = in.vy[i];
    for (int k = 0; k < kInversions; ++k) {
      const double wx = sxx * x + sxy * y, wy = sxy * x + syy * y;
      const double along = contraction(x, y) * (x * wx + y * wy);
      const double nextX = (px + wx - along * x) * inverse, nextY = (py + wy - along * y) * inverse;
      x = nextX;
      y = nextY;
    }
    in.vx[i] = x;
    in.vy[i] = y;
  }
}

void invertBaseline(const NodeArrays& in) { invertOn(in); }
CAROM_AVX2 void invertAvx2(const NodeArrays& in) { invertOn(in); }
CAROM_AVX512 void invertAvx512(const NodeArrays& in) { invertOn(in); }

}  // namespace

double SoftTotals::restMass() const { return std::sqrt(dot(momentum, momentum)); }

SoftBody::SoftBody(std::shared_ptr<const SoftMesh> mesh, const SoftMaterial& material, double mass,
                   const glm::dvec2& centre, const Vec21& u, InstructionSet instructions)
    : mesh_(std::move(mesh)), material_(material), mass_(mass), instructions_(instructions) {
  for (const SoftMesh::Triangle& triangle : mesh_->triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      triangles_.node[k].push_back(triangle.nodes[k]);
      triangles_.gradientX[k].push_back(triangle.gradients[k].x);
      triangles_.gradientY[k].push_back(triangle.gradients[k].y);
    }
    triangles_.mass.push_back(mass * triangle.share);
    triangles_.altitude.push_back(triangle.altitude);
  }
  const std::size_t count = triangles_.mass.size(), nodes = mesh_->places().size();
  for (std::size_t k = 0; k < 3; ++k) triangles_.forceX[k].resize(count), triangles_.forceY[k].resize(count);
  triangles_.stressXX.resize(count), triangles_.stressXY.resize(count), triangles_.stressYY.resize(count);
  triangles_.power.resize(count);

  const double vx = u.x / u.t, vy = u.y / u.t, share = contraction(vx, vy);
  for (std::size_t i = 0; i < nodes; ++i) {
    const glm::dvec2 d = mesh_->places()[i];
    const double along = share * (vx * d.x + vy * d.y), energy = mass * mesh_->nodeShare(i) * u.t;
    state_.x.push_back(centre.x + d.x - along * vx);
    state_.y.push_back(centre.y + d.y - along * vy);
    state_.px.push_back(energy * vx);
    state_.py.push_back(energy * vy);
    state_.e.push_back(energy);
    state_.vx.push_back(vx);
    state_.vy.push_back(vy);
    state_.clock.push_back(0.0);
  }
  tried_ = state_;
  for (std::vector<double>* each : {&middleX_, &middleY_, &on_.forceX, &on_.forceY, &on_.power, &gained_,
                                    &on_.stressXX, &on_.stressXY, &on_.stressYY, &pushX_, &pushY_}) {
    each->resize(nodes);
  }
  gatherForces(state_.vx, state_.vy);
}

void SoftBody::gatherForces(const std::vector<double>& vx, const std::vector<double>& vy) {
  Triangles& t = triangles_;
  const Arrays in{t.mass.size(),
                  t.node[0].data(),
                  t.node[1].data(),
                  t.node[2].data(),
                  t.gradientX[0].data(),
                  t.gradientY[0].data(),
                  t.gradientX[1].data(),
                  t.gradientY[1].data(),
                  t.gradientX[2].data(),
                  t.gradientY[2].data(),
                  t.mass.data(),
                  t.altitude.data(),
                  state_.x.data(),
                  state_.y.data(),
                  vx.data(),
                  vy.data(),
                  material_.soundSpeed * material_.soundSpeed,
                  material_.viscosity,
                  t.forceX[0].data(),
                  t.forceY[0].data(),
                  t.forceX[1].data(),
                  t.forceY[1].data(),
                  t.forceX[2].data(),
                  t.forceY[2].data(),
                  t.stressXX.data(),
                  t.stressXY.data(),
                  t.stressYY.data(),
                  t.power.data()};
  switch (instructions_) {
    case InstructionSet::avx512:
      forcesAvx512(in);
      break;
    case InstructionSet::avx2:
      forcesAvx2(in);
      break;
    case InstructionSet::baseline:
      forcesBaseline(in);
  }
  for (std::size_t i = 0; i < size(); ++i) {
    double fx = pushX_[i], fy = pushY_[i], power = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (const SoftMesh::Corner& corner : mesh_->cornersOf(i)) {
      const auto c = static_cast<std::size_t>(corner.triangle), k = static_cast<std::size_t>(corner.corner);
      fx += t.forceX[k][c];
      fy += t.forceY[k][c];
      power += t.power[c];
      xx += t.stressXX[c];
      xy += t.stressXY[c];
      yy += t.stressYY[c];
    }
    on_.forceX[i] = fx;
    on_.forceY[i] = fy;
    on_.power[i] = fx * vx[i] + fy * vy[i] - power;
    on_.stressXX[i] = xx;
    on_.stressXY[i] = xy;
    on_.stressYY[i] = yy;
  }
}

void SoftBody::invert(const std::vector<double>& px, const std::vector<double>& py,
                      const std::vector<double>& e, std::vector<double>& vx, std::vector<double>& vy) const {
  const NodeArrays in{size(),
                      px.data(),
                      py.data(),
                      e.data(),
                      on_.stressXX.data(),
                      on_.stressXY.data(),
                      on_.stressYY.data(),
                      vx.data(),
                      vy.data()};
  switch (instructions_) {
    case InstructionSet::avx512:
      invertAvx512(in);
      break;
    case InstructionSet::avx2:
      invertAvx2(in);
      break;
    case InstructionSet::baseline:
      invertBaseline(in);
  }
}

/// F of a triangle by the places, seen from a frame that moves with this velocity: L⁻¹ F.
SoftBodyDeformation SoftBody::deformationAt(std::size_t triangle, double vx, double vy) const {
  const Triangles& t = triangles_;
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(t.node[k][triangle]);
    xx += state_.x[i] * t.gradientX[k][triangle];
    xy += state_.x[i] * t.gradientY[k][triangle];
    yx += state_.y[i] * t.gradientX[k][triangle];
    yy += state_.y[i] * t.gradientY[k][triangle];
  }
  return seenFrom({xx, xy, yx, yy, 0.0, 0.0, 0.0}, vx, vy);
}

glm::dvec2 SoftBody::meanVelocity() const {
  glm::dvec2 momentum(0.0);
  double energy = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    momentum += glm::dvec2(state_.px[i], state_.py[i]);
    energy += state_.e[i];
  }
  return momentum / energy;
}

glm::dvec2 SoftBody::centre() const {
  glm::dvec2 sum(0.0);
  double energy = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    sum += state_.e[i] * place(i);
    energy += state_.e[i];
  }
  return sum / energy;
}

double SoftBody::unrest() const {
  const glm::dvec2 V = meanVelocity();
  const double gammaV = 1.0 / std::sqrt(1.0 - glm::dot(V, V));
  double energy = 0.0;
  for (std::size_t c = 0; c < triangles_.mass.size(); ++c) energy += elasticEnergy(ownDeformation(c), c);
  for (std::size_t i = 0; i < size(); ++i) {
    const glm::dvec2 v = velocity(i);
    // γ(w) = γ(v) γ(V) (1 − v·V), and w² = 1 − 1/γ².
    const double gammaW = gammaV * (1.0 - glm::dot(v, V)) / std::sqrt(1.0 - glm::dot(v, v));
    energy += 0.5 * mass_ * mesh_->nodeShare(i) * (1.0 - 1.0 / (gammaW * gammaW));
  }
  return energy / mass_;
}

double SoftBody::reachFrom(const glm::dvec2& from) const {
  double farthest2 = 0.0;
  for (const int node : mesh_->hull()) {
    const glm::dvec2 arm = place(static_cast<std::size_t>(node)) - from;
    farthest2 = std::max(farthest2, glm::dot(arm, arm));
  }
  return std::sqrt(farthest2);
}

glm::dvec2 SoftBody::place(const SoftMesh::Inside& inside) const {
  glm::dvec2 sum(0.0);
  for (std::size_t k = 0; k < 3; ++k) sum += inside.shares[k] * place(inside.nodes[k]);
  return sum;
}

glm::dvec2 SoftBody::velocity(const SoftMesh::Inside& inside) const {
  glm::dvec2 sum(0.0);
  for (std::size_t k = 0; k < 3; ++k) sum += inside.shares[k] * velocity(inside.nodes[k]);
  return sum;
}

double SoftBody::clock(const SoftMesh::Inside& inside) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += inside.shares[k] * state_.clock[inside.nodes[k]];
  return sum;
}

void SoftBody::setClocks(double clock) { std::fill(state_.clock.begin(), state_.clock.end(), clock); }

// The rotation that brings the relaxed places nearest to the places in the body's own frame: tan φ = Σ m X ×
// y / Σ m X · y.
glm::dvec2 SoftBody::turned() const {
  const glm::dvec2 V = meanVelocity();
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(V, V)), stretch = gamma * gamma / (gamma + 1.0);
  const glm::dvec2 centre = this->centre();
  double along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const glm::dvec2 X = mesh_->places()[i], d = place(i) - centre, y = d + stretch * glm::dot(V, d) * V;
    along += mesh_->nodeShare(i) * glm::dot(X, y);
    across += mesh_->nodeShare(i) * (X.x * y.y - X.y * y.x);
  }
  return glm::dvec2(along, across) / std::sqrt(along * along + across * across);
}

void SoftBody::coast(double duration) {
  for (std::size_t i = 0; i < size(); ++i) {
    const double x = state_.vx[i], y = state_.vy[i];
    state_.x[i] += duration * x;
    state_.y[i] += duration * y;
    state_.clock[i] += duration * std::sqrt(1.0 - x * x - y * y);
  }
}

void SoftBody::settle() {
  const glm::dvec2 axis = turned();
  const SoftTotals sums = totals();
  const glm::dvec2 V(sums.momentum.x / sums.momentum.t, sums.momentum.y / sums.momentum.t);
  const double share = contraction(V.x, V.y);
  for (std::size_t i = 0; i < size(); ++i) {
    const glm::dvec2 X = mesh_->places()[i], d(axis.x * X.x - axis.y * X.y, axis.y * X.x + axis.x * X.y);
    const glm::dvec2 place = sums.centre + d - share * glm::dot(V, d) * V;
    const double part = mesh_->nodeShare(i);
    state_.x[i] = place.x, state_.y[i] = place.y;
    state_.e[i] = part * sums.momentum.t;
    state_.px[i] = part * sums.momentum.x, state_.py[i] = part * sums.momentum.y;
    state_.vx[i] = V.x, state_.vy[i] = V.y;
  }
  gatherForces(state_.vx, state_.vy);
}

void SoftBody::drift(double dt) {
  for (std::size_t i = 0; i < size(); ++i) {
    state_.x[i] += dt * state_.vx[i];
    state_.y[i] += dt * state_.vy[i];
  }
}

void SoftBody::tryStep(double dt, bool middle) {
  gatherForces(middle ? middleX_ : state_.vx, middle ? middleY_ : state_.vy);
  if (!middle) tried_.vx = state_.vx, tried_.vy = state_.vy;
  for (std::size_t i = 0; i < size(); ++i) {
    tried_.px[i] = state_.px[i] + dt * on_.forceX[i];
    tried_.py[i] = state_.py[i] + dt * on_.forceY[i];
    tried_.e[i] = state_.e[i] + dt * on_.power[i];
    gained_[i] = 0.0;
  }
  invert(tried_.px, tried_.py, tried_.e, tried_.vx, tried_.vy);
}

void SoftBody::setMiddle() {
  for (std::size_t i = 0; i < size(); ++i) {
    middleX_[i] = 0.5 * (state_.vx[i] + tried_.vx[i]);
    middleY_[i] = 0.5 * (state_.vy[i] + tried_.vy[i]);
  }
}

void SoftBody::commit(double dt) {
  const Triangles& t = triangles_;
  for (std::size_t c = 0; c < t.mass.size(); ++c) {
    std::array<double, 3> power;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(t.node[k][c]);
      power[k] = t.forceX[k][c] * middleX_[i] + t.forceY[k][c] * middleY_[i];
    }
    const double third = (power[0] + power[1] + power[2]) * (1.0 / 3.0);
    for (std::size_t k = 0; k < 3; ++k)
      gained_[static_cast<std::size_t>(t.node[k][c])] += dt * (power[k] - third);
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const double x = middleX_[i], y = middleY_[i];
    state_.e[i] += gained_[i];
    state_.clock[i] += dt * std::sqrt(1.0 - x * x - y * y);
  }
  for (std::size_t i = 0; isPushed_ && i < size(); ++i) {
    const double work = dt * (pushX_[i] * middleX_[i] + pushY_[i] * middleY_[i]);
    state_.e[i] += work;
    state_.pushed = state_.pushed + Vec21{work, dt * pushX_[i], dt * pushY_[i]};
  }
  state_.px = tried_.px;
  state_.py = tried_.py;
  invert(state_.px, state_.py, state_.e, tried_.vx, tried_.vy);
  state_.vx = tried_.vx;
  state_.vy = tried_.vy;
}

glm::dvec2 SoftBody::stressMomentum(std::size_t i, const glm::dvec2& v) const {
  const double x = v.x, y = v.y;
  const double wx = on_.stressXX[i] * x + on_.stressXY[i] * y, wy = on_.stressXY[i] * x + on_.stressYY[i] * y;
  const double along = contraction(x, y) * (x * wx + y * wy);
  return {wx - along * x, wy - along * y};
}

void SoftBody::push(std::size_t node, const glm::dvec2& force) {
  pushX_[node] += force.x;
  pushY_[node] += force.y;
  isPushed_ = true;
}

void SoftBody::endPushes() {
  if (!isPushed_) return;
  isPushed_ = false;
  std::fill(pushX_.begin(), pushX_.end(), 0.0);
  std::fill(pushY_.begin(), pushY_.end(), 0.0);
}

SoftBodyDeformation SoftBody::ownDeformation(std::size_t triangle) const {
  const glm::dvec2 mean = meanOf(triangles_.node, state_, triangle);
  return deformationAt(triangle, mean.x, mean.y);
}

double SoftBody::elasticEnergy(const SoftBodyDeformation& f, std::size_t triangle) const {
  const double a = material_.soundSpeed * material_.soundSpeed;
  return 0.5 * a * (f.sum * (1.0 + 1.0 / f.area) - 4.0) * triangles_.mass[triangle];
}

double SoftBody::heatAndStretchOf(std::size_t i) const {
  const double x = state_.vx[i], y = state_.vy[i];
  const double stress =
      x * (on_.stressXX[i] * x + on_.stressXY[i] * y) + y * (on_.stressXY[i] * x + on_.stressYY[i] * y);
  return state_.e[i] * std::sqrt(1.0 - x * x - y * y) + stress - mass_ * mesh_->nodeShare(i);
}

std::vector<SoftBody::NodeState> SoftBody::nodeStates() const {
  std::vector<NodeState> states(size());
  for (std::size_t c = 0; c < triangles_.mass.size(); ++c) {
    const SoftBodyDeformation f = ownDeformation(c);
    const double most = f.sum - f.least - 1.0, least = f.least - 1.0;
    const double strain = most > -least ? most : least, elastic = elasticEnergy(f, c);
    for (const std::vector<int>& nodes : triangles_.node) {
      NodeState& state = states[static_cast<std::size_t>(nodes[c])];
      state.strain += strain * triangles_.mass[c] / 3.0;
      state.heat -= elastic / 3.0;
    }
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const double mass = mass_ * mesh_->nodeShare(i);
    states[i].strain /= mass;
    states[i].heat = (states[i].heat + heatAndStretchOf(i)) / mass;
  }
  return states;
}

SoftTotals SoftBody::totals() const {
  SoftTotals totals;
  double elastic = 0.0;
  for (std::size_t c = 0; c < triangles_.mass.size(); ++c) elastic += elasticEnergy(ownDeformation(c), c);
  for (std::size_t i = 0; i < size(); ++i) {
    totals.momentum = totals.momentum + Vec21{state_.e[i], state_.px[i], state_.py[i]};
    totals.centre += state_.e[i] * place(i);
    totals.heat += heatAndStretchOf(i);
  }
  totals.centre /= totals.momentum.t;
  totals.elastic = elastic;
  totals.heat -= elastic;
  for (std::size_t i = 0; i < size(); ++i) {
    const glm::dvec2 arm = place(i) - totals.centre;
    totals.spin += arm.x * state_.py[i] - arm.y * state_.px[i];
  }
  return totals;
}

SoftSurvey SoftBody::survey() const {
  SoftSurvey survey{true, std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t c = 0; c < triangles_.mass.size(); ++c) {
    const Deformation board = deformationAt(c, 0.0, 0.0);
    const glm::dvec2 mean = meanOf(triangles_.node, state_, c);
    const Deformation f = seenFrom(board, mean.x, mean.y);
    const double across = triangles_.altitude[c] * board.least;
    survey.longestStep = across < survey.longestStep ? across : survey.longestStep;
    survey.isSound = survey.isSound && f.area > kLeastArea;
    survey.heat -= elasticEnergy(f, c);
  }
  survey.longestStep *= kStepShare;
  for (std::size_t i = 0; i < size(); ++i) {
    const double speed2 = state_.vx[i] * state_.vx[i] + state_.vy[i] * state_.vy[i];
    survey.isSound = survey.isSound && speed2 < kFastest * kFastest;
    survey.heat += heatAndStretchOf(i);
  }
  return survey;
}

}  // namespace carom
