#pragma once
// A box for one value between two threads: one posts, the other looks. The newest value wins;
// neither waits for the other. Three copies: one is written, one is read, and one lies between them.

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace carom {

template <typename Value>
class ForceMailbox {
  static_assert(std::is_trivially_copyable_v<Value>);

 public:
  /// Posts a value. On one thread alone.
  void post(const Value& value) {
    copies_[writing_] = value;
    writing_ = between_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kIndex;
  }

  /// Returns the newest value, which stays until the next look. On one thread alone.
  const Value& look() {
    if (between_.load(std::memory_order_relaxed) & kNew)
      reading_ = between_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return copies_[reading_];
  }

 private:
  static constexpr std::uint32_t kIndex = 3, kNew = 4;

  std::array<Value, 3> copies_{};
  std::uint32_t writing_ = 0, reading_ = 1;
  std::atomic<std::uint32_t> between_{2};
};

}  // namespace carom
