// The pictures of what rests, kept while an eye sees the same of it: every pixel must be that of a renderer
// that keeps nothing, since it looks elsewhere before every frame.
#include "cave/render/still_layers.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "cave/glowing_puck.h"
#include "cave/pictures/image.h"
#include "cave/render/wall_renderer.h"
#include "cave/scene/scene_builder.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using namespace test;

/// All of which a picture may depend, but for the time.
struct Seen {
  Vec3 from_m{0.0, -1.6, 0.9};
  Vec3 beta{0.0};
  Vec3 eyeInRoom_m{0.0, 0.0, 1.65};
  glm::dvec3 towards{0.0, 1.0, -0.4};
  glm::ivec2 pixels{320, 240};
  Switches switches;
};

class StillLayersTest : public testing::Test {
 protected:
  StillLayersTest() {
    BilliardSetup setup;
    setup.board = Board{2.84, 1.42};
    scene_ = buildScene(setup, std::vector<BodyLooks>{{"white", "", 0.1, 0.08}});
    keepsNothing_.emplace(graphics_, scene_, kC_m_s);
  }

  Image drawn(WallRenderer& renderer, RenderTarget& picture, const Seen& seen, double t_s) const {
    const Lorentz headFromBoard = Lorentz::boost(uFromBeta(seen.beta), kC_m_s);
    const Event eye{t_s, seen.from_m};
    std::array<BodyView, 2> views;
    viewBody(WorldLine(Knot{}, kC_m_s), eye, headFromBoard, views[0], seen.switches);
    viewBody(puck_, eye, headFromBoard, views[1], seen.switches);
    renderer.look(headFromBoard, {eye, seen.eyeInRoom_m}, views, seen.switches);
    EXPECT_TRUE(
        renderer.draw(wallTowards(seen.eyeInRoom_m, seen.towards, seen.pixels), seen.eyeInRoom_m, picture));
    return readBack(picture);
  }

  Image drawnAnew(const Seen& seen, double t_s) {
    RenderTarget picture(seen.pixels);
    Seen elsewhere = seen;
    elsewhere.from_m.y -= 0.1;
    drawn(keepsNothing_.value(), picture, elsewhere, t_s);
    return drawn(keepsNothing_.value(), picture, seen, t_s);
  }

  Graphics graphics_;
  std::optional<WallRenderer> keepsNothing_;
  Scene scene_;
  // It crosses the table while the clocks on the rails and in the hall go on.
  const WorldLine puck_{{{0.0, {-0.6, 0.1, 0.04}}, uFromBeta({0.3, 0.0, 0.0}), 0.0, {}, 0.0}, kC_m_s, 0.15};
};

// Each view is seen thrice, so that it is drawn, kept and used; then one thing changes.
TEST_F(StillLayersTest, EveryFrameHasThePixelsOfARendererThatKeepsNothing) {
  const std::vector<std::pair<const char*, std::function<void(Seen&)>>> changes{
      {"nothing", [](Seen&) {}},
      {"the place", [](Seen& s) { s.from_m.x += 0.01; }},
      {"the velocity",
       [](Seen& s) {
         s.beta = {0.2, 0.3, 0.0};
       }},
      {"the place in the room", [](Seen& s) { s.eyeInRoom_m.y += 0.02; }},
      {"the wall",
       [](Seen& s) {
         s.towards = {0.3, 1.0, -0.5};
       }},
      {"a larger wall",
       [](Seen& s) {
         s.pixels = {400, 300};
       }},
      {"a smaller wall",
       [](Seen& s) {
         s.pixels = {240, 200};
       }},
      {"aberration", [](Seen& s) { s.switches.aberration = 0; }},
      {"retardation", [](Seen& s) { s.switches.retardation = 0; }},
      {"colour", [](Seen& s) { s.switches.colour = 1; }},
      {"the searchlight", [](Seen& s) { s.switches.searchlight = 1; }},
      {"all at once", [](Seen& s) { s = Seen{}; }}};
  WallRenderer keeps(graphics_, scene_, kC_m_s);
  Seen seen;
  double t_s = 1.0;
  std::vector<std::uint8_t> before;
  for (const auto& [what, change] : changes) {
    SCOPED_TRACE(what);
    change(seen);
    RenderTarget picture(seen.pixels);
    for (int frame = 0; frame < 3; ++frame, t_s += 0.13) {
      const Image kept = drawn(keeps, picture, seen, t_s);
      ASSERT_EQ(kept.rgb, drawnAnew(seen, t_s).rgb) << "frame " << frame;
      EXPECT_NE(kept.rgb, before) << "the puck and the clocks go on";
      before = kept.rgb;
    }
  }
}

// Walls that take turns have layers of their own.
TEST_F(StillLayersTest, PicturesThatTakeTurnsKeepTheirOwn) {
  WallRenderer keeps(graphics_, scene_, kC_m_s);
  Seen left, right;
  left.towards = {-0.5, 1.0, -0.4};
  RenderTarget ofLeft(left.pixels), ofRight(right.pixels);
  for (int frame = 0; frame < 4; ++frame) {
    const double t_s = 1.0 + 0.13 * frame;
    const Image a = drawn(keeps, ofLeft, left, t_s), b = drawn(keeps, ofRight, right, t_s);
    ASSERT_EQ(a.rgb, drawnAnew(left, t_s).rgb) << "frame " << frame;
    ASSERT_EQ(b.rgb, drawnAnew(right, t_s).rgb) << "frame " << frame;
  }
}

}  // namespace
}  // namespace carom
