// Words in the room: what they say, how large they are, and that both eyes see them at the same place.
#include "cave/overlay/hud_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "cave/display/display_walls.h"
#include "cave/glowing_puck.h"
#include "cave/hud/panel_place.h"
#include "cave/pictures/image.h"
#include "cave/record/effects.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

Wall frontOf(const char* name, StereoMode stereo) {
  Wall wall;
  wall.name = name;
  wall.lowerLeft_m = {-1.5, 0.0, -1.5};
  wall.lowerRight_m = {1.5, 0.0, -1.5};
  wall.upperLeft_m = {-1.5, 3.0, -1.5};
  wall.pixels = {900, 900};
  wall.stereo = stereo;
  return wall;
}

FrameRecord recordAt(double display_s) {
  FrameRecord record;
  record.display_s = record.viewers[0].observer.properTime_s = display_s;
  record.lightSpeed_m_s = kC_m_s;
  record.viewers[0].observer.headFromBoard = Lorentz::boost(uFromBeta({0.0, 0.6, 0.0}), kC_m_s).inverse();
  record.viewers[0].observer.left = {{0.0, {-0.03, 0.0, 0.0}}, {-0.03, 1.7, 0.0}};
  record.viewers[0].observer.right = {{0.0, {0.03, 0.0, 0.0}}, {0.03, 1.7, 0.0}};
  record.viewers[0].observer.middle = {{}, {0.0, 1.7, 0.0}};
  return record;
}

/// Returns each line's text with its chips in brackets, the chosen one with a star.
std::vector<std::string> textsOf(const std::vector<HudLine>& lines) {
  std::vector<std::string> texts;
  for (const HudLine& line : lines) {
    texts.push_back(line.text);
    for (const HudChip& chip : line.chips) texts.back() += "[" + chip.text + (chip.isOn ? " *]" : "]");
  }
  return texts;
}

std::vector<std::string> said(const FrameRecord& record, const LessonWords& lesson = {}) {
  std::vector<HudLine> lines;
  describe(record, lesson, {}, {}, kPanelRoom, lines);
  return textsOf(lines);
}

TEST(HudPanel, EachReadsTheOthersClocksScoresAndTurns) {
  const std::vector<RoomViewer> viewers{{"anna", {}}, {"ben", {}}};
  FrameRecord record;
  record.viewerCount = 2;
  record.views.clocks = 1;
  record.viewers[0].observer.headFromBoard = record.viewers[1].observer.headFromBoard = Lorentz(1.42);
  record.viewers[0].observer.properTime_s = 10.0;
  record.viewers[1].observer.properTime_s = 11.3;
  record.viewers[0].score = {1, 3};
  record.viewers[1].score = {0, 2};
  record.viewers[1].hasTurn = 1;
  const auto reads = [&](std::size_t viewer, const std::string& words) {
    std::vector<RoomViewer> seen = viewers;
    std::swap(seen.front(), seen[viewer]);
    std::vector<HudLine> lines;
    describe({record, viewer}, {}, {}, seen, kPanelRoom, lines);
    return std::any_of(lines.begin(), lines.end(), [&](const HudLine& line) { return line.text == words; });
  };
  EXPECT_TRUE(reads(0, "ben: 11.3 s, older than you by 1.3 s"));
  EXPECT_TRUE(reads(1, "anna: 10.0 s, younger than you by 1.3 s"));
  EXPECT_TRUE(reads(0, "you:  caroms  1   strokes  3"));
  EXPECT_TRUE(reads(0, "ben's turn"));
  EXPECT_TRUE(reads(1, "your turn"));
}

TEST(HudPanel, SayWhichViewsAreOn) {
  FrameRecord record = recordAt(12.36);
  EXPECT_TRUE(said(record).empty());
  record.views.boardNow = record.views.frozen = 1;
  EXPECT_EQ(said(record),
            (std::vector<std::string>{"as seen: light that reaches me now", "now, in the table's frame",
                                      "frozen view: walk around it"}));
  record.views = {};
  record.views.clocks = 1;
  EXPECT_EQ(said(record),
            (std::vector<std::string>{"labels: each puck's proper time", "my proper time  12.3 s",
                                      "my speed  0.60 c   γ = 1.25", "light  1.42 m/s"}));
  record.views = {};
  record.views.split = 1;
  EXPECT_EQ(said(record), (std::vector<std::string>{"as seen: light that reaches me now",
                                                    "left: Einstein, right: Newton"}));
}

