#include "cave/hud/hud_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/frame/clock_time.h"
#include "cave/frame/lesson_language.h"
#include "cave/frame/lesson_readings.h"
#include "cave/gl/view_colours.h"
#include "cave/hud/motion_overlay.h"
#include "cave/hud/sentences.h"
#include "cave/record/effects.h"
#include "cave/room/off_axis.h"
#include "cave/texts/format.h"
#include "cave/texts/key_names.h"
#include "cave/texts/texts.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

using Kind = WallAction::Kind;

constexpr glm::vec3 kSeenMark(0.92F);
constexpr glm::vec3 kTryThisColour(0.62F, 0.94F, 0.62F), kLookForColour(0.62F, 0.85F, 1.0F);

/// Builds the lines, one after the other, in memory that is reused.
class Lines {
 public:
  Lines(std::vector<HudLine>& lines, const LineRoom& room) : lines_(lines), room_(room) {}
  ~Lines() { lines_.resize(count_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  /// Adds an entry of the legend: a line, or more if it is long.
  template <typename... Values>
  void add(const std::optional<glm::vec3>& mark, texts::CheckedText<Values...> words,
           const Values&... values) {
    entry_.clear();
    texts::formatTo(entry_, words, values...);
    addEntry(mark, entry_);
  }

  /// Adds an entry of these words.
  void addEntry(const std::optional<glm::vec3>& mark, std::string_view words) {
    breaker_.begin(words);
    const LineRoom room = legendRoom();
    begin(breaker_.take(room)).mark = mark;
    while (!breaker_.isAtEnd()) begin(breaker_.take(behindIndent(room))).setIn = true;
  }

  /// Adds as many lines as the text needs; the first begins with `first` and the following ones are indented.
  /// With a `row` they are a button.
  void wrap(std::string_view words, std::string_view first = {}, bool urgent = false, WallAction row = {}) {
    breaker_.begin(words);
    for (bool begins = true; !breaker_.isAtEnd(); begins = false) {
      HudLine& line = begin(begins ? first : std::string_view());
      line.text += breaker_.take(first.empty() ? room_ : begins ? behind(first) : behindIndent(room_));
      line.urgent = urgent;
      line.row = row;
      line.setIn = !begins && !first.empty();
    }
  }

  /// Adds one of several texts, all in its colour, and empty lines if another one is longer, so that what
  /// stands below does not move.
  struct Part {
    std::string_view first, words;
    std::optional<glm::vec3> colour{};
  };
  void wrapOneOf(std::span<const Part> parts, std::size_t said) {
    const std::size_t before = count_;
    std::size_t most = before;
    for (const Part& part : parts) {
      wrap(part.words, part.first);
      most = std::max(most, std::exchange(count_, before));
    }
    wrap(parts[said].words, parts[said].first);
    for (std::size_t i = before; i < count_; ++i) lines_[i].mark = parts[said].colour;
    while (count_ < most) begin({});
  }

  /// Adds a line that begins with these words and goes on with chips; more lines if the chips need them.
  void addChips(std::string_view words, std::span<const HudChip> chips) {
    begin(words);
    for (const HudChip& chip : chips) {
      if (!chipFits(lines_[count_ - 1], chip, room_)) begin({});
      lines_[count_ - 1].chips.push_back(chip);
    }
  }

 private:
  /// Begins a line with these words.
  HudLine& begin(std::string_view words) {
    if (count_ == lines_.size()) lines_.emplace_back();
    HudLine& line = lines_[count_++];
    line.mark.reset();
    line.urgent = line.setIn = false;
    line.row = {};
    line.chips.clear();
    line.text.assign(words);
    return line;
  }

  /// Returns what is left of a line that begins with these words.
  LineRoom behind(std::string_view words) const {
    return {room_.columns - std::min(columnsOf(words), room_.columns - 1),
            std::max(room_.width_em - widthOf_em(words), 0.0)};
  }

  std::vector<HudLine>& lines_;
  LineRoom room_;
  static thread_local LineBreaker breaker_;
  static thread_local std::string entry_;
  std::size_t count_ = 0;
};

thread_local LineBreaker Lines::breaker_;
thread_local std::string Lines::entry_;

void addLight(const SeenFrame& seen, Lines& lines) {
  lines.add({}, texts::legend::kLight, seen.record.lightSpeed_m_s);
}

using Viewers = std::span<const RoomViewer>;

void addScore(const SeenFrame& seen, Viewers viewers, Lines& lines) {
  const std::size_t count = std::min<std::size_t>(seen.record.viewerCount, viewers.size());
  bool played = false;
  for (std::size_t i = 0; i < count; ++i) played = played || seen.inOrder(i).score.strokes > 0;
  if (!played) return;
  if (count < 2) return lines.add({}, texts::legend::kScore, seen.self.score.caroms, seen.self.score.strokes);
  for (std::size_t i = 0; i < count; ++i) {
    const Score& score = seen.inOrder(i).score;
    lines.add({}, texts::legend::kScoreOf,
              i == 0 ? std::string_view(texts::legend::kMe) : std::string_view(viewers[i].name), score.caroms,
              score.strokes);
  }
  if (seen.self.hasTurn) lines.add({}, texts::legend::kYourTurn);
  for (std::size_t i = 1; i < count; ++i) {
    if (seen.inOrder(i).hasTurn) lines.add({}, texts::legend::kTheirTurn, viewers[i].name);
  }
}

/// Adds the clocks of the others in the room, all of whose presents are simultaneous there.
void addOtherClocks(const SeenFrame& seen, Viewers viewers, Lines& lines) {
  constexpr double kShown_s = 0.05;  // of one decimal
  for (std::size_t i = 1; i < std::min<std::size_t>(seen.record.viewerCount, viewers.size()); ++i) {
    const double own_s = seen.inOrder(i).observer.properTime_s;
    const double older_s = own_s - seen.self.observer.properTime_s;
    if (std::abs(older_s) < kShown_s) {
      lines.add({}, texts::legend::kAsOld, viewers[i].name, shownTime_s(own_s));
    } else if (older_s > 0.0) {
      lines.add({}, texts::legend::kOlder, viewers[i].name, shownTime_s(own_s), older_s);
    } else {
      lines.add({}, texts::legend::kYounger, viewers[i].name, shownTime_s(own_s), -older_s);
    }
  }
}

void addClocks(const SeenFrame& seen, Viewers viewers, Lines& lines) {
  const Vec3 u = seen.self.observer.headFromBoard.inverse().u();
  lines.add({}, texts::legend::kMyTime, shownTime_s(seen.self.observer.properTime_s));
  addOtherClocks(seen, viewers, lines);
  lines.add({}, texts::legend::kMySpeed, glm::length(betaFromU(u)), gammaFromU(u));
  addLight(seen, lines);
}

/// Adds the others' clocks to a lesson that shows the clocks.
void addTwins(const SeenFrame& seen, Viewers viewers, Lines& lines) {
  if (seen.record.views.clocks) addOtherClocks(seen, viewers, lines);
}

HudChip chip(Kind kind, std::string_view words, std::uint8_t number = 0) {
  return {{kind, number}, texts::withKeyInLayout(words)};
}

/// Adds what to press, and at the right the way out.
void addButtons(const SeenFrame& seen, std::string_view words, std::vector<HudChip> chips, bool mayLeave,
                Lines& lines) {
  if (seen.record.views.frozen) chips.push_back(chip(Kind::unfreeze, texts::lesson::kTimeGoesOn));
  HudChip leave{actionOf(Choice::play), texts::lesson::kLeave.words()};
  leave.atRight = true;
  if (mayLeave) chips.push_back(leave);
  lines.addChips(words, chips);
}

void addQuestion(const SeenFrame& seen, const LessonWords& lesson, bool mayLeave, Lines& lines) {
  lines.wrap(lesson.question, texts::lesson::kQuestion);
  const bool isByPhone = hasClass(seen.record.classroom);
  for (std::size_t i = 0; i < std::min(lesson.answers.size(), kAnswerNumbers.size()); ++i) {
    const WallAction row{Kind::choose, static_cast<std::uint8_t>(i + 1)};
    lines.wrap(lesson.answers[i], kAnswerNumbers[i], false, isByPhone ? WallAction{} : row);
  }
  if (isByPhone) return addButtons(seen, texts::classroom::kByPhone, {}, mayLeave, lines);
  addButtons(seen, texts::lesson::kChoose, {chip(Kind::goOn, texts::lesson::kSkip)}, mayLeave, lines);
}

/// Adds the readings of the stopwatches in one line, behind other words.
void addReadings(const SeenFrame& seen, const LessonPlan& plan, std::string readings, Lines& lines) {
  for (const Stopwatch& watch : plan.stopwatches) {
    if (!readings.empty()) readings += "    ";
    readings += texts::format(
        texts::lesson::kReading, watch.name,
        reading_s(watch, {seen.self.observer, seen.record.boardFromRoom, seen.record.lesson.phase}));
  }
  lines.wrap(readings, {}, true);
}

/// Adds the velocities that the lesson offers.
void addObservers(const SeenFrame& seen, const LessonPlan& plan, Lines& lines) {
  if (plan.observers.empty()) return;
  const auto present = observerOf(plan, seen.record.boardFromRoom);
  std::vector<HudChip> offered;
  for (std::size_t i = 0; i < plan.observers.size(); ++i) {
    offered.push_back(chip(Kind::choose,
                           texts::format(texts::lesson::kObserver, plan.observers[i].name, i + 2),
                           static_cast<std::uint8_t>(i + 1)));
    offered.back().isOn = present == i;
  }
  lines.addChips(texts::lesson::kYouMove, offered);
}

void addAnswer(const LessonWords& lesson, std::uint8_t answer, Lines& lines) {
  if (answer == 0 || answer > lesson.answers.size()) return;
  const std::string& given = lesson.answers[answer - 1U];
  const bool isHidden = lesson.right >= lesson.answers.size();
  const std::string words = isHidden ? given
                            : answer - 1U == lesson.right
                                ? texts::format(texts::lesson::kRight, given)
                                : texts::format(texts::lesson::kWrong, given, lesson.answers[lesson.right]);
  lines.wrap(words, texts::lesson::kYourAnswer);
}

/// Returns how the lesson's pace is told, or nothing.
std::string paceWords(const LessonPlan& plan) {
  const double slowness = plan.interval.slowness;
  return slowness > 1.0 ? texts::format(texts::lesson::kSlowMotion, slowness) : "";
}

/// Returns words without an explanation in brackets behind them, for which a button has no room.
std::string_view withoutBrackets(std::string_view words) {
  return words.substr(0, std::min(words.find(" ("), words.find("（")));
}

/// Adds the buttons of the effects that the lesson offers.
void addEffectChips(const SeenFrame& seen, const LessonPlan& plan, std::vector<HudChip>& chips) {
  for (const std::uint8_t number : plan.effects) {
    const NamedSwitch& effect = kNamedSwitches.at(number);
    const std::string key = texts::inLayout(std::string_view(&effect.key, 1));
    chips.push_back(
        {{Kind::effect, number}, std::string(withoutBrackets(effect.words.words())) + "  " + key});
    chips.back().isOn = seen.record.switches.*effect.value != 0;
  }
}

/// Returns what to press while the lesson shows.
std::vector<HudChip> shownChips(const SeenFrame& seen, const LessonPlan& plan) {
  std::vector<HudChip> chips{chip(Kind::again, texts::lesson::kAgain),
                             chip(Kind::goOn, texts::lesson::kExplanation)};
  addEffectChips(seen, plan, chips);
  return chips;
}

/// Returns what to press while the lesson explains.
std::vector<HudChip> explainedChips(const SeenFrame& seen, const LessonPlan& plan) {
  std::vector<HudChip> chips{chip(Kind::goOn, texts::lesson::kBackToScene),
                             chip(Kind::again, texts::lesson::kAskAgain)};
  if (plan.offersSpacetime) {
    chips.push_back(chip(Kind::spacetime, texts::lesson::kSpacetime));
    chips.back().isOn = seen.record.views.spacetime != 0;
  }
  return chips;
}

/// Adds what to do in the first half of what the lesson shows, and then what to look for.
void addAdvice(const SeenFrame& seen, const LessonWords& lesson, const LessonInterval& interval,
               Lines& lines) {
  const std::array<Lines::Part, 2> parts{{{texts::lesson::kTryThis, lesson.todo, kTryThisColour},
                                          {texts::lesson::kLookFor, lesson.notice, kLookForColour}}};
  const double board_s = seen.self.observer.middle.observation.t_s;
  lines.wrapOneOf(parts, board_s >= 0.5 * (interval.from_s + interval.until_s) ? 1 : 0);
}

/// Adds the explanation, one sentence at a time, with its number and that of all: "1/3".
void addExplanation(const std::string& number, double since_s, Lines& lines) {
  const std::vector<std::string_view> sentences = sentencesOf(number);
  if (sentences.size() < 2) return lines.wrap(number);
  std::vector<std::string> places;
  for (std::size_t i = 1; i <= sentences.size(); ++i)
    places.push_back(fmt::format("{}/{}  ", i, sentences.size()));
  std::vector<Lines::Part> parts;
  for (std::size_t i = 0; i < sentences.size(); ++i) parts.push_back({places[i], sentences[i]});
  lines.wrapOneOf(parts, sentenceAt(sentences, since_s));
}

/// Adds the lesson's text for its phase, and how to continue.
void addLesson(const SeenFrame& seen, const LessonWords& lesson, const LessonPlan& plan, Viewers viewers,
               bool mayLeave, double explained_s, Lines& lines) {
  switch (seen.record.lesson.phase) {
    case LessonPhase::none:
      return;
    case LessonPhase::asks:
      return addQuestion(seen, lesson, mayLeave, lines);
    case LessonPhase::shows:
      addAdvice(seen, lesson, plan.interval, lines);
      addReadings(seen, plan, paceWords(plan), lines);
      addTwins(seen, viewers, lines);
      addObservers(seen, plan, lines);
      return addButtons(seen, {}, shownChips(seen, plan), mayLeave, lines);
    case LessonPhase::explains:
      addExplanation(lesson.number, explained_s, lines);
      addAnswer(lesson, seen.record.lesson.answer, lines);
      addReadings(seen, plan, {}, lines);
      addObservers(seen, plan, lines);
      return addButtons(seen, {}, explainedChips(seen, plan), mayLeave, lines);
  }
}

/// Adds the numbers behind the motion overlay on the floor (cave/hud/motion_overlay.h), but not while a
/// caption says what to look for during a scripted flight.
void addDrive(const SeenFrame& seen, Lines& lines) {
  const bool isTold = seen.record.drive.mode == DriveMode::tour && !seen.self.notice.empty();
  if (!isDriven(seen) || isTold) return;
  const Vec3 u = seen.record.boardFromRoom.u();
  const double gamma = gammaFromU(u);
  lines.add(kMotionColour, texts::legend::kPlatform, glm::length(betaFromU(u)), gamma);
  lines.add(kSeenMark, texts::legend::kLightRing);
  lines.add(kContractedColour, texts::legend::kContracted, 1.0 / gamma);
  const DriveView& drive = seen.record.drive;
  if (drive.thrust == Vec3(0.0) && drive.mode == DriveMode::free && !drive.atLimit) return;
  lines.add(drive.atLimit ? kLimitColour : kThrustColour, texts::legend::kThrust,
            100.0 * glm::length(drive.thrust),
            texts::legend::kDriveModes[static_cast<std::size_t>(drive.mode)]);
}

/// Adds the effects that are off, and those that are on without being so at the beginning.
void addEffects(const Switches& switches, Lines& lines) {
  constexpr Switches kUsual;
  std::string off, on;
  for (const NamedSwitch& effect : kNamedSwitches) {
    const bool isOn = switches.*effect.value != 0;
    if (isOn == (kUsual.*effect.value != 0)) continue;
    std::string& all = isOn ? on : off;
    all += (all.empty() ? "" : ", ") + std::string(effect.words.words());
  }
  if (!off.empty()) lines.wrap(texts::format(texts::legend::kEffectsOff, off));
  if (!on.empty()) lines.wrap(texts::format(texts::legend::kEffectsOn, on));
}

void addViews(const SeenFrame& seen, Viewers viewers, Lines& lines) {
  const TimeViews& views = seen.record.views;
  if (views.boardNow || views.myNow || views.split) lines.add(kSeenMark, texts::legend::kSeen);
  if (views.boardNow) lines.add(kBoardNowColour, texts::legend::kBoardNow);
  if (views.myNow) lines.add(kMyNowColour, texts::legend::kMyNow);
  if (views.split && views.beside == kNoSwitches) {
    lines.add({}, texts::legend::kEinsteinNewton);
  } else if (views.split) {
    lines.add({}, texts::legend::kChosenOtherwise);
  }
  for (const NamedView& view : kNamedViews) {
    if (!view.legend || !(views.*view.value)) continue;
    const bool isEvents = view.value == &TimeViews::events;
    lines.addEntry(isEvents ? std::optional(kEventColour) : std::nullopt, view.legend);
    if (isEvents) lines.add(kFlashColour, texts::legend::kFlash);
  }
  if (views.frozen) lines.add({}, texts::legend::kFrozen);
  if (views.clocks) {
    lines.add({}, texts::legend::kClocks);
    addClocks(seen, viewers, lines);
  }
}

}  // namespace

void describe(const SeenFrame& seen, const LessonWords& lesson, const LessonPlan& plan, Viewers viewers,
              const LineRoom& room, std::vector<HudLine>& words, bool mayLeave, double explained_s) {
  Lines lines(words, room);
  lines.wrap(seen.self.notice.words(), {}, true);
  addLesson(seen, lesson, plan, viewers, mayLeave, explained_s, lines);
  if (seen.record.lesson.phase == LessonPhase::none) {
    addScore(seen, viewers, lines);
    addEffects(seen.record.switches, lines);
    addViews(seen, viewers, lines);
    addDrive(seen, lines);
  }
  if (seen.record.controls.trackerCross) lines.add({}, texts::legend::kNearerBar);
}

void HudText::setWall(const Wall& wall, std::span<const RoomViewer> viewers) {
  bandRoom_ = bandRoom(wall);
  viewers_.assign(viewers.begin(), viewers.end());
}

void HudText::setLesson(const LessonWords& words, const LessonPlan& plan, bool mayLeave) {
  lesson_ = InLanguages(words);
  plan_ = InLanguages(plan);
  mayLeave_ = mayLeave;
  tenths_s_ = -1;
}

bool HudText::follow(const SeenFrame& seen) {
  const auto tenths_s = static_cast<std::int64_t>(std::floor(10.0 * seen.record.display_s));
  const Told told{seen.record.views, seen.record.controls, seen.record.lesson, seen.self.notice,
                  seen.self.language};
  if (tenths_s == tenths_s_ && told == told_) return false;
  const bool explainedBefore = told_.lesson.phase == LessonPhase::explains;
  if (told.lesson.phase != LessonPhase::explains || !explainedBefore) explainsFrom_s_ = seen.record.display_s;
  tenths_s_ = tenths_s;
  told_ = told;
  isBand_ = seen.record.lesson.phase != LessonPhase::none;
  describe(seen, lesson_.read(), plan_.read(), viewers_, isBand_ ? bandRoom_ : kPanelRoom, lines_, mayLeave_,
           seen.record.display_s - explainsFrom_s_);
  return true;
}

}  // namespace carom
