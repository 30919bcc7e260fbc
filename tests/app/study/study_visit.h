#pragma once
// A participant of a study who sees its pages as on a tablet.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "app/study/allocation.h"
#include "app/study/study_code.h"
#include "app/study/study_run.h"
#include "app/study/study_tables.h"
#include "app/temporary_folder.h"

namespace carom::test {

/// A session file with as many tables as a study asks for, a study of it, and its pages.
class StudyVisit {
 public:
  explicit StudyVisit(const std::string& more = "reasons = true\n", bool isAmended = false)
      : study_(folder_.file("study.toml",
                            "title = \"T\"\nseed = 5\nparticipants = 4\nlessons = "
                            "[\"light-clock\", \"twins\"]\n" +
                                more + "[[arm]]\nname = \"a\"\nrig = \"desk\"\n")),
        session_(folder_ / "day.db") {
    if (!std::filesystem::exists(session_)) {
      SQLite::Database made(session_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      made.exec(
          "CREATE TABLE session(key TEXT PRIMARY KEY, value); CREATE TABLE game(first_frame INTEGER); "
          "INSERT INTO game VALUES(0)");
    }
    codes_ = newCodes(4);
    open(isAmended);
  }

  void open(bool isAmended = false) {
    run_.reset();
    tables_.reset();
    const Study study = readStudy(study_);
    tables_ = std::make_unique<StudyTables>(session_, study, isAmended);
    StudyRun::Setup setup{
        study, {}, "# Consent\n", [this] { return std::to_string(++tokens_); }, [this] { return day_; }};
    for (std::size_t i = 0; i < codes_.size(); ++i) setup.slips[codes_[i]] = i + 1;
    run_ = std::make_unique<StudyRun>(std::move(setup), *tables_);
  }

  /// Sends a form on the page that was last seen: its hidden fields and these.
  const std::string& send(const std::string& fields) {
    static const std::regex hidden("type=\"hidden\" name=\"(\\w+)\" value=\"([^\"]*)\"");
    std::string form = fields;
    for (std::sregex_iterator it(page_.begin(), page_.end(), hidden), end; it != end; ++it)
      form += "&" + (*it)[1].str() + "=" + (*it)[2].str();
    return goTo(run_->take(form, now_s_ += 10.0));
  }
  /// Asks for the page of an address, as a browser does.
  const std::string& goTo(const std::string& address) {
    address_ = address;
    const std::size_t query = address.find('?');
    return page_ = run_->page(query == std::string::npos ? "" : address.substr(query + 1));
  }
  const std::string& enter(const std::string& code) {
    goTo("/study");
    return send("go=code&code=" + code);
  }
  bool says(const std::string& words) const { return page_.find(words) != std::string::npos; }

  void answerForm(std::size_t form, bool isRight) {
    for (const Item* item : run_->study().bank.ofForm(form)) {
      ASSERT_TRUE(says("Question ")) << page_;
      std::string answer;
      for (const ItemAnswer& one : item->answers) {
        if (one.isRight == isRight) answer = one.id;
      }
      send("go=next&confidence=3&answer=" + answer);
    }
    ASSERT_TRUE(says("Hand in"));
    send("go=next");
  }
  /// From the code to the lessons.
  void beginWith(const std::string& code) {
    enter(code);
    send("go=next&part=yes&paths=yes");
    send("go=next&age_band=18-24&relativity=read&language=Deutsch");
    answerForm(plan(code).forms[0], false);
    send("go=next&unwell-before=1");
  }
  Participant plan(const std::string& code) const {
    const auto number = std::find(codes_.begin(), codes_.end(), code) - codes_.begin();
    return allocate(run_->study())[static_cast<std::size_t>(number)];
  }
  std::vector<ResponseRow> responses(const std::string& code, const std::string& phase) {
    std::vector<ResponseRow> rows = responsesOf(tables_->database(), code);
    std::erase_if(rows, [&](const ResponseRow& row) { return row.phase != phase; });
    return rows;
  }
  ParticipantRow row(const std::string& code) {
    for (const ParticipantRow& one : participantsIn(tables_->database())) {
      if (one.code == code) return one;
    }
    return {};
  }

  TemporaryFolder folder_;
  std::filesystem::path study_, session_;
  std::vector<std::string> codes_;
  std::unique_ptr<StudyTables> tables_;
  std::unique_ptr<StudyRun> run_;
  std::string page_, address_, day_ = "2026-11-23";
  int tokens_ = 100;
  double now_s_ = 0.0;
};

}  // namespace carom::test
