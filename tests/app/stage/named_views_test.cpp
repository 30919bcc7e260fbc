// Each view of time is seen: whoever turns it on sees another picture of the same frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/stage/lesson_sight.h"

namespace carom {
namespace {

/// The 150th frame of a game in which soft pucks have met, so that there is something of each view to show.
class PlayedGame {
 public:
  PlayedGame()
      : rig_(test::deskOf(300)),
        scenario_(readScenario(fileOfGame("jellies"))),
        scene_(sceneOf(scenario_, tessellationFor(rig_, true))),
        walls_(graphics_, scene_, scenario_.billiard.lightSpeed_m_s, rig_.walls, {}, false) {
    walls_.setRoom(roomGeometryOf(rig_));
    world_.histories = startingHistories(scenario_);
    LiveSource source(rig_, scenario_, world_, {});
    Beginning beginning;
    beginning.languages = std::make_shared<const SessionLanguages>(languagesOf(rig_, nullptr, ""));
    FrameLeader leader(source, KeysOf::session, settingsOf(rig_, scenario_, fileOfGame("jellies"), beginning),
                       [](const WindowInput&, bool) { return DeskInput{}; });
    SimulatedClock clock;
    Pacer pacer(clock, 60.0, 0.0, false, 0);
    for (int frame = 0; frame < 150; ++frame) {
      Decision decision;
      leader.decide(pacer.next(), {}, decision);
      applyFrame(decision.frame, world_);
      record_ = decision.frame.record;
    }
    // The person has gone on since what a frozen view holds.
    ObserverView& observer = record_.viewers[0].observer;
    for (EyeView* eye : {&observer.left, &observer.right, &observer.middle})
      eye->positionInRoom_m += Vec3(0.2, 0.1, 0.0);
  }

  Image picture(const TimeViews& views) {
    record_.views = views;
    walls_.draw(record_, world_);
    graphics_.makeCurrent();
    return readBack(*walls_.pictureOf("screen"));
  }

 private:
  Graphics graphics_;
  Rig rig_;
  Scenario scenario_;
  World world_;
  Scene scene_;
  DisplayWalls walls_;
  FrameRecord record_;
};

/// The number of pixels that are plainly not the same, beyond any rounding.
int differing(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t pixel = 0; pixel < a.rgb.size(); pixel += 3) {
    int most = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i)
      most = std::max(most, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    count += most > 16;
  }
  return count;
}

TEST(NamedViews, EachIsSeenInAPicture) {
  PlayedGame game;
  const Image plain = game.picture({});
  ASSERT_EQ(differing(plain, game.picture({})), 0);
  for (const NamedView& view : kNamedViews) {
    TimeViews views;
    views.*view.value = 1;
    // A view that shows itself in less than a square of seven pixels, of 533 by 300, is not seen.
    EXPECT_GE(differing(plain, game.picture(views)), 49) << view.name;
  }
}

}  // namespace
}  // namespace carom
