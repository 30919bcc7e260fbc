#include "engine/soft/soft_play.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

namespace carom {

struct SoftPlay::Present {
  long slice = 0;
  double time = 0.0;
  std::vector<SoftPlayer> players;
  std::vector<SoftPush> pushes;
  SoftCollisions collisions;
  FarSides farSides;
  std::vector<FarSides::Heard> heard;
  std::vector<SoftFrozen> frozen;
  glm::dvec2 taken{0.0};
  Vec21 givenByHolders;
  // How long the lists were when the last slice began.
  struct Lengths {
    SoftCollisions::Lengths collisions;
    std::size_t heard = 0, frozen = 0;
  } before;

  std::size_t numberOf(const SoftPlayer& player) const {
    return static_cast<std::size_t>(&player - players.data());
  }
};

// It has the lists from the beginning of its slice on, so that a play at that beginning can go on from it,
// too; or all of them.
struct SoftPlay::Snapshot {
  Snapshot(const Present& now, const Present::Lengths& from);

  long slice;
  double time;
  std::vector<SoftPlayer::State> players;
  std::vector<SoftPush> pushes;
  SoftCollisions::State collisions;
  ListTail<FarSides::Heard> heard;
  ListTail<SoftFrozen> frozen;
  Present::Lengths begins;
  FarSides farSides;
  glm::dvec2 taken;
  Vec21 givenByHolders;
};

SoftPlay::Snapshot::Snapshot(const Present& now, const Present::Lengths& from)
    : slice(now.slice),
      time(now.time),
      pushes(now.pushes),
      collisions(now.collisions.state(from.collisions)),
      heard(now.heard, from.heard),
      frozen(now.frozen, from.frozen),
      begins(from),
      farSides(now.farSides),
      taken(now.taken),
      givenByHolders(now.givenByHolders) {
  for (const SoftPlayer& player : now.players) players.push_back(player.state());
}

/// Bodies that take common steps.
struct SoftPlay::Cluster {
  std::vector<std::size_t> members;  // in the order of their names
  SoftGroup group;
  double time;
};

namespace {

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

/// Returns whether a body comes within reach of another one in a slice of board time from now on.
bool meetsAnother(const SoftPlayer& player, std::span<const SoftPlayer> players, double time) {
  const glm::dvec2 centre = player.centreAt(time), velocity = player.velocity;
  return std::any_of(players.begin(), players.end(), [&](const SoftPlayer& other) {
    if (&other == &player) return false;
    const glm::dvec2 apart = other.centreAt(time) - centre;
    const double both = player.reach + other.reach;
    if (other.isAwake) return glm::length(apart) < both + 2.0 * SoftPlay::kSlice;
    return leastDistance(apart, other.velocity - velocity, SoftPlay::kSlice) < both;
  });
}

/// Tells the far sides of a collision that has begun.
void tellOf(const SoftCollision& collision, std::span<const SoftPlayer> players,
            std::span<const SoftCushion> cushions, FarSides& farSides) {
  const SoftPlayer& body = players[collision.body];
  const glm::dvec2 place(collision.contact.x, collision.contact.y);
  if (collision.cushion != SoftExchange::kNone) {
    const glm::dvec2& normal = cushions[collision.cushion].normal;
    farSides.push(collision.body, body.body, -normal, std::abs(glm::dot(body.velocity, normal)));
    return;
  }
  const double speed = glm::distance(body.velocity, players[collision.other].velocity);
  for (const std::size_t number : {collision.body, collision.other}) {
    const SoftBody& pushed = players[number].body;
    farSides.push(number, pushed, glm::normalize(pushed.centre() - place), speed);
  }
}

}  // namespace

SoftPlay::SoftPlay(std::vector<SoftCushion> cushions)
    : cushions_(std::move(cushions)), now_(std::make_unique<Present>()) {}
SoftPlay::~SoftPlay() = default;
SoftPlay::SoftPlay(SoftPlay&&) noexcept = default;
SoftPlay& SoftPlay::operator=(SoftPlay&&) noexcept = default;

std::size_t SoftPlay::add(const SoftEntry& entry) {
  SoftPlayer player(std::make_shared<const SoftEntry>(entry));
  player.since = player.quietSince = now_->time;
  player.measure();
  now_->players.push_back(std::move(player));
  return now_->players.size() - 1;
}

void SoftPlay::addStroke(const SoftStroke& stroke) { now_->pushes.emplace_back(stroke); }

double SoftPlay::time() const { return now_->time; }
std::size_t SoftPlay::size() const { return now_->players.size(); }
const std::string& SoftPlay::name(std::size_t body) const { return now_->players[body].entry->name; }
const SoftBody& SoftPlay::body(std::size_t body) const {
  now_->players[body].refresh();
  return now_->players[body].body;
}
bool SoftPlay::isAwake(std::size_t body) const { return now_->players[body].isAwake; }
double SoftPlay::timeOf(std::size_t body) const { return now_->players[body].since; }
std::span<const SoftCollision> SoftPlay::collisions() const { return now_->collisions.all(); }
std::span<const std::size_t> SoftPlay::parted() const { return now_->collisions.parted(); }
std::span<const FarSides::Heard> SoftPlay::heard() const { return now_->heard; }
std::span<const SoftFrozen> SoftPlay::frozen() const { return now_->frozen; }
std::optional<double> SoftPlay::strokeBegan(std::size_t stroke) const { return now_->pushes[stroke].began(); }

void SoftPlay::watch(std::function<void(std::size_t, double)> stepped) { stepped_ = std::move(stepped); }

void SoftPlay::tell(std::size_t body) const {
  if (stepped_) stepped_(body, now_->players[body].since);
}

SoftTotals SoftPlay::totals(std::size_t body) const {
  const SoftPlayer& player = now_->players[body];
  SoftTotals totals = this->body(body).totals();
  totals.centre += (now_->time - player.since) * player.velocity;
  return totals;
}

glm::dvec2 SoftPlay::place(std::size_t body, const SoftMesh::Inside& inside) const {
  const SoftPlayer& player = now_->players[body];
  glm::dvec2 place = player.body.place(inside) + (now_->time - player.since) * player.body.velocity(inside);
  for (std::size_t k = 0; k < 3 && !player.fade.empty(); ++k)
    place += player.fadeAt(now_->time) * inside.shares[k] * player.fade[inside.nodes[k]];
  return place;
}

glm::dvec2 SoftPlay::velocity(std::size_t body, const SoftMesh::Inside& inside) const {
  return now_->players[body].body.velocity(inside);
}

double SoftPlay::clock(std::size_t body, const SoftMesh::Inside& inside) const {
  const SoftPlayer& player = now_->players[body];
  const glm::dvec2 v = player.body.velocity(inside);
  return player.body.clock(inside) + (now_->time - player.since) * std::sqrt(1.0 - glm::dot(v, v));
}

bool SoftPlay::drawnPlaces(std::size_t body, std::optional<double> time,
                           std::vector<glm::dvec2>& places) const {
  const SoftPlayer& player = now_->players[body];
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
  for (SoftPlayer& player : now_->players) {
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

glm::dvec2 SoftPlay::centre(std::size_t body) const { return now_->players[body].centreAt(now_->time); }

std::vector<std::size_t> SoftPlay::reached(std::span<const RigidNeighbour> rigid) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    const bool isNear =
        std::any_of(now_->players.begin(), now_->players.end(), [&](const SoftPlayer& player) {
          const double reach = player.reach + rigid[k].radius + 2.0 * kSlice;
          return glm::length(player.centreAt(now_->time) - rigid[k].place) < reach;
        });
    if (isNear) found.push_back(k);
  }
  return found;
}

bool SoftPlay::mustWake(const SoftPlayer& player, double end) const {
  const glm::dvec2 centre = player.centreAt(now_->time), velocity = player.velocity;
  for (const SoftCushion& cushion : cushions_) {
    const double speed = glm::dot(cushion.normal, velocity);
    const double farthest = glm::dot(cushion.normal, centre) + player.reach + kSlice * speed;
    if (speed > 0.0 && farthest >= cushion.offset) return true;
  }
  for (const SoftHold& hold : player.entry->holds) {
    if (!hold.turns.empty() && hold.turns.front().time < end) return true;
  }
  const std::size_t number = now_->numberOf(player);
  const bool isPushed = std::any_of(now_->pushes.begin(), now_->pushes.end(), [&](const SoftPush& push) {
    return push.body() == number && push.reachesBefore(player, now_->time, kSlice, end);
  });
  return isPushed || meetsAnother(player, now_->players, now_->time);
}

void SoftPlay::wakeAll(double end) {
  for (bool changes = true; changes;) {
    changes = false;
    for (SoftPlayer& player : now_->players) {
      if (player.isAwake || !mustWake(player, end)) continue;
      player.wake(now_->time);
      tell(now_->numberOf(player));
      changes = true;
    }
  }
}

void SoftPlay::fallAsleep(std::size_t body, bool atOnce) {
  now_->farSides.forget(body);
  now_->players[body].fallAsleep(atOnce);
  tell(body);
}

// Those that could sleep are taken together for asleep, until none of them would be woken by another.
void SoftPlay::restTheQuiet() {
  std::vector<SoftPlayer*> quiet;
  for (SoftPlayer& player : now_->players) {
    if (!player.isAwake || !player.isQuiet(now_->time)) continue;
    player.isAwake = false;
    player.measure();
    quiet.push_back(&player);
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (SoftPlayer* player : quiet) {
      if (player->isAwake || !mustWake(*player, now_->time + kSlice)) continue;
      player->isAwake = changes = true;
      player->measure();
    }
  }
  for (SoftPlayer* player : quiet) {
    if (!player->isAwake) fallAsleep(now_->numberOf(*player), false);
  }
}

std::vector<std::vector<std::size_t>> SoftPlay::clusters() const {
  const std::vector<SoftPlayer>& players = now_->players;
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
      const SoftPlayer& one = players[members[k]];
      for (const std::size_t other : awake) {
        const double reach = one.reach + players[other].reach + 2.0 * kSlice;
        if (isIn[other] ||
            glm::length(one.centreAt(now_->time) - players[other].centreAt(now_->time)) >= reach)
          continue;
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
  now.before = {now.collisions.lengths(), now.heard.size(), now.frozen.size()};
  wakeAll(whole);
  for (const std::vector<std::size_t>& members : clusters()) play(members, end);
  now.time = end;
  if (end < whole) return;
  ++now.slice;
  now.collisions.end(now.time, [&](std::size_t body) { return now.players[body].soundTime(); });
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
      const std::size_t frozen = members[failure.body];
      now_->frozen.push_back({frozen, cluster.time});
      now_->players[frozen].since = cluster.time;
      fallAsleep(frozen, true);
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
    const SoftPlayer& player = now_->players[cluster.members[k]];
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

void SoftPlay::setPushes(const Cluster& cluster) {
  const std::vector<std::size_t>& members = cluster.members;
  for (const std::size_t member : members) now_->players[member].body.endPushes();
  for (SoftPush& push : now_->pushes) {
    if (std::find(members.begin(), members.end(), push.body()) == members.end()) continue;
    push.act(now_->players[push.body()], cluster.time, now_->farSides);
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
  const std::vector<std::size_t>& members = cluster.members;
  for (const SoftPush& push : now_->pushes) {
    if (std::find(members.begin(), members.end(), push.body()) != members.end())
      cut = push.nextChange(now_->players[push.body()], cluster.time, cut);
  }
  return cut;
}

void SoftPlay::note(const Cluster& cluster) {
  std::vector<SoftPlayer>& players = now_->players;
  for (const std::size_t member : cluster.members) players[member].since = cluster.time;
  for (const SoftExchange& touch : cluster.group.exchanges()) {
    if (const SoftCollision* begun =
            now_->collisions.note(touch, cluster.group, cluster.members, cluster.time))
      tellOf(*begun, players, cushions_, now_->farSides);
    players[cluster.members[touch.body]].quietSince = cluster.time;
    if (touch.other != SoftExchange::kNone) players[cluster.members[touch.other]].quietSince = cluster.time;
  }
  for (const std::size_t member : cluster.members) {
    now_->farSides.look(member, players[member].body, cluster.time, now_->heard);
    tell(member);
  }
}

void SoftPlay::book(const Cluster& cluster) {
  for (std::size_t k = 0; k < cushions_.size(); ++k) now_->taken -= cluster.group.impulseOf(k);
  now_->givenByHolders = now_->givenByHolders + cluster.group.givenByHolders();
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
    if (k == now.players.size()) now.players.emplace_back(snapshot.players[k].entry);
    now.players[k].restore(snapshot.players[k]);
  }
  now.pushes = snapshot.pushes;
  now.collisions.restore(snapshot.collisions);
  snapshot.heard.restore(now.heard);
  snapshot.frozen.restore(now.frozen);
  now.before = snapshot.begins;
  now.farSides = snapshot.farSides;
  now.taken = snapshot.taken;
  now.givenByHolders = snapshot.givenByHolders;
}

}  // namespace carom
