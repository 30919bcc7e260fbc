#pragma once
// The pointer over a window from frame to frame: no press is lost, however short it is and however long a
// frame takes. A frame takes at most one change of a button, at the place where it happened. A button that is
// let go elsewhere than where it was pressed is let go in the frame after the one that brought the pointer
// there, so that marks drawn with it are seen as drawn.

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

class PointerQueue {
 public:
  enum class Button { left, right };

  void move(const glm::dvec2& at) {
    if (!events_.empty() && events_.back().isMove) {  // only the latest place counts
      events_.back().at = at;
    } else {
      events_.push_back({at, Button::left, false, true});
    }
  }
  void change(Button button, bool down, const glm::dvec2& at) {
    if (events_.size() >= kMostEvents) discard();  // they are not asked for
    events_.push_back({at, button, down, false});
  }

  /// Begins a frame.
  void beginFrame() {
    std::size_t taken = 0;
    bool moved = false;
    for (; taken < events_.size(); ++taken) {
      const Event& event = events_[taken];
      if (!event.isMove && !event.down && moved) break;
      take(event);
      moved = moved || event.isMove;
      if (event.isMove) continue;
      ++taken;
      break;
    }
    events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(taken));
  }

  /// Forgets what has not been taken yet; buttons are as they were left.
  void discard() {
    for (const Event& event : events_) take(event);
    events_.clear();
  }

  const glm::dvec2& at() const { return at_; }
  bool isDown(Button button) const { return button == Button::left ? left_ : right_; }

 private:
  static constexpr std::size_t kMostEvents = 64;
  struct Event {
    glm::dvec2 at;
    Button button;
    bool down, isMove;
  };

  void take(const Event& event) {
    at_ = event.at;
    if (!event.isMove) (event.button == Button::left ? left_ : right_) = event.down;
  }

  std::vector<Event> events_;
  glm::dvec2 at_{0.0};
  bool left_ = false, right_ = false;
};

}  // namespace carom
