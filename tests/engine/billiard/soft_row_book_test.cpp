// The rows of soft pucks: taken in parts, after returns, and by other books.
#include "engine/billiard/soft_row_book.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>

namespace carom {
namespace {

/// A bounce of a soft disc, with a book of its rows.
struct Bounce {
  SoftPlay play = SoftPlay({{{1.0, 0.0}, 0.06}});
  SoftRowBook book;

  Bounce() {
    SoftEntry entry;
    entry.name = "jelly";
    entry.mesh = std::make_shared<const SoftMesh>(softDisc(0.0305, 5));
    entry.mass = 0.2;
    entry.u = {1.25, 0.75, 0.0};
    play.add(entry);
    book.begin();
    book.enter(7, play, nullptr, 0.02);
    play.watch([this](std::size_t body, double) { book.step(body, play); });
  }
  Bounce(const Bounce&) = delete;
  Bounce& operator=(const Bounce&) = delete;

  void playUntil(double time) {
    while (play.time() < time) {
      play.playSlice();
      book.endSlice(play);
    }
  }
  SoftRows taken() {
    SoftRows rows;
    book.take(rows);
    return rows;
  }
};

/// Expects that rows are those of `all` from the row `from` on, to the bit.
void expectRows(const SoftRows& rows, const SoftRows& all, std::size_t from) {
  ASSERT_EQ(rows.rows.size() + from, all.rows.size());
  std::size_t node = 0;
  for (std::size_t k = 0; k < from; ++k) node += all.rows[k].nodes;
  ASSERT_EQ(rows.nodes.size() + node, all.nodes.size());
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    EXPECT_EQ(rows.rows[k].time, all.rows[from + k].time) << k;
    EXPECT_EQ(rows.rows[k].centreX, all.rows[from + k].centreX) << k;
    EXPECT_EQ(rows.rows[k].body, 7U);
  }
  EXPECT_EQ(std::memcmp(rows.nodes.data(), all.nodes.data() + node, rows.nodes.size() * sizeof(SoftNode)), 0);
}

SoftRows allRows() {
  Bounce bounce;
  bounce.playUntil(0.3);
  return bounce.taken();
}

TEST(SoftRowBook, RowsThatAreTakenInPartsAreTheSame) {
  const SoftRows all = allRows();
  ASSERT_GT(all.rows.size(), 10U);
  Bounce bounce;
  bounce.playUntil(0.1);
  SoftRows parts = bounce.taken();
  EXPECT_TRUE(bounce.taken().rows.empty()) << "each row is taken once";
  bounce.playUntil(0.3);
  const SoftRows more = bounce.taken();
  parts.rows.insert(parts.rows.end(), more.rows.begin(), more.rows.end());
  parts.nodes.insert(parts.nodes.end(), more.nodes.begin(), more.nodes.end());
  expectRows(parts, all, 0);
}

// After a return the rows from there on are void and come again.
TEST(SoftRowBook, AReturnTakesRowsBack) {
  const SoftRows all = allRows();
  Bounce bounce;
  bounce.playUntil(0.1);
  const auto play = bounce.play.snapshot();
  const SoftRowBook::Snapshot book = bounce.book.snapshot(bounce.play.time());
  bounce.playUntil(0.2);
  bounce.taken();
  bounce.play.restore(*play);
  bounce.book.restore(book);
  bounce.playUntil(0.3);
  const SoftRows rows = bounce.taken();
  EXPECT_EQ(rows.truncatedFrom, book.time);
  std::size_t before = 0;
  while (before < all.rows.size() && all.rows[before].time < book.time) ++before;
  expectRows(rows, all, before);
  EXPECT_EQ(bounce.taken().truncatedFrom, std::numeric_limits<double>::infinity());
}

// What another book got is in this one once it follows, and what it does not listen to is not.
TEST(SoftRowBook, FollowsAnother) {
  const SoftRows all = allRows();
  Bounce ahead;
  SoftRowBook behind;
  behind.begin();
  behind.follow(ahead.book.snapshot(0.0), ahead.taken());
  ahead.playUntil(0.1);
  behind.follow(ahead.book.snapshot(ahead.play.time()), ahead.taken());
  ahead.book.listen(false);
  for (int slice = 0; slice < 20; ++slice) ahead.play.playSlice();
  EXPECT_TRUE(ahead.taken().rows.empty());
  SoftRows rows;
  behind.take(rows);
  ASSERT_FALSE(rows.rows.empty());
  SoftRows first = all;
  first.rows.resize(rows.rows.size());
  first.nodes.resize(rows.nodes.size());
  expectRows(rows, first, 0);
}

}  // namespace
}  // namespace carom
