#include "engine/linked/other_room.h"

#include <cstring>

namespace carom {
namespace {

/// Whether two strokes are the same to the bit.
bool sameStroke(const StrokeTold& a, const StrokeTold& b) {
  const auto bits = [](const StrokeTold& told) {
    const Stroke& stroke = told.stroke;
    return std::array{stroke.at_s,      stroke.from_m->x,         stroke.from_m->y,
                      stroke.from_m->z, stroke.momentum_kg_m_s.x, stroke.momentum_kg_m_s.y,
                      stroke.offset_m};
  };
  const auto left = bits(a), right = bits(b);
  return a.viewer == b.viewer && a.stroke.puck == b.stroke.puck &&
         std::memcmp(left.data(), right.data(), sizeof left) == 0;
}

}  // namespace

OtherRoom::OtherRoom(const Present& first, double lightSpeed_m_s)
    : c_m_s_(lightSpeed_m_s), present_(first), strokes_(first.strokes), withoutGap_(first.strokes) {}

Judgement OtherRoom::refuse(const char* why) {
  broken_ = why;
  return Judgement::broken;
}

/// Whether a present goes on from the newest one told before.
bool OtherRoom::keepsPromises(const Present& present) const {
  const Present& before = newest();
  if (present.size != before.size || present.strokes < before.strokes) return false;
  for (std::size_t i = 0; i < present.size; ++i) {
    const PersonTold &now = present.persons[i], &then = before.persons[i];
    if (!isInFutureOf(then.promise, now.promise, c_m_s_) || !isInFutureOf(now.promise, now.head, c_m_s_) ||
        !isInFutureOf(now.promise, now.hand, c_m_s_) ||
        afterLightOf_s(then.head, now.head, c_m_s_) < -kEyesStayBefore_s)
      return false;
  }
  return true;
}

Judgement OtherRoom::hear(const Present& present) {
  if (present.number <= newest().number) return Judgement::old;
  if (present.strokes > kMostStrokesTold) return refuse("it has made more strokes than a game holds");
  if (!keepsPromises(present)) return refuse("a promise was broken: it told of a moment before that promise");
  newest_ = present;
  useNewest();
  return Judgement::taken;
}

void OtherRoom::useNewest() {
  if (!newest_ || newest_->strokes > withoutGap_) return;
  present_ = *newest_;
  newest_.reset();
}

const StrokeTold* OtherRoom::stroke(std::uint32_t number) const {
  return number < strokes_.size() && strokes_[number] ? &*strokes_[number] : nullptr;
}

Judgement OtherRoom::hear(const StrokeTold& told) {
  if (told.number >= kMostStrokesTold || told.viewer >= present_.size || !told.stroke.from_m)
    return refuse("a stroke that cannot be: of nobody, from nowhere or one too many");
  if (const StrokeTold* known = stroke(told.number))
    return sameStroke(*known, told) ? Judgement::old : refuse("a stroke was told twice, and not the same");
  if (told.number < withoutGap_) return Judgement::old;  // from before the first present
  // The stroke was made after the present in use, for that one's strokes were all here.
  if (!isInFutureOf(present_.persons[told.viewer].promise, told.event(), c_m_s_))
    return refuse("a promise was broken: it told of a stroke outside it");
  if (told.number >= strokes_.size()) strokes_.resize(told.number + 1);
  strokes_[told.number] = told;
  while (withoutGap_ < strokes_.size() && stroke(withoutGap_)) ++withoutGap_;
  useNewest();
  return Judgement::taken;
}

bool OtherRoom::allows(const Event& eye) const {
  for (std::size_t i = 0; i < present_.size; ++i) {
    if (!(afterLightOf_s(present_.persons[i].promise, eye, c_m_s_) < -kEyesStayBefore_s)) return false;
  }
  return true;
}

}  // namespace carom
