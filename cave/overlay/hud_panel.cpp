#include "cave/overlay/hud_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/frame/clock_time.h"
#include "cave/frame/lesson_readings.h"
#include "cave/gl/view_colours.h"
#include "cave/overlay/motion_overlay.h"
#include "cave/room/off_axis.h"
#include "cave/texts/texts.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr double kCapitalOfLetters = 0.72;       // a capital's height, as a fraction of the nominal height
constexpr double kLine = 1.5, kBandLine = 1.25;  // distance from line to line, in that height
constexpr double kLetterWidth = 0.54;            // of running text, in that height
constexpr std::size_t kIndentLetters = 3;        // as wide as the indent of a line
constexpr double kSmallest_px = 9.0;             // smaller letters are illegible
constexpr PanelPicture::Rgba kGround{12, 14, 18, 175};  // dark; half of the picture shows through
constexpr glm::vec3 kWhite(235.0F), kUrgent(255.0F, 200.0F, 70.0F);  // letters
constexpr glm::vec3 kSeenMark(0.92F);

/// Builds the lines, one after the other, in memory that is reused.
class Lines {
 public:
  Lines(std::vector<HudLine>& lines, std::size_t letters) : lines_(lines), letters_(letters) {}
  ~Lines() { lines_.resize(count_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  template <typename... Values>
  void add(const std::optional<glm::vec3>& mark, fmt::format_string<Values...> words, Values&&... values) {
    if (count_ == lines_.size()) lines_.emplace_back();
    HudLine& line = lines_[count_++];
    line.mark = mark;
    line.urgent = line.setIn = false;
    line.text.clear();
    fmt::format_to(std::back_inserter(line.text), words, std::forward<Values>(values)...);
  }

  /// Adds as many lines as the text needs; the first begins with `first` and the following ones are indented.
  void wrap(std::string_view words, std::string_view first = {}, bool urgent = false) {
    for (bool begins = true; !words.empty(); begins = false) {
      const std::size_t taken = first.empty() ? 0 : begins ? first.size() : kIndentLetters;
      const std::size_t bytes = fitting(words, letters_ - std::min(taken, letters_ - 1));
      add({}, "{}{}", begins ? first : std::string_view(), words.substr(0, bytes));
      lines_[count_ - 1].urgent = urgent;
      lines_[count_ - 1].setIn = !begins && !first.empty();
      words.remove_prefix(std::min(words.size(), bytes + 1));  // including the space
    }
  }

 private:
  /// Returns whether a space stands before a unit, as in "0.6 c" and "2.84 m".
  static bool beforeUnit(std::string_view words, std::size_t space) {
    const auto letter = [&](std::size_t at) {
      return at < words.size() && words[at] >= 'a' && words[at] <= 'z';
    };
    return space > 0 && words[space - 1] >= '0' && words[space - 1] <= '9' && letter(space + 1) &&
           !letter(space + 2);
  }

  /// Returns how many bytes of whole words have at most this many letters; if the first word has more, its
  /// bytes alone.
  static std::size_t fitting(std::string_view words, std::size_t most) {
    std::size_t letters = 0, fits = 0;
    for (std::size_t i = 0; i <= words.size(); ++i) {
      const bool ends = i == words.size() || (words[i] == ' ' && !beforeUnit(words, i));
      if (ends && (letters <= most || fits == 0)) fits = i;
      if (ends && letters >= most) break;
      if (ends || (static_cast<unsigned char>(words[i]) & 0xC0U) != 0x80U) ++letters;
    }
    return fits;
  }

  std::vector<HudLine>& lines_;
  std::size_t letters_;
  std::size_t count_ = 0;
};

void addLight(const FrameRecord& record, Lines& lines) {
  lines.add({}, texts::legend::kLight, record.lightSpeed_m_s);
}

using Viewers = std::span<const RoomViewer>;

void addScore(const FrameRecord& record, Viewers viewers, Lines& lines) {
  const std::size_t count = std::min<std::size_t>(record.viewers, viewers.size());
  bool played = false;
  for (std::size_t i = 0; i < count; ++i) played = played || record.viewer(i).score.strokes > 0;
  if (!played) return;
  if (count < 2) return lines.add({}, texts::legend::kScore, record.score.caroms, record.score.strokes);
  for (std::size_t i = 0; i < count; ++i) {
    const Score& score = record.viewer(i).score;
    lines.add({}, texts::legend::kScoreOf, i == 0 ? std::string_view(texts::legend::kMe) : viewers[i].name,
              score.caroms, score.strokes);
  }
  if (record.hasTurn) lines.add({}, "{}", texts::legend::kYourTurn);
  for (std::size_t i = 1; i < count; ++i) {
    if (record.viewer(i).hasTurn) lines.add({}, texts::legend::kTheirTurn, viewers[i].name);
  }
}

/// Adds the clocks of the others in the room, all of whose presents are simultaneous there.
void addOtherClocks(const FrameRecord& record, Viewers viewers, Lines& lines) {
  constexpr double kShown_s = 0.05;  // of one decimal
  for (std::size_t i = 1; i < std::min<std::size_t>(record.viewers, viewers.size()); ++i) {
    const double own_s = record.viewer(i).observer.properTime_s;
    const double older_s = own_s - record.observer.properTime_s;
    if (std::abs(older_s) < kShown_s) {
      lines.add({}, texts::legend::kAsOld, viewers[i].name, shownTime_s(own_s));
    } else {
      const texts::Text words = older_s > 0.0 ? texts::legend::kOlder : texts::legend::kYounger;
      lines.add({}, "{}",
                fmt::format(fmt::runtime(words), viewers[i].name, shownTime_s(own_s), std::abs(older_s)));
    }
  }
}

void addClocks(const FrameRecord& record, Viewers viewers, Lines& lines) {
  const Vec3 u = record.observer.headFromBoard.inverse().u();
  lines.add({}, texts::legend::kMyTime, shownTime_s(record.observer.properTime_s));
  addOtherClocks(record, viewers, lines);
  lines.add({}, texts::legend::kMySpeed, glm::length(betaFromU(u)), gammaFromU(u));
  addLight(record, lines);
}

/// Adds the others' clocks to a lesson that shows the clocks.
void addTwins(const FrameRecord& record, Viewers viewers, Lines& lines) {
  if (record.views.clocks) addOtherClocks(record, viewers, lines);
}

void addQuestion(const LessonWords& lesson, Lines& lines) {
  lines.wrap(lesson.question, texts::lesson::kQuestion);
  constexpr auto& kNumbers = texts::lesson::kAnswerNumbers;
  for (std::size_t i = 0; i < std::min(lesson.answers.size(), kNumbers.size()); ++i)
    lines.wrap(lesson.answers[i], kNumbers[i]);
  if (lesson.answers.size() == 2) return lines.add({}, texts::lesson::kPressOneOfTwo);
  lines.add({}, texts::lesson::kPressOneOf, lesson.answers.size());
}

/// Adds the readings of the stopwatches in one line.
void addReadings(const FrameRecord& record, const LessonPlan& plan, Lines& lines) {
  std::string readings;
  for (const Stopwatch& watch : plan.stopwatches) {
    if (!readings.empty()) readings += "    ";
    readings += fmt::format(texts::lesson::kReading, watch.name,
                            reading_s(watch, {record.observer, record.boardFromRoom, record.lesson.phase}));
  }
  lines.wrap(readings, {}, true);
}

/// Adds the velocities that the lesson offers, the present one in brackets.
void addObservers(const FrameRecord& record, const LessonPlan& plan, Lines& lines) {
  if (plan.observers.empty()) return;
  const auto present = observerOf(plan, record.boardFromRoom);
  std::string offered = texts::lesson::kYouMove;
  for (std::size_t i = 0; i < plan.observers.size(); ++i) {
    const std::string& name = plan.observers[i].name;
    offered += present == i ? fmt::format(texts::lesson::kPresentObserver, i + 2, name)
                            : fmt::format(texts::lesson::kOtherObserver, i + 2, name);
  }
  lines.wrap(offered);
}

void addAnswer(const LessonWords& lesson, std::uint8_t answer, Lines& lines) {
  if (answer == 0 || answer > lesson.answers.size()) return;
  const std::string& given = lesson.answers[answer - 1U];
  const std::string words = answer - 1U == lesson.right
                                ? fmt::format(texts::lesson::kRight, given)
                                : fmt::format(texts::lesson::kWrong, given, lesson.answers[lesson.right]);
  lines.wrap(words, texts::lesson::kYourAnswer);
}

/// Returns how the lesson's pace is told, or nothing.
std::string paceWords(const LessonPlan& plan) {
  const double slowness = plan.interval.slowness;
  return slowness > 1.0 ? fmt::format(texts::lesson::kSlowMotion, slowness) : "";
}

/// Adds the lesson's text for its phase, and how to continue.
void addLesson(const FrameRecord& record, const LessonWords& lesson, const LessonPlan& plan, Viewers viewers,
               Lines& lines) {
  switch (record.lesson.phase) {
    case LessonPhase::none:
      return;
    case LessonPhase::asks:
      return addQuestion(lesson, lines);
    case LessonPhase::shows:
      lines.wrap(lesson.todo, texts::lesson::kTryThis);
      lines.wrap(lesson.notice, texts::lesson::kLookFor);
      addReadings(record, plan, lines);
      addTwins(record, viewers, lines);
      addObservers(record, plan, lines);
      return lines.add({}, "{}{}", texts::lesson::kOnwards, paceWords(plan));
    case LessonPhase::explains:
      lines.wrap(lesson.number);
      addAnswer(lesson, record.lesson.answer, lines);
      addReadings(record, plan, lines);
      addObservers(record, plan, lines);
      return lines.add({}, texts::lesson::kBack);
  }
}

/// Adds the numbers behind the motion overlay on the floor (cave/overlay/motion_overlay.h), but not while a caption
/// says what to look for during a scripted flight.
void addDrive(const FrameRecord& record, Lines& lines) {
  const bool isTold = record.drive.mode == DriveMode::tour && !record.notice.words().empty();
  if (!isDriven(record) || isTold) return;
  const Vec3 u = record.boardFromRoom.u();
  const double gamma = gammaFromU(u);
  lines.add(kMotionColour, texts::legend::kPlatform, glm::length(betaFromU(u)), gamma);
  lines.add(kSeenMark, texts::legend::kLightRing);
  lines.add(kContractedColour, texts::legend::kContracted, 1.0 / gamma);
  const DriveView& drive = record.drive;
  if (drive.thrust == Vec3(0.0) && drive.mode == DriveMode::free && !drive.atLimit) return;
  lines.add(drive.atLimit ? kLimitColour : kThrustColour, texts::legend::kThrust,
            100.0 * glm::length(drive.thrust),
            texts::legend::kDriveModes[static_cast<std::size_t>(drive.mode)]);
}

/// Adds the effects that are off, and those that are on without being so at the beginning.
void addEffects(const Switches& switches, Lines& lines) {
  constexpr Switches kUsual;
  std::string off, on;
  for (std::size_t i = 0; i < kNamedSwitches.size(); ++i) {
    const auto value = kNamedSwitches[i].value;
    if (switches.*value == kUsual.*value) continue;
    std::string& all = switches.*value ? on : off;
    all += (all.empty() ? "" : ", ") + std::string(texts::keys::kEffects[i]);
  }
  if (!off.empty()) lines.wrap(fmt::format(texts::legend::kEffectsOff, off));
  if (!on.empty()) lines.wrap(fmt::format(texts::legend::kEffectsOn, on));
}

void addViews(const FrameRecord& record, Viewers viewers, Lines& lines) {
  const TimeViews& views = record.views;
  if (views.boardNow || views.myNow || views.split) lines.add(kSeenMark, texts::legend::kSeen);
  if (views.boardNow) lines.add(kBoardNowColour, texts::legend::kBoardNow);
  if (views.myNow) lines.add(kMyNowColour, texts::legend::kMyNow);
  if (views.split && views.beside == kNoSwitches) {
    lines.add({}, texts::legend::kEinsteinNewton);
  } else if (views.split) {
    lines.add({}, texts::legend::kChosenOtherwise);
  }
  if (views.paths) lines.add({}, texts::legend::kPaths);
  if (views.events) {
    lines.add(kEventColour, texts::legend::kEvents);
    lines.add(kFlashColour, texts::legend::kFlash);
  }
  if (views.ruler) lines.add({}, texts::legend::kRuler);
  if (views.angles) lines.add({}, texts::legend::kAngles);
  if (views.frozen) lines.add({}, texts::legend::kFrozen);
  if (views.clocks) {
    lines.add({}, texts::legend::kClocks);
    addClocks(record, viewers, lines);
  }
}

/// Returns where text begins, in the height of letters: behind the marks of the legend; a band has none.
constexpr double beginOfText(bool band) { return band ? 1.25 : 2.0; }

/// Returns the indent of a line, which is that of an answer behind its number.
int beginOf_px(const HudLine& line, int height_px) { return line.setIn ? 8 * height_px / 5 : 0; }

}  // namespace

std::optional<Wall> frontWall(const RoomGeometry& room) {
  for (const Wall& wall : room.walls) {
    if (-glm::dot(normalOf(wall), room.forward) > std::sqrt(0.5)) return wall;
  }
  return std::nullopt;
}

std::size_t bandLetters(const Wall& wall) {
  const double letter_px = kLetterWidth * HudPanel::kBandCapital / kCapitalOfLetters * wall.pixels.y;
  const double width_px = (1.0 - 2.0 * HudPanel::kMargin) * wall.pixels.x;
  return std::max<std::size_t>(kLineLetters, static_cast<std::size_t>(width_px / letter_px));
}

/// Returns the height of a wall's lower edge above the floor, in a room whose floor is at height 0.
static double footOf_m(const Wall& wall) {
  return glm::dot(wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m) / sizeOf_m(wall).y;
}

/// Returns the fraction of the wall's height that the band may take.
static double mostOfBand(const Wall& wall) {
  const double height_m = sizeOf_m(wall).y;
  return std::max(HudPanel::kMostOfHeight, 1.0 - (HudPanel::kLowest_m - footOf_m(wall)) / height_m);
}

bool bandHolds(const LessonWords& words, const LessonPlan& plan, const Wall& wall) {
  constexpr double kLetter = HudPanel::kBandCapital / kCapitalOfLetters;
  const double most = mostOfBand(wall);
  std::vector<HudLine> lines;
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    for (std::uint8_t answer = 0; answer <= words.answers.size(); ++answer) {
      FrameRecord record;
      record.lesson = {phase, answer};
      describe(record, words, plan, {}, bandLetters(wall), lines);
      const double high = (kBandLine * static_cast<double>(lines.size()) + 1.0) * kLetter;
      if (high > most) return false;
    }
  }
  return true;
}

