#include "cave/bodies/seen_rows.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/light/emission_kernel.h"

namespace carom {
namespace {

/// A vector of a body's own frame, in the board's axes, as the board has it; and the other way round.
glm::dvec2 contracted(const glm::dvec2& d, const glm::dvec2& v) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(v, v));
  return d - gamma / (gamma + 1.0) * glm::dot(v, d) * v;
}
glm::dvec2 stretched(const glm::dvec2& d, const glm::dvec2& v) {
  const double gamma2 = 1.0 / (1.0 - glm::dot(v, v));
  return d + gamma2 / (std::sqrt(gamma2) + 1.0) * glm::dot(v, d) * v;
}

glm::dvec3 withU(const glm::dvec2& v) {
  return glm::dvec3(v / std::sqrt(std::max(1e-12, 1.0 - glm::dot(v, v))), 0.0);
}

/// The rows of a soft puck as one eye has them. Without contraction each node is away from the centre by as
/// much as it would be if its matter were relaxed there: stretched by its own motion.
class PuckRows {
 public:
  PuckRows(const SoftModel& model, const SoftHistory& history, std::span<const double> times_m,
           const RowEye& eye)
      : model_(model), history_(history), times_m_(times_m), eye_(eye) {}

  std::size_t count() const { return times_m_.size(); }
  double time_m(std::size_t k) const { return times_m_[k]; }
  glm::dvec2 onBoard(std::size_t k, std::size_t node) const {
    const SoftNode& at = history_.nodesOf(k)[node];
    const glm::dvec2 arm(at.x, at.y);
    return history_.row(k).centre() +
           (eye_.isContracted() ? arm : stretched(arm, history_.velocityAfter(k, node)));
  }
  glm::dvec3 fromEye_m(std::size_t k, std::size_t point) const {
    const SoftModel::Point& at = model_.points[point];
    return glm::dvec3(onBoard(k, at.node), 0.5 * model_.height_m + at.z_m) - eye_.observation().r_m;
  }
  glm::dvec3 velocityBefore(std::size_t point) const { return velocity(0, point); }
  glm::dvec3 velocityAfter(std::size_t point) const { return velocity(count() - 1, point); }

  /// The velocity with which a node shines: between the rows' own, which do not jump at a row.
  glm::dvec2 shiningVelocity(const RowSpot& spot, std::size_t node) const {
    const glm::dvec2 v = history_.velocityAfter(spot.row, node);
    if (spot.share <= 0.0 || spot.row + 1 >= count()) return v;
    return glm::mix(v, history_.nodesOf(spot.row + 1)[node].v(), spot.share);
  }
  glm::dvec2 placeAt(const RowSpot& spot, std::size_t node) const {
    if (spot.share <= 0.0 || spot.row + 1 >= count()) return onBoard(spot.row, node);
    return glm::mix(onBoard(spot.row, node), onBoard(spot.row + 1, node), spot.share);
  }
  double told(const RowSpot& spot, std::size_t node, Told told) const {
    const auto at = [&](std::size_t k) {
      const SoftNode& of = history_.nodesOf(k)[node];
      return told == Told::strain ? of.strainShare() : of.heatShare();
    };
    if (spot.share <= 0.0 || spot.row + 1 >= count()) return at(spot.row);
    return glm::mix(at(spot.row), at(spot.row + 1), spot.share);
  }

 private:
  /// A node beside the rows goes on evenly. Without contraction it keeps its stretched distance to the
  /// centre.
  glm::dvec3 velocity(std::size_t k, std::size_t point) const {
    const glm::dvec2 v = eye_.isContracted() ? history_.velocityAfter(k, model_.points[point].node)
                                             : history_.row(k).velocity();
    return {v, 0.0};
  }

  const SoftModel& model_;
  const SoftHistory& history_;
  std::span<const double> times_m_;
  const RowEye& eye_;
};

/// The rows of a told body as one eye has them. It is unseen before the first one.
class ToldRows {
 public:
  ToldRows(const SampledHistory& history, std::span<const double> times_m, const RowEye& eye)
      : history_(history), times_m_(times_m), eye_(eye) {}

