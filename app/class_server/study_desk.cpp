#include "app/class_server/study_desk.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <utility>

#include "app/toml/config_folder.h"
#include "app/toml/input_file.h"
#include "cave/record/effects.h"
#include "cave/record/time_views.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// Returns 128 bits from the operating system, as hexadecimal digits.
std::string anyToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the operating system gave no random numbers");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

std::string today() { return fmt::format("{:%F}", fmt::gmtime(std::time(nullptr))); }

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

StudyDesk::StudyDesk(Study study, StudyDeskOptions options) : options_(std::move(options)) {
  tables_ = std::make_unique<StudyTables>(options_.session, study, options_.isAmended);
  StudyRun::Setup setup{std::move(study), options_.slips, {}, anyToken, today};
  for (const StudyArm& arm : setup.study.arms) setup.armsHere.push_back(isSameFile(arm.rig, options_.rig));
  setup.consent = readText(setup.study.consent, InputKind::toml);
  run_ = std::make_unique<StudyRun>(std::move(setup), *tables_);
  options_.server.studyPage = [this](std::string_view query) { return run_->page(query); };
  options_.server.studyForm = [this](std::string_view form) { return run_->take(form, now_s()); };
  options_.server.studyStyle = studyStyle();
  server_ = std::make_unique<ClassServer>(options_.server);
}

StudyDesk::~StudyDesk() { server_.reset(); }  // its thread uses the rest

std::string StudyDesk::address() const { return server_->invitation().address + "study"; }

std::string StudyDesk::fileOf(const RoomWish& wish) const {
  return wish.code.empty() ? options_.waiting : run_->study().lessons.at(wish.lesson).scenario.string();
}

void StudyDesk::command(const OperatorSettings& settings, double session_s, Commands& commands) {
  run_->tell(session_s);
  if (const auto wish = run_->takeWish()) {
    wanted_ = wish;
    isAsked_ = false;
  }
  if (wanted_ && !isAsked_) commands.emplace_back(PlayScenario{fileOf(*wanted_), true});
  isAsked_ = true;
  if (run_->asksUnwell(now_s())) commands.emplace_back(TellPerson{texts::message::kHowUnwell});
  if (order_) {
    if (auto said = run_->order(*order_, now_s())) {
      said_ = *std::move(said);
      order_.reset();
    }
  }
  if (auto standings = run_->takeStandings()) standings_ = *std::move(standings);
  if (played_ && !hasExplained_ && settings.lesson.phase == LessonPhase::explains)
    hasExplained_ = run_->lessonExplains(*played_);
  if (played_) putOff(settings, commands);
}

void StudyDesk::putOff(const OperatorSettings& settings, Commands& commands) const {
  const StudyArm& arm = run_->study().arms.at(played_->arm);
  for (const NamedSwitch& row : kNamedSwitches) {
    if (settings.switches.*row.value != 0 && holds(arm.switchesOff, row.name))
      commands.emplace_back(SetSwitch{row.value, false, false});
  }
  for (const NamedView& row : kNamedViews) {
    if (settings.views.*row.value != 0 && holds(arm.viewsOff, row.name))
      commands.emplace_back(SetView{row.value, false});
  }
}

void StudyDesk::applyTo(OperatorSettings& settings) const {
  settings.walls.blank = played_ ? 0 : 1;  // nothing of a lesson is seen during the tests
  if (!played_) return;
  const StudyArm& arm = run_->study().arms.at(played_->arm);
  for (const NamedSwitch& row : kNamedSwitches) {
    if (holds(arm.switchesOff, row.name)) settings.switches.*row.value = 0;
  }
  for (const NamedView& row : kNamedViews) {
    if (holds(arm.viewsOff, row.name)) settings.views.*row.value = 0;
  }
}

bool StudyDesk::play(const std::string& file) {
  isAsked_ = false;  // commands of the game before are forgotten
  const bool isWanted = wanted_ && fileOf(*wanted_) == file;
  if (isWanted && wanted_->code.empty()) {
    wanted_.reset();
    played_.reset();
  } else if (isWanted) {
    played_ = std::exchange(wanted_, {});
    hasExplained_ = false;
  } else if (played_ && fileOf(*played_) != file) {
    played_.reset();  // somebody has chosen another game
  }
  return played_.has_value();
}

bool StudyDesk::allows(const std::string& file) const {
  return (wanted_ && fileOf(*wanted_) == file) || (played_ && fileOf(*played_) == file);
}

void StudyDesk::begun() {
  if (played_) run_->lessonBegins(*played_);
}

bool StudyDesk::isStill() const { return played_ && run_->study().arms.at(played_->arm).isStill; }

}  // namespace carom
