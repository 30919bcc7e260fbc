#pragma once
// A study while people take part: which page each participant sees, what they answer, and which lesson is
// wanted in the room. The pages come from a thread of their own; frames never wait for them.

#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/study/allocation.h"
#include "app/study/form_fields.h"
#include "app/study/study_orders.h"
#include "app/study/study_pages.h"
#include "app/study/study_tables.h"

namespace carom {

/// What the study wants of the room: a lesson of a participant, or that it waits.
struct RoomWish {
  std::string code;                               ///< empty: the room waits
  std::size_t lesson = 0, position = 0, arm = 0;  ///< indices of lesson and arm; the place in their order
};

class StudyRun {
 public:
  struct Setup {
    Study study;
    std::map<std::string, std::size_t> slips;  ///< number by code
    std::string consent;                       ///< the text of its page
    std::function<std::string()> newToken;     ///< another one at each call
    std::function<std::string()> today;        ///< YYYY-MM-DD, UTC
    std::vector<bool> armsHere{};              ///< whether the room of each arm is this one; empty: of all
  };
  /// Goes on with the participants that the tables have, which must outlive this.
  StudyRun(Setup setup, StudyTables& tables);
  ~StudyRun() { store(); }
  StudyRun(const StudyRun&) = delete;
  StudyRun& operator=(const StudyRun&) = delete;

  /// Takes a form, and returns the address of the page that follows. `now_s` is of any steady clock. The
  /// address names the person by a token that is of no use once they are done, have stopped, or have typed
  /// their code again: going back on that tablet then leads to the page that asks for a code.
  std::string take(std::string_view form, double now_s);
  /// Returns the page of an address, from what follows its question mark, which may be empty. Changes
  /// nothing: it may be asked for again.
  std::string page(std::string_view query);

  // For the thread of the frames, which none of these lets wait.
  std::optional<RoomWish> takeWish();
  /// Carries out an order of the console. Returns what came of it; none while a page is made: order it again.
  std::optional<std::string> order(const StudyOrder& order, double now_s);
  /// Returns whether the person in the room is to be asked now how they feel: every ten minutes, and again
  /// until they have answered.
  bool asksUnwell(double now_s);
  /// Returns how far everybody is who is not done, if that has changed since the last call.
  std::optional<std::vector<StudyStanding>> takeStandings();
  /// Tells the time of the session.
  void tell(double session_s) { session_s_ = session_s; }

  const Study& study() const { return setup_.study; }
  /// Records that the newest game of the session is this lesson.
  void lessonBegins(const RoomWish& wish);
  /// Notes that this lesson has explained itself. Returns false while a page is made: say it again.
  bool lessonExplains(const RoomWish& wish);

 private:
  struct Place {
    ParticipantRow row;
    Participant plan;
    std::map<std::pair<std::string, std::string>, ResponseRow> responses;  ///< by phase and item
    std::size_t item = 0;
    double shown_s = 0.0, askedUnwell_s = 0.0;
    bool isUnwell = false, asksUnwell = false;
    bool asksStop = false, asksOnwards = false;  ///< the page asks once before it is final
    bool hasExplained = false;                   ///< the present lesson has
    bool needsGuardian = false;                  ///< is under age, without the consent of a guardian
    std::string notice;                          ///< why the last form was not taken
  };
  using Refusal = std::string;

  std::string enter(const FormFields& fields, double now_s);
  std::string enter(const std::string& typed, double now_s);
  std::string addressOf(std::string page);
  std::string endOf(const Place& place) const;
  Refusal refusalOf(const std::string& code) const;
  std::string carryOut(const CallCode& called, double now_s);
  std::string carryOut(const RateUnwell& rated, double now_s);
  std::string carryOut(const StopInRoom& stopped, double now_s);
  Place& placeOf(const std::string& code);
  Refusal take(Place& place, const FormFields& fields, double now_s);
  Refusal takeConsent(Place& place, const FormFields& fields);
  Refusal takeBackground(Place& place, const FormFields& fields);
  void takeItem(Place& place, const FormFields& fields, double now_s);
  Refusal takeRatings(Place& place, std::span<const RatingQuestion> questions, const FormFields& fields,
                      double now_s);
  void takeLesson(Place& place, const std::string& go, double now_s);
  void askUnwell(Place& place, double now_s);
  void stop(Place& place);
  void goTo(Place& place, StudyStep step);
  void enterRoom(Place& place);
  void leaveRoom(const Place& place);
  std::string render(const Place& place, const std::string& token) const;
  std::string renderTest(const Place& place, const StudyPageFrame& frame) const;
  std::vector<const Item*> itemsOf(const Place& place) const;
  void keep(Place& place, ResponseRow row, bool isChanged);
  void store();
  std::string wordsOf(const Place& place) const;
  void tellOperator(const Place& place);

  Setup setup_;
  StudyTables& tables_;
  std::vector<Participant> planned_;
  std::mutex mutex_;
  std::map<std::string, Place> places_;          ///< by code
  std::map<std::string, std::string> codes_;     ///< by token
  std::map<std::string, std::string> pages_;     ///< by token: refusals and ends, of no participant
  std::deque<std::function<void()>> unwritten_;  ///< rows that wait for the disk
  std::optional<RoomWish> wish_;
  std::string inRoom_, called_;  ///< codes; called: at the console, and not yet on a page
  std::string withdrawn_;        ///< marks of the codes whose data were deleted
  bool isNews_ = true;           ///< the console has not seen how far everybody is
  bool isTroubled_ = false;
  std::atomic<double> session_s_{0.0};
};

}  // namespace carom
