// `carom study`: the plan is the allocation, codes are drawn once, and only codes are deleted.
#include "app/record_tools/study.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "app/program.h"
#include "app/study/allocation.h"
#include "app/study/study_code.h"

namespace carom {
namespace {

using test::contentOf;
using test::runCarom;
using test::TemporaryFolder;

std::filesystem::path madeStudy(const TemporaryFolder& folder) {
  return folder.file("own.toml",
                     "title = \"Own\"\nseed = 3\nparticipants = 8\nlessons = [\"light-clock\", \"twins\"]\n"
                     "[[arm]]\nname = \"walks\"\nrig = \"desk\"\n[[arm]]\nname = \"stands\"\nrig = \"desk\"\n"
                     "head = \"still\"\n");
}

TEST(StudyTools, ThePlanIsTheAllocation) {
  const TemporaryFolder folder;
  const auto file = madeStudy(folder);
  const Study study = readStudy(file);
  const auto json = runCarom(folder, {"study", "plan", file, "--json", "-"});
  ASSERT_EQ(json.status, 0) << json.err;
  EXPECT_EQ(json.out, planJson(study, allocate(study)));
  const auto table = runCarom(folder, {"study", "plan", file});
  ASSERT_EQ(table.status, 0) << table.err;
  std::istringstream lines(table.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "Own");
  std::getline(lines, line);
  EXPECT_EQ(line, "SHA-256 " + study.sha256);
  std::getline(lines, line);
  for (const Participant& one : allocate(study)) {
    std::size_t number = 0, row = 0;
    std::string arm, forms;
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream(line) >> number >> arm >> row >> forms;
    EXPECT_EQ(number, one.number);
    EXPECT_EQ(arm, study.arms[one.arm].name);
    EXPECT_EQ(row, one.orderRow);
    EXPECT_EQ(forms, std::string(kForms[one.forms[0]]) + kForms[one.forms[1]] + kForms[one.forms[2]]);
    EXPECT_TRUE(
        line.ends_with(study.lessons[one.lessons[0]].name + ", " + study.lessons[one.lessons[1]].name))
        << line;
  }
}

TEST(StudyTools, CodesAreDrawnOnceForEachParticipant) {
  const TemporaryFolder folder;
  const auto file = madeStudy(folder), slips = folder / "slips.csv", page = folder / "slips.html";
  const auto drawn = runCarom(folder, {"study", "codes", file, "-o", slips, "--html", page});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  for (const auto& one : {slips, page})
    EXPECT_EQ(std::filesystem::status(one).permissions() & std::filesystem::perms::others_all,
              std::filesystem::perms::none)
        << "with a code one can answer in its owner's place";
  const std::string text = contentOf(slips), shown = contentOf(page);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "number,code");
  std::set<std::string> codes;
  for (int number = 1; number <= 8; ++number) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line.substr(0, 2), std::to_string(number) + ",");
    const std::string code = line.substr(2);
    EXPECT_EQ(codeOf(code), code);
    EXPECT_NE(shown.find(code), std::string::npos);
    codes.insert(code);
  }
  EXPECT_FALSE(std::getline(lines, line));
  EXPECT_EQ(codes.size(), 8U);
  const auto again = runCarom(folder, {"study", "codes", file, "-o", slips});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("slips.csv is there already, expected a new name"), std::string::npos)
      << again.err;
  EXPECT_EQ(contentOf(slips), text);
}

TEST(StudyTools, OnlyWhatIsACodeIsDeleted) {
  const TemporaryFolder folder;
  const auto data = folder / "data";
  std::filesystem::create_directories(data);
  folder.file("data/study.csv", "key,value\nwithdrew,0\n");
  const std::string code = newCodes(1)[0], other = newCodes(1)[0];
  folder.file("data/participants.csv", "participant,arm\n" + code + ",a\n");
  const auto wrong = runCarom(folder, {"study", "delete", "a", data});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("'a' is no code, expected six letters and digits as on the slip"),
            std::string::npos)
      << wrong.err;
  const auto absent = runCarom(folder, {"study", "delete", other, data});
  EXPECT_EQ(absent.status, 1) << absent.out;
  EXPECT_NE(absent.out.find("has nothing of this code"), std::string::npos) << absent.out;
  const auto deleted = runCarom(folder, {"study", "delete", code, data});
  EXPECT_EQ(deleted.status, 0) << deleted.err;
  EXPECT_EQ(deleted.out, data.string() +
                             ": removed 1 rows, 0 lessons with their paths, 0 files\n"
                             "1 participant withdrew. Copies and backups elsewhere are not changed.\n");
  EXPECT_EQ(contentOf(data / "participants.csv"), "participant,arm\n");
  EXPECT_EQ(contentOf(data / "study.csv"), "key,value\nwithdrew,1\n");
}

}  // namespace
}  // namespace carom
