#include "app/play/match.h"

namespace carom {

Match::Match(const FrameRecord& before) {
  for (std::size_t viewer = 0; viewer < before.viewerCount; ++viewer) {
    scores_[viewer] = CaromScore(before.viewers[viewer].score);
    if (before.viewers[viewer].hasTurn) turn_ = viewer;
  }
}

void Match::struck(std::size_t viewer, std::size_t viewers, std::size_t puck, double arrives_s) {
  scores_[viewer].struck(puck, arrives_s);
  latest_ = viewer;
  turn_ = (viewer + 1) % viewers;
}

std::optional<std::size_t> Match::look(std::size_t viewer, std::span<const GameEvent> events,
                                       const Event& eye, double c_m_s) {
  const auto cushions = scores_[viewer].look(events, eye, c_m_s);
  if (cushions && viewer == latest_) turn_ = viewer;
  return cushions;
}

void Match::putInto(FrameRecord& record) const {
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    record.viewers[viewer].score = scores_[viewer].score();
    record.viewers[viewer].hasTurn = record.viewerCount > 1 && viewer == turn_ ? 1 : 0;
  }
}

}  // namespace carom
