#pragma once
// A device that takes one session at a time but cannot refuse a second, such as one behind a server: the
// sessions of one computer agree about it among themselves. Those of others do not know of each other.

#include <string>

namespace carom {

class OnlySession {
 public:
  /// Claims the device until this object, or the process, ends. Throws NeedsHelp (devices/tracker/retry.h) if
  /// another session of this computer has it.
  explicit OnlySession(const std::string& device);
  OnlySession(const OnlySession&) = delete;
  OnlySession& operator=(const OnlySession&) = delete;
  ~OnlySession();

 private:
  int descriptor_;
};

}  // namespace carom
