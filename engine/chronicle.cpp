#include "engine/chronicle.h"

#include <algorithm>

namespace carom {

namespace {

constexpr std::size_t kMostNewLegs = 256;

Vec2 betaOf(const Vec21& u) { return {u.x / u.t, u.y / u.t}; }

}  // namespace

Chronicle::Chronicle(const BilliardSetup& setup)
    : c_m_s_(setup.lightSpeed_m_s),
      friction_m_s2_(setup.rules.friction_m_s2),
      forgottenLegs_(setup.pucks.size(), 0) {
  for (const Puck& puck : setup.pucks) {
    const double height_m = 0.5 * puck.height_m;
    height_m_.push_back(height_m);
    const Event start{0.0, {puck.position_m.x, puck.position_m.y, height_m}};
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
    const Knot first{start, {gamma * puck.beta.x, gamma * puck.beta.y, 0.0}, 0.0, start, friction_m_s2_};
    lines_.emplace_back(first, c_m_s_, std::hypot(puck.radius_m, height_m));
  }
}

void Chronicle::addLeg(std::size_t puck, const Leg& leg, const Vec21& news) {
  newLegs_.push_back({puck, leg, news});
  if (newLegs_.size() == kMostNewLegs) complete();
}

// The ends of the world lines are scattered over the memory: those of the legs to come are asked for while
// one is added.
void Chronicle::complete() {
  constexpr std::size_t kLines = 16, kEnds = 8;  // legs ahead
  for (std::size_t k = 0; k < newLegs_.size(); ++k) {
    if (k + kLines < newLegs_.size()) {
      const char* line = reinterpret_cast<const char*>(&lines_[newLegs_[k + kLines].puck]);
      __builtin_prefetch(line), __builtin_prefetch(line + 64);
    }
    if (k + kEnds < newLegs_.size()) lines_[newLegs_[k + kEnds].puck].fetchEnd();
    const auto& [puck, leg, news] = newLegs_[k];
    lines_[puck].append({eventOf(puck, leg.start),
                         {leg.u.x, leg.u.y, 0.0},
                         leg.properTime / c_m_s_,
                         eventOf(puck, news),
                         friction_m_s2_});
  }
  newLegs_.clear();
}

void Chronicle::keepLegs(std::size_t puck, std::size_t legs) {
  complete();
  lines_[puck].keepFirst(legs - forgottenLegs_[puck]);
}

std::size_t Chronicle::addCollision(std::optional<Cushion> cushion, const Vec21& contact, double heat_j) {
  Collision collision;
  collision.cushion = cushion;
  collision.contact = {contact.t / c_m_s_, {contact.x, contact.y, 0.0}};
  collision.heat_j = heat_j;
  collisions_.push_back(collision);
  return collisionCount() - 1;
}

void Chronicle::addTurn(std::size_t collision, std::size_t puck, const Moment& before, const Vec21& uAfter) {
  Collision& noted = collisions_[collision - forgottenCollisions_];
  noted.turns.push_back(turnOf(puck, before, uAfter));
  noted.contact.r_m.z = noted.turns[0].event.r_m.z;
}

void Chronicle::changeTurn(std::size_t collision, std::size_t puck, const Moment& before,
                           const Vec21& uAfter) {
  if (collision < forgottenCollisions_) return;
  for (Turn& turn : collisions_[collision - forgottenCollisions_].turns) {
    if (turn.puck == puck) turn = turnOf(puck, before, uAfter);
  }
}

void Chronicle::addHeat(std::size_t collision, double heat_j) {
  if (collision >= forgottenCollisions_) collisions_[collision - forgottenCollisions_].heat_j += heat_j;
}

void Chronicle::keepCollisions(std::size_t count) { collisions_.resize(count - forgottenCollisions_); }

void Chronicle::forgetBefore(double t_s) {
  complete();
  for (std::size_t puck = 0; puck < lines_.size(); ++puck)
    forgottenLegs_[puck] += lines_[puck].forgetBefore(t_s);
  const auto over = std::find_if(collisions_.begin(), collisions_.end(), [t_s](const Collision& collision) {
    return std::any_of(collision.turns.begin(), collision.turns.end(),
                       [t_s](const Turn& turn) { return turn.event.t_s >= t_s; });
  });
  forgottenCollisions_ += static_cast<std::size_t>(over - collisions_.begin());
  collisions_.erase(collisions_.begin(), over);
}

Event Chronicle::eventOf(std::size_t puck, const Vec21& x) const {
  return {x.t / c_m_s_, {x.x, x.y, height_m_[puck]}};
}

Turn Chronicle::turnOf(std::size_t puck, const Moment& before, const Vec21& uAfter) const {
  return {puck, eventOf(puck, before.x), betaOf(before.u), betaOf(uAfter), before.properTime / c_m_s_};
}

}  // namespace carom
