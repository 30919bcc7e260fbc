#pragma once
// The memory of a world line: its knots, and when the points of the body join their legs.
//
// The knots lie in pages of four, so that none is moved when more are added and a line has room for three
// more at most. Heights, friction and spin mostly are those of the line's first knot throughout; they are
// kept for every knot only once one of them differs. A knot of a disc that does not spin takes 96 bytes
// instead of 136 and 32 for its settling.

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory_resource>
#include <vector>

#include "engine/base/prefetch.h"
#include "engine/spacetime/knot.h"

namespace carom {

/// When all points within the body's radius have joined a leg.
struct Settling {
  double after_s = 0.0;    ///< at most so long after the leg's turn, by the centre's own clock
  double reach_m = 0.0;    ///< how far from the centre a point can be until then, in the leg's rest frame
  bool beforeNext = true;  ///< whether they had when the signal that ends the leg was made
};

class KnotStore {
 public:
  /// Begins with a line's first knot. The others lie in `memory`; those of a copy in the default one.
  KnotStore(const Knot& origin, const Settling& settling, std::pmr::memory_resource* memory)
      : pages_(memory), rests_(memory), rest_(restOf(origin)), origin_(planeOf(origin)) {
    push_back(origin, settling);
  }
  ~KnotStore();
  KnotStore(const KnotStore& other);
  KnotStore(KnotStore&& other) noexcept;
  KnotStore& operator=(const KnotStore& other);
  KnotStore& operator=(KnotStore&& other);

  std::size_t size() const { return size_; }
  Knot operator[](std::size_t i) const { return knotOf(rowAt(i).plane, rests_.empty() ? rest_ : rests_[i]); }
  Knot back() const { return knotOf(last_->plane, rests_.empty() ? rest_ : rests_.back()); }
  /// Returns the time of a knot's turn.
  double turn_s(std::size_t i) const { return rowAt(i).plane.turn_t; }
  /// Returns the knot with which the line was made.
  Knot origin() const { return knotOf(origin_, rest_); }

  void push_back(const Knot& knot, const Settling& settling);
  /// Keeps the first `count` knots, at least one.
  void keepFirst(std::size_t count);
  /// Removes the first `count` knots, not all. Their pages are kept for knots to come.
  void dropFirst(std::size_t count);

  const Settling& settling(std::size_t i) const { return rowAt(i).settling; }
  Settling& lastSettling() { return last_->settling; }

  /// Prefetches from memory what `fetchEnd` reads; `fetchEnd` what `back` and `push_back` read and write.
  void fetch() const { prefetch(this, sizeof(KnotStore) - sizeof(origin_)); }
  void fetchEnd() const { prefetch(last_, 2 * sizeof(Row)); }

 private:
  static constexpr std::size_t kRows = 4;
  // Of a knot: what differs from leg to leg of a disc on the board.
  struct Plane {
    double turn_t, turn_x, turn_y;
    double u_x, u_y;
    double properTime;
    double signal_t, signal_x, signal_y;
  };
  // The rest of it.
  struct Rest {
    double turn_z, u_z, signal_z;
    double deceleration;
    Spin spin;
  };
  struct Row {
    Plane plane;
    Settling settling;
  };
  using Page = std::array<Row, kRows>;

  static Plane planeOf(const Knot& k) {
    return {k.turn.t_s,     k.turn.r_m.x, k.turn.r_m.y,   k.u.x,         k.u.y,
            k.properTime_s, k.signal.t_s, k.signal.r_m.x, k.signal.r_m.y};
  }
  static Rest restOf(const Knot& k) {
    return {k.turn.r_m.z, k.u.z, k.signal.r_m.z, k.deceleration_m_s2, k.spin};
  }
  static Knot knotOf(const Plane& p, const Rest& r) {
    return {{p.turn_t, {p.turn_x, p.turn_y, r.turn_z}},         {p.u_x, p.u_y, r.u_z}, p.properTime,
            {p.signal_t, {p.signal_x, p.signal_y, r.signal_z}}, r.deceleration,        r.spin};
  }
  const Row& rowAt(std::size_t i) const { return (*pages_[(first_ + i) / kRows])[(first_ + i) % kRows]; }
  // The place of the last row, counted from the beginning of the first page.
  std::size_t end() const { return first_ + size_ - 1; }
  void noteLast() { last_ = &(*pages_[end() / kRows])[end() % kRows]; }
  void copyRows(const KnotStore& other);
  void makePages();  // for all rows
  void freePages();

  Row* last_ = nullptr;
  std::uint32_t first_ = 0;  // place of the first row in the first page
  std::uint32_t size_ = 0;
  std::pmr::vector<Page*> pages_;  // those behind the last row's are free
  std::pmr::vector<Rest> rests_;   // of every knot; none while all have that of the first
  Rest rest_;                      // of the first
  Plane origin_;
};

/// The knots of a line, or those from one of them on, as values: a container for reading. Holds until the
/// line changes.
class Knots {
 public:
  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = Knot;
    using difference_type = std::ptrdiff_t;
    using reference = Knot;
    struct pointer {
      Knot knot;
      const Knot* operator->() const { return &knot; }
    };

    Iterator() = default;
    Iterator(const KnotStore* store, std::ptrdiff_t at) : store_(store), at_(at) {}
    Knot operator*() const { return (*store_)[static_cast<std::size_t>(at_)]; }
    pointer operator->() const { return {**this}; }
    Knot operator[](std::ptrdiff_t n) const { return *(*this + n); }
    Iterator& operator+=(std::ptrdiff_t n) { return at_ += n, *this; }
    Iterator& operator-=(std::ptrdiff_t n) { return at_ -= n, *this; }
    Iterator& operator++() { return ++at_, *this; }
    Iterator& operator--() { return --at_, *this; }
    Iterator operator++(int) { return {store_, at_++}; }
    Iterator operator--(int) { return {store_, at_--}; }
    friend Iterator operator+(Iterator it, std::ptrdiff_t n) { return it += n; }
    friend Iterator operator+(std::ptrdiff_t n, Iterator it) { return it += n; }
    friend Iterator operator-(Iterator it, std::ptrdiff_t n) { return it -= n; }
    friend std::ptrdiff_t operator-(const Iterator& a, const Iterator& b) { return a.at_ - b.at_; }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }
    auto operator<=>(const Iterator& other) const { return at_ <=> other.at_; }

   private:
    const KnotStore* store_ = nullptr;
    std::ptrdiff_t at_ = 0;
  };

  explicit Knots(const KnotStore& store, std::size_t from = 0) : store_(&store), from_(from) {}
  std::size_t size() const { return store_->size() - from_; }
  bool empty() const { return size() == 0; }
  Knot operator[](std::size_t i) const { return (*store_)[from_ + i]; }
  Knot front() const { return (*this)[0]; }
  Knot back() const { return store_->back(); }
  Iterator begin() const { return {store_, static_cast<std::ptrdiff_t>(from_)}; }
  Iterator end() const { return {store_, static_cast<std::ptrdiff_t>(store_->size())}; }
  Knots subspan(std::size_t from) const { return Knots(*store_, from_ + from); }

 private:
  const KnotStore* store_;
  std::size_t from_;
};

}  // namespace carom
