#pragma once
// A priority queue of numbered items. Each item has a time at which it is due; that time can be changed.
// Items with equal times come out in the order of their numbers.
//
// Items that are due before a horizon are in a four-way heap. Four siblings fill one cache line, and the
// least of them is found without a branch. Where there are many items, most lie beyond the horizon and are
// only noted, so that the heap stays in the cache. When the heap is empty, the horizon moves on and all items
// are looked through once.

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace carom {

class DueQueue {
 public:
  DueQueue() = default;
  /// Makes a queue of `items` items, none of which is ever due at first.
  explicit DueQueue(int items)
      : horizon_(items <= kHeap ? kLatest : -kNever), due_(items, kNever), place_(items, kNone) {}

  /// Returns the time at which the next item is due; infinity if none ever is.
  double firstDue() {
    if (size_ == 0) moveHorizon();
    return size_ == 0 ? kNever : top().due;
  }
  /// Returns the next item. At least one item must be due.
  int first() {
    if (size_ == 0) moveHorizon();
    return top().item;
  }
  double due(int item) const { return due_[item]; }
  /// Returns item number `k` (from 1) of those due soon after the first, roughly in their order; -1 if there
  /// is none.
  int soon(int k) const { return k < size_ ? at(k).item : kNone; }

  void setDue(int item, double time) {
    if (time == due_[item]) return;
    due_[item] = time;
    const int slot = place_[item];
    if (time > horizon_) {
      if (slot != kNone) takeOut(slot);
    } else {
      place(slot != kNone ? slot : newSlot(), {time, item});
    }
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kLatest = std::numeric_limits<double>::max();
  static constexpr int kNone = -1;
  static constexpr int kHeap = 4096;  // about so many items in the heap at once: 64 KiB

  struct Entry {
    double due = kNever;
    int item = std::numeric_limits<int>::max();
    bool operator<(const Entry& other) const {
      return (due < other.due) | ((due == other.due) & (item < other.item));
    }
  };
  // Slots 4 p + 1 to 4 p + 4 are the children of slot p; slot 0 is in the first family. Entries of free slots
  // are never due.
  struct alignas(64) Family {
    std::array<Entry, 4> entries;
  };
  Entry& at(unsigned slot) { return families_[(slot + 3) / 4].entries[(slot + 3) % 4]; }
  const Entry& at(unsigned slot) const { return families_[(slot + 3) / 4].entries[(slot + 3) % 4]; }

  const Entry& top() const { return families_[0].entries[3]; }

  // Moves the horizon to where about kHeap items lie before it, as a sample of the items tells.
  void moveHorizon() {
    constexpr std::size_t kSample = 512;
    if (due_.size() <= kHeap) return;
    std::array<double, kSample> sample;
    for (std::size_t k = 0; k < kSample; ++k) sample[k] = due_[k * due_.size() / kSample];
    const auto quantile = sample.begin() + kSample * kHeap / due_.size();
    std::nth_element(sample.begin(), quantile, sample.end());
    horizon_ = std::min(*quantile, kLatest);
    for (int item = 0; item < static_cast<int>(due_.size()); ++item) {
      if (due_[item] <= horizon_) place(newSlot(), {due_[item], item});
    }
  }
  int newSlot() {
    const auto families = static_cast<std::size_t>(size_ + 3) / 4 + 1;
    if (families_.size() < families) families_.resize(families);
    return size_++;
  }
  void takeOut(int slot) {
    place_[at(slot).item] = kNone;
    const Entry last = at(--size_);
    at(size_) = {};
    if (slot != size_) place(slot, last);
  }
  // Puts the entry where it belongs, beginning at a slot whose own entry it replaces.
  void place(int slot, const Entry& entry) {
    if (slot > 0 && entry < at((slot - 1) / 4)) {
      rise(slot, entry);
    } else {
      sink(slot, entry);
    }
  }
  void rise(int slot, const Entry& entry) {
    while (slot > 0) {
      const int parent = (slot - 1) / 4;
      if (!(entry < at(parent))) break;
      put(slot, at(parent));
      slot = parent;
    }
    put(slot, entry);
  }
  void sink(int slot, const Entry& entry) {
    while (4 * slot + 1 < size_) {
      const std::array<Entry, 4>& children = families_[slot + 1].entries;
      const int low = children[1] < children[0] ? 1 : 0, high = children[3] < children[2] ? 3 : 2;
      const int least = children[high] < children[low] ? high : low;
      if (!(children[least] < entry)) break;
      put(slot, children[least]);
      slot = 4 * slot + 1 + least;
    }
    put(slot, entry);
  }
  void put(int slot, const Entry& entry) {
    at(slot) = entry;
    place_[entry.item] = slot;
  }

  double horizon_ = 0.0;
  int size_ = 0;  // of the heap
  std::vector<Family> families_;
  std::vector<double> due_;  // by item
  std::vector<int> place_;   // its slot
};

}  // namespace carom
