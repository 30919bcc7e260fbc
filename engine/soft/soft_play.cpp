#include "engine/soft/soft_play.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

namespace carom {

namespace {

std::vector<int> sideOf(const SoftMesh& mesh, bool isPlusX) {
  double end = 0.0;
  for (const glm::dvec2& place : mesh.places())
    end = isPlusX ? std::max(end, place.x) : std::min(end, place.x);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    if (std::abs(mesh.places()[i].x - end) <= 1e-9 * mesh.reach_m()) nodes.push_back(static_cast<int>(i));
  }
  return nodes;
}

}  // namespace

struct SoftPlay::Player {
  explicit Player(std::shared_ptr<const SoftEntry> comes)
      : entry(std::move(comes)), body(entry->mesh, entry->material, entry->mass, entry->centre, entry->u) {
    body.setClocks(entry->clock);
    for (const SoftHold& hold : entry->holds) heldNodes.push_back(sideOf(*entry->mesh, hold.isPlusX));
  }

  std::shared_ptr<const SoftEntry> entry;
  SoftBody body;
  std::vector<std::vector<int>> heldNodes;  // of each hold
  bool isAwake = false;
  double since = 0.0;       // the time of the body's state
  double quietSince = 0.0;  // nothing has touched it since, and it has hardly moved in itself
  // By the state: the centre of energy with its velocity, and the circle around it that holds the body.
  glm::dvec2 centre{0.0}, velocity{0.0};
  double reach = 0.0;
  bool hasStresses = false;  // of the state; a body that has been brought back has not
  // Where the nodes were beside their places when it fell asleep: this fades away in the time R.
  std::vector<glm::dvec2> fade{};
  double fadesFrom = 0.0;

  void measure() {
    body.refresh();
    hasStresses = true;
    centre = body.centre(), velocity = body.meanVelocity();
    reach = isAwake ? body.reachFrom(centre) : entry->mesh->reach_m();
  }
  void refresh() {
    if (!std::exchange(hasStresses, true)) body.refresh();
  }
  double soundTime() const { return 2.0 * entry->mesh->reach_m() / entry->material.soundSpeed; }
  double fadeAt(double time) const {
    return std::max(0.0, 1.0 - (time - fadesFrom) / entry->mesh->reach_m());
  }
};

struct SoftPlay::Push {
  SoftStroke stroke;
  std::vector<double> shares{};  // of the nodes; none until it begins
  std::vector<double> begins{};  // when the light of the hand has reached the node
  std::optional<double> began{};
  bool isOver = false;
};

struct SoftPlay::Present {
  long slice = 0;
  double time = 0.0;
  std::vector<Player> players;
  std::vector<Push> pushes;
  std::vector<SoftCollision> collisions;
  std::size_t settled = 0;  // of them are over
  std::vector<std::size_t> parted;
  FarSides farSides;
  std::vector<FarSides::Heard> heard;
  std::vector<SoftFrozen> frozen;
  glm::dvec2 taken{0.0};
  Vec21 givenByHolders;
  // How long the lists were, as far as they do not change any more, when the last slice began.
  struct Lengths {
    std::size_t collisions = 0, parted = 0, heard = 0, frozen = 0;
  } before;
};

namespace {

/// The end of a list that only grows. Where the beginning is not known, something stands in its place.
template <typename Item>
struct Tail {
  Tail(const std::vector<Item>& all, std::size_t from)
      : first(from), items(all.begin() + static_cast<std::ptrdiff_t>(from), all.end()) {}
  void restore(std::vector<Item>& all) const {
    all.resize(first);
    all.insert(all.end(), items.begin(), items.end());
  }
  std::size_t first;
  std::vector<Item> items;
};

}  // namespace

// It has the lists from the beginning of its slice on, so that a play at that beginning can go on from it,
// too; or all of them.
struct SoftPlay::Snapshot {
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
  Snapshot(const Present& now, const Present::Lengths& from);

