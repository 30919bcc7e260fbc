#include "cave/record/frame_digest.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <type_traits>

#include "cave/record/record_fields.h"
#include "engine/base/xxh3.h"

namespace carom {
namespace {

/// Digests the numbers of fields one after the other.
class Digest : public FieldVisitor {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T> Digest& operator<<(const T& value) {
    digest_ = XXH3_64bits_withSeed(&value, sizeof value, digest_);
    return *this;
  }
  template <typename Part>
  requires(!std::is_arithmetic_v<Part>) Digest& operator<<(const Part& part) {
    visit(part, *this);
    return *this;
  }

  template <typename T>
  requires std::is_arithmetic_v<T>
  void operator()(const char*, T value, const FieldKind&) { *this << value; }
  template <typename Choice>
  requires std::is_enum_v<Choice>
  void operator()(const char*, Choice value, const FieldKind&) { *this << static_cast<int>(value); }
  template <typename Choice>
  void operator()(const char*, const std::optional<Choice>& value, const FieldKind&) {
    *this << (value ? static_cast<int>(*value) : -1);
  }
  template <Compound Value>
  void operator()(const char*, const Value& value, const FieldKind& kind) {
    eachNumber(value, kind, [this](const char*, double number) { *this << number; });
  }
  template <std::size_t bytes>
  void operator()(const char*, const ShortText<bytes>& words, const FieldKind&) {
    digest_ = XXH3_64bits_withSeed(words.text.data(), words.text.size(), digest_);
  }
  template <typename Flags, typename Row, std::size_t rows>
  void operator()(const char*, const Flags& flags, const std::array<Row, rows>& named) {
    for (const Row& row : named) *this << flags.*row.value;
  }
  void turns(const Turns& turns) {
    *this << turns.size();
    for (const Turn& turn : turns) {
      visit(turn, *this);
      visitSpin(turn, *this);
    }
  }

  operator std::uint64_t() const { return digest_; }

 private:
  std::uint64_t digest_ = 0;
};

constexpr std::size_t kSections = static_cast<std::size_t>(FrameSection::events) + 1;

/// Digests each section of a record by itself.
class SectionDigests : public FieldVisitor {
 public:
  void section(FrameSection section) { current_ = &of(section); }
  Digest& of(FrameSection section) { return all_[static_cast<std::size_t>(section)]; }
  const std::array<Digest, kSections>& all() const { return all_; }

  template <typename Value, typename Kind>
  void operator()(const char* name, const Value& value, const Kind& kind) {
    (*current_)(name, value, kind);
  }

 private:
  std::array<Digest, kSections> all_;
  Digest* current_ = all_.data();
};

/// Digests the newest knots and their numbers: once a history has lost or gained a knot, its digest stays
/// different.
std::uint64_t digestOfNewest(std::span<const WorldLine> histories) {
  Digest digest;
  for (const WorldLine& history : histories) digest << history.knots().size() << history.knots().back();
  return digest;
}

/// Does the same for the list of events.
std::uint64_t digestOfNewest(std::span<const GameEvent> events) {
  Digest digest;
  digest << events.size();
  if (!events.empty()) digest << events.front().number << events.back();
  return digest;
}

template <typename T>
std::uint64_t digestOfBytes(std::span<const T> list, std::uint64_t before) {
  return XXH3_64bits_withSeed(list.data(), list.size_bytes(), before);
}

/// Digests the new rows and the new moments of people of another room, and of each soft body the number of
/// its rows and the nodes of the last one.
std::uint64_t digestOfRows(const FrameState& state, const World& world) {
  std::uint64_t digest = digestOfBytes(std::span(state.rows), 0);
  digest = digestOfBytes(std::span(state.rowNodes), digest);
  digest = digestOfBytes(std::span(state.told), digest);
  for (const SoftPast& past : world.soft) {
    const std::size_t count = past.rows.rowCount();
    digest = digestOfBytes(std::span(&count, 1), digest);
    if (count > 0) digest = digestOfBytes(past.rows.nodesOf(count - 1), digest);
  }
  return digest;
}

}  // namespace

FrameDigest digestOf(const FrameState& state, const World& world) {
  SectionDigests digests;
  visitAll(state.record, digests);
  for (const BodyKnot& knot : state.knots) digests.of(FrameSection::knots) << knot.body << knot.knot;
  for (const GameEvent& event : state.events) digests.of(FrameSection::events) << event;
  FrameDigest all;
  std::copy(digests.all().begin(), digests.all().end(), all.fields.begin());
  all.fields[kSections] = digestOfNewest(world.histories);
  all.fields[kSections + 1] = digestOfNewest(world.events);
  all.fields[kSections + 2] = digestOfRows(state, world);
  return all;
}

HistoryDigest digestOf(const WorldLine& history) {
  Digest turns, velocities, properTimes, signal;
  for (const Knot& knot : history.knots()) {
    turns("", knot.turn, kNumber);
    velocities("", knot.u, kVector);
    velocities << knot.deceleration_m_s2;
    properTimes << knot.properTime_s;
    signal("", knot.signal, kNumber);
  }
  return {{history.knots().size(), turns, velocities, properTimes, signal}};
}

}  // namespace carom
