#pragma once
// What a frame brings to the journal besides its record.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/linked/told_path.h"

namespace carom {

/// A stroke made by hand.
struct HandStroke {
  Stroke stroke;
  std::size_t viewer = 0;    ///< whose hand it was, an index of the viewers of its room
  std::uint32_t room = 0;    ///< of linked rooms, where it was made; 0: the host, or the only room
  std::uint32_t number = 0;  ///< counts the strokes of that room in a game from 0
  std::string viewerName{};  ///< of a viewer elsewhere; empty: the viewer is of this room
};

/// Another room of a linked game in a frame, by one of its viewers: the promise that held.
struct LinkRow {
  std::uint32_t room = 0;
  std::string_view state;
  std::uint64_t heard = 0;  ///< number of its newest present
  double roundTrip_s = 0.0;
  Event promise;
  std::string viewer;
  bool waits = false;  ///< the people here did not live on
  double pace = 1.0;
  std::uint32_t digest_s = 0;  ///< both games are the same up to this board time
};

/// The moment of a person in another room, as a present told it.
struct LinkPersonRow {
  std::uint32_t room = 0;
  std::uint64_t number = 0;  ///< of the present; 0: none told it, the person is gone
  ToldMoment moment;
};

struct LinkNoteRow {
  std::uint32_t room = 0;
  std::string what, value;
};

/// What a frame brings of another room.
struct LinkNews {
  std::vector<HandStroke> strokes;
  std::vector<LinkRow> rows;
  std::vector<LinkPersonRow> persons;
  std::vector<LinkNoteRow> notes;

  void clear() {
    strokes.clear();
    rows.clear();
    persons.clear();
    notes.clear();
  }
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

/// What happened to a task (app/live/task_run.h).
struct TaskNews {
  std::string task;  ///< its name
  std::size_t viewer = 0;
  std::string event;      ///< begun, failed, solved
  int stars = 0;          ///< 1 to 3 where it is solved
  double energy_j = 0.0;  ///< of its strokes so far
};

}  // namespace carom