  long slice;
  double time;
  std::vector<State> players;
  std::vector<Push> pushes;
  std::size_t settled;
  Tail<SoftCollision> collisions;
  Tail<std::size_t> parted;
  Tail<FarSides::Heard> heard;
  Tail<SoftFrozen> frozen;
  FarSides farSides;
  glm::dvec2 taken;
  Vec21 givenByHolders;
};

SoftPlay::Snapshot::Snapshot(const Present& now, const Present::Lengths& from)
    : slice(now.slice),
      time(now.time),
      pushes(now.pushes),
      settled(now.settled),
      collisions(now.collisions, from.collisions),
      parted(now.parted, from.parted),
      heard(now.heard, from.heard),
      frozen(now.frozen, from.frozen),
      farSides(now.farSides),
      taken(now.taken),
      givenByHolders(now.givenByHolders) {
  for (const Player& player : now.players)
    players.push_back({player.entry, player.body.state(), player.isAwake, player.since, player.quietSince,
                       player.fade, player.fadesFrom, player.centre, player.velocity, player.reach});
}

/// Bodies that take common steps.
struct SoftPlay::Cluster {
  std::vector<std::size_t> members;  // in the order of their names
  SoftGroup group;
  double time;
};

namespace {

constexpr double kUnrest = 1e-5;  // of the mass: below it a body can fall asleep
constexpr double kSpin = 1e-6;    // of M R, likewise
constexpr double kNever = std::numeric_limits<double>::infinity();

glm::dvec2 holdVelocity(const SoftHold& hold, const glm::dvec2& atFirst, double time) {
  glm::dvec2 velocity = atFirst;
  for (const SoftHold::Turn& turn : hold.turns) {
    if (turn.time <= time) velocity = turn.velocity;
  }
  return velocity;
}

/// Returns the least distance of two points in even motion within a duration.
double leastDistance(const glm::dvec2& apart, const glm::dvec2& velocity, double duration) {
  const double speed2 = glm::dot(velocity, velocity);
  const double nearest = speed2 > 0.0 ? std::clamp(-glm::dot(apart, velocity) / speed2, 0.0, duration) : 0.0;
  return glm::length(apart + nearest * velocity);
}

}  // namespace

SoftPlay::SoftPlay(std::vector<SoftCushion> cushions)
    : cushions_(std::move(cushions)), now_(std::make_unique<Present>()) {}
SoftPlay::~SoftPlay() = default;
SoftPlay::SoftPlay(SoftPlay&&) noexcept = default;
SoftPlay& SoftPlay::operator=(SoftPlay&&) noexcept = default;

std::size_t SoftPlay::add(const SoftEntry& entry) {
  Player player(std::make_shared<const SoftEntry>(entry));
  player.since = player.quietSince = now_->time;
  player.measure();
  now_->players.push_back(std::move(player));
  return now_->players.size() - 1;
}

void SoftPlay::addStroke(const SoftStroke& stroke) { now_->pushes.push_back({stroke}); }

double SoftPlay::time() const { return now_->time; }
std::size_t SoftPlay::size() const { return now_->players.size(); }
const std::string& SoftPlay::name(std::size_t body) const { return now_->players[body].entry->name; }
const SoftBody& SoftPlay::body(std::size_t body) const {
  now_->players[body].refresh();
  return now_->players[body].body;
}
bool SoftPlay::isAwake(std::size_t body) const { return now_->players[body].isAwake; }
double SoftPlay::timeOf(std::size_t body) const { return now_->players[body].since; }
std::span<const SoftCollision> SoftPlay::collisions() const { return now_->collisions; }
std::span<const std::size_t> SoftPlay::parted() const { return now_->parted; }
std::span<const FarSides::Heard> SoftPlay::heard() const { return now_->heard; }
std::span<const SoftFrozen> SoftPlay::frozen() const { return now_->frozen; }
std::optional<double> SoftPlay::strokeBegan(std::size_t stroke) const { return now_->pushes[stroke].began; }

void SoftPlay::watch(std::function<void(std::size_t, double)> stepped) { stepped_ = std::move(stepped); }

