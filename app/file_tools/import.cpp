#include "app/file_tools/import.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "app/file_tools/rig_text.h"
#include "app/room_checks/room_check.h"
#include "app/room_formats/room_kind.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {

std::vector<Finding> findingsOf(const Room& room) {
  std::vector<Finding> findings = room.findings.all();
  const std::vector<Finding> judged = judgeRoom(room);
  findings.insert(findings.end(), judged.begin(), judged.end());
  return findings;
}

bool printFindings(const std::filesystem::path& file, const std::vector<Finding>& findings) {
  bool failed = false;
  for (const Finding& finding : toldOf(findings)) {
    const bool error = finding.kind == Finding::Kind::error;
    failed = failed || error;
    const std::string line =
        fmt::format("{}:{}:{}: {}", file.string(), finding.at.line, finding.at.column, finding.text);
    error ? log::error(line) : log::warn(line);
  }
  return failed;
}

namespace {

/// A rig and the files that it needs beside it: written when constructed, and removed unless they are kept.
class RigFiles {
 public:
  RigFiles(const std::filesystem::path& rig, const Room& room) {
    if (!room.files.empty() && rig == "-")
      throw std::runtime_error(
          "the rig needs files beside it, expected the name of a file for it instead of -");
    std::error_code failed;
    for (const RoomFile& file : room.files) {
      const std::filesystem::path path = rig.parent_path() / file.name;
      if (std::filesystem::exists(std::filesystem::symlink_status(path, failed)))
        throw std::runtime_error(fmt::format("{} is there already, expected a new file", path.string()));
    }
    try {
      for (const RoomFile& file : room.files) {
        add(rig.parent_path() / file.name, *file.content);
      }
    } catch (...) {
      remove();
      throw;
    }
  }
  RigFiles(const RigFiles&) = delete;
  RigFiles& operator=(const RigFiles&) = delete;
  ~RigFiles() { remove(); }

  void add(const std::filesystem::path& path, const std::string& content) {
    WholeFile(path).commit(content);
    written_.push_back(path);
  }
  void keep() { written_.clear(); }

 private:
  void remove() {
    std::error_code failed;
    for (const std::filesystem::path& path : written_) std::filesystem::remove(path, failed);
    written_.clear();
  }

  std::vector<std::filesystem::path> written_;
};

}  // namespace

int runImport(const ImportOptions& options) {
  if (options.file.extension() == ".toml") {
    throw InputErrors(
        {InputError(options.file.string(), 1, 1,
                    fmt::format("this is no room of another program, expected {}", kForeignRooms))});
  }
  Room room = readForeignRoom(options.file, options.room);
  if (printFindings(options.file, findingsOf(room))) return 1;
  putOnFloor(room);
  keepDisplays(room);
  simulateUntracked(room);
  room.assumptions.push_back("the displays run at 60 Hz");
  const std::string text = rigText(room);
  std::error_code failed;
  if (options.rig != "-" && std::filesystem::exists(std::filesystem::symlink_status(options.rig, failed))) {
    throw std::runtime_error(fmt::format(
        "{} is there already, expected a new file: rigs are measured by hand", options.rig.string()));
  }
  if (room.files.empty()) {
    readRig(options.rig, text);  // throws if the written rig would be refused
    WholeFile(options.rig).commit(text);
  } else {
    RigFiles files(options.rig, room);
    files.add(options.rig, text);
    readRig(options.rig);  // the same: a rig may name files anywhere only where it lies
    files.keep();
  }
  for (const std::string& assumption : room.assumptions) log::note(fmt::format("assumed: {}", assumption));
  return 0;
}

void addImport(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("import", "Turn another program's room file into a rig");
  auto options = std::make_shared<ImportOptions>();
  command->add_option("FILE", options->file, kForeignFiles)->required();
  command->add_option("-o,--output", options->rig, "The rig to write; must not exist. - is standard output")
      ->required()
      ->type_name("RIG.toml");
  command->add_option("--room", options->room, kRoomHelp)->type_name("NAME");
  command->footer("Example:\n  carom import cave.pvx -o cave.toml");
  command->callback([options, &status] { status = runImport(*options); });
}

}  // namespace carom
