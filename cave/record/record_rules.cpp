#include "cave/record/record_rules.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "cave/record/record_fields.h"
#include "engine/base/limits.h"

namespace carom {
namespace {

template <typename... T>
[[noreturn]] void refuse(fmt::format_string<const T&...> text, const T&... values) {
  throw std::invalid_argument(fmt::format(text, values...));
}

/// Returns whether a transform is one. `inverse` uses the formula for Lorentz transforms; it does not invert
/// any other matrix.
bool isLorentz(const Lorentz& transform) {
  constexpr double kRounding = 1e-9;
  const glm::dmat4 one = (transform.inverse() * transform).matrix();
  const double gamma = transform.matrix()[0][0];
  bool possible = std::isfinite(gamma) && gamma > 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const double off = std::abs(one[column][row] - (row == column ? 1.0 : 0.0));
      possible = possible && off <= kRounding * gamma * gamma;
    }
  }
  return possible;
}

/// Refuses impossible fields.
class Rules : public FieldVisitor {
 public:
  /// `what`: stands before the names in messages, such as "a knot's ".
  explicit Rules(const char* what, double gameLightSpeed_m_s = 0.0)
      : what_(what), gameLightSpeed_m_s_(gameLightSpeed_m_s) {}

  void operator()(const char* name, double value, const FieldKind& kind) const {
    expect(name, "", value, kind);
  }
  template <typename Whole>
  requires(std::is_unsigned_v<Whole> || std::is_enum_v<Whole>) void operator()(const char* name, Whole value,
                                                                               const FieldKind& kind) const {
    const auto whole = static_cast<std::uint64_t>(value);
    if (static_cast<double>(whole) >= kind.least && static_cast<double>(whole) <= kind.most) return;
    refuse("{}{}{} is {}, expected {} to {}", what_, prefix, name, whole, kind.least, kind.most);
  }
  template <typename Choice>
  void operator()(const char* name, const std::optional<Choice>& value, const FieldKind& kind) const {
    if (value) (*this)(name, *value, kind);
  }
  template <Compound Value>
  void operator()(const char* name, const Value& value, const FieldKind& kind) const {
    eachNumber(value, kind, [&](const char* suffix, double number) { expect(name, suffix, number, kind); });
  }
  void operator()(const char* name, const Lorentz& transform, const FieldKind&) const {
    if (const double c_m_s = transform.lightSpeed_m_s(); c_m_s != gameLightSpeed_m_s_)
      refuse("{}{} has light at {} m/s, expected the game's {}", what_, name, c_m_s, gameLightSpeed_m_s_);
    if (!isLorentz(transform)) refuse("{}{} is no Lorentz transform", what_, name);
  }
  template <std::size_t bytes>
  void operator()(const char* name, const ShortText<bytes>& words, const FieldKind&) const {
    if (words.text.back() != 0) refuse("{}{} has no end", what_, name);
  }
  template <typename Flags, typename Row, std::size_t rows>
  void operator()(const char*, const Flags& flags, const std::array<Row, rows>& named) const {
    for (const Row& row : named) (*this)(row.name, flags.*row.value, kFlag);
  }
  void turns(const Turns& turns) {
    for (const Turn& turn : turns) {
      visit(turn, *this);
      visitSpin(turn, *this);
    }
  }

 private:
  void expect(const char* name, const char* suffix, double value, const FieldKind& kind) const {
    if (value >= kind.least && value <= kind.most) return;
    if (kind.most != kNumber.most && kind.most != kTime.most)
      refuse("{}{}{}{} is {}, expected {} to {}", what_, prefix, name, suffix, value, kind.least, kind.most);
    refuse("{}{}{}{} is {}, expected a {}number", what_, prefix, name, suffix, value,
           kind.most == kNumber.most ? "finite " : "");
  }

  const char* what_;
  double gameLightSpeed_m_s_;
};

}  // namespace

void expectPossible(const FrameRecord& record, double gameLightSpeed_m_s) {
  Rules rules("", gameLightSpeed_m_s);
  visitAll(record, rules);
  const double c_m_s = record.lightSpeed_m_s;
  const bool settable = c_m_s >= kLeastLightSpeed_m_s && c_m_s <= kMostLightSpeed_m_s;
  if (!settable && c_m_s != gameLightSpeed_m_s) {
    refuse("light_speed_m_s is {}, expected {} to {} or the game's {}", c_m_s, kLeastLightSpeed_m_s,
           kMostLightSpeed_m_s, gameLightSpeed_m_s);
  }
  for (const HeadsetEye& eye : record.headset.eyes) {
    const EyeFrustum& f = eye.frustum;
    if (!(f.left < f.right && f.down < f.up)) refuse("an eye's frustum is none");
  }
}

void expectPossible(const Knot& knot) {
  Rules rules("a knot's ");
  visit(knot, rules);
}

void expectPossible(const ToldMoment& moment) {
  Rules rules("a person's ");
  visit(moment, rules);
  rules("", moment.head, kNumber);
  rules("proper_time_s", moment.properTime_s, kNumber);
  rules("number", moment.person, FieldKind{0.0, kMostViewers - 1});
}

void expectPossible(const GameEvent& event, std::uint64_t pucks) {
  Rules rules("an event's ");
  visit(event, rules);
  for (const Turn& turn : event.turns) {
    if (turn.puck >= pucks)
      refuse("an event turns puck {}, expected one of {} from 0", std::uint64_t{turn.puck}, pucks);
  }
}

}  // namespace carom
