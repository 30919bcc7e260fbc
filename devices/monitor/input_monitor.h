#pragma once
// Where the buttons and axes of one sensor stand: for `carom track`.

#include <map>
#include <set>
#include <string>

#include "devices/tracker/reading.h"

namespace carom {

class InputMonitor {
 public:
  /// Of a button or an axis; other readings say nothing here.
  void add(const Reading& reading);

  /// "axes +0.50 +0.00, buttons 0 3": an axis that has not come is "-", buttons are those that are pressed.
  /// Empty until something has come.
  std::string text() const;

 private:
  std::map<int, double> axes_;
  std::set<int> pressed_;
  bool hasButtons_ = false;
};

}  // namespace carom
