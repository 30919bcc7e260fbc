#include "app/languages/language_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <unordered_set>

#include "app/languages/scenario_texts.h"
#include "app/languages/source_text.h"
#include "app/toml/config_folder.h"
#include "engine/text/code_points.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr const char *kTexts = "carom.po", *kGames = "scenarios.po", *kPseudo = "pseudo";

bool isFile(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

fs::path languagesFolder() { return configFolder() / "languages"; }

/// A PO file beside a scenario of one's own: "mine.fr.po".
struct OwnFile {
  fs::path scenario;
  std::string code;
};

std::optional<OwnFile> ownFile(const fs::path& po) {
  const fs::path stem = po.stem();  // "mine.fr"
  const std::string code = stem.extension().string();
  if (code.size() < 2 || !isLanguageCode(code.substr(1))) return {};
  OwnFile own{po.parent_path() / (stem.stem().string() + ".toml"), code.substr(1)};
  return isFile(own.scenario) ? std::optional(own) : std::nullopt;
}

/// Returns whether a context is of a game: it begins with the name of a file.
bool isOfGame(const PoEntry& entry) {
  return entry.context && entry.context->words.find(".toml ") != std::string::npos;
}

/// Returns the English that the entries of a file are about.
std::vector<SourceText> sourcesOf(const PoFile& file) {
  const bool hasGames = std::ranges::any_of(file.entries, isOfGame);
  const bool hasTexts = std::ranges::any_of(
      file.entries, [](const PoEntry& entry) { return !entry.isObsolete && !isOfGame(entry); });
  std::vector<SourceText> sources;
  if (hasTexts || !hasGames) sources = sourceTexts(texts::catalogue());
  if (hasGames) std::ranges::move(shippedScenarioTexts(), std::back_inserter(sources));
  return sources;
}

/// Throws the errors of a file, if it has any.
void throwErrors(const fs::path& file, const std::vector<Finding>& findings) {
  std::vector<InputError> errors;
  for (const Finding& finding : toldOf(findings)) {
    if (finding.kind == Finding::Kind::error)
      errors.emplace_back(file.string(), finding.at.line, finding.at.column, finding.text);
  }
  if (!errors.empty()) throw InputErrors(std::move(errors));
}

/// The words of some files on their way into a language.
class Words {
 public:
  /// Adds a file's translations. Throws its errors.
  void add(const fs::path& file) {
    const ReadTranslation read = readTranslation(file, {});
    throwErrors(file, read.judged.findings);
    if (code_.empty()) code_ = read.judged.code;
    for (const Translated& one : read.judged.translated) {
      const SourceText& source = read.rules.sources[one.source];
      source.hasValues ? texts_.push_back({source.context, one.forms})
                       : games_.push_back({source.english, one.forms});
      if (!source.hasValues && standsOnPlates(source.context)) labels_ += one.forms.front();
    }
  }

  const std::string& code() const { return code_; }

  /// Puts the words into a language; of two for the same English in games the first.
  void putInto(texts::Language& language) const {
    for (const auto& [name, forms] : texts_) language.put(texts::textNamed(name).index(), forms);
    std::unordered_set<std::string_view> known;
    for (const auto& [english, forms] : games_) {
      if (known.insert(english).second) language.putOther(english, forms.front());
    }
    language.putOnPlates(labels_);
  }

 private:
  struct Text {
    std::string of;
    std::vector<std::string> forms;
  };

  std::string code_;
  std::vector<Text> texts_, games_;
  std::string labels_;  ///< of lessons' labels, which stand on plates
};

/// Throws if no font here has the letters of a language: a tenth of them would be boxes.
void checkFonts(const texts::Language& language, const LetterFonts& fonts) {
  if (!fonts.lettersWithoutFont || !fonts.missingPackage) return;
  const std::string words = language.allWords();
  const std::u32string missing = fonts.lettersWithoutFont(words);
  const std::u32string signs = codePointsOf(words);
  const std::size_t all = std::unordered_set<char32_t>(signs.begin(), signs.end()).size();
  const std::string package = missing.size() * 10 > all ? fonts.missingPackage() : "";
  if (package.empty()) return;
  throw std::runtime_error(
      fmt::format("language '{0}': no font here has {1} of its {2} letters, expected the package {3} "
                  "(apt-get install {3})",
                  language.code(), missing.size(), all, package));
}

[[noreturn]] void refuse(const std::string& given) {
  std::vector<std::string> codes = shippedLanguages();
  codes.insert(codes.begin(), "en");
  codes.emplace_back(kPseudo);
  throw std::runtime_error(fmt::format("there is no language '{}', expected one of {} or a PO file",
                                       printable(given), fmt::join(codes, ", ")));
}

LanguageProgress::Part partOf(const fs::path& file, std::size_t all) {
  const ReadTranslation read = readTranslation(file, {});
  throwErrors(file, read.judged.findings);
  return {read.judged.translated.size(), all};
}

}  // namespace

