#pragma once
// A priority queue of numbered items. Each item has a time at which it is due; that time can be changed.
// Items with equal times come out in the order of their numbers.
//
// The soonest are a short sorted list, so that one can look ahead. Further items due today are in a four-way
// heap. Four siblings fill one cache line, and the least of them is found without a branch. Where there are
// many items, those due later are only listed under their day: a calendar (R. Brown, 1988, Calendar queues).
// When the soonest become few, the next day's items are sorted and follow them; only an item that is due that
// day and is given its time afterwards goes through the heap. An item that is given another time stays on the
// list of its old day, and is left out there when that day comes. When the calendar ends, a new one begins,
// for which all items are looked through once.

#include <algorithm>
#include <array>
#include <limits>
#include <vector>
#include "engine/base/large_pages.h"
#include "engine/base/never.h"
#include "engine/base/prefetch.h"

namespace carom {

class DueQueue {
 public:
  DueQueue() = default;
  /// Makes a queue of `items` items; at first none is ever due.
  explicit DueQueue(int items)
      : lastDay_(std::max(kFewestDays, items / kADay) - 1),
        today_(lastDay_),
        days_(items <= kFew ? 0 : lastDay_ + 1),
        items_(items) {
    if (items > kFew) begins_ = -kLatest, perDay_ = 1.0;  // at the end of a calendar
  }

  /// Returns the time at which the next item is due; infinity if none ever is.
  double firstDue() {
    fillSoon();
    return begin_ == end_ ? kNever : soon_[begin_].due;
  }
  /// Returns the next item. At least one item must be due.
  int first() {
    fillSoon();
    return soon_[begin_].item;
  }
  double due(int item) const { return items_[item].due; }
  /// Visits those of the next `count` items that this one of kStages stages has not visited since they came
  /// among the soonest. An item that is given a time among those visited is not visited again.
  template <class Visit>
  void lookAhead(int stage, int count, Visit visit) {
    const int from = std::max(seen_[stage], begin_), to = std::max(from, std::min(begin_ + count, end_));
    seen_[stage] = to;
    for (int k = from; k < to; ++k) visit(soon_[k].item);
  }
  static constexpr int kStages = 2;
  static constexpr int kSoon = 16;  // after `first`, fewer are known only where the calendar ends
  static constexpr int kMostSoon = 128;
  /// Prefetches an item's time from memory.
  void fetch(int item) const { prefetch(&items_[item]); }

  void setDue(int item, double time) {
    Item& own = items_[item];
    if (time == own.due) return;
    const Entry before{own.due, item}, now{time, item};
    own.due = time;
    if (isSoon(before)) takeSoonOut(before);
    const int slot = own.slot;
    if (isSoon(now)) {
      if (slot != kNone) takeOut(slot);
      insertSoon(now);
    } else if (const int day = dayOf(time); day > today_) {
      if (slot != kNone) takeOut(slot);
      if (day <= lastDay_) days_[day].push_back(item);
    } else {
      place(slot != kNone ? slot : newSlot(), now);
    }
  }

 private:
  static constexpr double kLatest = std::numeric_limits<double>::max();
  static constexpr int kNone = -1;
  static constexpr int kFew = 256;                     // items, all in the heap
  static constexpr int kFewestDays = 256, kADay = 64;  // the usual number of items due on each

  struct Item {
    double due = kNever;
    int slot = kNone;  // in the heap
  };
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

  // Whether an entry belongs among the soonest: before the last of them.
  bool isSoon(const Entry& entry) const { return begin_ < end_ && !(soon_[end_ - 1] < entry); }
  void fillSoon() {
    while (end_ - begin_ < kSoon) {
      if (size_ > 0) {
        makeRoom();
        soon_[end_++] = at(0);
        takeOut(0);
      } else if (!openDay()) {
        return;
      }
    }
  }
  void makeRoom() {
    if (end_ < static_cast<int>(soon_.size())) return;
    std::copy(soon_.begin() + begin_, soon_.end(), soon_.begin());
    for (int& seen : seen_) seen -= begin_;
    end_ -= begin_;
    begin_ = 0;
  }
  void insertSoon(const Entry& entry) {
    if (end_ - begin_ == kMostSoon) moveLastSoon();
    makeRoom();
    int k = end_++;
    for (; k > begin_ && entry < soon_[k - 1]; --k) soon_[k] = soon_[k - 1];
    soon_[k] = entry;
    for (int& seen : seen_) seen += k < seen ? 1 : 0;
  }
  void moveLastSoon() {
    place(newSlot(), soon_[--end_]);
    for (int& seen : seen_) seen = std::min(seen, end_);
  }
  void takeSoonOut(const Entry& entry) {
    int k = begin_;
    while (soon_[k].item != entry.item) ++k;
    if (k == begin_) {
      ++begin_;
    } else {
      std::copy(soon_.begin() + k + 1, soon_.begin() + end_--, soon_.begin() + k);
      for (int& seen : seen_) seen -= k < seen ? 1 : 0;
    }
  }

