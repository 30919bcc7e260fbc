#include "app/study/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <system_error>

#include "app/file_keys/study_keys.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/toml/config_folder.h"
#include "app/toml/toml_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// Returns the file that a study names: beside it if it is there, otherwise the shipped one of this name.
fs::path namedFile(const fs::path& study, const std::string& name, std::string_view kind) {
  std::error_code failed;
  const fs::path beside = study.parent_path() / name;
  if (fs::is_regular_file(beside, failed)) return beside;
  const fs::path below = configFolder() / kind / name;
  return fs::is_regular_file(below, failed) ? below : shippedFile(name, kind);
}

/// Returns why a file that a study names cannot be read; empty if it can.
std::string refusalOfNamed(const fs::path& study, const fs::path& file, const std::string& name,
                           std::string_view kind, InputKind input) {
  std::error_code failed;
  if (!fs::exists(file, failed)) {
    const std::vector<std::string> known = shippedNames(kind);
    const auto near = nearestWord(name, known);
    return fmt::format("there is no '{}', expected a file beside the study or one of the folder {}{}",
                       printable(name), kind, near ? fmt::format(", such as '{}'?", *near) : "");
  }
  if (!liesBelow(file, study.parent_path()) && !liesBelow(file, configFolder()))
    return fmt::format("'{}' is {}, expected a file below this folder or a shipped one", printable(name),
                       outsideWords(file, study.parent_path()));
  const std::string refusal = refusalOf(file, input);
  return refusal.empty() ? "" : fmt::format("'{}': {}", printable(name), refusal);
}

/// Calls `read`; records a fault at a place of the study if the file that it reads is wrong.
template <typename Read>
void readNamed(const TomlTable& table, FilePlace place, std::string_view what, Read&& read) {
  try {
    read();
  } catch (const InputErrors& errors) {
    table.fault(place, fmt::format("{} cannot be used: {}", what, printable(errors.faults().front().what())));
  }
}

std::vector<std::string> readNames(const TomlTable& table, std::string_view key) {
  std::vector<std::string> names;
  const std::vector<std::string_view>& choices = table.declared(key).choices;
  for (const PlacedText& name : table.texts(key)) {
    if (std::find(choices.begin(), choices.end(), name.text) == choices.end())
      table.fault(name.place, fmt::format("'{}' is none that there is, expected one of {}", name.text,
                                          fmt::join(choices, ", ")));
    names.push_back(name.text);
  }
  return names;
}

/// Reads a study's keys. With `isKept` the files that it names are not looked for.
class StudyReader {
 public:
  StudyReader(const TomlFile& file, Study& study, bool isKept)
      : root_(file.root()), study_(study), isKept_(isKept) {}

  void read() {
    study_.title = root_.text("title");
    study_.seed = static_cast<std::uint64_t>(root_.integer("seed"));
    study_.participants = static_cast<std::size_t>(root_.integer("participants"));
    readLessons();
    study_.hasFixedOrder = root_.choice("orders") == 1;
    study_.hasFixedForms = root_.choice("forms") == 1;
    study_.primary = root_.text("primary", "");
    study_.asksGender = root_.flag("gender");
    study_.asksReasons = root_.flag("reasons");
    study_.isOpen = root_.flag("open");
    study_.keepUntil = root_.date("keep_until");
    if (study_.keepUntil && !study_.keepUntil->ok())
      root_.fault("keep_until", "keep_until is no day of the calendar, expected one such as 2031-12-31");
    study_.consent = readFile("consent", "consent-en.md");
    study_.bankFile = readFile("items", "items.toml");
    readArms();
    tellFewPeople();
    tellPrimary();
  }

  void readBank(const std::optional<std::string>& kept) {
    if (study_.bankFile.empty()) return;
    readNamed(root_, root_.place("items"), "this item bank", [&] {
      study_.bankText = kept ? *kept : readText(study_.bankFile, InputKind::toml);
      study_.bank = readItemBank(study_.bankFile, study_.bankText);
      const fs::path shipped = configFolder() / "studies" / "items.toml";
      std::error_code failed;
      study_.hasShippedBank =
          fs::is_regular_file(shipped, failed) && readText(shipped, InputKind::toml) == study_.bankText;
    });
  }

