#include "app/record_tools/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/study/allocation.h"
#include "app/study/study.h"
#include "app/study/study_code.h"
#include "app/study/study_report.h"
#include "app/study_data/study_delete.h"
#include "app/study_data/study_export.h"
#include "app/tools/option_values.h"
#include "engine/text/printable.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// Returns the allocation as a table for people.
std::string planText(const Study& study, const std::vector<Participant>& participants) {
  std::string text = fmt::format("{}\nSHA-256 {}\n{:>6}  {:16}  {:>3}  {:5}  {}\n", study.title, study.sha256,
                                 "number", "arm", "row", "forms", "lessons");
  for (const Participant& one : participants) {
    std::vector<std::string> lessons;
    for (const std::size_t lesson : one.lessons) lessons.push_back(study.lessons[lesson].name);
    text += fmt::format("{:>6}  {:16}  {:>3}  {}{}{}    {}\n", one.number, study.arms[one.arm].name,
                        one.orderRow, kForms[one.forms[0]], kForms[one.forms[1]], kForms[one.forms[2]],
                        fmt::join(lessons, ", "));
  }
  if (rigsOf(study).size() < 2) return text;
  for (const std::string& rig : rigsOf(study)) {
    std::vector<std::size_t> numbers;
    for (const Participant& one : participants) {
      if (study.arms[one.arm].rig.stem() == rig) numbers.push_back(one.number);
    }
    text += fmt::format("session with --rig {}: numbers {}\n", rig, fmt::join(numbers, ", "));
  }
  return text;
}

CLI::Option* addStudyFile(CLI::App& command, fs::path& file) {
  return command.add_option("STUDY", file, "Study file, or the name of a shipped one")
      ->required()
      ->transform(shipped({"studies"}));
}

void addPlan(CLI::App& study, int& status) {
  struct Line {
    fs::path file;
    std::optional<fs::path> json;
  };
  CLI::App* command = study.add_subcommand(
      "plan", "Say who takes part in which arm, with which lessons and forms, and the SHA-256 of the study");
  const auto line = std::make_shared<Line>();
  addStudyFile(*command, line->file);
  addJson(*command, line->json);
  command->footer("Example:\n  carom study plan walking-or-standing --json plan.json");
  command->callback([line, &status] {
    const Study planned = readStudy(line->file);
    const std::vector<Participant> participants = allocate(planned);
    WholeFile out(line->json.value_or("-"));
    out.commit(line->json ? planJson(planned, participants) : planText(planned, participants));
    status = 0;
  });
}

void refuseToOverwrite(const fs::path& file) {
  std::error_code failed;
  if (file != "-" && fs::exists(file, failed))
    throw std::runtime_error(file.string() +
                             " is there already, expected a new name: codes that were handed out would be "
                             "lost");
}

void addCodes(CLI::App& study, int& status) {
  struct Line {
    fs::path file, slips;
    std::optional<fs::path> html;
  };
  CLI::App* command =
      study.add_subcommand("codes", "Draw a code for each planned participant from the system's randomness");
  const auto line = std::make_shared<Line>();
  addStudyFile(*command, line->file);
  command->add_option("-o,--output", line->slips, "File for the codes, CSV: number,code; none that is there")
      ->required()
      ->type_name("SLIPS");
  command->add_option("--html", line->html, "A page of slips to print and cut")->type_name("FILE");
  command->footer("Example:\n  carom study codes walking-or-standing -o slips.csv --html slips.html");
  command->callback([line, &status] {
    const Study planned = readStudy(line->file);
    refuseToOverwrite(line->slips);
    if (line->html) refuseToOverwrite(*line->html);
    const std::vector<std::string> codes = newCodes(planned.participants);
    ::umask(S_IRWXG | S_IRWXO);  // with a code one can answer in its owner's place
    WholeFile out(line->slips);
    if (line->html) WholeFile(*line->html).commit(slipsHtml(planned.title, codes));
    out.commit(slipsCsv(codes));
    status = 0;
  });
}

void addExportOf(CLI::App& study, int& status) {
  CLI::App* command = study.add_subcommand(
      "export", "Write the data of session files as CSV files with a codebook, into a new folder");
  const auto wanted = std::make_shared<StudyExport>();
  const auto isConsented = std::make_shared<bool>(false);
  command->add_option("FILE", wanted->sessions, "Session files of one study")->required();
  command->add_option("-o,--output", wanted->folder, "Folder to write, none that is there")
      ->required()
      ->type_name("FOLDER");
  CLI::Option* consented =
      command->add_flag("--consented", *isConsented,
                        "With --motion: you have made sure that these people allowed it in writing");
  CLI::Option* motion = command->add_flag("--motion", wanted->hasMotion,
                                          "Also the raw paths of heads and hands, as BIDS, of those who "
                                          "ticked that box. A path is personal data: "
                                          "it tells people apart like a fingerprint");
  motion->needs(consented);
  consented->needs(motion);
  command->footer("Example:\n  carom study export monday.db tuesday.db -o data");
  command->callback([wanted, isConsented, &status] {
    exportStudy(*wanted);
    status = 0;
  });
}

void addDelete(CLI::App& study, int& status) {
  struct Line {
    std::string code;
    std::vector<fs::path> files;
  };
  CLI::App* command = study.add_subcommand(
      "delete", "Delete all data of a participant who withdraws, from session files and exported folders");
  const auto line = std::make_shared<Line>();
  command->add_option("CODE", line->code, "Code of the slip")->required();
  command->add_option("FILE", line->files, "Session files and folders that carom study export has written")
      ->required();
  command->footer("Example:\n  carom study delete 7KQ2MD monday.db data");
  command->callback([line, &status] {
    const std::optional<std::string> code = codeOf(line->code);
    if (!code)
      throw std::runtime_error(fmt::format("'{}' is no code, expected six letters and digits as on the slip",
                                           printable(line->code)));
    bool isFound = false;
    const std::string withdrawal = newWithdrawal();
    for (const fs::path& file : line->files) {
      const StudyDeletion deleted = deleteParticipant(*code, file, withdrawal);
      isFound = isFound || deleted.any();
      const std::string what = deleted.any()
                                   ? fmt::format("removed {} rows, {} lessons with their paths, {} files",
                                                 deleted.rows, deleted.games, deleted.files)
                                   : "has nothing of this code";
      fmt::print("{}: {}\n", printable(file.string()), what);
    }
    if (!isFound)
      throw std::runtime_error("none of these has data of this code, expected some in one of them");
    fmt::print("1 participant withdrew. Copies and backups elsewhere are not changed.\n");
    status = 0;
  });
}

void addReport(CLI::App& study, int& status) {
  CLI::App* command = study.add_subcommand(
      "report", "Analyse exported data with R: report.html and results.csv in their folder");
  const auto folder = std::make_shared<fs::path>();
  command->add_option("FOLDER", *folder, "Folder that carom study export has written")->required();
  command->footer("Example:\n  carom study report data");
  command->callback([folder, &status] {
    status = writeStudyReport(*folder);
    if (status == 0) fmt::print("{}\n", (*folder / "report.html").string());
  });
}

}  // namespace

void addStudy(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("study", "Run a study of what people learn: plan, codes, data, report, deletion");
  command->require_subcommand(1);
  addPlan(*command, status);
  addCodes(*command, status);
  addExportOf(*command, status);
  addReport(*command, status);
  addDelete(*command, status);
}

}  // namespace carom