void SoftPlay::tell(std::size_t body) const {
  if (stepped_) stepped_(body, now_->players[body].since);
}

SoftTotals SoftPlay::totals(std::size_t body) const {
  const Player& player = now_->players[body];
  SoftTotals totals = this->body(body).totals();
  totals.centre += (now_->time - player.since) * player.velocity;
  return totals;
}

glm::dvec2 SoftPlay::place(std::size_t body, const SoftMesh::Inside& inside) const {
  const Player& player = now_->players[body];
  glm::dvec2 place = player.body.place(inside) + (now_->time - player.since) * player.body.velocity(inside);
  for (std::size_t k = 0; k < 3 && !player.fade.empty(); ++k)
    place += player.fadeAt(now_->time) * inside.shares[k] * player.fade[inside.nodes[k]];
  return place;
}

glm::dvec2 SoftPlay::velocity(std::size_t body, const SoftMesh::Inside& inside) const {
  return now_->players[body].body.velocity(inside);
}

double SoftPlay::clock(std::size_t body, const SoftMesh::Inside& inside) const {
  const Player& player = now_->players[body];
  const glm::dvec2 v = player.body.velocity(inside);
  return player.body.clock(inside) + (now_->time - player.since) * std::sqrt(1.0 - glm::dot(v, v));
}

bool SoftPlay::drawnPlaces(std::size_t body, std::optional<double> time,
                           std::vector<glm::dvec2>& places) const {
  const Player& player = now_->players[body];
  const double at = time.value_or(player.since);
  const double left = player.fade.empty() ? 0.0 : player.fadeAt(at);
  places.resize(player.body.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = player.body.place(i) + (at - player.since) * player.body.velocity(i);
    if (left > 0.0) places[i] += left * player.fade[i];
  }
  return left > 0.0;
}

SoftAccounts SoftPlay::accounts() const {
  SoftAccounts accounts;
  for (Player& player : now_->players) {
    player.refresh();
    const SoftTotals totals = player.body.totals();
    accounts.motion = accounts.motion + totals.momentum;
    accounts.heat += totals.restMass() - player.entry->mass;
    accounts.givenByStrokes = accounts.givenByStrokes + player.body.state().pushed;
  }
  accounts.taken = now_->taken;
  accounts.givenByHolders = now_->givenByHolders;
  return accounts;
}

glm::dvec2 SoftPlay::centre(std::size_t body) const { return centreOf(now_->players[body]); }

glm::dvec2 SoftPlay::centreOf(const Player& player) const {
  return player.centre + (now_->time - player.since) * player.velocity;
}

std::vector<std::size_t> SoftPlay::reached(std::span<const RigidNeighbour> rigid) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    const bool isNear = std::any_of(now_->players.begin(), now_->players.end(), [&](const Player& player) {
      const double reach = player.reach + rigid[k].radius + 2.0 * kSlice;
      return glm::length(centreOf(player) - rigid[k].place) < reach;
    });
    if (isNear) found.push_back(k);
  }
  return found;
}

bool SoftPlay::meetsAnother(const Player& player) const {
  const glm::dvec2 centre = centreOf(player), velocity = player.velocity;
  const double reach = player.reach;
  return std::any_of(now_->players.begin(), now_->players.end(), [&](const Player& other) {
    if (&other == &player) return false;
    const glm::dvec2 apart = centreOf(other) - centre;
    const double both = reach + other.reach;
    if (other.isAwake) return glm::length(apart) < both + 2.0 * kSlice;
    return leastDistance(apart, other.velocity - velocity, kSlice) < both;
  });
}

bool SoftPlay::isPushedBefore(const Player& player, double end) const {
  const auto number = static_cast<std::size_t>(&player - now_->players.data());
  return std::any_of(now_->pushes.begin(), now_->pushes.end(), [&](const Push& push) {
    if (push.stroke.body != number || push.isOver) return false;
    const Vec21& hand = push.stroke.hand;
    if (!push.stroke.hasPlace) return hand.t < end;
    const double apart = glm::length(centreOf(player) - glm::dvec2(hand.x, hand.y));
    const double nearest = std::max(0.0, apart - player.reach - kSlice);
    return end - hand.t >= std::hypot(nearest, push.stroke.height);
  });
}

