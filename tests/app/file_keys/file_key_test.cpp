// The declarations of keys: their ranges in words, what is found by its name, and the keys of playlists.
#include "app/file_keys/file_key.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/file_keys/declared_keys.h"
#include "app/file_keys/playlist_keys.h"
#include "app/scenario/playlist.h"

namespace carom {
namespace {

using namespace declare;
using test::compare;

TEST(FileKey, ReaderOfPlaylistsReadsTheDeclaredKeys) { compare(playlistKeys(), readPlaylist, {{}}); }

TEST(FileKey, RangesHoldTheirEndsUnlessTheySayOtherwise) {
  const Range closed{.least = -1.0, .most = 2.0}, open{.least = -1.0, .most = 2.0, .above = true};
  EXPECT_TRUE(within(closed, -1.0) && within(closed, 2.0) && within(open, 2.0));
  EXPECT_FALSE(within(open, -1.0));
  EXPECT_FALSE(within(closed, -1.001) || within(closed, 2.001));
  EXPECT_FALSE(within(closed, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(within(Range{}, std::numeric_limits<double>::infinity()));
}

TEST(FileKey, IsFoundByItsName) {
  const FileKey file = table("file", "", {number("a", kShare, "", 0.5), tables("b", "", {flag("c", "")})});
  ASSERT_NE(findKey(file, "b"), nullptr);
  EXPECT_EQ(findKey(file, "b")->type, FileKey::Type::tables);
  EXPECT_EQ(findKey(file, "c"), nullptr) << "it is of another table";
  EXPECT_EQ(findKey(*findKey(file, "b"), "c")->fallback, std::vector<double>{0.0});
  EXPECT_EQ(findKey(file, ""), nullptr);
  EXPECT_TRUE(required(file.keys[0]).isRequired);
}

}  // namespace
}  // namespace carom
