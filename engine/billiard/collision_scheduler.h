#pragma once
// The anticipation of `Billiard` (billiard.h, which says what happens in which order): each puck holds its
// next predicted event, a queue says whose is due first, and only what an event changed is predicted anew.
// Inside, c = 1 (times in metres of light) and the pucks are numbered in the order of their names.

#include <limits>
#include <span>
#include <vector>

#include "engine/billiard/billiard_setup.h"
#include "engine/billiard/cell_grid.h"
#include "engine/billiard/due_queue.h"
#include "engine/billiard/game_history.h"
#include "engine/collision/cushion_contact.h"
#include "engine/collision/kick.h"
#include "engine/collision/puck_contact.h"
#include "engine/collision/puck_leg.h"

namespace carom {

/// A game that can be copied: a copy is a point in the game to which one can return.
class CollisionScheduler {
 public:
  explicit CollisionScheduler(const BilliardSetup& setup);

  /// Commits everything that is due at or before board time `limit`, and what that must wait for; or stops,
  /// returning false, when the history holds that many events.
  bool playUntil(double limit, std::size_t events, GameHistory& history);
  /// How much later than its contact and than its first turn a collision can come due.
  double rollbackWindow() const { return rollbackWindow_; }
  /// The latest board time anything committed so far was due at.
  double clock() const { return clock_; }

  void addStroke(const Stroke& stroke);
  /// Takes back what was written since this copy of the game was made.
  void restore(GameHistory& history) const;

  Ledger ledger() const;
  std::span<const JamNote> jams() const { return jams_; }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  enum class Kind : unsigned char { none, turn, stroke, cushion, pair };  // in the order of equal times
  // What a puck meets next.
  struct PredictedEvent {
    Kind kind = Kind::none;
    bool withoutDelay = false;
    int with = -1;               // the other puck, the cushion or the stroke
    unsigned otherLeg = 0;       // the number of the leg on which the other puck was found
    double ownTime = kNever;     // board time of this puck's centre
    double otherTime = -kNever;  // and of the other's
    double touchAt = 0.0;  // with friction: board time at which the straight flights touch the world lines
    double due() const { return ownTime > otherTime ? ownTime : otherTime; }
  };
  // A leg that is certain, but that the centre has not begun.
  struct CommittedLeg {
    Leg leg;
    Vec21 signal;
    Vec21 uBefore;
    std::uint64_t event = 0;  // its number
    int cushion = -1;
    bool atOnce = false;
    // Of a cushion's kick: its contact, and the number of the leg that this was found on.
    Vec21 contact;
    double ownTime = 0.0;
    bool withoutDelay = false;
    std::size_t foundOn = 0;
    // A contact of a leg that is no more, unless the puck had it before that leg was struck.
    bool isPrevented(std::size_t struckLeg, double struckAt) const {
      return foundOn > struckLeg || (foundOn == struckLeg && ownTime > struckAt);
    }
    double heat = 0.0;              // of this puck
    Vec21 radiated, taken, braked;  // four-momenta booked with it
  };
  struct HandledContact {
    int puck;
    unsigned leg;
  };
  // A puck beside its disc. What others read of it lies together.
  struct alignas(64) PuckState {
    double decidedAt = -kNever;  // own moment of the last contact that was decided on this leg
    unsigned legNumber = 0;
    int lastPartner = -1;  // with whom it collided last, if nothing else happened since
    std::vector<HandledContact>
        met;  // pucks, on the named leg of theirs, whose contact with this leg is dealt with
    std::array<double, 2> leavesCell{kNever, kNever};  // when its centre does, along each axis
    unsigned metCushions = 0;                          // as `met`, of cushions, one bit each

    Leg leg;  // that it follows
    std::vector<CommittedLeg> decided;
    std::vector<int> strokes;  // still to come
    double mass = 0.0;
    double height = 0.0;    // of the centre
    std::size_t file = 0;   // place in the setup
    std::size_t begun = 1;  // legs begun
    double runBegan = -kNever, lastKick = -kNever;
    int kicksInRun = 0;
    bool jammed = false;
    // By other pucks: the run of blows that it is in, and the hardest of them, as a celerity.
    double blowsBegan = -kNever, lastBlow = -kNever, hardestBlow = 0.0;
    int blows = 0, jams = 0;  // since it was last in peace; `jams` are its turns in them
  };
  struct PuckStroke {
    Vec21 hand;
    double height = 0.0;  // of the hand above the centre
    bool fromHand = false;
    double px = 0.0, py = 0.0;  // momentum over c
  };
  struct Accounts {
    Vec21 radiated, taken, braked, given;
    double heat = 0.0;
  };

  // collision_scheduler.cpp: what happens next
  int storeStroke(const Stroke& stroke);
  void flashUntil(double limit, GameHistory& history);
  void step(GameHistory& history);
  bool hasDeferredBefore(double limit);
  void prefetchUpcoming();
  void fetchDiscs(int found) const;
  void meet(int i, GameHistory& history);
  bool waitsForItself(int i) const;
  void changeCell(int i, int axis);

