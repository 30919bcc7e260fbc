#include "cave/texts/language.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <nlohmann/json.hpp>

#include "cave/texts/numbered_name.h"
#include "cave/texts/pseudo.h"

namespace carom::texts {
namespace {

constinit thread_local const Language* inUse = nullptr;
std::vector<std::shared_ptr<const Language>> sessionLanguages;

/// Decimal comma and narrow no-break space in French and German (ISO 80000-1, 7.3).
Digits digitsOf(std::string_view code) {
  if (code == "fr" || code == "de") return {",", "\u202F"};
  return {};
}

/// Returns a number and its unit with the language's sign before its decimals: "1.2 c".
std::string withPoint(std::string_view number, const char* point) {
  const std::size_t at = number.find_first_not_of("0123456789");
  if (at == std::string_view::npos || number[at] != '.') return std::string(number);
  return std::string(number.substr(0, at)) + point + std::string(number.substr(at + 1));
}

}  // namespace

std::size_t pluralForms(std::string_view code) { return code == "ja" ? 1 : 2; }

std::size_t pluralForm(std::string_view code, double number) {
  if (code == "ja") return 0;
  if (code == "fr") return number >= 2.0 ? 1 : 0;
  return number == 1.0 ? 0 : 1;
}

Language::Language(std::string code)
    : code_(std::move(code)), digits_(digitsOf(code_)), forms_(catalogue().size()) {}

Language Language::pseudo() {
  Language made("pseudo");
  made.isPseudo_ = true;
  for (const Entry& entry : catalogue()) {
    if (*entry.text.english() == 0 || entry.name.starts_with("plate.")) continue;  // twelve letters at most
    std::vector<std::string> forms{pseudoOf(entry.text.english())};
    if (entry.text.englishOfMany()) forms.push_back(pseudoOf(entry.text.englishOfMany()));
    made.put(entry.text.index(), std::move(forms));
  }
  return made;
}

void Language::put(std::size_t index, std::vector<std::string> forms) { forms_.at(index) = std::move(forms); }

void Language::putOther(std::string english, std::string words) {
  others_.insert_or_assign(std::move(english), std::move(words));
}

const char* Language::words(const Text& text) const {
  const std::vector<std::string>& forms = forms_[text.index()];
  return forms.empty() ? text.english() : forms.back().c_str();
}

const char* Language::wordsFor(const Text& text, double number) const {
  const std::vector<std::string>& forms = forms_[text.index()];
  if (forms.empty()) return pluralForm("en", number) == 0 ? text.english() : text.englishOfMany();
  return forms[std::min(pluralForm(code_, number), forms.size() - 1)].c_str();
}

std::string Language::other(std::string_view english) const {
  if (isPseudo_) return pseudoOf(english);
  const auto isDigit = [](char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; };
  if (const auto whole = others_.find(std::string(english)); whole != others_.end()) return whole->second;
  if (!english.empty() && isDigit(english[0])) return withPoint(english, digits_.point);
  const std::string_view bare = nameWithoutNumber(english);
  const auto name = others_.find(std::string(bare));
  return (name == others_.end() ? std::string(bare) : name->second) +
         std::string(english.substr(bare.size()));
}

std::string Language::packed() const {
  nlohmann::json all{
      {"code", code_}, {"texts", nlohmann::json::object()}, {"others", others_}, {"plates", gamePlates_}};
  for (const Entry& entry : catalogue())
    if (const auto& forms = forms_[entry.text.index()]; !forms.empty()) all["texts"][entry.name] = forms;
  return all.dump();
}

Language Language::unpacked(const std::string& line) {
  const nlohmann::json all = nlohmann::json::parse(line);
  Language made(all.at("code").get<std::string>());
  made.isPseudo_ = made.code_ == "pseudo";
  for (const auto& [name, forms] : all.at("texts").items())
    made.put(textNamed(name).index(), forms.get<std::vector<std::string>>());
  made.others_ = all.at("others").get<decltype(made.others_)>();
  made.gamePlates_ = all.at("plates").get<std::string>();
  return made;
}

std::string Language::allWords() const {
  std::string all;
  for (const auto& forms : forms_)
    for (const std::string& words : forms) all += words;
  for (const auto& [english, words] : others_) all += words;
  return all;
}

std::string Language::plateWords() const {
  std::string all = gamePlates_;
  for (const Entry& entry : catalogue())
    if (entry.name.starts_with("plate."))
      for (const std::string& words : forms_[entry.text.index()]) all += words;
  return all;
}

void setSessionLanguages(std::vector<std::shared_ptr<const Language>> languages) {
  sessionLanguages = std::move(languages);
}

const Language* ofSession(std::size_t number) {
  return number < sessionLanguages.size() ? sessionLanguages[number].get() : inUse;
}

const Language* language() { return inUse; }

std::string languageCode() { return inUse ? inUse->code() : "en"; }

std::string other(std::string_view english) { return inUse ? inUse->other(english) : std::string(english); }

const char* Text::words() const { return inUse ? inUse->words(*this) : many_ ? many_ : one_; }

InLanguage::InLanguage(const Language* language) : before_(std::exchange(inUse, language)) {}
InLanguage::~InLanguage() { inUse = before_; }

}  // namespace carom::texts