bool SoftPlay::mustWake(const Player& player, double end) const {
  const glm::dvec2 centre = centreOf(player), velocity = player.velocity;
  for (const SoftCushion& cushion : cushions_) {
    const double speed = glm::dot(cushion.normal, velocity);
    const double farthest = glm::dot(cushion.normal, centre) + player.reach + kSlice * speed;
    if (speed > 0.0 && farthest >= cushion.offset) return true;
  }
  for (const SoftHold& hold : player.entry->holds) {
    if (!hold.turns.empty() && hold.turns.front().time < end) return true;
  }
  return isPushedBefore(player, end) || meetsAnother(player);
}

void SoftPlay::wake(Player& player) {
  player.body.coast(now_->time - player.since);
  player.since = player.quietSince = now_->time;
  player.isAwake = true;
  player.measure();
  tell(static_cast<std::size_t>(&player - now_->players.data()));
}

void SoftPlay::wakeAll(double end) {
  for (bool changes = true; changes;) {
    changes = false;
    for (Player& player : now_->players) {
      if (player.isAwake || !mustWake(player, end)) continue;
      wake(player);
      changes = true;
    }
  }
}

void SoftPlay::fallAsleep(Player& player, bool atOnce) {
  std::vector<glm::dvec2> beside;
  const double left = player.fade.empty() ? 0.0 : player.fadeAt(player.since);
  for (std::size_t i = 0; i < player.body.size(); ++i)
    beside.push_back(player.body.place(i) + (left > 0.0 ? left * player.fade[i] : glm::dvec2(0.0)));
  player.body.settle();
  for (std::size_t i = 0; i < beside.size(); ++i) beside[i] -= player.body.place(i);
  player.fade = atOnce ? std::vector<glm::dvec2>{} : std::move(beside);
  player.fadesFrom = player.since;
  player.isAwake = false;
  now_->farSides.forget(static_cast<std::size_t>(&player - now_->players.data()));
  player.measure();
  tell(static_cast<std::size_t>(&player - now_->players.data()));
}

// Those that could sleep are taken together for asleep, until none of them would be woken by another.
void SoftPlay::restTheQuiet() {
  std::vector<Player*> quiet;
  for (Player& player : now_->players) {
    if (!player.isAwake) continue;
    const double most = kSpin * player.entry->mass * player.entry->mesh->reach_m();
    if (!(player.body.unrest() < kUnrest && std::abs(player.body.totals().spin) < most))
      player.quietSince = now_->time;
    if (now_->time - player.quietSince < player.soundTime()) continue;
    player.isAwake = false;
    player.measure();
    quiet.push_back(&player);
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (Player* player : quiet) {
      if (player->isAwake || !mustWake(*player, now_->time + kSlice)) continue;
      player->isAwake = changes = true;
      player->measure();
    }
  }
  for (Player* player : quiet) {
    if (!player->isAwake) fallAsleep(*player, false);
  }
}

std::vector<std::vector<std::size_t>> SoftPlay::clusters() const {
  const std::vector<Player>& players = now_->players;
  std::vector<std::size_t> awake;
  for (std::size_t k = 0; k < players.size(); ++k) {
    if (players[k].isAwake) awake.push_back(k);
  }
  std::sort(awake.begin(), awake.end(),
            [&](std::size_t a, std::size_t b) { return players[a].entry->name < players[b].entry->name; });
  std::vector<std::vector<std::size_t>> found;
  std::vector<bool> isIn(players.size(), false);
  for (const std::size_t first : awake) {
    if (isIn[first]) continue;
    std::vector<std::size_t> members{first};
    isIn[first] = true;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Player& one = players[members[k]];
      for (const std::size_t other : awake) {
        const double reach = one.reach + players[other].reach + 2.0 * kSlice;
        if (isIn[other] || glm::length(centreOf(one) - centreOf(players[other])) >= reach) continue;
        isIn[other] = true;
        members.push_back(other);
      }
    }
    std::sort(members.begin(), members.end(),
              [&](std::size_t a, std::size_t b) { return players[a].entry->name < players[b].entry->name; });
    found.push_back(std::move(members));
  }
  return found;
}

