#include "cave/display/wall_overlays.h"

namespace carom {

void WallOverlays::setRoom(const RoomGeometry& room) {
  front_ = frontWall(room);
  if (room.panel) board_.emplace(*room.panel);
  for (std::size_t viewer = 0; viewer < room.viewers.size(); ++viewer) {
    rooms_.at(viewer) = seenBy(room, viewer);
    if (front_) words_[viewer].setWall(*front_, rooms_[viewer].viewers);
  }
}

void WallOverlays::draw(const SeenFrame& seen, const WallPictures& pictures) {
  const RoomGeometry& room = rooms_[seen.viewer];
  words_[seen.viewer].follow(seen);
  if (board_)
    drawFront(
        {room, board_->place(), true, seen.self.observer.middle.positionInRoom_m, seen, board_->wiped()});
  for (const WallPictures::FlatEye& flat : pictures.flatEyes()) {
    const Over over{room, *flat.wall,   front_ && standSame(*front_, *flat.wall), flat.eyeInRoom_m,
                    seen, *flat.picture};
    for (const auto overlay : kOverlays) (this->*overlay)(over);
  }
}

/// Draws words and choices over the picture of the front wall, or of the board in its place.
void WallOverlays::drawFront(const Over& over) {
  if (!over.isFront) return;
  words_[over.seen.viewer].draw(over.wall, over.seen, over.picture);
  choices_.draw(over.wall, over.seen, offeredIn(over.room, over.seen, offers_), over.picture);
  class_.draw(over.wall, over.seen.record.classroom, over.picture);
  if (offers_.hasTable) home_.draw(over.room, over.wall, over.eye_m, over.seen, over.picture);
}

}  // namespace carom
