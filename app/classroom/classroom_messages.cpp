// What a class is told: the messages to phones and to the teacher's page, and the view of the walls.

#include <algorithm>
#include <iterator>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/classroom/classroom.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using Json = nlohmann::json;

/// The most reasons that the teacher's page is sent: the newest by the phones' order.
constexpr std::size_t kMostReasons = 40;

Json numbersOf(const VoteCounts& counts, std::size_t choices) {
  Json numbers = Json::array();
  for (std::size_t i = 0; i < choices; ++i) numbers.push_back(counts.at(i));
  return numbers;
}

/// Returns the reasons that were given in the newest vote, and then those of the one before.
Json reasonsIn(const ClassBallot& ballot, int newest) {
  Json reasons = Json::array();
  for (int round = newest; round > 0; --round) {
    for (const auto& [token, vote] : ballot.votesOf(round)) {
      if (!vote.reason.empty() && reasons.size() < kMostReasons) reasons.push_back(vote.reason);
    }
  }
  return reasons;
}

std::string textOf(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

/// Returns the number of phones that are joined now; those whose vote counts have joined.
std::size_t Classroom::phones() const {
  std::set<std::string_view> present;
  for (const auto& [id, guest] : guests_) {
    if (!guest.token.empty() && !isTeacher(id)) present.insert(guest.token);
  }
  return std::max(present.size(), ballot_.answered(flow_.round()));
}

/// Returns the counts of a vote, unless one is open, or it had too few answers.
std::optional<VoteCounts> Classroom::countsToShow(int round) const {
  if (flow_.isOpen() || round > flow_.round()) return {};
  return ballot_.countsOf(round);
}

/// Returns what the teacher might do next, by how many were right: discussion helps most if about half were
/// (C. Crouch and E. Mazur 2001, Am. J. Phys. 69, 970).
std::string Classroom::hint() const {
  constexpr double kFew = 30.0, kMany = 70.0;
  if (flow_.phase() != ClassPhase::closed) return "";
  const std::optional<VoteCounts> counts = countsToShow(flow_.round());
  if (!counts) return texts::format(texts::phone::kTooFew, kLeastForCounts);
  const auto all = static_cast<double>(std::accumulate(counts->begin(), counts->end(), std::uint64_t{0}));
  const double right = 100.0 * static_cast<double>(counts->at(question_.right)) / all;
  if (right < kFew) return texts::format(texts::phone::kHintFew, right);
  if (right > kMany) return texts::format(texts::phone::kHintMany, right);
  return flow_.round() == 1 ? texts::format(texts::phone::kHintDiscuss, right)
                            : texts::format(texts::phone::kHintShow, right);
}

std::string Classroom::messageFor(Id id) {
  const auto found = guests_.find(id);
  if (found == guests_.end()) return {};
  Guest& guest = found->second;
  Json message = Json::object();
  if (const texts::Text refusal = std::exchange(guest.refusal, {})) message["refused"] = refusal.words();
  if (!isIn(id)) return textOf(message);
  const int round = flow_.round();
  message["token"] = guest.token;
  if (guest.comesBack || isTeacher(id)) message["word"] = invitation_.word;  // its page may have another
  message["state"] = kClassPhases.at(static_cast<std::size_t>(flow_.phase()));
  message["round"] = round;
  message["lesson"] = question_.lesson;
  message["question"] = question_.question;
  message["answers"] = question_.answers;
  message["answered"] = ballot_.answered(round);
  message["phones"] = phones();
  message["yours"] = nullptr;
  if (const PhoneVote* const vote = ballot_.voteOf(guest.token, round)) {
    message["yours"] = vote->answer;
    message["confidence"] = vote->confidence;
  }
  if (const PhoneVote* const first = round > 1 ? ballot_.voteOf(guest.token, 1) : nullptr)
    message["first"] = first->answer;
  Json counts = Json::array();
  bool isCounted = false;
  for (int vote = 1; vote <= round; ++vote) {
    const std::optional<VoteCounts> shown = countsToShow(vote);
    counts.push_back(shown ? numbersOf(*shown, question_.answers.size()) : Json::array());
    isCounted = isCounted || shown;
  }
  if (isCounted) message["counts"] = counts;
  if (flow_.phase() == ClassPhase::explained) message["right"] = question_.right + 1;
  if (guest.wasTeacher) message["teacher"] = isTeacher(id);
  if (isTeacher(id)) {
    Json steps = Json::array();
    for (std::size_t step = 0; step < kClassSteps.size(); ++step) {
      if (may(static_cast<ClassStep>(step))) steps.push_back(kClassSteps.at(step));
    }
    message["steps"] = steps;
    message["hint"] = hint();
    message["reasons"] = reasonsIn(ballot_, round);
  }
  return textOf(message);
}

ClassView Classroom::view() const {
  ClassView view;
  view.phase = flow_.phase();
  view.round = static_cast<std::uint8_t>(flow_.round());
  view.choices = static_cast<std::uint8_t>(std::min(question_.answers.size(), kMostAnswers));
  view.right =
      view.phase == ClassPhase::explained ? static_cast<std::uint8_t>(question_.right + 1) : std::uint8_t{0};
  view.answered = ballot_.answered(flow_.round());
  view.phones = phones();
  for (int round = 1; round <= static_cast<int>(kVotes); ++round)
    view.counts.at(static_cast<std::size_t>(round - 1)) = countsToShow(round).value_or(VoteCounts{});
  view.address = ShortText<120>(invitation_.address);
  view.word = ShortText<120>(invitation_.word);
  return view;
}

}  // namespace carom