void SoftPlay::playSlice(double until) {
  Present& now = *now_;
  const double whole = kSlice * static_cast<double>(now.slice + 1), end = std::min(whole, until);
  now.before = {now.settled, now.parted.size(), now.heard.size(), now.frozen.size()};
  wakeAll(whole);
  for (const std::vector<std::size_t>& members : clusters()) play(members, end);
  now.time = end;
  if (end < whole) return;
  ++now.slice;
  endCollisions();
  restTheQuiet();
}

void SoftPlay::play(const std::vector<std::size_t>& members, double end) {
  std::vector<SoftBody*> bodies;
  for (const std::size_t member : members) {
    now_->players[member].refresh();
    bodies.push_back(&now_->players[member].body);
  }
  if (bodies.empty()) return;
  Cluster cluster{members, SoftGroup(bodies, cushions_), now_->players[members.front()].since};
  while (cluster.time < end) {
    setHolds(cluster);
    setPushes(cluster);
    const double cut = nextCut(cluster, end), most = cut - cluster.time;
    try {
      const double dt = cluster.group.step(most);
      cluster.time = dt == most ? cut : cluster.time + dt;
      note(cluster);
    } catch (const SoftStepFailure& failure) {
      // The body goes on in its mean motion; the others play on without it for the rest of the slice.
      book(cluster);
      std::vector<std::size_t> others = members;
      freeze(now_->players[members[failure.body]], cluster.time);
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(failure.body));
      return play(others, end);
    }
  }
  book(cluster);
  for (const std::size_t member : members) now_->players[member].measure();
}

void SoftPlay::setHolds(Cluster& cluster) {
  std::vector<HeldSide>& held = cluster.group.held();
  held.clear();
  for (std::size_t k = 0; k < cluster.members.size(); ++k) {
    const Player& player = now_->players[cluster.members[k]];
    const Vec21& u = player.entry->u;
    for (const SoftHold& hold : player.entry->holds) {
      for (const SoftHold::Turn& turn : hold.turns) {
        if (turn.time != cluster.time) continue;
        const double speed = glm::distance(turn.velocity, player.body.meanVelocity());
        now_->farSides.push(cluster.members[k], player.body, {hold.isPlusX ? -1.0 : 1.0, 0.0}, speed);
      }
    }
    for (std::size_t h = 0; h < player.heldNodes.size(); ++h) {
      held.push_back({k, player.heldNodes[h],
                      holdVelocity(player.entry->holds[h], glm::dvec2(u.x, u.y) / u.t, cluster.time)});
    }
  }
}

void SoftPlay::begin(Push& push, double time) {
  const Player& player = now_->players[push.stroke.body];
  const SoftMesh& mesh = *player.entry->mesh;
  const glm::dvec2 axis = player.body.turned(), way = glm::normalize(push.stroke.momentum);
  push.began = time;
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    const glm::dvec2 X = mesh.places()[i], turned(axis.x * X.x - axis.y * X.y, axis.y * X.x + axis.x * X.y);
    push.shares.push_back(mesh.nodeShare(i) * std::max(0.0, -glm::dot(turned, way)));
    push.begins.push_back(kNever);
    sum += push.shares.back();
  }
  for (double& share : push.shares) share /= sum;
  const double given = glm::length(push.stroke.momentum), energy = player.body.totals().momentum.t;
  now_->farSides.push(push.stroke.body, player.body, way, given / std::hypot(given, energy));
}

