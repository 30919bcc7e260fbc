#include "engine/spacetime/knot_store.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace carom {

KnotStore::~KnotStore() { freePages(); }

KnotStore::KnotStore(const KnotStore& other)
    : rests_(other.rests_), rest_(other.rest_), origin_(other.origin_) {
  copyRows(other);
}

KnotStore::KnotStore(KnotStore&& other) noexcept
    : last_(other.last_),
      first_(other.first_),
      size_(std::exchange(other.size_, 0)),
      pages_(std::move(other.pages_)),
      rests_(std::move(other.rests_)),
      rest_(other.rest_),
      origin_(other.origin_) {}

KnotStore& KnotStore::operator=(const KnotStore& other) {
  if (this == &other) return *this;
  rests_ = other.rests_;
  rest_ = other.rest_;
  origin_ = other.origin_;
  copyRows(other);
  return *this;
}

// The knots stay in the memory that they lie in.
KnotStore& KnotStore::operator=(KnotStore&& other) {
  if (pages_.get_allocator() != other.pages_.get_allocator()) return *this = other;
  std::swap(last_, other.last_);
  std::swap(first_, other.first_), std::swap(size_, other.size_);
  pages_.swap(other.pages_), rests_.swap(other.rests_);
  rest_ = other.rest_;
  origin_ = other.origin_;
  return *this;
}

void KnotStore::push_back(const Knot& knot, const Settling& settling) {
  const Rest rest = restOf(knot);
  if (rests_.empty() && std::memcmp(&rest, &rest_, sizeof(Rest)) != 0) rests_.assign(size_, rest_);
  if (!rests_.empty()) rests_.push_back(rest);
  ++size_;
  if (size_ == 1 || end() % kRows == 0) {
    makePages();
    noteLast();
  } else {
    ++last_;  // without a look at the pages
  }
  *last_ = {planeOf(knot), settling};
}

void KnotStore::keepFirst(std::size_t count) {
  if (count >= size_) return;
  size_ = static_cast<std::uint32_t>(std::max<std::size_t>(1, count));
  if (!rests_.empty()) rests_.resize(size_);
  noteLast();
}

void KnotStore::dropFirst(std::size_t count) {
  if (!rests_.empty()) rests_.erase(rests_.begin(), rests_.begin() + static_cast<std::ptrdiff_t>(count));
  const std::size_t first = first_ + count;
  std::rotate(pages_.begin(), pages_.begin() + static_cast<std::ptrdiff_t>(first / kRows), pages_.end());
  first_ = static_cast<std::uint32_t>(first % kRows);
  size_ -= static_cast<std::uint32_t>(count);
}

void KnotStore::copyRows(const KnotStore& other) {
  first_ = other.first_;
  size_ = other.size_;
  makePages();
  for (std::size_t page = 0; page <= end() / kRows; ++page) *pages_[page] = *other.pages_[page];
  noteLast();
}

void KnotStore::makePages() {
  constexpr std::size_t kFewest = 4;
  std::pmr::polymorphic_allocator<> memory(pages_.get_allocator().resource());
  while (pages_.size() <= end() / kRows) {
    if (pages_.size() == pages_.capacity()) pages_.reserve(std::max(kFewest, 2 * pages_.size()));
    pages_.push_back(memory.new_object<Page>());
  }
}

void KnotStore::freePages() {
  std::pmr::polymorphic_allocator<> memory(pages_.get_allocator().resource());
  for (Page* const page : pages_) memory.delete_object(page);
  pages_.clear();
}

}  // namespace carom