  std::size_t count() const { return times_m_.size(); }
  double time_m(std::size_t k) const { return times_m_[k]; }
  glm::dvec3 fromEye_m(std::size_t k, std::size_t point) const {
    return history_.place_m(k, point) - eye_.observation().r_m;
  }
  glm::dvec3 velocityBefore(std::size_t) const { return glm::dvec3(0.0); }
  glm::dvec3 velocityAfter(std::size_t point) const { return velocity(count() - 2, point); }
  /// Over c, after a row.
  glm::dvec3 velocity(std::size_t k, std::size_t point) const {
    const std::size_t from = std::min(k, count() - 2);
    return (history_.place_m(from + 1, point) - history_.place_m(from, point)) /
           (times_m_[from + 1] - times_m_[from]);
  }
  glm::dvec3 placeAt(const RowSpot& spot, std::size_t point) const {
    return history_.place_m(spot.row, point) +
           (spot.boardTime_m - times_m_[spot.row]) * velocity(spot.row, point);
  }

 private:
  const SampledHistory& history_;
  std::span<const double> times_m_;
  const RowEye& eye_;
};

/// A normal that is across a surface on the board, in the own frame of matter that moves with γβ = u.
glm::dvec3 ownNormal(const glm::dvec3& normal, const glm::dvec3& u) {
  const double gamma = gammaFromU(u);
  const glm::dvec3 own = normal - u * (glm::dot(u, normal) / (gamma * (gamma + 1.0)));
  const double length = glm::length(own);
  return length > 0.0 ? own / length : glm::dvec3(0.0, 0.0, 1.0);
}

/// The normal of the side where these two nodes are beside a vertex. On the board it is across the hull; in
/// the vertex's own frame lengths along its motion are longer, so less of it is along the motion.
glm::dvec3 sideNormal(const glm::dvec2& before, const glm::dvec2& after, const glm::dvec2& v) {
  const glm::dvec2 along = after - before;
  const glm::dvec2 normal = contracted({along.y, -along.x}, v);
  const double length = glm::length(normal);
  return length > 0.0 ? glm::dvec3(normal / length, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
}

SeenBound boundOf(std::span<const SeenVertex> vertices) {
  glm::dvec3 least(vertices.front().drawn), most = least;
  for (const SeenVertex& vertex : vertices) {
    least = glm::min(least, glm::dvec3(vertex.drawn));
    most = glm::max(most, glm::dvec3(vertex.drawn));
  }
  return {0.5 * (least + most), 0.5 * glm::length(most - least)};
}

}  // namespace

template <typename Rows>
void SeenRows::findPoints(const SoftModel& model, const SoftPast& past, const RowEye& eye, const Rows& rows,
                          Told told) {
  points_.resize(model.points.size());
  std::size_t guess = rows.count() - 1;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& point = points_[i];
    point.spot = eye.find(rows, i, guess);
    guess = point.spot.row;
    point.isOnLeg = point.spot.isBeforeAll && past.rigid.has_value();
    if (point.isOnLeg) {
      findOnLeg(model, i, eye);
      continue;
    }
    const std::uint32_t node = model.points[i].node;
    point.drawn = eye.drawn(point.spot.boardTime_m, point.spot.fromEye_m);
    point.boardTime_m = eye.toldTime_m(point.spot.boardTime_m);
    point.u = withU(rows.shiningVelocity(point.spot, node));
    point.told = rows.told(point.spot, node, told);
  }
}

/// A vertex that is catching up is lit as on its incoming leg: its colour must not flash.
void SeenRows::findOnLeg(const SoftModel& model, std::size_t number, const RowEye& eye) {
  const SoftModel::Point& of = model.points[number];
  const kernel::VertexEmission emission = emissionIn(rigid_, Vec3(model.relaxed_m[of.node], of.z_m));
  const LegView& leg = rigid_.legs[static_cast<std::size_t>(emission.leg)];
  const LegView& lit = emission.catchingUp ? rigid_.legs[static_cast<std::size_t>(emission.leg - 1)] : leg;
  Point& point = points_[number];
  point.drawn = eye.drawnAtSeen(seenFromEye(rigid_, emission));
  point.boardTime_m = eye.toldTime_m(kernel::boardTimeOf(leg, emission.event));
  point.u = {lit.toBoardTime.y, lit.toBoardTime.z, lit.toBoardTime.w};
  point.told = 0.0;
}