void SoftPlay::setPushes(Cluster& cluster) {
  for (const std::size_t member : cluster.members) now_->players[member].body.endPushes();
  for (Push& push : now_->pushes) {
    const SoftStroke& stroke = push.stroke;
    const auto isHere = std::find(cluster.members.begin(), cluster.members.end(), stroke.body);
    if (push.isOver || isHere == cluster.members.end() || cluster.time < stroke.hand.t) continue;
    if (stroke.momentum == glm::dvec2(0.0)) {
      push.isOver = true;
      continue;
    }
    Player& player = now_->players[stroke.body];
    const double lasts = player.soundTime();
    const glm::dvec2 hand(stroke.hand.x, stroke.hand.y), force = stroke.momentum / lasts;
    const auto isLit = [&](std::size_t i) {
      if (!stroke.hasPlace) return true;
      const glm::dvec2 way = player.body.place(i) - hand;
      const double since = cluster.time - stroke.hand.t;
      return since * since >= glm::dot(way, way) + stroke.height * stroke.height;
    };
    push.isOver = push.began.has_value();
    for (std::size_t i = 0; i < player.body.size(); ++i) {
      if (!push.began && isLit(i)) begin(push, cluster.time);
      if (!push.began || push.shares[i] == 0.0) continue;
      if (push.begins[i] == kNever && isLit(i)) push.begins[i] = cluster.time;
      if (cluster.time >= push.begins[i] + lasts) continue;
      push.isOver = false;
      player.quietSince = cluster.time;
      if (push.begins[i] < kNever) player.body.push(i, push.shares[i] * force);
    }
    // What is over is never looked at again, and is copied with every snapshot.
    if (push.isOver) push.shares = push.begins = {};
  }
}

double SoftPlay::nextCut(const Cluster& cluster, double end) const {
  double cut = end;
  const auto consider = [&](double time) {
    if (time > cluster.time) cut = std::min(cut, time);
  };
  for (const std::size_t member : cluster.members) {
    for (const SoftHold& hold : now_->players[member].entry->holds) {
      for (const SoftHold::Turn& turn : hold.turns) consider(turn.time);
    }
  }
  for (const Push& push : now_->pushes) {
    const auto& members = cluster.members;
    if (push.isOver || std::find(members.begin(), members.end(), push.stroke.body) == members.end()) continue;
    consider(push.stroke.hand.t);
    for (const double begin : push.begins) consider(begin + now_->players[push.stroke.body].soundTime());
  }
  return cut;
}

void SoftPlay::note(const Cluster& cluster) {
  std::vector<SoftCollision>& all = now_->collisions;
  for (const std::size_t member : cluster.members) now_->players[member].since = cluster.time;
  for (const SoftExchange& exchange : cluster.group.exchanges()) {
    const bool isPair = exchange.other != SoftExchange::kNone;
    const std::size_t body = cluster.members[exchange.body];
    const std::size_t other = isPair ? cluster.members[exchange.other] : SoftExchange::kNone;
    const auto heat = [&](bool before) {
      const auto of = [&](std::size_t k) {
        return before ? cluster.group.surveyBefore(k).heat : cluster.group.survey(k).heat;
      };
      return of(exchange.body) + (isPair ? of(exchange.other) : 0.0);
    };
    const auto known = std::find_if(
        all.begin() + static_cast<std::ptrdiff_t>(now_->settled), all.end(), [&](const SoftCollision& one) {
          return !one.isOver && one.body == body && one.other == other && one.cushion == exchange.cushion;
        });
    const bool isNew = known == all.end();
    if (isNew) {
      all.push_back({body,
                     other,
                     exchange.cushion,
                     {cluster.time - exchange.since, exchange.place.x, exchange.place.y}});
      all.back().heatBefore = heat(true);
      tellFarSides(all.back());
    }
    SoftCollision& collision = isNew ? all.back() : *known;
    collision.lastTouch = cluster.time;
    collision.lastPlace = exchange.place;
    collision.impulse += exchange.impulse;
    collision.heatAfter = heat(false);
    now_->players[body].quietSince = cluster.time;
    if (isPair) now_->players[other].quietSince = cluster.time;
  }
  for (const std::size_t member : cluster.members) {
    now_->farSides.look(member, now_->players[member].body, cluster.time, now_->heard);
    tell(member);
  }
}

