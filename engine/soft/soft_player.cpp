#include "engine/soft/soft_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {
namespace {

constexpr double kUnrest = 1e-5;  // of the mass: below it a body can fall asleep
constexpr double kSpin = 1e-6;    // of M R, likewise

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

SoftPlayer::SoftPlayer(std::shared_ptr<const SoftEntry> comes)
    : entry(std::move(comes)), body(entry->mesh, entry->material, entry->mass, entry->centre, entry->u) {
  body.setClocks(entry->clock);
  for (const SoftHold& hold : entry->holds) heldNodes.push_back(sideOf(*entry->mesh, hold.isPlusX));
}

void SoftPlayer::measure() {
  body.refresh();
  hasStresses = true;
  centre = body.centre(), velocity = body.meanVelocity();
  reach = isAwake ? body.reachFrom(centre) : entry->mesh->reach_m();
}

void SoftPlayer::refresh() {
  if (!std::exchange(hasStresses, true)) body.refresh();
}

void SoftPlayer::wake(double time) {
  body.coast(time - since);
  since = quietSince = time;
  isAwake = true;
  measure();
}

void SoftPlayer::fallAsleep(bool atOnce) {
  std::vector<glm::dvec2> beside;
  const double left = fade.empty() ? 0.0 : fadeAt(since);
  for (std::size_t i = 0; i < body.size(); ++i)
    beside.push_back(body.place(i) + (left > 0.0 ? left * fade[i] : glm::dvec2(0.0)));
  body.settle();
  for (std::size_t i = 0; i < beside.size(); ++i) beside[i] -= body.place(i);
  fade = atOnce ? std::vector<glm::dvec2>{} : std::move(beside);
  fadesFrom = since;
  isAwake = false;
  measure();
}

bool SoftPlayer::isQuiet(double time) {
  const double most = kSpin * entry->mass * entry->mesh->reach_m();
  if (!(body.unrest() < kUnrest && std::abs(body.totals().spin) < most)) quietSince = time;
  return time - quietSince >= soundTime();
}

double SoftPlayer::soundTime() const { return 2.0 * entry->mesh->reach_m() / entry->material.soundSpeed; }

double SoftPlayer::fadeAt(double time) const {
  return std::max(0.0, 1.0 - (time - fadesFrom) / entry->mesh->reach_m());
}

SoftPlayer::State SoftPlayer::state() const {
  return {entry, body.state(), isAwake, since, quietSince, fade, fadesFrom, centre, velocity, reach};
}

void SoftPlayer::restore(const State& state) {
  if (entry != state.entry) *this = SoftPlayer(state.entry);
  body.restore(state.body);
  isAwake = state.isAwake;
  since = state.since, quietSince = state.quietSince;
  fade = state.fade, fadesFrom = state.fadesFrom;
  centre = state.centre, velocity = state.velocity, reach = state.reach;
  hasStresses = false;
}

}  // namespace carom
