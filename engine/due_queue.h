#pragma once
// A priority queue of numbered items, each with the time at which it is due: a four-way heap in which an
// item's time can be changed. Equal times come out in the order of the numbers.

#include <limits>
#include <vector>

namespace carom {

class DueQueue {
 public:
  DueQueue() = default;
  explicit DueQueue(int items) : slots_(items), place_(items) {
    for (int i = 0; i < items; ++i) slots_[i] = {std::numeric_limits<double>::infinity(), i}, place_[i] = i;
  }

  int first() const { return slots_.front().item; }
  double firstDue() const { return slots_.front().due; }
  double due(int item) const { return slots_[place_[item]].due; }

  void setDue(int item, double time) {
    const int slot = place_[item];
    if (time == slots_[slot].due) return;
    const Entry entry{time, item};
    if (entry < slots_[slot]) {
      rise(slot, entry);
    } else {
      sink(slot, entry);
    }
  }

 private:
  struct Entry {
    double due;
    int item;
    bool operator<(const Entry& other) const {
      return due < other.due || (due == other.due && item < other.item);
    }
  };
  void rise(int slot, const Entry& entry) {
    while (slot > 0) {
      const int parent = (slot - 1) / 4;
      if (!(entry < slots_[parent])) break;
      put(slot, slots_[parent]);
      slot = parent;
    }
    put(slot, entry);
  }
  void sink(int slot, const Entry& entry) {
    const int size = static_cast<int>(slots_.size());
    while (true) {
      const int begin = 4 * slot + 1;
      if (begin >= size) break;
      int least = begin;
      for (int child = begin + 1; child < begin + 4 && child < size; ++child) {
        if (slots_[child] < slots_[least]) least = child;
      }
      if (!(slots_[least] < entry)) break;
      put(slot, slots_[least]);
      slot = least;
    }
    put(slot, entry);
  }
  void put(int slot, const Entry& entry) {
    slots_[slot] = entry;
    place_[entry.item] = slot;
  }

  std::vector<Entry> slots_;
  std::vector<int> place_;
};

}  // namespace carom