void SoftPlay::tellFarSides(const SoftCollision& collision) {
  const Player& body = now_->players[collision.body];
  const glm::dvec2 place(collision.contact.x, collision.contact.y);
  if (collision.cushion != SoftExchange::kNone) {
    const glm::dvec2& normal = cushions_[collision.cushion].normal;
    now_->farSides.push(collision.body, body.body, -normal, std::abs(glm::dot(body.velocity, normal)));
    return;
  }
  const Player& other = now_->players[collision.other];
  const double speed = glm::distance(body.velocity, other.velocity);
  for (const std::size_t number : {collision.body, collision.other}) {
    const SoftBody& pushed = now_->players[number].body;
    now_->farSides.push(number, pushed, glm::normalize(pushed.centre() - place), speed);
  }
}

void SoftPlay::book(const Cluster& cluster) {
  for (std::size_t k = 0; k < cushions_.size(); ++k) now_->taken -= cluster.group.impulseOf(k);
  now_->givenByHolders = now_->givenByHolders + cluster.group.givenByHolders();
}

void SoftPlay::freeze(Player& player, double time) {
  now_->frozen.push_back({static_cast<std::size_t>(&player - now_->players.data()), time});
  player.since = time;
  fallAsleep(player, true);
}

void SoftPlay::endCollisions() {
  const auto soundTime = [&](std::size_t body) {
    return body == SoftExchange::kNone ? 0.0 : now_->players[body].soundTime();
  };
  bool allOver = true;
  for (std::size_t k = now_->settled; k < now_->collisions.size(); ++k) {
    SoftCollision& one = now_->collisions[k];
    if (!one.isOver && now_->time - one.lastTouch > std::max(soundTime(one.body), soundTime(one.other))) {
      one.isOver = true;
      now_->parted.push_back(k);
    }
    allOver = allOver && one.isOver;
    if (allOver) now_->settled = k + 1;
  }
}

std::shared_ptr<const SoftPlay::Snapshot> SoftPlay::snapshot() const {
  return std::make_shared<const Snapshot>(*now_, now_->before);
}

std::shared_ptr<const SoftPlay::Snapshot> SoftPlay::wholeSnapshot() const {
  return std::make_shared<const Snapshot>(*now_, Present::Lengths{});
}

void SoftPlay::restore(const Snapshot& snapshot) {
  Present& now = *now_;
  now.slice = snapshot.slice;
  now.time = snapshot.time;
  while (now.players.size() > snapshot.players.size()) now.players.pop_back();
  for (std::size_t k = 0; k < snapshot.players.size(); ++k) {
    const Snapshot::State& state = snapshot.players[k];
    if (k == now.players.size()) now.players.emplace_back(state.entry);
    Player& player = now.players[k];
    if (player.entry != state.entry) player = Player(state.entry);
    player.body.restore(state.body);
    player.isAwake = state.isAwake;
    player.since = state.since, player.quietSince = state.quietSince;
    player.fade = state.fade, player.fadesFrom = state.fadesFrom;
    player.centre = state.centre, player.velocity = state.velocity, player.reach = state.reach;
    player.hasStresses = false;
  }
  now.pushes = snapshot.pushes;
  now.settled = snapshot.settled;
  snapshot.collisions.restore(now.collisions);
  snapshot.parted.restore(now.parted);
  snapshot.heard.restore(now.heard);
  snapshot.frozen.restore(now.frozen);
  now.before = {snapshot.collisions.first, snapshot.parted.first, snapshot.heard.first,
                snapshot.frozen.first};
  now.farSides = snapshot.farSides;
  now.taken = snapshot.taken;
  now.givenByHolders = snapshot.givenByHolders;
}

}  // namespace carom
