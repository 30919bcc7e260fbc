#include "app/file_keys/task_keys.h"

namespace carom {
namespace {

using namespace declare;

/// Returns the names of two pucks.
FileKey two(std::string_view name, std::string_view sentence) {
  return ofSize(2, 2, declare::texts(name, sentence));
}

FileKey goal() {
  FileKey keys =
      table("goal", "one of these; each is judged from the events of the game, as their light arrives",
            {text("hit", "puck that the struck one is to hit"),
             whole("cushions", 1, 9, "a carom off so many cushions, at least"),
             two("hit-both", "two pucks that are to be seen hit within 0.1 s of the viewer's own time"),
             text("looks-faster", "puck that is to be seen faster than light"),
             two("clock-reads", "two pucks whose clocks are to be seen at the same reading, within 0.05 s")});
  const std::vector<std::string_view> all{"hit", "cushions", "hit-both", "looks-faster", "clock-reads"};
  std::vector<FileKey::Combination>& one = keys.rules.emplace_back();
  for (const std::string_view key : all) {
    FileKey::Combination& only = one.emplace_back(FileKey::Combination{{key}, {}});
    for (const std::string_view other : all)
      if (other != key) only.without.push_back(other);
  }
  return keys;
}

}  // namespace

FileKey taskKeys() {
  FileKey goals = goal();
  goals.isRequired = true;
  return ofSize(
      0, kMostTasks,
      tables("task", "something to do for who plays, one after the other",
             {required(ofLetters(kTaskNameLetters, text("name", "unique"))),
              required(ofLetters(kTaskTextLetters, text("text", "what to do"))), goals,
              choice("world", {"newton", "measured", "seen"},
                     "newton: light is slow, without contraction and aberration; measured: contraction, "
                     "without light delay and aberration; seen: all of them",
                     2),
              required(inUnit("J", numbers("stars_j", 2, kPositive,
                                           "energy of the strokes up to which there are three stars, and "
                                           "two; otherwise there is one")))}));
}

}  // namespace carom
