#include "engine/billiard/soft_row_book.h"

#include <algorithm>
#include <limits>

#include "engine/light/vertex_history.h"

namespace carom {
namespace {

// Rows that no frame takes, as where a game is only computed, or a long one is resumed, are dropped beyond
// this.
constexpr std::size_t kMostNodesWaiting = std::size_t{1} << 22U;

/// Returns where the points of a rigid puck are drawn that become nodes. Those of its upper and lower rim,
/// which are drawn, hear of a contact at the same time.
std::vector<glm::dvec2> rimPlaces(const SoftMesh& mesh, const WorldLine& line, double t_s, double height_m) {
  std::vector<glm::dvec2> places;
  for (const glm::dvec2& offset_m : mesh.places()) {
    const auto history = vertexHistory(line, {offset_m, 0.5 * height_m});
    places.emplace_back(placeAt(pieceAt(history, t_s), t_s, line.lightSpeed_m_s()));
  }
  return places;
}

}  // namespace

void SoftRowBook::begin() {
  recorders_.clear();
  truncateFrom(-std::numeric_limits<double>::infinity());
}

void SoftRowBook::enter(std::size_t puck, const SoftPlay& play, const WorldLine* line, double height_m) {
  const std::size_t body = recorders_.size();
  std::vector<glm::dvec2> drawn;
  if (line) {
    drawn = rimPlaces(play.body(body).mesh(), *line, play.time() / line->lightSpeed_m_s(), height_m);
  } else {
    play.drawnPlaces(body, play.time(), drawn);
  }
  recorders_.emplace_back(puck, play.time(), std::move(drawn), line != nullptr);
  play.drawnPlaces(body, play.time(), places_);
  recorders_.back().take(play.time(), places_, play.body(body), true, rows_);
}

void SoftRowBook::step(std::size_t body, const SoftPlay& play) {
  if (!listens_) return;
  const bool fades = play.drawnPlaces(body, std::nullopt, places_);
  const bool isRelaxed = !play.isAwake(body) && !fades;
  recorders_[body].take(play.timeOf(body), places_, play.body(body), isRelaxed, rows_);
}

void SoftRowBook::endSlice(const SoftPlay& play) {
  for (std::size_t body = 0; body < recorders_.size(); ++body) {
    RowRecorder& recorder = recorders_[body];
    if (play.isAwake(body) || recorder.isStill() || !(play.time() > recorder.time())) continue;
    const bool fades = play.drawnPlaces(body, play.time(), places_);
    recorder.take(play.time(), places_, play.body(body), !fades, rows_);
  }
  bound();
}

void SoftRowBook::bound() {
  if (rows_.nodes.size() <= kMostNodesWaiting) return;
  std::size_t rows = 0, nodes = 0;
  while (rows_.nodes.size() - nodes > kMostNodesWaiting / 2) nodes += rows_.rows[rows++].nodes;
  rows_.rows.erase(rows_.rows.begin(), rows_.rows.begin() + static_cast<std::ptrdiff_t>(rows));
  rows_.nodes.erase(rows_.nodes.begin(), rows_.nodes.begin() + static_cast<std::ptrdiff_t>(nodes));
}

void SoftRowBook::take(SoftRows& rows) {
  rows.clear();
  std::swap(rows, rows_);
}

void SoftRowBook::truncateFrom(double time) {
  std::size_t row = 0, node = 0, keptNodes = 0;
  std::vector<SoftRow> kept;
  for (; row < rows_.rows.size(); node += rows_.rows[row++].nodes) {
    if (rows_.rows[row].time >= time) continue;
    const auto from = rows_.nodes.begin() + static_cast<std::ptrdiff_t>(node);
    std::copy(from, from + rows_.rows[row].nodes,
              rows_.nodes.begin() + static_cast<std::ptrdiff_t>(keptNodes));
    kept.push_back(rows_.rows[row]);
    keptNodes += rows_.rows[row].nodes;
  }
  rows_.rows = std::move(kept);
  rows_.nodes.resize(keptNodes);
  rows_.truncatedFrom = std::min(rows_.truncatedFrom, time);
}

void SoftRowBook::continueFrom(const Snapshot& snapshot) {
  recorders_ = snapshot.recorders;
  rows_.clear();
}

void SoftRowBook::follow(const Snapshot& snapshot, const SoftRows& rows) {
  recorders_ = snapshot.recorders;
  rows_.rows.insert(rows_.rows.end(), rows.rows.begin(), rows.rows.end());
  rows_.nodes.insert(rows_.nodes.end(), rows.nodes.begin(), rows.nodes.end());
  bound();
}

void SoftRowBook::restore(const Snapshot& snapshot) {
  recorders_ = snapshot.recorders;
  truncateFrom(snapshot.time);
  for (const RowRecorder& recorder : recorders_) {
    if (recorder.last().time < snapshot.time) continue;
    rows_.rows.push_back(recorder.last());
    rows_.nodes.insert(rows_.nodes.end(), recorder.lastNodes().begin(), recorder.lastNodes().end());
  }
}

}  // namespace carom