 private:
  fs::path readFile(std::string_view key, const std::string& usual) {
    const std::string name = root_.text(key, usual);
    if (isKept_) return name;
    const fs::path file = namedFile(study_.file, name, "studies");
    const std::string refusal = refusalOfNamed(study_.file, file, name, "studies", InputKind::toml);
    if (refusal.empty()) return file;
    root_.fault(key, fmt::format("{}: {}", key, refusal));
    return {};
  }

  void readLessons() {
    const FileKey& declared = root_.declared("lessons");
    const std::vector<PlacedText> names = root_.texts("lessons");
    if (names.empty() || names.size() > declared.most)
      root_.fault("lessons", fmt::format("lessons has {} names, expected {} to {}", names.size(),
                                         declared.fewest, declared.most));
    for (const PlacedText& name : names) {
      const auto isSame = [&](const StudyLesson& lesson) { return lesson.name == name.text; };
      if (std::any_of(study_.lessons.begin(), study_.lessons.end(), isSame))
        root_.fault(name.place,
                    fmt::format("the lesson '{}' stands here twice, expected it once", name.text));
      study_.lessons.push_back({name.text, isKept_ ? fs::path() : lessonFile(name)});
    }
  }

  fs::path lessonFile(const PlacedText& name) {
    const fs::path file = namedFile(study_.file, name.text, "scenarios");
    const std::string refusal = refusalOfNamed(study_.file, file, name.text, "scenarios", InputKind::toml);
    if (!refusal.empty()) {
      root_.fault(name.place, "lessons: " + refusal);
      return file;
    }
    readNamed(root_, name.place, "this lesson", [&] {
      if (!readScenario(file).lesson)
        root_.fault(name.place, fmt::format("'{}' is a game without a lesson, expected a lesson", name.text));
    });
    return file;
  }

  void readArms() {
    const std::vector<TomlTable> tables = root_.tables("arm");
    if (tables.empty()) root_.fault("arm", "there is no arm here, expected one [[arm]] at least");
    for (const TomlTable& table : tables) {
      StudyArm arm;
      arm.name = table.text("name");
      const auto isSame = [&](const StudyArm& other) { return other.name == arm.name; };
      if (std::any_of(study_.arms.begin(), study_.arms.end(), isSame))
        table.fault("name", fmt::format("two arms are '{}', expected different names", arm.name));
      const std::string rig = table.text("rig");
      if (!isKept_ && !rig.empty()) arm.rig = rigFile(table, rig);
      arm.isStill = table.choice("head") == 1;
      arm.switchesOff = readNames(table, "switches_off");
      arm.viewsOff = readNames(table, "views_off");
      tellSameArm(table, arm);
      study_.arms.push_back(std::move(arm));
    }
  }

  fs::path rigFile(const TomlTable& table, const std::string& name) {
    const fs::path file = namedFile(study_.file, name, "rigs");
    const std::string refusal = refusalOfNamed(study_.file, file, name, "rigs", InputKind::toml);
    if (!refusal.empty()) {
      table.fault("rig", "rig: " + refusal);
    } else {
      readNamed(table, table.place("rig"), "this rig", [&] { readRig(file); });
    }
    return file;
  }

  void tell(FilePlace place, std::string words) {
    study_.odd.push_back({Finding::Kind::warning, place, std::move(words)});
  }

  void tellSameArm(const TomlTable& table, const StudyArm& arm) {
    const auto isSame = [&](const StudyArm& other) {
      return isSameFile(other.rig, arm.rig) && other.isStill == arm.isStill &&
             other.switchesOff == arm.switchesOff && other.viewsOff == arm.viewsOff;
    };
    const auto same =
        isKept_ ? study_.arms.end() : std::find_if(study_.arms.begin(), study_.arms.end(), isSame);
    if (same == study_.arms.end()) return;
    tell(table.place(),
         fmt::format("the arm '{}' has the same settings as the arm '{}', expected a difference "
                     "between them",
                     arm.name, same->name));
  }

