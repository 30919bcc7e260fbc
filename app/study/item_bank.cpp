#include "app/study/item_bank.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "app/file_keys/study_keys.h"
#include "app/toml/toml_file.h"

namespace carom {
namespace {

/// Reads the name of something, which becomes a part of rows.
std::string readId(const TomlTable& table, std::string_view key) {
  const FileKey& declared = table.declared(key);
  const std::string id = declared.isRequired || table.has(key) ? table.text(key) : "";
  static const std::regex plain(declared.pattern);
  if (!id.empty() && (id.size() > declared.letters || !std::regex_match(id, plain)))
    table.fault(key, fmt::format("{} is '{}', expected at most {} letters, digits and . _ -", key, id,
                                 declared.letters));
  return id;
}

std::string readWords(const TomlTable& table, std::string_view key) {
  std::string words = table.text(key);
  if (const std::size_t most = table.declared(key).letters; words.size() > most)
    table.fault(key, fmt::format("{} has {} bytes, expected at most {}", key, words.size(), most));
  return words;
}

ItemAnswer readAnswer(const TomlTable& table) {
  ItemAnswer answer{readId(table, "id"), readWords(table, "text"), table.flag("right"),
                    readId(table, "misconception")};
  if (answer.id == kDontKnow)
    table.fault("id", fmt::format("'{}' is the answer that each item has, expected another id", kDontKnow));
  if (answer.isRight && !answer.misconception.empty())
    table.fault("misconception", "the right answer has a misconception, expected one or the other");
  return answer;
}

/// Records a fault unless the item has one key, and answers of different ids.
void checkAnswers(const TomlTable& table, const Item& item) {
  const auto rights = std::count_if(item.answers.begin(), item.answers.end(),
                                    [](const ItemAnswer& answer) { return answer.isRight; });
  const std::string name = fmt::format("item {} of form {}", item.id, kForms[item.form]);
  if (rights == 0) table.fault(table.place(), name + " has no key, expected one answer with right = true");
  if (rights > 1)
    table.fault(table.place(), fmt::format("{} has {} right answers, expected one", name, rights));
  const std::size_t fewest = table.declared("answer").fewest;
  if (item.answers.size() < fewest)
    table.fault(table.place(),
                fmt::format("{} has {} answers, expected at least {}", name, item.answers.size(), fewest));
  for (const ItemAnswer& answer : item.answers) {
    if (item.answer(answer.id) != &answer)
      table.fault(table.place(), fmt::format("{} has two answers '{}', expected one", name, answer.id));
  }
}

Item readItem(const TomlTable& table) {
  Item item{
      readId(table, "id"), readId(table, "concept"), table.choice("form"), readWords(table, "question"), {}};
  for (const TomlTable& answer : table.tables("answer")) item.answers.push_back(readAnswer(answer));
  return item;
}

/// Records a fault for each form that does not ask for a concept that another form asks for.
void checkForms(const TomlTable& root, const ItemBank& bank) {
  for (const std::string& asked : bank.concepts()) {
    for (std::size_t form = 0; form < kForms.size(); ++form) {
      const auto asks = [&](const Item& item) { return item.form == form && item.concept_ == asked; };
      if (std::none_of(bank.items.begin(), bank.items.end(), asks))
        root.fault("item", fmt::format("form {} has no item of the concept {}, expected one in each form",
                                       kForms[form], asked));
    }
  }
}

/// Tells of templates whose forms do not have the same answers.
void compareForms(const TomlTable& table, ItemBank& bank, const Item& item) {
  const auto first = std::find_if(bank.items.begin(), bank.items.end(),
                                  [&](const Item& other) { return other.id == item.id; });
  const auto tell = [&](const std::string& words) {
    bank.odd.push_back({Finding::Kind::warning, table.place(), words});
  };
  for (const ItemAnswer& answer : item.answers) {
    const ItemAnswer* same = first->answer(answer.id);
    if (!same) {
      tell(fmt::format("item {} has an answer '{}' in form {} and none in form {}", item.id, answer.id,
                       kForms[item.form], kForms[first->form]));
    } else if (same->isRight != answer.isRight || same->misconception != answer.misconception) {
      tell(fmt::format("the answer '{}' of item {} means something else in form {} than in form {}",
                       answer.id, item.id, kForms[item.form], kForms[first->form]));
    }
  }
}

}  // namespace

const ItemAnswer* Item::answer(std::string_view answerId) const {
  const auto found = std::find_if(answers.begin(), answers.end(),
                                  [&](const ItemAnswer& answer) { return answer.id == answerId; });
  return found == answers.end() ? nullptr : &*found;
}

std::vector<const Item*> ItemBank::ofForm(std::size_t form) const {
  std::vector<const Item*> found;
  for (const Item& item : items) {
    if (item.form == form) found.push_back(&item);
  }
  return found;
}

const Item* ItemBank::find(std::string_view id, std::size_t form) const {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [&](const Item& item) { return item.id == id && item.form == form; });
  return found == items.end() ? nullptr : &*found;
}

std::vector<std::string> ItemBank::concepts() const {
  std::vector<std::string> found;
  for (const Item& item : items) {
    if (std::find(found.begin(), found.end(), item.concept_) == found.end()) found.push_back(item.concept_);
  }
  return found;
}

ItemBank readItemBank(const std::filesystem::path& path, const std::optional<std::string>& kept) {
  const TomlFile file(path, itemBankKeys(), kept);
  const TomlTable& root = file.root();
  ItemBank bank;
  bank.title = root.text("title", path.stem().string());
  const std::vector<TomlTable> tables = root.tables("item");
  if (tables.empty()) root.fault("item", "there is no item here, expected [[item]]");
  std::vector<Item> items;
  for (const TomlTable& table : tables) items.push_back(readItem(table));
  file.throwFaults();  // what follows from a key that is missing or wrong is not told besides
  for (std::size_t i = 0; i < items.size(); ++i) {
    const TomlTable& table = tables[i];
    Item& item = items[i];
    checkAnswers(table, item);
    if (bank.find(item.id, item.form))
      table.fault(
          "id", fmt::format("item {} stands twice in form {}, expected it once", item.id, kForms[item.form]));
    bank.items.push_back(std::move(item));
    compareForms(table, bank, bank.items.back());
  }
  checkForms(root, bank);
  file.throwFaults();
  return bank;
}

}  // namespace carom
