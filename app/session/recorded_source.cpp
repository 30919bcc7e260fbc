#include "app/session/recorded_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

/// Of a frame: a gap in the recording must not leave the other nodes waiting, nor the keys.
constexpr double kLongestStay_s = 0.25;

}  // namespace

RecordedGame wholeGame(SessionFile& session, std::span<const WorldLine> atStart) {
  RecordedGame game{{{atStart.begin(), atStart.end()}, {}}, {}};
  session.goTo(0);
  for (FrameState frame; session.next(frame);) {
    session.apply(frame, game.world);
    game.pucks = game.news.record.pucks = frame.record.pucks;
    for (const EyeView& eye : frame.record.observer.eyes) {
      game.known_s = std::max(game.known_s, eye.observation.t_s);
    }
  }
  game.news.record.truncateFrom_s = 0.0;
  game.news.record.eventsKept = 0;
  game.news.events = game.world.events;
  for (std::size_t body = 0; body < atStart.size(); ++body) {
    for (const Knot& knot : game.world.histories[body].knots().subspan(atStart[body].knots().size())) {
      game.news.knots.push_back({body, knot});
    }
  }
  return game;
}

RecordedSource::RecordedSource(SessionFile& session, std::vector<WorldLine> atStart, double display_hz,
                               Clock& clock, std::optional<double> from_s)
    : session_(session),
      atStart_(std::move(atStart)),
      period_s_(1.0 / display_hz),
      clock_(clock),
      due_s_(clock.now_s()) {
  const auto [first, last] = *session_.frames();
  span_s_ = {session_.shownAt_s(first), session_.shownAt_s(last)};
  session_.goTo(0);
  readAhead();
  if (!from_s) return;
  goElsewhere(session_.frameAt(*from_s));
  ends_ = true;
}

void RecordedSource::readAhead() { more_ = session_.next(ahead_); }

/// From now on the frames bring nothing of the game: all of it comes with the next one.
void RecordedSource::goElsewhere(std::uint64_t number) {
  ends_ = false;
  if (leftAlone_) {
    leftAlone_ = false;
    bringsGame_ = true;
  }
  session_.goTo(number);
  readAhead();
}

/// The number of the frame after the one at hand, at another speed than the recorded one.
std::uint64_t RecordedSource::following(double rate) const {
  const auto stride = static_cast<std::uint64_t>(std::ceil(std::abs(rate)));
  const std::uint64_t here = shown_.record.number;
  const auto [first, last] = *session_.frames();
  if (rate > 0.0) return std::min(here + stride, last);
  return here > first + stride ? here - stride : first;
}

/// Has the next frame follow in `ahead_`; false: the one at hand stays.
bool RecordedSource::move(const Playback& playback) {
  if (playback.jumps != jumps_) {
    jumps_ = playback.jumps;
    goElsewhere(session_.frameAt(playback.goTo_s));
  } else if (begun_ && playback.paused) {
    return false;
  } else if (begun_ && playback.rate != 1.0) {
    const std::uint64_t number = following(playback.rate);
    if (number == shown_.record.number) return false;
    goElsewhere(number);
  }
  return more_;
}

/// With the frame at hand.
void RecordedSource::bringGame() {
  FrameState news = wholeGame(session_, atStart_).news;
  shown_.knots = std::move(news.knots);
  shown_.events = std::move(news.events);
  shown_.record.truncateFrom_s = news.record.truncateFrom_s;
  shown_.record.eventsKept = news.record.eventsKept;
  session_.goTo(shown_.record.number + 1);
  readAhead();
  bringsGame_ = false;
}

void RecordedSource::next(const Controls& controls, FrameState& state) {
  const bool jumps = controls.playback.jumps != jumps_;
  const bool moves = move(controls.playback);
  if (moves) {
    const double before_s = begun_ && !jumps ? shown_.record.display_s : ahead_.record.display_s;
    std::swap(shown_, ahead_);
    readAhead();
    const double step_s = std::abs(shown_.record.display_s - before_s);
    const double stay_s = std::min(step_s / std::abs(controls.playback.rate), kLongestStay_s);
    due_s_ = std::max(due_s_ + stay_s, clock_.now_s());
  } else {
    due_s_ = std::max(due_s_, clock_.now_s()) + period_s_;
  }
  if (bringsGame_) {
    bringGame();
  } else if (!leftAlone_ || !moves) {
    shown_.knots.clear();
    shown_.events.clear();
    shown_.record.truncateFrom_s = std::numeric_limits<double>::infinity();
    shown_.record.eventsKept = std::numeric_limits<std::uint64_t>::max();
  }
  state = shown_;
  state.record.last = ends_ && moves && !more_;
  obey(controls, state.record);
  handsOff_.tell(clock_.now_s(), state.record.notice);
  last_ = state.record;
  begun_ = true;
}

/// What the operator has changed holds; the rest is as it was.
void RecordedSource::obey(const Controls& controls, FrameRecord& record) {
  if (begun_) {
    switches_.note(last_.switches, controls.switches);
    walls_.note(last_.controls, controls.walls);
    views_.note(last_.views, controls.views);
  }
  const bool wasFrozen = record.views.frozen != 0;
  switches_.hold(record.switches);
  walls_.hold(record.controls);
  views_.hold(record.views);
  if (record.views.frozen && !wasFrozen) {
    if (!frozen_) frozen_ = record.observer;
    record.observer = frozenViewAt(*frozen_, record.observer);
  } else {
    frozen_.reset();
  }
}

void RecordedSource::drawn() { clock_.sleepUntil(due_s_); }

std::optional<std::uint64_t> RecordedSource::end() const { return session_.frames()->second + 1; }

}  // namespace carom
