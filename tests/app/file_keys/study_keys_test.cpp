// The readers of studies and item banks read the keys that are declared for them.
#include "app/file_keys/study_keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "app/file_keys/declared_keys.h"
#include "app/study/study.h"

namespace carom {
namespace {

using test::compare;

TEST(FileKey, ReadersOfStudiesReadTheDeclaredKeys) {
  compare(studyKeys(), [](const std::filesystem::path& file) { readStudy(file); }, {{}});
  compare(itemBankKeys(), [](const std::filesystem::path& file) { readItemBank(file); }, {{}});
}

// The ids become parts of rows, so that no separator may stand in them.
TEST(FileKey, IdsOfItemsAreOfPlainLetters) {
  const FileKey* item = findKey(itemBankKeys(), "item");
  ASSERT_NE(item, nullptr);
  const FileKey* answer = findKey(*item, "answer");
  ASSERT_NE(answer, nullptr);
  for (const FileKey* key : {findKey(*item, "id"), findKey(*item, "concept"), findKey(*answer, "id"),
                             findKey(*answer, "misconception")}) {
    ASSERT_NE(key, nullptr);
    SCOPED_TRACE(key->name);
    const std::regex pattern(key->pattern);
    for (const char* right : {"a", "9", "light-clock", "A.1_b"})
      EXPECT_TRUE(std::regex_match(right, pattern)) << right;
    for (const char* wrong : {"", "-a", "a b", "a;b", "a\n", "é"})
      EXPECT_FALSE(std::regex_match(wrong, pattern)) << wrong;
  }
}

}  // namespace
}  // namespace carom
