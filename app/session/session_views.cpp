#include "app/session/session_views.h"

#include "app/input/key_table.h"
#include "cave/gl/gui.h"
#include "cave/overlay/latency_overlay.h"
#include "cave/texts/language.h"
#include "cave/texts/texts.h"

namespace carom {

void WallsView::draw(const FrameRecord& record, const World& world) {
  walls_.draw(record, world);
  const LatencyView* latency = statistics_.view(record);
  if (latency || director_.settings().keysShown || hasConsoleTile_) {
    walls_.show([this, latency] { drawOver(latency); });
  } else {
    walls_.show();
  }
}

void WallsView::drawOver(const LatencyView* latency) {
  const texts::InLanguage reads(texts::ofSession(director_.settings().languageOf[0]));
  if (latency) drawLatency(*latency, walls_.drawingTimes());
  const bool closes =
      director_.settings().keysShown && isKeySheetPressed(keys_.in(director_.settings().languageOf[0]));
  if (closes && pressed_) pressed_->emplace_back(ShowKeys{false});
  if (hasConsoleTile_ && isTilePressed(texts::console::kShow)) pressed_->emplace_back(ShowConsole{true});
}

void DrawingEnd::draw(const FrameRecord&, const World&) {
  statistics_.mark(FramePart::submit);
  if (!realTime_) return;
  walls_.awaitShown();
  statistics_.mark(FramePart::draw);
}

}  // namespace carom