  // collision_scheduler_predict.cpp: what will happen
  void predict(int i);
  void predictAll();
  int enterCell(int i);
  void layOutCells();
  void considerCushions(int i, PredictedEvent& best) const;
  void considerCushion(int i, int cushion, PredictedEvent& best) const;
  void considerStrokes(int i, PredictedEvent& best) const;
  void considerPairs(int i, int found, PredictedEvent& best);
  void considerPair(int i, int other, PredictedEvent& best);
  static bool isEarlier(double ownTime, int with, const PredictedEvent& than);
  std::optional<Meeting> meetingOf(int first, int second, double& touchAt) const;
  double leavesCell(int i, int axis) const;
  int wayAlong(int i, int axis) const { return (axis == 0 ? discs_[i].u.x : discs_[i].u.y) > 0.0 ? 1 : -1; }
  // The axis along which its centre leaves its cell first.
  int leavesFirst(int i) const { return pucks_[i].leavesCell[1] < pucks_[i].leavesCell[0] ? 1 : 0; }
  void schedule(int i);
  void predictDependents(int of);
  void setPredictedEvent(int i, const PredictedEvent& a);
  // Has the other puck decided something since that voids it?
  bool isVoid(const PredictedEvent& a) const {
    return a.kind == Kind::pair &&
           (pucks_[a.with].legNumber != a.otherLeg || a.otherTime >= discs_[a.with].turnsAt ||
            a.otherTime < pucks_[a.with].decidedAt);
  }

  // collision_scheduler_commit.cpp: what happened
  struct Place {
    LegState turn;
    bool tooLate = false;  // a later turn is decided already
    // Of a cushion's signal: the leg touched that cushion itself, and the signal of this came first.
    std::optional<CushionContact> touchedBefore;
  };
  void collide(int first, int second, const PredictedEvent& a, GameHistory& history);
  void bounce(int i, const PredictedEvent& a, GameHistory& history);
  void strike(int i, int stroke, GameHistory& history);
  LegState turnOnFollowedLeg(int i, int which, const PairContact& contact, bool simultaneous) const;
  Place placeTurn(int i, const Vec21& signal, int cushion, const LegState& onFollowedLeg,
                  GameHistory& history);
  Place whereSignalArrives(int i, const Vec21& signal, int cushion, GameHistory& history);
  std::optional<Vec21> cornerBefore(int cushion, const CushionContact& contact) const;
  void bounceAt(int i, int cushion, CushionContact contact, std::size_t foundOn, GameHistory& history);
  void decide(int i, const CommittedLeg& decided, const LegState& turn, GameHistory& history);
  void beginLeg(int i, const Leg& leg);
  void beginCommitted(int i);
  double restitution(int i, double usual, double turnTime);
  // The number of the last leg decided, counted from the start of the game.
  std::size_t lastLegNumber(int i) const { return pucks_[i].begun + pucks_[i].decided.size(); }
  const Leg& lastLeg(int i) const {
    return pucks_[i].decided.empty() ? pucks_[i].leg : pucks_[i].decided.back().leg;
  }
  void placeAnew(int i, CommittedLeg kick, GameHistory& history);
  void noteBounce(const CommittedLeg& decided, GameHistory& history) const;
  void noteKick(int i, const Vec21& turn);

  // collision_scheduler_jam.cpp: what happens to pucks that press on one another
  struct Member {
    int puck = 0;
    LegState turn;  // before
    Vec21 u;        // after
    double heat = 0.0;
    Vec21 radiated, taken;
    unsigned cushions = 0;  // that it touches, one bit each
    int body = 0;           // the first of those it moves on with
    int changed = 0;        // the last sweep that changed it
  };
  struct Press {
    int first = 0, second = 0;  // places among the members
  };
  void noteBlow(int i, double turnTime, double closing, bool byPressed);
  bool isPressed(int i, double t) const;
  void settle(const std::array<int, 2>& who, const PairContact& contact, const std::array<LegState, 2>& turn,
              GameHistory& history);
  void gatherJam(const std::array<int, 2>& who, const PairContact& contact,
                 const std::array<LegState, 2>& turn);
  std::optional<LegState> joinsAt(int i, const Vec21& touched, const Vec21& U, double earliest) const;
  static void kicked(Member& member, const Vec21& u, double heat);
  void addMember(int i, const LegState& turn);
  void relax(double slow);
  void moveOnTogether(double slow);
  void leaveCushions(Member& member, double slow);
  void commitJam(const PairContact& contact, GameHistory& history);

  // Fixed by the setup.
  double c_m_s_;
  TurnConvention convention_;
  double puckRestitution_, cushionRestitution_;
  double brake_;  // friction over c²
  std::vector<CushionPlane> cushions_;
  double largestRadius_ = 0.0;
  double boxLowX_ = 0.0, boxLowY_ = 0.0, boxWidth_ = 0.0, boxHeight_ = 0.0;
  std::vector<PuckStroke> strokes_;
  std::vector<std::pair<std::uint32_t, Event>>
      flashes_;  // in the order of time, beside their place in the setup

  // The state of the game, by puck.
  std::vector<Disc> discs_;  // of the legs being followed; what the search for partners reads
  std::vector<PuckState> pucks_;
  struct alignas(64) Prediction {
    PredictedEvent next;
    int firstDependent = -1;  // of those whose next predicted event is with this puck
    int nextDependent = -1,
        dependentBefore = -1;  // beside this puck in the list of the one that it will meet
  };
  std::vector<Prediction> predictions_;
  DueQueue queue_;
  CellGrid cells_;
  std::vector<int> near_, void_;  // scratch
  std::vector<Member> members_;   // scratch: the jam that is being settled
  std::vector<Press> presses_;
  std::vector<char> inJam_;        // by puck
  std::array<int, 21> fetched_{};  // by place in the queue: whose data are already on their way from memory
  std::size_t flashed_ = 0;        // of the flashes
  std::vector<int> deferred_;      // pucks that were put off until others have had their events
  double gammaBound_ = 1.0;        // that the cells are made for
  double pairReach_ = 0.0;         // from how far apart two pucks must know of each other
  bool cellsTooSmall_ = false;
  double rollbackWindow_ = 0.0;
  double clock_ = 0.0;
  Accounts accounts_;
  std::vector<JamNote> jams_;
};

}  // namespace carom
