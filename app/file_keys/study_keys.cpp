#include "app/file_keys/study_keys.h"

#include "app/file_keys/lesson_keys.h"
#include "cave/record/effects.h"

namespace carom {
namespace {

using namespace declare;

constexpr std::size_t kMostLetters = 400, kMostNameLetters = 40;

/// What the ids of items, answers, concepts and misconceptions consist of: they become parts of rows.
constexpr std::string_view kId = "^[A-Za-z0-9][A-Za-z0-9._-]*$";

FileKey id(std::string_view name, std::string_view sentence) {
  return fitting(kId, ofLetters(kMostNameLetters, text(name, sentence)));
}

FileKey switchesOffKey() {
  FileKey effects = declare::texts("switches_off", "effects that are off for the people of this arm");
  for (const NamedSwitch& row : kNamedSwitches) effects.choices.emplace_back(row.name);
  return effects;
}

FileKey viewsOffKey() {
  FileKey views = viewsKey("views of time that the people of this arm do not get");
  views.name = "views_off";
  return views;
}

FileKey armKeys() {
  constexpr std::size_t kMostArms = 12;
  return required(ofSize(
      1, kMostArms,
      tables("arm", "what differs between participants; each takes part in one arm",
             {required(ofLetters(kMostNameLetters, text("name", "of the arm, as results have it"))),
              required(text("rig", "a name that carom list tells, or a file, looked for beside the study")),
              choice("head", {"tracked", "still"},
                     "still: the eyes stay where they were when the lesson began", 0),
              switchesOffKey(), viewsOffKey()})));
}

}  // namespace

const FileKey& studyKeys() {
  constexpr int kMostPeople = 10000, kMostSeed = 2147483647;
  constexpr std::size_t kMostLessons = 26;
  static const FileKey keys = table(
      "study", "Carom study",
      {required(ofLetters(kMostLetters, text("title", "for people"))),
       required(whole("seed", 0, kMostSeed, "from which the allocation follows, on every machine the same")),
       required(whole("participants", 1, kMostPeople, "how many are planned, fixed before the first one")),
       required(ofSize(1, kMostLessons,
                       declare::texts("lessons",
                                      "names that carom list tells, or files, looked for beside the "
                                      "study"))),
       choice("orders", {"williams", "fixed"},
              "of the lessons. williams: each lesson stands in each place, and follows each other one, "
              "equally often. fixed: as listed",
              0),
       choice("forms", {"rotate", "fixed"},
              "rotate: the six ordered pairs of forms before and after are used equally often, and the "
              "third form is the delayed test. fixed: everybody A, B, C",
              0),
       text("items", "the item bank, looked for beside the study; left out: the shipped one"),
       ofLetters(kMostLetters, text("primary", "the one outcome that needs no correction")),
       flag("gender", "the background page asks for the gender, in words or not at all"),
       flag("reasons", "each item asks why"), flag("open", "the console shows the arm"),
       date("keep_until", "the day after which the data are to be deleted"),
       text("consent", "the consent page, looked for beside the study; left out: consent-en.md"), armKeys()});
  return keys;
}

const FileKey& itemBankKeys() {
  constexpr std::size_t kMostItems = 1000, kMostAnswersOfItem = 10;
  static const FileKey keys = table(
      "item bank", "Carom item bank",
      {ofLetters(kMostLetters, text("title", "for people")),
       required(ofSize(
           1, kMostItems,
           tables(
               "item", "a question of a test",
               {required(id("id", "of the template: the same in each form")),
                required(id("concept", "what it asks for")),
                required(choice("form", {"A", "B", "C"}, "in which test it stands")),
                required(ofLetters(kMostLetters, text("question", "as it is read"))),
                required(ofSize(2, kMostAnswersOfItem,
                                tables("answer", "from which one chooses; \"I do not know\" is always added",
                                       {required(id("id", "the same in each form")),
                                        required(ofLetters(kMostLetters, text("text", "as it is read"))),
                                        flag("right", "it is the key; one answer of an item is"),
                                        id("misconception", "that leads to this answer")})))})))});
  return keys;
}

}  // namespace carom