SeenBound SeenRows::see(const SoftModel& model, const SoftPast& past, const SeenHow& how, Told told,
                        std::span<SeenVertex> vertices) {
  const RowEye eye(how.observation, how.headFromBoard, how.switches, how.moment);
  const double now_m = how.observation.t_s * how.headFromBoard.lightSpeed_m_s();
  times_m_.clear();
  for (std::size_t k = 0; k < past.rows.rowCount(); ++k) times_m_.push_back(past.rows.row(k).time - now_m);
  if (past.rigid) viewBody(*past.rigid, how.observation, how.headFromBoard, rigid_, how.switches, how.moment);
  const PuckRows rows(model, past.rows, times_m_, eye);
  findPoints(model, past, eye, rows, told);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const SoftModel::Vertex& vertex = model.vertices[i];
    const Point &at = points_[vertex.point], &middle = points_[vertex.middle];
    const auto beside = [&](std::uint32_t node) {
      return at.isOnLeg ? model.relaxed_m[node] : rows.placeAt(at.spot, node);
    };
    const glm::dvec2 v = at.isOnLeg ? glm::dvec2(0.0) : glm::dvec2(betaFromU(at.u));
    const glm::dvec3 normal = vertex.faces == 0 ? sideNormal(beside(vertex.before), beside(vertex.after), v)
                                                : glm::dvec3(0.0, 0.0, vertex.faces);
    const glm::dvec3 drawn =
        vertex.reach == 1.0F ? at.drawn : middle.drawn + double{vertex.reach} * (at.drawn - middle.drawn);
    vertices[i] = {glm::vec3(drawn), static_cast<float>(at.boardTime_m), glm::vec3(at.u),
                   static_cast<float>(at.told), glm::vec3(normal)};
  }
  SeenBound bound = boundOf(vertices);
  bound.middleU = points_.back().u;
  for (const Point& point : points_) bound.hottest = std::max(bound.hottest, point.told);
  // As long as nothing of it is seen to be soft it is drawn as the rigid puck that it was.
  const auto isOnLeg = [](const Point& point) { return point.isOnLeg; };
  if (std::all_of(points_.begin(), points_.end(), isOnLeg)) bound.radius = -1.0;
  return bound;
}

SeenBound SeenRows::see(const SoftModel& model, const SeenHow& how, std::span<SeenVertex> vertices) {
  const RowEye eye(how.observation, how.headFromBoard, how.switches, how.moment);
  const SampledHistory& history = model.told->history;
  times_m_.clear();
  for (std::size_t k = 0; k < history.rowCount(); ++k)
    times_m_.push_back(history.lightSpeed_m_s() * (history.time_s(k) - how.observation.t_s));
  const ToldRows rows(history, times_m_, eye);
  points_.resize(model.points.size());
  std::size_t guess = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& point = points_[i];
    point.spot = eye.find(rows, i, guess);
    guess = point.spot.row;
    point.drawn = eye.drawn(point.spot.boardTime_m, point.spot.fromEye_m);
    point.boardTime_m = point.spot.isBeforeAll ? 10.0 * kUnseen_m : eye.toldTime_m(point.spot.boardTime_m);
    point.u = uFromBeta(rows.velocity(point.spot.row, i));
  }
  // Of each vertex the sum over its triangles, as they are on the board when it is seen.
  normals_.assign(points_.size(), glm::dvec3(0.0));
  for (const auto& corners : model.told->triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = corners[k], j = corners[(k + 1) % 3], l = corners[(k + 2) % 3];
      const RowSpot& spot = points_[i].spot;
      const glm::dvec3 at = rows.placeAt(spot, i);
      normals_[i] += glm::cross(rows.placeAt(spot, j) - at, rows.placeAt(spot, l) - at);
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point& at = points_[model.vertices[i].point];
    const glm::dvec3 beside(model.painted[i].place_m), across = normals_[model.vertices[i].point];
    const glm::dvec3 normal = beside == glm::dvec3(0.0) ? ownNormal(across, at.u) : glm::normalize(beside);
    vertices[i] = {glm::vec3(at.drawn + beside), static_cast<float>(at.boardTime_m), glm::vec3(at.u), 0.0F,
                   glm::vec3(normal)};
  }
  return boundOf(vertices);
}

}  // namespace carom