const LessonWords kLesson{
    "Twins",
    "Two twins part and meet again. Who of them is then the older one, and why?",
    {"Neither", "The one who stayed at home, as seen from where they meet", "The traveller"},
    1,
    "Press G and go.",
    "Watch your clock.",
    "10.3 s and 8 s.",
    "",
    ""};

TEST(HudPanel, AskWithNumberedAnswersInShortLines) {
  FrameRecord record = recordAt(1.0);
  record.lesson.phase = LessonPhase::asks;
  EXPECT_EQ(said(record, kLesson),
            (std::vector<std::string>{"Question:  Two twins part and meet",
                                      "again. Who of them is then the older", "one, and why?", "1   Neither",
                                      "2   The one who stayed at home, as seen", "from where they meet",
                                      "3   The traveller", "Choose an answer.[Skip  Enter]", "[Leave  F7]"}));
  std::vector<HudLine> lines;
  describe(record, kLesson, {}, {}, kPanelRoom, lines);
  for (const auto& [line, answer] : {std::pair{3U, 1}, {4U, 2}, {5U, 2}, {6U, 3}})
    EXPECT_EQ(lines[line].row, (WallAction{WallAction::Kind::choose, static_cast<std::uint8_t>(answer)}));
  EXPECT_FALSE(lines[2].isRow() || lines[7].isRow());
  // A class answers by phone: there is nothing to press.
  record.lesson.phase = LessonPhase::asks;
  record.classroom.phase = ClassPhase::vote;
  record.classroom.word = ShortText<120>("KIWI");
  EXPECT_EQ(said(record, kLesson).back(), "Answer by phone.[Leave  F7]");
  describe(record, kLesson, {}, {}, kPanelRoom, lines);
  EXPECT_TRUE(std::none_of(lines.begin(), lines.end(), [](const HudLine& line) { return line.isRow(); }));
  record.classroom = {};
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    record.lesson.phase = phase;
    const auto mayLeave = [&](bool may) {
      describe(record, kLesson, {}, {}, kPanelRoom, lines, may);
      const auto texts = textsOf(lines);
      return std::any_of(texts.begin(), texts.end(),
                         [](const std::string& line) { return line.find("Leave") != std::string::npos; });
    };
    EXPECT_TRUE(mayLeave(true));
    EXPECT_FALSE(mayLeave(false)) << "in a study nobody leaves a lesson";
  }
}

TEST(HudPanel, ANumberKeepsItsUnitAndALongWordIsDivided) {
  FrameRecord record = recordAt(1.0);
  record.lesson.phase = LessonPhase::shows;
  LessonWords lesson = kLesson;
  lesson.todo = "It goes along there at a speed of 0.75 c until it is at the far end, 2.84 m away.";
  lesson.notice = std::string(60, 'n') + " ends";
  double& board_s = record.viewers[0].observer.middle.observation.t_s;
  board_s = -1.0;  // the first half of what the lesson shows
  EXPECT_EQ(
      said(record, lesson),
      (std::vector<std::string>{"Try this:  It goes along there at a", "speed of 0.75 c until it is at the",
                                "far end, 2.84 m away.", "[Again  Y][Explanation  Enter]", "[Leave  F7]"}));
  board_s = 1.0;
  EXPECT_EQ(said(record, lesson),
            (std::vector<std::string>{"Look for:  " + std::string(29, 'n'), std::string(31, 'n') + " ends",
                                      "", "[Again  Y][Explanation  Enter]", "[Leave  F7]"}))
      << "the buttons stay where they are";
  board_s = -1.0;
  lesson.todo = "It goes away and then at 0.75 c";
  EXPECT_EQ(said(record, lesson)[0], "Try this:  It goes away and then at");
  EXPECT_EQ(said(record, lesson)[1], "0.75 c");
}

TEST(HudPanel, WhileALessonSpeaksTheLegendIsFolded) {
  FrameRecord record = recordAt(1.0);
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    record.lesson.phase = phase;
    record.views = {};
    const auto alone = said(record, kLesson);
    record.views.boardNow = record.views.clocks = record.views.ruler = 1;
    EXPECT_EQ(said(record, kLesson), alone);
  }
}

