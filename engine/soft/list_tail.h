#pragma once
// The end of a list that only grows.

#include <cstddef>
#include <vector>

namespace carom {

/// Brings a list back to what it was. Where its beginning is not known, something stands in its place.
template <typename Item>
struct ListTail {
  ListTail(const std::vector<Item>& all, std::size_t from)
      : first(from), items(all.begin() + static_cast<std::ptrdiff_t>(from), all.end()) {}
  void restore(std::vector<Item>& all) const {
    all.resize(first);
    all.insert(all.end(), items.begin(), items.end());
  }
  std::size_t first;
  std::vector<Item> items;
};

}  // namespace carom