  void tellPrimary() {
    constexpr std::string_view kGain = "gain", kBetween = "gain between arms";
    const std::string& primary = study_.primary;
    const std::size_t arms = study_.arms.size();
    if (primary.empty() || (primary == kGain && arms == 1) || (primary == kBetween && arms == 2)) return;
    const std::string expected = arms > 2 ? "no primary outcome with more than two arms"
                                          : fmt::format("'{}', for {}", arms == 1 ? kGain : kBetween,
                                                        arms == 1 ? "one arm" : "two arms");
    tell(root_.place("primary"), fmt::format("primary is '{}', which the report has no test for, expected {}",
                                             printable(primary), expected));
  }

  void tellFewPeople() {
    if (study_.arms.empty() || study_.lessons.empty()) return;
    const std::size_t each = study_.participants / study_.arms.size();
    constexpr std::size_t kFewest = 12;  // as in config/studies/analyse.R
    if (each < kFewest)
      tell(root_.place("participants"),
           fmt::format(
               "{} people in an arm: the report will describe and have no p-values, expected at least {}",
               each, kFewest));
    const std::size_t pairs = study_.hasFixedForms ? 1 : 6, rows = orderRows(study_);
    if (each >= std::max(rows, pairs)) return;
    tell(root_.place("participants"),
         fmt::format("too few participants for the rows: {} in an arm, expected at least {}, for {} orders "
                     "of lessons and {} pairs of forms",
                     each, std::max(rows, pairs), rows, pairs));
  }

  const TomlTable& root_;
  Study& study_;
  bool isKept_;
};

Study read(const fs::path& path, const std::optional<std::string>& kept,
           const std::optional<std::string>& keptBank) {
  Study study;
  study.file = path;
  study.text = kept ? *kept : readText(path, InputKind::toml);
  const TomlFile file(path, studyKeys(), study.text);
  StudyReader reader(file, study, kept.has_value());
  reader.read();
  reader.readBank(keptBank);
  file.throwFaults();
  study.sha256 = sha256Of(study.text + study.bankText);
  return study;
}

}  // namespace

Study readStudy(const fs::path& file) { return read(file, {}, {}); }

Study keptStudy(const std::string& text, const std::string& bankText) {
  return read("study.toml", text, bankText);
}

std::vector<Finding> leftOfTemplate(const std::string& consent) {
  static const std::regex brackets(R"(\[[^\]\n]*\](?!\())");  // followed by (…) it is a link
  constexpr std::array<std::string_view, 2> kTemplate{"A template for your ethics board",
                                                      "Eine Vorlage für Ihre Ethikkommission"};
  std::vector<Finding> found;
  std::istringstream lines(consent);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const auto add = [&](std::ptrdiff_t at, const std::string& words) {
      found.push_back({Finding::Kind::warning, {number, static_cast<int>(at) + 1}, words});
    };
    for (const std::string_view words : kTemplate) {
      if (const std::size_t at = line.find(words); at != std::string::npos)
        add(static_cast<std::ptrdiff_t>(at),
            "this is still the template's sentence, expected a consent page that is complete");
    }
    for (std::sregex_iterator it(line.begin(), line.end(), brackets), end; it != end; ++it)
      add(it->position(),
          fmt::format("{} stands in brackets, expected the words of this study", printable(it->str())));
  }
  return found;
}

std::vector<std::string> rigsOf(const Study& study) {
  std::vector<std::string> names;
  for (const StudyArm& arm : study.arms) {
    const std::string name = arm.rig.stem().string();
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::size_t orderRows(const Study& study) {
  const std::size_t lessons = study.lessons.size();
  if (study.hasFixedOrder) return 1;
  return lessons % 2 == 0 ? lessons : 2 * lessons;
}

std::string sha256Of(const std::string& bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace carom
