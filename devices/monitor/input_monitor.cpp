#include "devices/monitor/input_monitor.h"

#include <fmt/format.h>

#include <cmath>

namespace carom {

void InputMonitor::add(const Reading& reading) {
  if (reading.kind == Reading::Kind::axis) axes_[reading.index] = reading.value;
  if (reading.kind != Reading::Kind::button) return;
  hasButtons_ = true;
  if (reading.value != 0.0) {
    pressed_.insert(reading.index);
  } else {
    pressed_.erase(reading.index);
  }
}

std::string InputMonitor::text() const {
  std::string text;
  if (!axes_.empty()) {
    text += "axes";
    int next = 0;
    for (const auto& [index, value] : axes_) {
      for (; next < index; ++next) text += " -";
      text += fmt::format(" {:+.2f}", std::round(100.0 * value) / 100.0 + 0.0);  // never "-0.00"
      next = index + 1;
    }
  }
  if (!hasButtons_) return text;
  if (!text.empty()) text += ", ";
  if (pressed_.empty()) return text + "no button";
  return text + fmt::format("buttons {}", fmt::join(pressed_, " "));
}

}  // namespace carom
