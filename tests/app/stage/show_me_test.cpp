// What the chapters of "Show me" claim is in their pictures. Each is looked at as a lesson's moment is
// (lesson_check.h): the game with that moment, its views, and, where the person is driven, a velocity.
#include <fstream>
#include <iterator>

#include <gtest/gtest-spi.h>

#include "app/stage/lesson_check.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::LessonCheck;
using test::LessonMoment;

/// A chapter, by its sentence, and what must be seen at a moment of it.
struct Chapter {
  std::size_t caption;
  const char* says;
  double moment_s;
  double beta;  // of the person, along the table
  void (*holds)(const LessonCheck&);
};

/// The speed at which a body's light tells its places, over c, by the line of sight: β/(1 + β·n), with n from
/// the eye to the body.
double looks(const LessonCheck& check, const std::string& body) {
  const Motion motion = check.eye.emitting(check.moment.line(body));
  const Vec3 beta = betaFromU(motion.u);
  return glm::length(beta) / (1.0 + glm::dot(beta, glm::normalize(motion.event.r_m - check.eye.at().r_m)));
}

void looksFaster(const LessonCheck& check) {
  check.puck("white");
  EXPECT_GT(looks(check, "white"), 1.3 * 0.387);
  check.gauge("white", fmt::format("looks {:.2f} c", looks(check, "white")));
}

void looksSlower(const LessonCheck& check) {
  check.puck("white");
  EXPECT_LT(looks(check, "white"), 0.387 / 1.2);
  check.gauge("white", fmt::format("looks {:.2f} c", looks(check, "white")));
}

/// The ghost is as wide as it is drawn contracted, and half as wide as across: beyond that there is cloth.
void halfAsWide(const LessonCheck& check) {
  check.ghost("red", false);
  const WorldLine& line = check.moment.line("red");
  EXPECT_NEAR(gammaFromU(line.at(check.eye.at().t_s).u), 1.0 / 0.527, 0.01);
  std::vector<glm::dvec2> within, beyond, ground;
  for (const double way : {-1.0, 1.0}) {
    for (const double share : {0.6, 0.7, 0.8})
      within.push_back(check.eye.onBoardNow(line, {way * share * 0.12, 0.0, 0.025}));
    for (const double share : {1.35, 1.5, 1.65})
      beyond.push_back(check.eye.onBoardNow(line, {way * share * 0.12, 0.0, 0.025}));
    for (const double share : {2.6, 2.8, 3.0})
      ground.push_back(check.eye.onBoardNow(line, {way * share * 0.12, 0.0, 0.025}));
  }
  check.isTinted(within, ground, kBoardNowColour, "ghost of red");
  EXPECT_NONFATAL_FAILURE(check.isTinted(beyond, ground, kBoardNowColour, "beside the ghost"), "not there");
}

/// What of the puck is farther away is seen where it was earlier: behind what is nearer.
void looksTurned(const LessonCheck& check) {
  check.puck("red");
  const WorldLine& line = check.moment.line("red");
  const double ahead = std::copysign(1.0, check.eye.emitting(line).u.x);
  const glm::dvec2 far = check.eye.seen(line, {0.0, 0.12, 0.025}),
                   near = check.eye.seen(line, {0.0, -0.12, 0.025});
  EXPECT_LT(ahead * (far.x - near.x), -LessonCheck::kLeastThing * check.picture.size_px.y);
}

/// Both ghosts of the fast puck are there, and apart.
void twoNows(const LessonCheck& check) {
  check.ghost("red", true);
  const WorldLine& line = check.moment.line("red");
  const Motion now = line.at(check.eye.at().t_s);
  const auto onBoard = [&](const Vec3& offset_m) {
    return check.eye.seen(now.event.r_m + test::LessonEye::contracted(now, offset_m));
  };
  std::vector<glm::dvec2> within, around;
  for (int i = 0; i < 24; ++i) {
    const double angle = std::numbers::pi * i / 12.0;
    const Vec3 way_m = 0.12 * Vec3(std::cos(angle), std::sin(angle), 0.0);
    within.push_back(onBoard(0.6 * way_m + Vec3(0.0, 0.0, 0.025)));
    around.push_back(onBoard(1.9 * way_m + Vec3(0.0, 0.0, 0.025)));
  }
  check.isLarge(within, "blue ghost of red");
  check.isTinted(within, around, kBoardNowColour, "blue ghost of red");
  EXPECT_GT(glm::distance(onBoard(Vec3(0.0)), check.eye.forMeNow(line, Vec3(0.0))),
            LessonCheck::kLeastThing * check.picture.size_px.y);
}