TEST(HudPanel, TellWhatIsMeasuredAndWhichVelocitiesThereAre) {
  LessonPlan plan;
  plan.interval.slowness = 4.0;
  plan.observers = {{"at rest", Vec3(0.0)}, {"0.5 c to the right", {0.5, 0.0, 0.0}}};
  plan.stopwatches.resize(2);
  plan.stopwatches[0].name = "Your clock";
  plan.stopwatches[0].clock = StopwatchClock::mine;
  plan.stopwatches[1].name = "From hit to hit";
  plan.stopwatches[1].clock = StopwatchClock::room;
  plan.stopwatches[1].starts = {1.5, {1.42, 0.0, 0.0}};
  plan.stopwatches[1].stops = Event{1.5, {-1.42, 0.0, 0.0}};
  FrameRecord record = recordAt(12.36);
  record.boardFromRoom = Lorentz::boost(uFromBeta({0.5, 0.0, 0.0}), kC_m_s);
  record.lesson.phase = LessonPhase::explains;
  std::vector<HudLine> lines;
  describe(record, kLesson, plan, {}, {90, 0.54 * 90}, lines);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].text, "Your clock: 12.36 s    From hit to hit: 1.15 s");
  EXPECT_TRUE(lines[1].urgent);
  EXPECT_EQ(textsOf(lines)[2], "You move:[at rest  F2][0.5 c to the right  F3 *]");
  EXPECT_EQ(lines[2].chips[1].action, (WallAction{WallAction::Kind::choose, 2}));
  record.lesson.phase = LessonPhase::shows;
  describe(record, kLesson, plan, {}, {90, 0.54 * 90}, lines);
  EXPECT_EQ(textsOf(lines).back(), "[Again  Y][Explanation  Enter][Leave  F7]");
  EXPECT_EQ(lines[1].text.find("Slow motion: 1/4    Your clock:"), 0U) << lines[1].text;
  record.views.frozen = 1;
  describe(record, kLesson, plan, {}, {120, 0.54 * 120}, lines);
  EXPECT_EQ(textsOf(lines).back(), "[Again  Y][Explanation  Enter][Let time go on  F][Leave  F7]");
}

TEST(HudPanel, AnExplanationMayOfferSpacetime) {
  FrameRecord record = recordAt(1.0);
  record.lesson.phase = LessonPhase::explains;
  std::vector<HudLine> lines;
  const auto offered = [&](bool may) {
    LessonPlan plan;
    plan.offersSpacetime = may;
    describe(record, kLesson, plan, {}, {120, 0.54 * 120}, lines);
    const auto& chips = lines.back().chips;
    const auto found = std::find_if(chips.begin(), chips.end(), [](const HudChip& chip) {
      return chip.action == WallAction{WallAction::Kind::spacetime};
    });
    return found == chips.end() ? std::string() : found->text + (found->isOn ? " *" : "");
  };
  EXPECT_EQ(offered(false), "");
  EXPECT_EQ(offered(true), texts::lesson::kSpacetime.words());
  record.views.spacetime = 1;
  EXPECT_EQ(offered(true), std::string(texts::lesson::kSpacetime.words()) + " *");
}

TEST(HudPanel, ALessonMayOfferEffects) {
  LessonPlan plan;
  plan.effects = {numberOf(&Switches::retardation), numberOf(&Switches::contraction)};
  FrameRecord record = recordAt(1.0);
  record.switches.contraction = 0;
  std::vector<HudLine> lines;
  const auto offered = [&](LessonPhase phase) {
    record.lesson.phase = phase;
    describe(record, kLesson, plan, {}, {120, 0.54 * 120}, lines);
    std::vector<std::string> texts;
    for (const HudLine& line : lines)
      for (const HudChip& chip : line.chips)
        if (chip.action.kind == WallAction::Kind::effect)
          texts.push_back(fmt::format("{} {}{}", chip.action.number, chip.text, chip.isOn ? " *" : ""));
    return texts;
  };
  const std::vector<std::string> both{"0 light delay  1 *", "1 contraction  2"};
  EXPECT_EQ(offered(LessonPhase::asks), std::vector<std::string>{}) << "the keys answer the question";
  EXPECT_EQ(offered(LessonPhase::shows), both);
  EXPECT_EQ(offered(LessonPhase::explains), std::vector<std::string>{})
      << "it explains what is seen with them";
}

