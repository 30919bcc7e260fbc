#include "app/file_keys/lesson_keys.h"

#include "cave/frame/lesson_plan.h"
#include "cave/record/effects.h"
#include "cave/record/lesson_words.h"
#include "cave/record/time_views.h"

namespace carom {
namespace {

using namespace declare;

constexpr std::size_t kMostObservers = kMostAnswers - 1;  // the wand's last button goes on

/// Returns the tables of one kind of drawings.
FileKey drawings(std::string_view name, std::string_view sentence, std::vector<FileKey> keys) {
  return ofSize(0, kMostLessonDrawings, tables(name, sentence, std::move(keys)));
}

FileKey words(std::string_view name, std::string_view sentence, std::size_t letters = kLessonTextLetters) {
  return required(ofLetters(letters, text(name, sentence)));
}

FileKey namedBody() { return required(text("body", "name of the puck or namedBody")); }

FileKey stopwatch() {
  return drawings("stopwatch", "a time that is read while the lesson shows and explains",
                  {required(text("name", "before the reading")),
                   choice("clock", {"frame", "room", "mine", "seen"},
                          "clocks at rest in the frame beta, or in the observer's room; the observer's own "
                          "clock; the table's clock "
                          "at place_m as the observer sees it",
                          0),
                   numbers("beta", 3, {}, "v/c of the frame on the board; left out: the table's frame"),
                   text("starts", "name of the [[flash]] that starts it; left out: it starts with from_s"),
                   text("stops", "name of the [[flash]] that stops it"),
                   flag("stops_when_seen", "it stops when the observer sees its start"),
                   numbers("place_m", 3, {}, "place of the table's clock that is seen"),
                   numbers("stands_m", 3, {}, "where a plate with the reading stands")});
}

FileKey offersEffects() {
  FileKey effects = declare::texts(
      "offers_effects",
      "while it shows, buttons turn these effects off and on; it explains with them as they were at first");
  for (const NamedSwitch& effect : kNamedSwitches) effects.choices.emplace_back(effect.name);
  return effects;
}

}  // namespace

FileKey viewsKey(std::string_view sentence, std::string_view name) {
  FileKey views = declare::texts(name, sentence);
  for (const NamedView& view : kNamedViews) views.choices.emplace_back(view.name);
  return views;
}

FileKey lessonKeys() {
  constexpr Range kSlowness{.least = 1.0, .most = 100.0};
  return table(
      "lesson", "a question before the game, the part of the game that answers it, and the number behind it",
      {words("question", "asked before anything of the answer is seen"),
       required(ofSize(2, kMostAnswers,
                       ofLetters(kAnswerLetters, declare::texts("answers", "from which one chooses")))),
       required(whole("right", 1, static_cast<int>(kMostAnswers), "which of the answers, from 1")),
       words("todo", "what to do"),
       words("notice", "what to look for"),
       words("number", "what comes out, and why", kLessonNumberLetters),
       ofLetters(kPresenterLetters, text("predicted_wrongly",
                                         "for the presenter's page: the prediction that many make, and why")),
       ofLetters(kPresenterLetters,
                 text("go_on_with", "for the presenter's page: questions for a discussion")),
       viewsKey("views of time that it begins with"),
       viewsKey("views of time that are on while it explains", "explains_views"),
       flag("offers_spacetime", "while it explains, a button shows the game's spacetime in the room"),
       offersEffects(),
       required(
           number("from_s", kNotNegative, "board time at the observer at which the lesson begins to show")),
       required(number("until_s", kPositive,
                       "board time up to which it shows, then it begins again; at most 60 s later")),
       required(number("moment_s", kNotNegative,
                       "board time that is held while it explains; from from_s to until_s")),
       flag("keeps_clocks",
            "while it explains, the moment that has been reached is held instead, so that everybody's clock "
            "stays as it "
            "is"),
       number("slowness", kSlowness, "how many times slower the observer's time passes than in the game",
              1.0),
       whole("explained_for", 1, static_cast<int>(kMostObservers),
             "which of the [[lesson.observer]], from 1, sees the explanation", 1),
       flag("hold", "a hand with a force device holds the puck that it points at, while its button is held"),
       ofSize(0, kMostObservers,
              tables("observer",
                     "velocities that the visitor can take; observers of all of them pass the position of "
                     "[observer] "
                     "at moment_s",
                     {required(text("name", "on the button")),
                      required(numbers("beta", 3, {}, "v/c on the board"))})),
       stopwatch(),
       drawings("counter", "a plate above a namedBody that counts the flashes that the observer has seen",
                {namedBody(), required(text("flashes", "how the names of the flashes begin"))}),
       drawings(
           "gauge", "a plate above a namedBody with what is true of it where it is seen",
           {namedBody(),
            choice("shows", {"speed", "apparent speed", "gamma", "seen length"},
                   "its speed over c in the observer's room, the speed with which it is seen to move over "
                   "c, its Lorentz factor, or how long it looks along its motion",
                   0)}),
       drawings("label", "a plate with a short word that stands at a place of the board",
                {required(text("text", "at most twelve letters, of ASCII and °βγτΔ²×±≈")),
                 required(numbers("at_m", 3, {}, "its foot")),
                 flag("explains", "it stands there only while the lesson explains")}),
       drawings("arrow", "an arrow from above to what the wall speaks of",
                {text("body", "name of the puck or namedBody, as it is seen"),
                 numbers("at_m", 3, {}, "without a namedBody, the place"),
                 flag("explains", "it stands there while the lesson explains, and not while it shows")}),
       drawings("line", "a straight line on the cloth",
                {required(numbers("from_m", 3, {}, "its one end")),
                 required(numbers("to_m", 3, {}, "its other end"))}),
       drawings("simultaneous",
                "a line on the cloth along x with the table's times of what is simultaneous with a flash",
                {required(text("with", "name of the [[flash]]")),
                 numbers("beta", 3, {}, "v/c of the frame; left out: the observer's"),
                 number("from_m", {}, "x of its one end; left out: at the cushion"),
                 number("to_m", {}, "x of its other end; left out: at the cushion")})});
}

}  // namespace carom
