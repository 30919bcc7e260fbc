#pragma once
// All that is drawn over the pictures of the session, in its order: words, choices, aids, hands.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cave/display/wall_pictures.h"
#include "cave/hud/motion_overlay.h"
#include "cave/overlay/choice_tiles.h"
#include "cave/overlay/class_board.h"
#include "cave/overlay/comfort_overlay.h"
#include "cave/overlay/cue_overlay.h"
#include "cave/overlay/home_arrow.h"
#include "cave/overlay/hud_panel.h"
#include "cave/overlay/room_overlay.h"
#include "cave/overlay/standing_board.h"
#include "cave/room/room_geometry.h"

namespace carom {

class WallOverlays {
 public:
  /// Shows another game.
  void setScene(const Scene& scene) { cue_.setRims(rimsOf(scene)); }
  /// Gives the room to the overlays. Without it there is no HUD panel. Needs the drawing context.
  void setRoom(const RoomGeometry& room);
  /// Sets the game's lesson for the HUD panel; empty texts mean no lesson. `mayLeave`: it has the button that
  /// leaves it.
  void setLesson(const LessonWords& words, const LessonPlan& plan, bool mayLeave = true) {
    for (HudPanel& panel : words_) panel.setLesson(words, plan, mayLeave);
  }
  /// Sets the names of the session's languages, by their numbers in the records.
  void setLanguages(const std::vector<std::string>& names) { choices_.setLanguages(names); }
  /// Sets what the game offers (cave/overlay/choice_tiles.h, cave/overlay/home_arrow.h).
  void setOffers(const GameOffers& offers) { offers_ = offers; }

  /// Draws over the newest pictures of one viewer. Needs the drawing context.
  void draw(const SeenFrame& seen, const WallPictures& pictures);

  /// Returns the board that stands in the room in the place of the front wall, for a headset's wearer; or
  /// null.
  const StandingBoard* board() const { return board_ ? &*board_ : nullptr; }

 private:
  /// A picture to draw over.
  struct Over {
    const RoomGeometry& room;  ///< as the viewer sees it
    const Wall& wall;
    bool isFront;
    const glm::dvec3& eye_m;  ///< in the room
    const SeenFrame& seen;
    const RenderTarget& picture;
  };
  void drawComfort(const Over& over) {
    comfort_.draw(over.room, over.wall, over.eye_m, over.seen, over.picture);
  }
  void drawMotion(const Over& over) {
    motion_.draw(over.room, over.wall, over.eye_m, over.seen, over.picture);
  }
  void drawAids(const Over& over) {
    aids_.draw(over.room, over.wall, over.isFront, over.eye_m, over.seen, over.picture);
  }
  void drawFront(const Over& over);
  void drawBoard(const Over& over) {
    if (board_) board_->draw(over.wall, over.eye_m, over.picture);
  }
  void drawCue(const Over& over) { cue_.draw(over.room, over.wall, over.eye_m, over.seen, over.picture); }
  void drawFade(const Over& over) { comfort_.fade(over.wall, over.seen, over.picture); }

  /// In the order of drawing.
  static constexpr std::array kOverlays{&WallOverlays::drawComfort, &WallOverlays::drawMotion,
                                        &WallOverlays::drawAids,    &WallOverlays::drawFront,
                                        &WallOverlays::drawBoard,   &WallOverlays::drawCue,
                                        &WallOverlays::drawFade};

  std::array<RoomGeometry, kMostViewers> rooms_;  ///< as each viewer sees it
  std::optional<Wall> front_;                     ///< the wall with the HUD panel
  std::optional<StandingBoard> board_;
  ComfortOverlay comfort_;
  HomeArrow home_;
  MotionOverlay motion_;
  RoomOverlay aids_;
  CueOverlay cue_;
  std::array<HudPanel, kMostViewers> words_;  ///< of each viewer
  ChoiceTiles choices_;
  ClassBoard class_;
  GameOffers offers_;
};

}  // namespace carom
