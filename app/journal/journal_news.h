#pragma once
// What a frame brings to the journal besides its record.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom {

/// A stroke made by hand.
struct HandStroke {
  Stroke stroke;
  std::size_t viewer = 0;  ///< whose hand it was, an index of the rig's viewers
};

/// A phone's answer in a vote of the class, as it counted when the vote was closed.
struct ClassVote {
  int round = 1;                 ///< 1 before the class has discussed, 2 after
  std::string lesson, question;  ///< in words
  std::string token;             ///< of the phone; a random number
  std::string answer;            ///< in words
  int confidence = 0;            ///< 1 (guessed) to 4 (certain); 0: not told
  double seconds = 0.0;          ///< from the opening of the vote to the answer
  std::string reason;            ///< in the student's words; may be empty

  bool operator==(const ClassVote&) const = default;
};

/// Where a class was when its session ended or broke off.
struct ClassLeft {
  std::string phase;                ///< as kClassPhases names it (cave/record/class_view.h); empty: no class
  int round = 0;                    ///< the present or latest vote; 0: none
  std::vector<std::string> tokens;  ///< of all phones whose votes counted
  std::vector<ClassVote> votes;     ///< that counted since the question was asked
};

/// What happened to a task (app/session/task_run.h).
struct TaskNews {
  std::string task;  ///< its name
  std::size_t viewer = 0;
  std::string event;      ///< begun, failed, solved
  int stars = 0;          ///< 1 to 3 where it is solved
  double energy_j = 0.0;  ///< of its strokes so far
};

}  // namespace carom