  // The heap holds items due up to this day. An item due after the calendar's end has the day after the last,
  // what is never due a day after that.
  int dayOf(double time) const {
    if (time == kNever) return lastDay_ + 2;
    return static_cast<int>(std::clamp((time - begins_) * perDay_, 0.0, lastDay_ + 1.0));
  }
  // Adds the items of the next day to the soonest, behind which nothing is in the heap. Returns whether there
  // is such a day: not after the last of a calendar while something is due before, nor where nothing is due.
  bool openDay() {
    if (days_.empty() || (today_ == lastDay_ && (begin_ < end_ || !beginCalendar()))) return false;
    constexpr std::size_t kAhead = 16;
    std::vector<int>& listed = days_[++today_];
    opened_.clear();
    for (std::size_t k = 0; k < listed.size(); ++k) {
      fetch(listed[std::min(k + kAhead, listed.size() - 1)]);
      const Entry entry{items_[listed[k]].due, listed[k]};
      if (dayOf(entry.due) == today_) opened_.push_back(entry);
    }
    listed.clear();
    std::sort(opened_.begin(), opened_.end());
    int before = kNone;  // an item can have been listed twice
    for (const Entry& entry : opened_) {
      if (entry.item != before) addLast(entry);
      before = entry.item;
    }
    return true;
  }
  // Adds an item that is due after all of the soonest and of the heap.
  void addLast(const Entry& entry) {
    if (end_ - begin_ >= kMostSoon) return place(newSlot(), entry);
    makeRoom();
    soon_[end_++] = entry;
  }
  // Begins a calendar with the first item due. A sample of the items tells how long a day is. Returns whether
  // there is such an item.
  bool beginCalendar() {
    constexpr std::size_t kSample = 512, kShare = 4;
    std::array<double, kSample> sample;
    for (std::size_t k = 0; k < kSample; ++k) sample[k] = items_[k * items_.size() / kSample].due;
    std::nth_element(sample.begin(), sample.begin() + kSample / kShare, sample.end());
    begins_ = kNever;
    for (const Item& item : items_) begins_ = std::min(begins_, item.due);
    if (begins_ == kNever) return begins_ = -kLatest, perDay_ = 1.0, false;
    const double days = static_cast<double>(items_.size()) / (kShare * kADay);
    perDay_ = std::min(days / (sample[kSample / kShare] - begins_), kLatest);
    today_ = -1;
    for (int item = 0; item < static_cast<int>(items_.size()); ++item) {
      if (const int day = dayOf(items_[item].due); day <= lastDay_) days_[day].push_back(item);
    }
    return true;
  }
  int newSlot() {
    const auto families = static_cast<std::size_t>(size_ + 3) / 4 + 1;
    if (families_.size() < families) families_.resize(families);
    return size_++;
  }
  void takeOut(int slot) {
    items_[at(slot).item].slot = kNone;
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
    items_[entry.item].slot = slot;
  }

  int lastDay_ = kFewestDays - 1;  // of a calendar of days of equal length
  int today_ = lastDay_;
  double begins_ = 0.0, perDay_ = 0.0;
  std::vector<std::vector<int>>
      days_;                   // the items that have been given a time on each; no days for few items
  std::vector<Entry> opened_;  // scratch
  std::array<Entry, 2 * kMostSoon>
      soon_;  // the places from begin_ to end_: all that are due before the heap's
  int begin_ = 0, end_ = 0;
  std::array<int, kStages> seen_{};  // places of the first that the stages of `lookAhead` have not visited
  int size_ = 0;                     // of the heap
  std::vector<Family> families_;
  LargeArray<Item> items_;
};

}  // namespace carom