/// The mean colour of the cloth around a place where nothing else is.
glm::dvec3 clothAt(const LessonCheck& check, double x_m) {
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 25; ++i) {
    const glm::dvec2 at_px = check.eye.seen({x_m + 0.01 * (i % 5), 0.35 + 0.01 * (i / 5), 0.0});
    check.onWall(at_px, "cloth");
    sum += test::colourAt(check.picture, at_px) / 25.0;
  }
  return sum;
}

void bluerAndBrighterAhead(const LessonCheck& check) {
  const glm::dvec3 ahead = clothAt(check, 0.9), behind = clothAt(check, -0.9);
  EXPECT_GT(ahead.b / ahead.r, 1.5 * behind.b / behind.r);
  EXPECT_GT(glm::length(ahead), 1.2 * glm::length(behind));
}

void yoursToStrike(const LessonCheck& check) {
  for (const char* puck : {"white", "yellow"}) check.puck(puck);
}

const std::vector<Chapter> kChapters{
    {0, "faster as they come", 8.1, 0.0, looksFaster},
    {0, "slower as they go", 6.1, 0.0, looksSlower},
    {1, "the fast red one is only half as wide", 14.75, 0.0, halfAsWide},
    {2, "You see the red one turned", 25.55, 0.0, looksTurned},
    {3, "Blue: where the pucks are now for the table; pink: now for you", 38.2, 0.4, twoNows},
    {4, "light from ahead is bluer and brighter", 52.0, 0.4, bluerAndBrighterAhead},
    {5, "Now you: drag a puck back", 66.0, 0.0, yoursToStrike},
};

/// The names of the views that are on.
std::string namesOf(const TimeViews& views) {
  std::string names;
  for (const NamedView& view : kNamedViews)
    if (views.*view.value) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", view.name);
  return names;
}

/// Show me, to be looked at as a lesson at the chapter's moment, without its flight.
std::string asLesson(const Chapter& chapter, const TimeViews& views) {
  std::ifstream file(fileOfGame("show-me"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  text.resize(text.find("[tour]"));
  text += fmt::format(
      "[lesson]\nquestion = 'Which?'\nanswers = ['This', 'That']\nright = 1\ntodo = 'Look.'\nnotice = "
      "'See.'\n"
      "number = 'One.'\nviews = [{}]\nfrom_s = {:.3f}\nuntil_s = {:.3f}\nmoment_s = {:.3f}\n",
      namesOf(views), chapter.moment_s - 0.5, chapter.moment_s + 0.5, chapter.moment_s);
  if (chapter.beta != 0.0)
    text += fmt::format("[[lesson.observer]]\nname = 'driven'\nbeta = [{}, 0.0, 0.0]\n", chapter.beta);
  return text;
}

TEST(ShowMe, EachChapterIsSeen) {
  Graphics graphics;
  const std::vector<Caption> captions = readScenario(fileOfGame("show-me")).captions;
  for (const int lines : {600, 1080}) {
    const Rig rig = test::deskOf(lines);
    for (std::size_t number = 0; number < kChapters.size(); ++number) {
      const Chapter& chapter = kChapters[number];
      SCOPED_TRACE(testing::Message() << chapter.says << ", " << lines << " lines");
      const Caption& caption = captions.at(chapter.caption);
      EXPECT_NE(caption.text.find(chapter.says), std::string::npos) << caption.text;
      EXPECT_GT(chapter.moment_s, caption.from_s);
      EXPECT_LT(chapter.moment_s, caption.from_s + caption.for_s);
      const test::TemporaryFolder folder;
      LessonMoment moment(rig, folder.file("chapter.toml", asLesson(chapter, caption.views)).string(),
                          LessonPhase::shows);
      if (caption.colour) moment.record.switches.colour = moment.record.switches.searchlight = 1;
      test::LessonStage stage(graphics, rig, moment.scenario);
      const Image picture = stage.draw(moment);
      if (const char* kept = std::getenv("CAROM_LESSON_PICTURES"))
        writePng(picture, std::filesystem::path(kept) / fmt::format("show-me-{}-{}.png", number + 1, lines));
      chapter.holds(LessonCheck(moment, rig.walls.at(0), picture));
    }
  }
  EXPECT_EQ(captions.size(), kChapters.back().caption + 1) << "each chapter is looked at";
}

}  // namespace
}  // namespace carom