TEST(HudPanel, ShowWhatToDoAndExplainWhatWasAnswered) {
  FrameRecord record = recordAt(1.0);
  record.lesson = {LessonPhase::shows, 1};
  for (const double board_s : {-1.0, 1.0}) {  // what to do, then what to look for
    record.viewers[0].observer.middle.observation.t_s = board_s;
    EXPECT_EQ(said(record, kLesson),
              (std::vector<std::string>{
                  board_s < 0.0 ? "Try this:  Press G and go." : "Look for:  Watch your clock.",
                  "[Again  Y][Explanation  Enter]", "[Leave  F7]"}));
  }
  record.lesson.phase = LessonPhase::explains;
  EXPECT_EQ(said(record, kLesson),
            (std::vector<std::string>{"10.3 s and 8 s.", "Your answer:  Neither. Not quite. Right",
                                      "is: The one who stayed at home, as", "seen from where they meet.",
                                      "[Scene  Enter][Ask again  Y]", "[Leave  F7]"}));
  record.lesson.answer = 2;
  EXPECT_EQ(said(record, kLesson)[2], "home, as seen from where they meet.");
  record.lesson.answer = 0;
  EXPECT_EQ(said(record, kLesson).size(), 3u) << "skipped: the number alone";
  LessonWords hidden = kLesson;
  hidden.right = hidden.answers.size();
  record.lesson.answer = 1;
  EXPECT_EQ(said(record, hidden)[1], "Your answer:  Neither") << "which one is right is not told";
}

TEST(HudPanel, BeginWithWhatJustHappenedAndLetItStandOut) {
  FrameRecord record = recordAt(1.0);
  std::string words;
  for (int i = 0; i < 59; ++i) words += i % 7 == 6 ? " " : "γ";  // 110 bytes
  record.viewers[0].notice = Notice(words);
  record.views.paths = 1;
  std::vector<HudLine> lines;
  describe(record, {}, {}, {}, kPanelRoom, lines);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[0].urgent && lines[1].urgent);
  EXPECT_FALSE(lines[2].urgent);
  EXPECT_EQ(lines[0].text + " " + lines[1].text, words) << "nothing is cut within a letter";
}

TEST(HudPanel, SayWhichEffectsAreNotAsAtTheBeginning) {
  FrameRecord record = recordAt(1.0);
  EXPECT_TRUE(said(record).empty());
  record.switches.retardation = 0;
  record.switches.colour = 1;
  EXPECT_EQ(said(record), (std::vector<std::string>{"off: light delay (retardation)", "on: Doppler colour"}));
}

TEST(HudPanel, ACaptionDuringAScriptedFlightSpeaksAlone) {
  FrameRecord record = recordAt(1.0);
  record.boardFromRoom = Lorentz::boost({0.75, 0.0, 0.0}, record.boardFromRoom.lightSpeed_m_s());
  record.drive.mode = DriveMode::tour;
  EXPECT_GT(said(record).size(), 2U) << "speed and contraction";
  record.viewers[0].notice = Notice("Watch the hall.");
  EXPECT_EQ(said(record), std::vector<std::string>{"Watch the hall."});
  record.drive.mode = DriveMode::free;
  EXPECT_GT(said(record).size(), 2U);
}

TEST(HudPanel, AreOnTheFirstWallAhead) {
  RoomGeometry room;
  Wall left = frontOf("left", StereoMode::mono);
  left.lowerLeft_m = {-1.5, 0.0, 1.5};
  left.lowerRight_m = {-1.5, 0.0, -1.5};
  left.upperLeft_m = {-1.5, 3.0, 1.5};
  room.walls = {left};
  EXPECT_FALSE(frontWall(room));
  room.walls.push_back(frontOf("front", StereoMode::mono));
  ASSERT_TRUE(frontWall(room));
  EXPECT_EQ(frontWall(room)->name, "front");
}

class DrawnWords : public testing::Test {
 protected:
  Image drawn(const std::vector<HudLine>& lines, double textSize = 1.0) {
    graphics_.makeCurrent();
    RenderTarget picture({900, 900});
    HudPanel words;
    words.set(lines);
    Wall wall = frontOf("front", StereoMode::mono);
    wall.textSize = textSize;
    words.draw(wall, picture);
    return readBack(picture);
  }

  Graphics graphics_;
};

/// The lowest and the highest row of a picture that is lit.
std::pair<int, int> litRows(const Image& image) {
  int lowest = image.size_px.y, highest = -1;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      if (image.rgb[static_cast<std::size_t>(3 * (y * image.size_px.x + x))] < 128) continue;
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
    }
  }
  return {lowest, highest};
}

