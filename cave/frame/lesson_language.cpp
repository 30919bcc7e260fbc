#include "cave/frame/lesson_language.h"

#include "cave/texts/language.h"

namespace carom {

LessonWords inLanguage(LessonWords english) {
  for (std::string* words : {&english.title, &english.question, &english.todo, &english.notice,
                             &english.number, &english.predictedWrongly, &english.goOnWith})
    *words = texts::other(*words);
  for (std::string& answer : english.answers) answer = texts::other(answer);
  return english;
}

LessonPlan inLanguage(LessonPlan english) {
  for (LessonObserver& observer : english.observers) observer.name = texts::other(observer.name);
  for (Stopwatch& watch : english.stopwatches) watch.name = texts::other(watch.name);
  for (LessonLabel& label : english.labels) label.words = texts::other(label.words);
  return english;
}

}  // namespace carom
