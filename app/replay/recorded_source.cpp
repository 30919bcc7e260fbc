#include "app/replay/recorded_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {
namespace {

/// Longest duration of a frame: a gap in the recording must not block the other nodes or the keys.
constexpr double kLongestStay_s = 0.25;

}  // namespace

RecordedGame wholeGame(SessionFile& session, std::span<const WorldLine> atStart, std::uint64_t last) {
  RecordedGame game{{{atStart.begin(), atStart.end()}, {}}, {}};
  FrameState frame;
  const auto look = [&] {
    game.pucks = game.news.record.pucks = frame.record.pucks;
    for (const ViewerState& viewer : frame.record.present()) {
      for (const EyeView& eye : viewer.observer.all())
        game.known_s = std::max(game.known_s, eye.observation.t_s);
    }
  };
  session.goToChanges();
  while (session.next(frame) && frame.record.number <= last) {
    session.apply(frame, game.world);
    look();
  }
  if (const auto frames = session.frames()) {  // the latest frame says until when the game is known
    session.goTo(std::min(last, frames->second));
    if (session.next(frame)) {
      look();
      game.headset = frame.record.headset;
    }
  }
  game.news.record.truncateFrom_s = 0.0;
  game.news.record.eventsKept = 0;
  game.news.events = game.world.events;
  for (const ToldPath& person : game.world.people)
    game.news.told.insert(game.news.told.end(), person.moments().begin(), person.moments().end());
  for (std::size_t body = 0; body < atStart.size(); ++body) {
    for (const Knot& knot : game.world.histories[body].knots().subspan(atStart[body].knots().size())) {
      game.news.knots.push_back({body, knot});
    }
  }
  return game;
}

RecordedSource::RecordedSource(SessionFile& session, std::vector<WorldLine> atStart, double display_hz,
                               std::optional<double> from_s, std::size_t viewer)
    : session_(session), atStart_(std::move(atStart)), period_s_(1.0 / display_hz), viewer_(viewer) {
  const auto [first, last] = *session_.frames();
  span_s_ = {session_.shownAt_s(first), session_.shownAt_s(last)};
  session_.goTo(0);
  readAhead();
  if (!from_s) return;
  session_.goTo(session_.frameAt(*from_s));
  readAhead();
  bringsGame_ = true;
}

void RecordedSource::readAhead() { more_ = session_.next(ahead_); }

/// Continues at frame `number`. From now on frames add nothing to the game: the next one brings all of it.
void RecordedSource::goElsewhere(std::uint64_t number) {
  ends_ = false;
  if (leftAlone_) {
    leftAlone_ = false;
    bringsGame_ = true;
  }
  session_.goTo(number);
  readAhead();
}

/// Returns the number of the frame after the current one, at a rate other than the recorded one.
std::uint64_t RecordedSource::following(double rate) const {
  const auto stride = static_cast<std::uint64_t>(std::ceil(std::abs(rate)));
  const std::uint64_t here = shown_.record.number;
  const auto [first, last] = *session_.frames();
  if (rate > 0.0) return std::min(here + stride, last);
  return here > first + stride ? here - stride : first;
}

/// Selects the next frame into `ahead_`. Returns false if the current one stays.
bool RecordedSource::move(const Playback& playback, const Seek* seek) {
  if (seek) {
    goElsewhere(session_.frameAt(seek->session_s));
  } else if (begun_ && playback.paused) {
    return false;
  } else if (begun_ && playback.rate != 1.0) {
    const std::uint64_t number = following(playback.rate);
    if (number == shown_.record.number) return false;
    goElsewhere(number);
  }
  return more_;
}

/// Adds the game to the current frame: as it was known then while all is shown as recorded, else all of it.
void RecordedSource::bringGame() {
  const std::uint64_t here = shown_.record.number;
  FrameState news = (leftAlone_ ? wholeGame(session_, atStart_, here) : wholeGame(session_, atStart_)).news;
  shown_.knots = std::move(news.knots);
  shown_.events = std::move(news.events);
  shown_.told = std::move(news.told);
  shown_.record.truncateFrom_s = news.record.truncateFrom_s;
  shown_.record.eventsKept = news.record.eventsKept;
  session_.goTo(here + 1);
  readAhead();
  bringsGame_ = false;
}

void RecordedSource::next(const FrameTimes& times, const FrameInput& input, OperatorSettings& settings,
                          Decision& decision) {
  const Seek* seek = lastOf<Seek>(input.commands);
  const bool moves = move(settings.playback, seek);
  decision.stay_s = period_s_;
  if (moves) {
    const double before_s = begun_ && !seek ? shown_.record.display_s : ahead_.record.display_s;
    std::swap(shown_, ahead_);
    readAhead();
    const double step_s = std::abs(shown_.record.display_s - before_s);
    decision.stay_s = std::min(step_s / std::abs(settings.playback.rate), kLongestStay_s);
  }
  if (bringsGame_) {
    bringGame();
  } else if (!leftAlone_ || !moves) {
    shown_.knots.clear();
    shown_.events.clear();
    shown_.told.clear();
    shown_.record.truncateFrom_s = std::numeric_limits<double>::infinity();
    shown_.record.eventsKept = std::numeric_limits<std::uint64_t>::max();
  }
  decision.frame = shown_;
  FrameRecord& record = decision.frame.record;
  std::swap(record.viewers.front(), record.viewers[viewer_]);  // the walls are those of this viewer
  record.firstOfRoom = viewer_;
  record.last = ends_ && moves && !more_;
  keepChanges(input.commands, settings, record);
  readOnly_.handled(input.desk, times.begin_s);
  for (ViewerState& viewer : record.present()) readOnly_.tell(times.begin_s, viewer.notice);
  begun_ = true;
}

/// Keeps the settings that the operator has changed; all others are as recorded.
void RecordedSource::keepChanges(std::span<const Command> commands, OperatorSettings& settings,
                                 FrameRecord& record) {
  for (const Command& command : commands) {
    std::erase_if(changed_, [&](const Command& known) { return nameOf(known) == nameOf(command); });
    changed_.push_back(command);
  }
  takeFrom(record, settings);
  for (const Command& command : changed_) apply(command, settings);
  const bool wasFrozen = record.views.frozen != 0;
  putInto(record, settings);
  freeze(record, wasFrozen);
}

/// Applies the operator's freezing. `wasFrozen` means that the recording itself is frozen in this frame.
void RecordedSource::freeze(FrameRecord& record, bool wasFrozen) {
  if (!record.views.frozen || wasFrozen) return frozen_.reset();
  const bool begins = !frozen_;
  if (begins) frozen_.emplace();
  for (std::size_t i = 0; i < record.viewerCount; ++i) {
    ObserverView& observer = record.viewers[i].observer;
    if (begins) (*frozen_)[i] = observer;
    observer = frozenViewAt((*frozen_)[i], observer);
  }
}

SourceStatus RecordedSource::status() const { return {session_.frames()->second + 1, span_s_, {}}; }

}  // namespace carom
