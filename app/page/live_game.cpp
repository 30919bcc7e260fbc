#include "app/page/live_game.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <utility>

#include "app/page/page_rows.h"
#include "cave/frame/bodies.h"

namespace carom {
namespace {

constexpr std::size_t kMostEvents = 1000;  // the newest

static_assert(std::endian::native == std::endian::little);

/// A message under construction.
class Message {
 public:
  void number(double value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof value);
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void count(std::uint64_t value) { number(static_cast<double>(value)); }
  void knot(const Knot& knot) {
    for (const double value : numbersOf(knot)) number(value);
  }
  void frame(const VisitFrame& frame) {
    for (const double value : numbersOf(frame)) number(value);
    for (const std::uint32_t value : statesOf(frame)) count(value);
  }
  void events(std::span<const GameEvent> events) {
    count(events.size());
    for (const GameEvent& event : events) {
      count(event.number);
      count(static_cast<std::uint64_t>(event.kind));
      count(event.cushion ? 1 + static_cast<std::uint64_t>(*event.cushion) : 0);
      for (const double value : {event.at.t_s, event.at.r_m.x, event.at.r_m.y, event.at.r_m.z}) number(value);
      count(event.turns.size());
      for (const Turn& turn : event.turns) count(turn.puck + kFirstPuck);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

template <typename One>
void append(std::vector<One>& to, const std::vector<One>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void LiveGame::News::add(const FrameState& state) {
  const FrameRecord& record = state.record;
  const Change change{record.truncateFrom_s, record.eventsKept, state.knots.size(), state.events.size()};
  const bool isCut = change.cutFrom_s < std::numeric_limits<double>::infinity();
  if (isCut || change.knots + change.events > 0) {  // no event goes but with a cut
    changes.push_back(change);
    append(knots, state.knots);
    append(events, state.events);
  }
  constexpr std::size_t kFirstViewer = 0;
  pucks = record.pucks;
  frame = frameOf(record, kFirstViewer);
  for (const ViewerState& one : record.present())
    for (const EyeView& eye : one.observer.all()) known_s = std::max(known_s, eye.observation.t_s);
}

void LiveGame::News::add(const News& later) {
  append(changes, later.changes);
  append(knots, later.knots);
  append(events, later.events);
  frame = later.frame;
  pucks = later.pucks;
  known_s = std::max(known_s, later.known_s);
}

void LiveGame::News::clear() {
  changes.clear();
  knots.clear();
  events.clear();
  frame.reset();
  known_s = 0.0;
}

void LiveGame::begin(std::uint64_t game, std::vector<WorldLine> atStart) {
  const std::scoped_lock hold(mutex_);
  staged_.clear();
  waiting_.clear();
  begins_ = Beginning{game, std::move(atStart)};
}

void LiveGame::add(const FrameState& state) {
  staged_.add(state);
  const std::unique_lock hold(mutex_, std::try_to_lock);
  if (!hold) return;
  waiting_.add(staged_);
  staged_.clear();
}

void LiveGame::apply(const News& news) {
  std::span<const BodyKnot> knots = news.knots;
  std::span<const GameEvent> events = news.events;
  const std::span<WorldLine> pucks = std::span(now_.lines).subspan(kFirstPuck, news.pucks);
  for (const Change& change : news.changes) {
    if (change.cutFrom_s < std::numeric_limits<double>::infinity())
      for (WorldLine& line : pucks) line.truncateFrom(change.cutFrom_s);
    for (const BodyKnot& knot : knots.first(change.knots)) now_.lines.at(knot.body).append(knot.knot);
    while (!events_.empty() && events_.back().number >= change.eventsKept) events_.pop_back();
    for (const GameEvent& event : events.first(change.events)) events_.push_back(event);
    knots = knots.subspan(change.knots);
    events = events.subspan(change.events);
  }
  if (events_.size() > kMostEvents) events_.erase(events_.begin(), events_.end() - kMostEvents);
  frame_ = news.frame;
  known_s_ = news.known_s;
  for (WorldLine& line : pucks) line.forgetBefore(known_s_ - kPast_s);
}

std::string LiveGame::more() {
  taken_.clear();
  {
    const std::scoped_lock hold(mutex_);
    if (begins_) {
      now_ = *std::exchange(begins_, {});
      events_.clear();
      frame_.reset();
    }
    std::swap(taken_, waiting_);
  }
  if (!taken_.frame) return {};
  const bool isFirst = !frame_;
  apply(taken_);
  if (isFirst) return whole();
  Message message;
  message.number(0.0);
  message.count(now_.game);
  message.number(known_s_);
  message.frame(*frame_);
  message.count(taken_.changes.size());
  std::span<const BodyKnot> knots = taken_.knots;
  std::span<const GameEvent> events = taken_.events;
  for (const Change& change : taken_.changes) {
    message.number(std::min(change.cutFrom_s, 1e300));
    message.count(change.knots);
    for (const BodyKnot& one : knots.first(change.knots)) {
      message.knot(one.knot);
      message.count(one.body);
    }
    message.count(change.eventsKept);
    message.events(events.first(change.events));
    knots = knots.subspan(change.knots);
    events = events.subspan(change.events);
  }
  return message.take();
}

std::string LiveGame::whole() const {
  if (!frame_) return {};
  Message message;
  message.number(1.0);
  message.count(now_.game);
  message.number(known_s_);
  message.frame(*frame_);
  message.count(now_.lines.size());
  for (const WorldLine& line : now_.lines) {
    message.count(line.knots().size());
    for (const Knot& knot : line.knots()) message.knot(knot);
  }
  message.events(events_);
  return message.take();
}

}  // namespace carom