void describe(const FrameRecord& record, const LessonWords& lesson, const LessonPlan& plan, Viewers viewers,
              std::size_t letters, std::vector<HudLine>& words) {
  Lines lines(words, letters);
  lines.wrap(record.notice.words(), {}, true);
  addLesson(record, lesson, plan, viewers, lines);
  if (record.lesson.phase == LessonPhase::none) {
    addScore(record, viewers, lines);
    addEffects(record.switches, lines);
    addViews(record, viewers, lines);
    addDrive(record, lines);
  }
  if (record.controls.trackerCross) lines.add({}, texts::legend::kNearerBar);
}

void HudPanel::set(const std::vector<HudLine>& lines) {
  if (lines.size() != lines_.size()) written_ = false;
  lines_.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == lines_[i].line) continue;
    lines_[i].line = lines[i];
    lines_[i].ink = {};
    written_ = false;
  }
}

void HudPanel::setLesson(const LessonWords& words, const LessonPlan& plan) {
  lesson_ = words;
  plan_ = plan;
  tenths_s_ = -1;
}

void HudPanel::follow(const FrameRecord& record) {
  const auto tenths_s = static_cast<std::int64_t>(std::floor(10.0 * record.display_s));
  if (tenths_s == tenths_s_ && record.views == views_ && record.controls == controls_ &&
      record.lesson == lessonState_ && record.notice == notice_) {
    return;
  }
  tenths_s_ = tenths_s;
  views_ = record.views;
  controls_ = record.controls;
  lessonState_ = record.lesson;
  notice_ = record.notice;
  const bool band = record.lesson.phase != LessonPhase::none;
  if (band != band_) written_ = false;
  band_ = band;
  describe(record, lesson_, plan_, viewers_, band ? bandLetters_ : kLineLetters, described_);
  set(described_);
}

