#pragma once
// The state of the buttons and axes of one sensor, for `carom track`.

#include <map>
#include <set>
#include <string>

#include "devices/tracker/reading.h"

namespace carom {

class InputMonitor {
 public:
  /// Takes the reading of a button or an axis and ignores all others.
  void add(const Reading& reading);

  /// Returns a text such as "axes +0.50 +0.00, buttons 0 3": "-" stands for an axis that has sent nothing
  /// yet; only pressed buttons are listed. Empty until something has arrived.
  std::string text() const;

 private:
  std::map<int, double> axes_;
  std::set<int> pressed_;
  bool hasButtons_ = false;
};

}  // namespace carom
