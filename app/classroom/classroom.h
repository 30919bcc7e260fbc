#pragma once
// A class that answers by phone, without its sockets: who has joined, the teacher, the question, its votes,
// and what each of them is told. Times are seconds on any steady clock.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/classroom/class_ballot.h"
#include "app/classroom/class_flow.h"
#include "app/classroom/phone_message.h"
#include "app/classroom/pin_gate.h"
#include "app/journal_rows/journal_news.h"

namespace carom {

/// How to join a class.
struct ClassInvitation {
  std::string address;  ///< of the pages: http://192.168.1.20:8080/
  std::string word;     ///< of the room
  std::string pin;      ///< of the teacher
};

/// The question of a game, as a class is asked it.
struct ClassQuestion {
  std::string file, lesson, question;
  std::vector<std::string> answers;  ///< none: the game asks nothing
  std::size_t right = 0;             ///< index

  bool isAsked() const { return !answers.empty(); }
};

/// What has happened on the wall.
struct LessonNews {
  std::optional<ClassQuestion> game;  ///< another game begins, or the same one again
  LessonPhase phase = LessonPhase::none;
};

/// What the class wants of the lesson on the wall.
enum class LessonWish : std::uint8_t { ask, show, explain, next };

class Classroom {
 public:
  using Id = std::uint64_t;  ///< of a connection

  /// The most phones that are remembered.
  static constexpr std::size_t kMostPhones = 1000;

  /// `newToken` returns another token of 32 letters whenever it is called.
  Classroom(ClassInvitation invitation, std::function<std::string()> newToken)
      : invitation_(std::move(invitation)), newToken_(std::move(newToken)), gate_(invitation_.pin) {}

  /// Sets the address of the pages.
  void invite(const std::string& address) { invitation_.address = address; }
  /// Goes on with a class whose session broke off; `left` is used with the first question.
  void resume(const ClassLeft& left);

  /// Lets in a connection from this address. It is told nothing until it has said hello, or the PIN.
  void connect(Id id, const std::string& address) { guests_[id].address = address; }
  void leave(Id id);
  void receive(Id id, const PhoneMessage& message, double now_s);
  /// Tells a connection that its message was none.
  void refuseMessage(Id id);

  /// Takes a step. Returns why not, or null if it was possible.
  texts::Text take(ClassStep step, double now_s);
  bool may(ClassStep step) const;
  void follow(const LessonNews& news, double now_s);

  /// Returns whether the connection has said hello, or is the teacher's.
  bool isIn(Id id) const;
  bool isTeacher(Id id) const { return teacher_ == id; }
  /// Returns the message that tells a connection how things stand, and once why its last message was refused.
  std::string messageFor(Id id);
  /// Returns how things stand for the walls.
  ClassView view() const;
  const ClassInvitation& invitation() const { return invitation_; }

  /// Returns whether something that all are told has changed since the last call.
  bool takeChange() { return std::exchange(changed_, false); }
  /// Return what the lesson and the journal have not been told yet.
  std::vector<LessonWish> takeWishes() { return std::exchange(wishes_, {}); }
  std::vector<ClassVote> takeVotes() { return std::exchange(votes_, {}); }

 private:
  /// The person behind a connection.
  struct Guest {
    std::string address, token;
    texts::Text refusal;  ///< not told yet
    bool wasTeacher = false;
    bool comesBack = false;  ///< with a token of this class or of one before
  };
  texts::Text take(Guest& guest, Id id, const PhoneMessage& message, double now_s);
  texts::Text join(Guest& guest, const std::string& token);
  texts::Text answer(const Guest& guest, const PhoneAnswer& given, double now_s);
  texts::Text teach(Guest& guest, Id id, const std::string& pin, double now_s);
  void close();
  void goOnWith(const ClassLeft& left);
  std::size_t phones() const;
  std::optional<VoteCounts> countsToShow(int round) const;
  std::string hint() const;

  ClassInvitation invitation_;
  std::function<std::string()> newToken_;
  PinGate gate_;
  ClassFlow flow_;
  ClassBallot ballot_;
  ClassQuestion question_;
  std::map<Id, Guest> guests_;
  std::set<std::string, std::less<>> tokens_;  ///< that were given
  std::optional<Id> teacher_;
  std::optional<ClassLeft> left_;
  double opened_s_ = 0.0;  ///< when the present vote was opened
  struct Awaited {
    double until_s = 0.0;
    bool asks = false;  ///< the teacher asks as soon as it has come
  };
  std::optional<Awaited> awaited_;  ///< the next lesson, which has been wished for
  bool changed_ = false;
  std::vector<LessonWish> wishes_;
  std::vector<ClassVote> votes_;
};

}  // namespace carom
