#include "app/classroom/classroom.h"

#include <algorithm>
#include <utility>

#include "cave/texts/texts.h"

namespace carom {
namespace {

constexpr double kAwaited_s = 10.0;  // the longest that a next lesson takes to begin

template <typename... Handlers>
struct Each : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Each(Handlers...) -> Each<Handlers...>;

}  // namespace

void Classroom::resume(const ClassLeft& left) {
  tokens_.insert(left.tokens.begin(), left.tokens.end());
  left_ = left;
}

void Classroom::leave(Id id) {
  guests_.erase(id);
  if (teacher_ == id) teacher_.reset();
  changed_ = true;
}

bool Classroom::isIn(Id id) const {
  const auto guest = guests_.find(id);
  return guest != guests_.end() && (!guest->second.token.empty() || guest->second.wasTeacher);
}

void Classroom::refuseMessage(Id id) {
  if (const auto guest = guests_.find(id); guest != guests_.end())
    guest->second.refusal = texts::phone::kNoMessage;
}

void Classroom::receive(Id id, const PhoneMessage& message, double now_s) {
  const auto guest = guests_.find(id);
  if (guest != guests_.end()) guest->second.refusal = take(guest->second, id, message, now_s);
}

/// Takes a message. Returns why not, or none.
texts::Text Classroom::take(Guest& guest, Id id, const PhoneMessage& message, double now_s) {
  return std::visit(
      Each{[&](const PhoneHello& hello) { return isTeacher(id) ? texts::Text() : join(guest, hello.token); },
           [&](const PhoneAnswer& given) { return answer(guest, given, now_s); },
           [&](const PhoneReason& reason) -> texts::Text {
             if (!flow_.isOpen() || reason.round != flow_.round()) return texts::phone::kVoteClosed;
             return ballot_.explain(guest.token, reason.round, reason.words) ? texts::Text()
                                                                             : texts::phone::kAnswerFirst;
           },
           [&](const TeacherPin& pin) { return teach(guest, id, pin.pin, now_s); },
           [&](const TeacherStep& step) {
             return isTeacher(id) ? take(step.step, now_s) : texts::phone::kTeacherOnly;
           }},
      message);
}

/// Gives a phone its place again, or a new one if its token is none of ours.
texts::Text Classroom::join(Guest& guest, const std::string& token) {
  if (!guest.token.empty()) return {};
  guest.comesBack = !token.empty();
  if (tokens_.size() >= kMostPhones) {
    // Those that have gone and have not voted can be forgotten.
    std::set<std::string, std::less<>> present;
    for (const auto& [id, other] : guests_) present.insert(other.token);
    std::erase_if(tokens_, [&](const std::string& kept) {
      return kept != token && !present.contains(kept) && !ballot_.has(kept);
    });
  }
  if (tokens_.contains(token)) {
    guest.token = token;
  } else if (tokens_.size() >= kMostPhones) {
    return texts::phone::kFull;
  } else {
    guest.token = *tokens_.insert(newToken_()).first;
  }
  changed_ = true;
  return {};
}

texts::Text Classroom::answer(const Guest& guest, const PhoneAnswer& given, double now_s) {
  if (guest.token.empty()) return texts::phone::kHelloFirst;
  if (!flow_.isOpen() || given.round != flow_.round()) return texts::phone::kVoteClosed;
  if (static_cast<std::size_t>(given.answer) > question_.answers.size()) return texts::phone::kNoMessage;
  ballot_.cast(guest.token, given.round, {given.answer, given.confidence, now_s - opened_s_, {}});
  changed_ = true;
  return {};
}

/// Makes the guest the teacher, in the place of the one before, if the PIN is right.
texts::Text Classroom::teach(Guest& guest, Id id, const std::string& pin, double now_s) {
  switch (gate_.tryPin(pin, guest.address, now_s)) {
    case PinAnswer::wrong:
      return texts::phone::kWrongPin;
    case PinAnswer::tooMany:
      return texts::phone::kTooManyPins;
    case PinAnswer::right:
      break;
  }
  teacher_ = id;
  guest.wasTeacher = changed_ = true;
  return {};
}

bool Classroom::may(ClassStep step) const {
  const bool needsQuestion = step == ClassStep::ask || step == ClassStep::show || step == ClassStep::explain;
  return flow_.may(step) && (question_.isAsked() || !needsQuestion);
}

texts::Text Classroom::take(ClassStep step, double now_s) {
  if (awaited_ && now_s > awaited_->until_s) awaited_.reset();
  if (awaited_ && step == ClassStep::ask) {
    awaited_->asks = true;
    return {};
  }
  if (!may(step)) return question_.isAsked() ? texts::phone::kNotNow : texts::phone::kNoQuestion;
  if (step == ClassStep::close) {
    close();
    return {};
  }
  flow_.take(step);
  if (flow_.isOpen()) opened_s_ = now_s;
  if (step == ClassStep::ask || step == ClassStep::next) ballot_.clear();
  if (step == ClassStep::next) awaited_ = Awaited{now_s + kAwaited_s};
  if (step == ClassStep::ask) wishes_.push_back(LessonWish::ask);
  if (step == ClassStep::show) wishes_.push_back(LessonWish::show);
  if (step == ClassStep::explain) wishes_.push_back(LessonWish::explain);
  if (step == ClassStep::next) wishes_.push_back(LessonWish::next);
  changed_ = true;
  return {};
}

/// Closes the open vote, whose answers count now.
void Classroom::close() {
  flow_.take(ClassStep::close);
  changed_ = true;
  for (const auto& [token, vote] : ballot_.votesOf(flow_.round()))
    votes_.push_back({flow_.round(), question_.lesson, question_.question, token,
                      question_.answers.at(static_cast<std::size_t>(vote.answer - 1)), vote.confidence,
                      vote.seconds, vote.reason});
}

void Classroom::follow(const LessonNews& news, double now_s) {
  changed_ = true;
  const std::optional<Awaited> awaited = news.game ? std::exchange(awaited_, {}) : std::nullopt;
  if (news.game) {
    const bool isSame = news.game->file == question_.file && news.game->question == question_.question;
    if (!isSame || awaited) {
      flow_.begin();
      ballot_.clear();
    }
    question_ = *news.game;
    if (left_) {
      goOnWith(*std::exchange(left_, {}));
      opened_s_ = now_s;
    }
  }
  if (!question_.isAsked()) return;
  const bool moves = news.phase == LessonPhase::shows || news.phase == LessonPhase::explains;
  if (moves && flow_.isOpen()) close();
  const ClassPhase before = flow_.phase();
  flow_.follow(news.phase);
  if (flow_.phase() == ClassPhase::idle && before != ClassPhase::idle) ballot_.clear();
  if (awaited && awaited->asks) take(ClassStep::ask, now_s);
}

/// Goes on where the session broke off, if it was about this question. Answers in a vote that was open are
/// given again.
void Classroom::goOnWith(const ClassLeft& left) {
  const auto* phase = std::find(kClassPhases.begin(), kClassPhases.end(), left.phase);
  const auto found = static_cast<ClassPhase>(phase - kClassPhases.begin());
  const bool isUnderWay =
      found == ClassPhase::vote || found == ClassPhase::closed || found == ClassPhase::discuss;
  if (!isUnderWay || left.round < 1 || left.round > static_cast<int>(kVotes)) return;
  for (const ClassVote& vote : left.votes) {
    const auto answer = std::find(question_.answers.begin(), question_.answers.end(), vote.answer);
    if (vote.question != question_.question || answer == question_.answers.end()) continue;
    ballot_.cast(vote.token, std::clamp(vote.round, 1, static_cast<int>(kVotes)),
                 {static_cast<int>(answer - question_.answers.begin()) + 1, vote.confidence, vote.seconds,
                  vote.reason});
  }
  flow_.resume(found, left.round);
}

}  // namespace carom
