#include "cave/display/display_walls.h"

#include <imgui.h>

#include <utility>

#include "cave/gl/gui.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"

namespace carom {

DisplayWalls::DisplayWalls(Graphics& graphics, const Scene& scene, double lightSpeed_m_s,
                           std::vector<Wall> walls, const std::optional<WindowPlacement>& oneWindow,
                           bool visible)
    : graphics_(graphics),
      pictures_(graphics, scene, lightSpeed_m_s,
                placedIn(visible ? oneWindow : std::nullopt, std::move(walls))),
      windows_(graphics, pictures_, visible, oneWindow.has_value()) {
  overlays_.setScene(scene);
}

void DisplayWalls::setScene(const Scene& scene, double lightSpeed_m_s) {
  pictures_.setScene(scene, lightSpeed_m_s);
  overlays_.setScene(scene);
}

void DisplayWalls::setRoom(const RoomGeometry& room) {
  graphics_.makeCurrent();
  overlays_.setRoom(room);
}

void DisplayWalls::sayStarting() {
  show([] { overCorner("##starting", [] { ImGui::TextUnformatted(texts::message::kStarting); }); });
  awaitShown();
  swap();
}

void DisplayWalls::draw(const FrameRecord& record, const World& world) {
  pictures_.hangOnHead(record.headset);
  drawn_ = record.controls;
  const texts::InLanguage reads(texts::ofSession(record.viewers.front().language));
  if (drawn_.blank) return pictures_.drawBlack();
  switch (drawn_.shown) {
    case Shown::session:
      return drawSession(record, world);
    case Shown::calibrationPattern:
      return pictures_.drawCalibrationPatterns(drawn_.eyesSwapped != 0);
    case Shown::alignmentPattern:
      return pictures_.drawSeams(record.display_s);
  }
}

void DisplayWalls::drawSession(const FrameRecord& record, const World& world) {
  for (std::size_t viewer = 0; viewer < record.viewerCount; ++viewer) {
    ViewerState state = record.viewers[viewer];
    if (drawn_.eyesSwapped) std::swap(state.observer.left, state.observer.right);
    const SeenFrame seen(record, viewer, state);
    const texts::InLanguage reads(texts::ofSession(state.language));
    pictures_.drawSession(seen, world);
    graphics_.makeCurrent();
    overlays_.draw(seen, pictures_);
    pictures_.drawScreens(seen);
  }
}

std::array<unsigned, 2> DisplayWalls::onHead() const {
  return {pictures_.eyes()[0].pictures.drawn().texture(), pictures_.eyes()[1].pictures.drawn().texture()};
}

const RenderTarget* DisplayWalls::pictureOf(const std::string& wall, int piece) const {
  const StandingBoard* const board = overlays_.board();
  return board && board->place().name == wall ? &board->written() : pictures_.pictureOf(wall, piece);
}

std::optional<PointedWall> DisplayWalls::pointedAt() const {
  if (drawn_.blank || drawn_.shown != Shown::session) return std::nullopt;
  return windows_.pointedAt(drawn_.eyesSwapped != 0);
}

}  // namespace carom