// Times the text size.
TEST_F(DrawnWords, CapitalsAreFourCentimetresHigh) {
  for (const double textSize : {1.0, 1.5, 2.0}) {
    const auto [lowest, highest] = litRows(drawn({{"HHHH", {}}}, textSize));
    EXPECT_NEAR(highest - lowest + 1, textSize * 0.04 * 300.0, 1.0);  // 300 pixels a metre
    // The panel hangs from 2.2 m: two letters' heights of it with one line.
    EXPECT_LT(highest, PanelPlace::kHighest_m * 300.0);
    EXPECT_GT(lowest, (PanelPlace::kHighest_m - textSize * 0.15) * 300.0);
  }
}

// The band's lines are broken for larger letters, and these get smaller only where they would take the game's
// place.
TEST(HudPanel, LargerWordsHaveFewerOfThemInALine) {
  Wall wall = frontOf("front", StereoMode::mono);
  wall.pixels = {3840, 1080};
  const std::size_t letters = bandRoom(wall).columns;
  BandLayout layout;
  const std::vector<HudLine> one{{"HHHH", {}}}, many(30, one.front());
  layOut(wall, wall.pixels, one, layout);
  const int height_px = layout.height_px;
  wall.textSize = 2.0;
  EXPECT_NEAR(static_cast<double>(bandRoom(wall).columns), 0.5 * static_cast<double>(letters), 1.0);
  layOut(wall, wall.pixels, one, layout);
  EXPECT_NEAR(layout.height_px, 2 * height_px, 1);
  layOut(wall, wall.pixels, many, layout);
  EXPECT_LE(layout.size_px.y, PanelPlace::mostOfBand(wall) * wall.pixels.y);
}

/// The height of the least high line of the picture, from run to run of bright rows.
int leastLine_px(const Image& image) {
  int least = image.size_px.y, run = 0;
  for (int y = 0; y < image.size_px.y; ++y) {
    bool lit = false;
    for (int x = 0; x < image.size_px.x && !lit; ++x)
      lit = image.rgb[static_cast<std::size_t>(3 * (y * image.size_px.x + x))] >= 128;
    if (!lit && run > 0) least = std::min(least, run);
    run = lit ? run + 1 : 0;
  }
  return least;
}

/// English words of so many letters together, none of which reaches below its line.
std::string textOf(std::size_t letters) {
  std::string text;
  while (text.size() < letters)
    text += "The slow clock on the train had ticked late and so had the other one. ";
  text.resize(letters);
  if (text.back() == ' ') text.back() = 'n';
  return text;
}

// The longest texts that a lesson may have, with a stopwatch and velocities.
TEST_F(DrawnWords, TheBandOfALessonHasLettersOfAFortiethOfTheHeight) {
  LessonWords words{"", textOf(160), {}, 0, textOf(160), textOf(160), textOf(230), "", ""};
  for (int i = 0; i < 3; ++i) words.answers.push_back(textOf(70));
  words.answers.push_back("HHH");
  LessonPlan plan;
  plan.observers = {{"at rest", Vec3(0.0)}, {"0.5 c to the left", {0.5, 0.0, 0.0}}};
  plan.stopwatches.resize(2);
  plan.stopwatches[0].name = plan.stopwatches[1].name = "HHH";
  for (const glm::ivec2& size_px : {glm::ivec2(1067, 600), glm::ivec2(1280, 720), glm::ivec2(1920, 1080)}) {
    Wall wall = frontOf("front", StereoMode::mono);
    wall.pixels = size_px;
    wall.lowerRight_m.x = wall.lowerLeft_m.x + 3.0 * size_px.x / size_px.y;
    EXPECT_TRUE(bandHolds(words, plan, wall));
    for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
      graphics_.makeCurrent();
      RenderTarget picture(size_px);
      HudPanel band;
      band.setWall(wall, {});
      band.setLesson(words, plan);
      FrameRecord record = recordAt(1.0);
      record.lesson = {phase, 1};
      band.follow(record);
      band.draw(wall, picture);
      const Image image = readBack(picture);
      // The line of capitals and digits is the least high; its last row of pixels may be faint.
      EXPECT_GE(leastLine_px(image) + 1, size_px.y / 40) << size_px.x << ", " << static_cast<int>(phase);
      int low = size_px.y;
      for (int y = 0; y < size_px.y; ++y) {
        for (int x = 0; x < size_px.x; ++x) {
          const std::uint8_t* pixel = &image.rgb[static_cast<std::size_t>(3 * (y * size_px.x + x))];
          if (pixel[0] + pixel[1] + pixel[2] > 0) low = std::min(low, y);
        }
      }
      EXPECT_GE(low, PanelPlace::kLowest_m / 3.0 * size_px.y - 1.0) << "the game has its place below";
    }
  }
}