int HudPanel::endOf_px(const Written& written, int height_px) {
  return beginOf_px(written.line, height_px) + written.ink.size_px.x;
}

/// Returns the distance from line to line, in the nominal height of letters.
double HudPanel::line() const { return band_ ? kBandLine : kLine; }

void HudPanel::write(const glm::ivec2& picture_px, const Wall& wall) {
  const double capital_px =
      band_ ? kBandCapital * picture_px.y : kCapital_m * picture_px.y / sizeOf_m(wall).y;
  int height_px = static_cast<int>(std::ceil(std::max(kSmallest_px, capital_px / kCapitalOfLetters)));
  const auto widest_px = [&] {
    int widest = 0;
    for (Written& written : lines_) {
      if (height_px != height_px_ || written.ink.size_px.x == 0)
        written.ink = ink(written.line.text, height_px);
      widest = std::max(widest, endOf_px(written, height_px));
    }
    height_px_ = height_px;
    return widest;
  };
  // A small wall gets small letters.
  const double wide = widest_px() + 2.0 * beginOfText(band_) * height_px;
  const double high = (line() * static_cast<double>(lines_.size()) + 1.0) * height_px;
  const double mostOfWidth = band_ ? 1.0 : kMostOfWidth,
               mostOfHeight = band_ ? mostOfBand(wall) : kMostOfHeight;
  const double share = std::min(mostOfWidth * picture_px.x / wide, mostOfHeight * picture_px.y / high);
  if (share < 1.0) {
    height_px = std::max(1, static_cast<int>(share * height_px));
    widest_px();
  }
}