ReadTranslation readTranslation(const fs::path& path, const LetterFonts& fonts) {
  PoFile file = readPo(path);
  ReadTranslation read;
  if (const auto own = ownFile(path)) {
    read.rules.code = own->code;
    read.rules.sources = scenarioTexts(own->scenario);
    const std::string prefix = own->scenario.filename().string() + ' ';
    for (PoEntry& entry : file.entries) {
      if (entry.context && !entry.context->words.starts_with(prefix)) entry.context->words.insert(0, prefix);
    }
  } else {
    if (isSameFile(path.parent_path().parent_path(), languagesFolder()))
      read.rules.code = path.parent_path().filename().string();
    read.rules.sources = sourcesOf(file);
  }
  read.rules.glossary = Glossary::beside(path);
  read.rules.lettersWithoutFont = fonts.lettersWithoutFont;
  read.judged = judge(file, read.rules);
  return read;
}

std::vector<std::string> shippedLanguages() {
  std::vector<std::string> codes;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(languagesFolder(), failed)) {
    if (isFile(entry.path() / kTexts)) codes.push_back(entry.path().filename().string());
  }
  std::ranges::sort(codes);
  return codes;
}

fs::path folderOfLanguage(const std::string& code) {
  if (!isLanguageCode(code) || !isFile(languagesFolder() / code / kTexts)) refuse(code);
  return languagesFolder() / code;
}

std::shared_ptr<texts::Language> loadLanguage(const std::string& given, const LetterFonts& fonts) {
  if (given == "en") return nullptr;
  if (given == kPseudo) return std::make_shared<texts::Language>(texts::Language::pseudo());
  Words words;
  if (given.ends_with(".po")) {
    const fs::path file(given);
    words.add(file);
    const fs::path other = file.filename() == kTexts   ? file.parent_path() / kGames
                           : file.filename() == kGames ? file.parent_path() / kTexts
                                                       : fs::path();
    if (!other.empty() && isFile(other)) words.add(other);
  } else {
    const fs::path folder = folderOfLanguage(given);
    words.add(folder / kTexts);
    if (isFile(folder / kGames)) words.add(folder / kGames);
  }
  auto language = std::make_shared<texts::Language>(words.code());
  words.putInto(*language);
  checkFonts(*language, fonts);
  return language;
}

bool addWordsBeside(const fs::path& scenario, texts::Language& language) {
  const fs::path file =
      scenario.parent_path() / fmt::format("{}.{}.po", scenario.stem().string(), language.code());
  if (!isFile(file)) return false;
  Words words;
  words.add(file);
  words.putInto(language);
  return true;
}

std::vector<LanguageProgress> progressOfLanguages() {
  std::vector<LanguageProgress> all;
  const std::size_t texts = sourceTexts(texts::catalogue()).size(), games = shippedScenarioTexts().size();
  for (const std::string& code : shippedLanguages()) {
    LanguageProgress& progress = all.emplace_back(LanguageProgress{code, {0, texts}, {0, games}, {}});
    try {
      const fs::path folder = folderOfLanguage(code);
      progress.texts = partOf(folder / kTexts, texts);
      if (isFile(folder / kGames)) progress.games = partOf(folder / kGames, games);
    } catch (const std::exception& error) {
      progress.fault = error.what();
    }
  }
  return all;
}

}  // namespace carom