TEST(HudPanel, TextsAreTooLongForAWallThatIsTooNarrow) {
  Wall wall = frontOf("front", StereoMode::mono);
  LessonWords words = kLesson;
  EXPECT_TRUE(bandHolds(words, {}, wall));
  words.number = textOf(230);
  words.answers[0] = words.answers[1] = textOf(70);
  EXPECT_TRUE(bandHolds(words, {}, wall)) << "two answers of 70 letters and 230 letters on a square wall";
  words.question = textOf(160);
  words.answers = std::vector<std::string>(4, textOf(70));
  wall.pixels.x = 700;
  EXPECT_FALSE(bandHolds(words, {}, wall)) << "four such answers to a long question on a narrow one";
}

TEST_F(DrawnWords, NothingToSayIsNothingDrawn) {
  EXPECT_GT(drawn({{"words", {}}}).rgb, std::vector<std::uint8_t>(3 * 900 * 900, 0));
  EXPECT_EQ(drawn({}).rgb, std::vector<std::uint8_t>(3 * 900 * 900, 0));
}

/// The box of what differs from black.
struct Box {
  int left = 900, right = -1, low = 900, high = -1;
};
Box boxOf(const Image& image) {
  Box box;
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      const std::uint8_t* pixel = &image.rgb[static_cast<std::size_t>(3 * (y * image.size_px.x + x))];
      if (pixel[0] + pixel[1] + pixel[2] == 0) continue;
      box = {std::min(box.left, x), std::max(box.right, x), std::min(box.low, y), std::max(box.high, y)};
    }
  }
  return box;
}

// However much there is to say: beside and below it is the game.
TEST_F(DrawnWords, LeaveTheGameItsPlace) {
  std::vector<HudLine> lines;
  for (int i = 0; i < 24; ++i) lines.push_back({"W" + std::string(kPanelRoom.columns, 'n'), {}});
  for (const std::size_t count : {std::size_t{1}, std::size_t{10}, lines.size()}) {
    const Box box = boxOf(drawn({lines.begin(), lines.begin() + static_cast<long>(count)}));
    ASSERT_GT(box.right, box.left);
    EXPECT_LE(box.right - box.left + 1, PanelPlace::kMostOfWidth * 900) << count;
    EXPECT_LE(box.high - box.low + 1, PanelPlace::kMostOfHeight * 900) << count;
    EXPECT_LE(box.high, PanelPlace::kHighest_m * 300.0);
  }
}

TEST_F(DrawnWords, ALongLineStaysOnTheWall) {
  const Image image = drawn({{std::string(200, 'm'), {}}});
  for (int y = 0; y < 900; ++y) EXPECT_EQ(image.rgb[static_cast<std::size_t>(3 * (y * 900 + 899))], 0) << y;
}

// A computer for each eye: both pictures hold the same panel on the same pixels, and other things elsewhere.
TEST(HudPanel, HaveNoParallax) {
  Graphics graphics;
  const std::vector<Wall> walls{frontOf("l", StereoMode::left), frontOf("r", StereoMode::right)};
  DisplayWalls set(graphics, test::glowingPuck(0.2), kC_m_s, walls, std::nullopt, false);
  RoomGeometry room;
  room.walls = walls;
  set.setRoom(room);
  FrameRecord record = recordAt(3.0);
  const World world{
      {WorldLine(Knot{}, kC_m_s), WorldLine({{0.0, {0.1, 0.3, -1.0}}, {}, 0.0, {}, 0.0}, kC_m_s)}, {}};
  const auto images = [&] {
    set.draw(record, world);
    graphics.makeCurrent();
    return std::pair(readBack(*set.pictureOf("l")), readBack(*set.pictureOf("r")));
  };
  const auto [leftBefore, rightBefore] = images();
  EXPECT_NE(leftBefore.rgb, rightBefore.rgb);
  record.views.clocks = 1;
  const auto [left, right] = images();
  int changed = 0;
  for (std::size_t i = 0; i < left.rgb.size(); ++i) {
    const bool inLeft = left.rgb[i] != leftBefore.rgb[i], inRight = right.rgb[i] != rightBefore.rgb[i];
    ASSERT_EQ(inLeft, inRight) << i;
    if (!inLeft) continue;
    ASSERT_EQ(left.rgb[i], right.rgb[i]) << i;
    ++changed;
  }
  EXPECT_GT(changed, 10000);
}

}  // namespace
}  // namespace carom
