#include "app/replay/soft_replay_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
// How much longer than its legs a puck's rows are kept, in metres of light.
constexpr double kKept_m = 2.0;

}  // namespace

bool hasSoftPucks(const Scenario& scenario) {
  const auto& pucks = scenario.billiard.pucks;
  return std::any_of(pucks.begin(), pucks.end(), [](const Puck& puck) { return puck.soft.has_value(); });
}

SoftReplaySource::SoftReplaySource(std::unique_ptr<FrameSource> recorded, const Scenario& scenario,
                                   std::vector<StrokeInFrame> strokes)
    : recorded_(std::move(recorded)), scenario_(scenario), strokes_(std::move(strokes)) {}

/// Begins the game with the strokes of earlier frames.
void SoftReplaySource::begin(std::uint64_t frame) {
  std::vector<Stroke> before;
  for (struck_ = 0; struck_ < strokes_.size() && strokes_[struck_].first < frame; ++struck_)
    before.push_back(strokes_[struck_].second);
  game_ = std::make_unique<Game>(scenario_, before);
}

void SoftReplaySource::next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
                            Decision& decision) {
  recorded_->next(times, input, settings, decision);
  FrameRecord& record = decision.frame.record;
  const bool bringsAll = record.truncateFrom_s == 0.0, isFirst = !game_;
  const bool isElsewhere = bringsAll && record.number != last_ + 1;  // not a session that was resumed there
  if (isFirst || bringsAll) begin(isElsewhere && !isFirst ? kAll : record.number);
  last_ = record.number;
  for (; struck_ < strokes_.size() && strokes_[struck_].first <= record.number; ++struck_)
    game_->strike(strokes_[struck_].second);
  for (const ViewerState& viewer : record.present()) {
    if (record.views.myNow != 0) game_->playToNowOf(viewer.observer);
  }
  game_->advance(latestObservation_s(record), played_);
  std::swap(decision.frame.rows, played_.rows);
  std::swap(decision.frame.rowNodes, played_.rowNodes);
  record.rowsFrom_m =
      isFirst || bringsAll ? -std::numeric_limits<double>::infinity() : played_.record.rowsFrom_m;
  if (std::isfinite(record.forgetBefore_s))
    record.rowsForgottenBefore_m = record.forgetBefore_s * scenario_.billiard.lightSpeed_m_s - kKept_m;
}

}  // namespace carom
