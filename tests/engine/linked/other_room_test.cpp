// Another room: which of its news count, and which break a promise.
#include "engine/linked/other_room.h"
#include "engine/light_speed.h"

#include <gtest/gtest.h>

#include <limits>

namespace carom {
namespace {

using test::kC_m_s;

Present presentAt(std::uint64_t number, double t_s, std::uint32_t strokes = 0) {
  Present present;
  present.number = number;
  present.strokes = strokes;
  present.size = 1;
  const Event head{t_s, Vec3(0.0)};
  present.persons[0] = {{t_s - 0.5, Vec3(0.0)}, head, head, t_s};
  return present;
}

StrokeTold strokeAt(std::uint32_t number, double t_s, double x_m = 0.0) {
  StrokeTold told{number, 0, {}};
  told.stroke.at_s = t_s;
  told.stroke.from_m = Vec3(x_m, 0.0, 0.0);
  return told;
}

bool allowsAt(const OtherRoom& room, double t_s) { return room.allows({t_s, {kC_m_s, 0.0, 0.0}}); }

TEST(OtherRoom, EyesStayOutsideTheNewestPromise) {
  OtherRoom room(presentAt(1, 0.0), kC_m_s);  // the promise's light is at the eye's place at 0.5 s
  EXPECT_TRUE(allowsAt(room, 0.499));
  EXPECT_FALSE(allowsAt(room, 0.5 - 0.5e-6)) << "a margin for rounding";
  EXPECT_FALSE(allowsAt(room, 0.501));
  EXPECT_FALSE(allowsAt(room, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(room.hear(presentAt(2, 1.0)), Judgement::taken);
  EXPECT_TRUE(allowsAt(room, 1.499));
}

TEST(OtherRoom, APromiseCountsOnceItsStrokesAreHere) {
  OtherRoom room(presentAt(1, 0.0), kC_m_s);
  EXPECT_EQ(room.hear(presentAt(2, 1.0, 2)), Judgement::taken);
  EXPECT_FALSE(allowsAt(room, 0.6));
  EXPECT_EQ(room.hear(strokeAt(1, 0.4)), Judgement::taken);
  EXPECT_FALSE(allowsAt(room, 0.6));
  EXPECT_EQ(room.newest().number, 2U);
  EXPECT_EQ(room.present().number, 1U);
  EXPECT_EQ(room.hear(strokeAt(0, 0.3)), Judgement::taken);
  EXPECT_TRUE(allowsAt(room, 0.6));
  EXPECT_EQ(room.present().number, 2U);
  EXPECT_EQ(room.strokes(), 2U);
}

TEST(OtherRoom, OldNewsAreNothingNew) {
  OtherRoom room(presentAt(3, 0.0), kC_m_s);
  EXPECT_EQ(room.hear(presentAt(5, 0.2)), Judgement::taken);
  EXPECT_EQ(room.hear(presentAt(4, 0.1)), Judgement::old);
  EXPECT_EQ(room.hear(presentAt(5, 0.2)), Judgement::old);
  EXPECT_EQ(room.hear(strokeAt(0, 0.3)), Judgement::taken);
  EXPECT_EQ(room.hear(strokeAt(0, 0.3)), Judgement::old);
  EXPECT_EQ(room.stroke(0)->stroke.at_s, 0.3);
  EXPECT_EQ(room.stroke(1), nullptr);
  EXPECT_TRUE(room.broken().empty());
}

TEST(OtherRoom, NoticesEveryBrokenPromise) {
  const auto hears = [](const Present& present) {
    OtherRoom room(presentAt(1, 10.0), kC_m_s);
    const Judgement judged = room.hear(present);
    EXPECT_EQ(room.present().number, judged == Judgement::broken ? 1U : present.number);
    EXPECT_EQ(room.broken().empty(), judged != Judgement::broken);
    return judged;
  };
  Present backwards = presentAt(2, 10.1);
  backwards.persons[0].promise.t_s = 9.4;
  EXPECT_EQ(hears(backwards), Judgement::broken);
  Present aside = presentAt(2, 10.1);
  aside.persons[0].promise.r_m.x = 1.0;
  EXPECT_EQ(hears(aside), Judgement::broken);
  Present hand = presentAt(2, 10.1);
  hand.persons[0].hand.r_m.y = 1.0;
  EXPECT_EQ(hears(hand), Judgement::broken);
  Present head = presentAt(2, 10.1);
  head.persons[0].head.r_m.y = 0.3;
  EXPECT_EQ(hears(head), Judgement::broken) << "faster than light";
  Present noNumber = presentAt(2, 10.1);
  noNumber.persons[0].promise.t_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hears(noNumber), Judgement::broken);
  Present more = presentAt(2, 10.1);
  more.size = 2;
  EXPECT_EQ(hears(more), Judgement::broken);
  EXPECT_EQ(hears(presentAt(2, 10.1, kMostStrokesTold + 1)), Judgement::broken);
  EXPECT_EQ(hears(presentAt(2, 10.1)), Judgement::taken);
}

TEST(OtherRoom, NoticesStrokesThatCannotBe) {
  const auto hears = [](StrokeTold told) {
    OtherRoom room(presentAt(1, 10.0), kC_m_s);
    EXPECT_EQ(room.hear(strokeAt(0, 9.6)), Judgement::taken);
    return room.hear(told);
  };
  EXPECT_EQ(hears(strokeAt(1, 9.6)), Judgement::taken);
  EXPECT_EQ(hears(strokeAt(1, 9.4)), Judgement::broken) << "before the promise";
  EXPECT_EQ(hears(strokeAt(1, 9.6, 0.5)), Judgement::broken) << "beside its light";
  EXPECT_EQ(hears(strokeAt(0, 9.7)), Judgement::broken) << "told twice, and not the same";
  EXPECT_EQ(hears(strokeAt(kMostStrokesTold, 9.7)), Judgement::broken);
  StrokeTold ofNobody = strokeAt(1, 9.7);
  ofNobody.viewer = 1;
  EXPECT_EQ(hears(ofNobody), Judgement::broken);
  StrokeTold fromNowhere = strokeAt(1, 9.7);
  fromNowhere.stroke.from_m.reset();
  EXPECT_EQ(hears(fromNowhere), Judgement::broken);
  EXPECT_EQ(hears(strokeAt(1, std::numeric_limits<double>::quiet_NaN())), Judgement::broken);
}

}  // namespace
}  // namespace carom