/// Paints the background, the marks and the letters.
void HudPanel::paint(const glm::ivec2& size_px, int height_px) {
  panel_.begin(size_px, kGround);
  const int line_px = static_cast<int>(line() * height_px), mark_px = 3 * height_px / 4;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto& [line, ink] = lines_[i];
    const int text_px = static_cast<int>(beginOfText(band_) * height_px) + beginOf_px(line, height_px);
    const int foot_px = size_px.y - height_px / 2 - static_cast<int>(i + 1) * line_px;
    panel_.write({text_px, foot_px}, ink, line.urgent ? kUrgent : kWhite);
    if (!line.mark) continue;
    const glm::vec3 mark = 255.0F * *line.mark;
    panel_.fill({2 * height_px / 3, foot_px + height_px / 4}, glm::ivec2(mark_px),
                {static_cast<std::uint8_t>(mark.x), static_cast<std::uint8_t>(mark.y),
                 static_cast<std::uint8_t>(mark.z), 255});
  }
  panel_.upload();
}

double HudPanel::top_m(const Wall& wall, double margin_m) {
  const double height_m = sizeOf_m(wall).y;
  return std::min(height_m - margin_m, std::max(kHighest_m - footOf_m(wall), 0.5 * height_m));
}

/// Returns the panel's lower left corner. The band's lower edge is at the height of the eyes, or lower if it would
/// reach beyond the wall.
glm::ivec2 HudPanel::lowerLeft_px(const Wall& wall, const glm::dvec2& pxPerM) const {
  const int high_px = panel_.size_px().y;
  if (band_) {
    const auto wall_px = static_cast<int>(sizeOf_m(wall).y * pxPerM.y);
    const auto eyes_px = static_cast<int>((kEyes_m - footOf_m(wall)) * pxPerM.y);
    return {0, std::clamp(eyes_px, 0, std::max(0, wall_px - high_px))};
  }
  const double margin_m = kMargin * sizeOf_m(wall).y;
  return {static_cast<int>(margin_m * pxPerM.x),
          std::max(0, static_cast<int>(top_m(wall, margin_m) * pxPerM.y) - high_px)};
}

void HudPanel::draw(const Wall& wall, const RenderTarget& picture) {
  if (lines_.empty()) return;
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  if (!written_ || picture_px_ != picture.size_px()) {
    if (picture_px_ != picture.size_px()) height_px_ = 0;
    picture_px_ = picture.size_px();
    write(picture_px_, wall);
    int widest_px = 0;
    for (const Written& written : lines_) widest_px = std::max(widest_px, endOf_px(written, height_px_));
    widest_px += height_px_ - widest_px % height_px_;  // so that the width does not change with every digit
    paint({band_ ? picture_px_.x : widest_px + 3 * height_px_,
           static_cast<int>(line() * height_px_) * static_cast<int>(lines_.size()) + height_px_},
          height_px_);
    written_ = true;
  }
  // Draws pixel on pixel, unless pixels are not square.
  panel_.draw(picture, lowerLeft_px(wall, pxPerM), pxPerM.x / pxPerM.y);
}

}  // namespace carom
