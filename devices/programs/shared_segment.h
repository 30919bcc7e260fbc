#pragma once
// A segment of System V shared memory that another program writes.

#include <cstdint>
#include <span>

namespace carom {

class SharedSegment {
 public:
  /// Attaches the segment of that key, to read. Throws std::runtime_error if there is none, and NeedsHelp
  /// (devices/tracker/retry.h) if it may not be read.
  explicit SharedSegment(int key);
  SharedSegment(const SharedSegment&) = delete;
  SharedSegment& operator=(const SharedSegment&) = delete;
  ~SharedSegment();

  /// Returns all of it. It stays as long as this object, also when it is removed; its bytes change at any
  /// time.
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  /// Returns whether the segment was removed, or another one has its key now.
  bool isGone() const;
  /// Returns whether no other program has it attached.
  bool isOurs() const;

 private:
  int key_, id_;
  std::span<const std::uint8_t> bytes_;
};

}  // namespace carom
