#pragma once
// The event-driven simulation behind `Billiard` (billiard.h says what happens in which order). Each puck
// keeps its next predicted event, a queue orders these events by time, and after an event only the pucks that
// it changed are predicted anew. Inside, c = 1 (times in metres of light), and the pucks are numbered in the
// order of their names.

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/large_pages.h"
#include "engine/billiard/billiard_setup.h"
#include "engine/billiard/cell_grid.h"
#include "engine/billiard/due_queue.h"
#include "engine/billiard/game_history.h"
#include "engine/billiard/jam_solver.h"
#include "engine/billiard/puck_state.h"
#include "engine/collision/corner_contact.h"
#include "engine/collision/corner_kick.h"
#include "engine/collision/cushion_contact.h"
#include "engine/collision/kick.h"
#include "engine/collision/puck_contact.h"
#include "engine/collision/puck_leg.h"
#include "engine/collision/rim_friction.h"
#include "engine/collision/turning.h"

namespace carom {

/// The state of a game. It can be copied; a copy is a point to which the game can return.
class CollisionScheduler {
 public:
  explicit CollisionScheduler(const BilliardSetup& setup);

  /// Commits every event that is due at or before board time `limit`, and the events for which these must
  /// wait. Stops and returns false when the game holds `events` events.
  bool playUntil(double limit, std::size_t events, GameHistory& history);
  /// Returns by how much a collision can come due later than its contact and than its first turn.
  double rollbackWindow() const { return rollbackWindow_; }
  /// Returns the latest due time (board time) of the events committed so far.
  double clock() const { return clock_; }

  void addStroke(const Stroke& stroke);
  /// A puck as it leaves the game.
  struct Withdrawn {
    LegState state;                    ///< on the leg that it follows
    Vec21 u;                           ///< by the kicks that are decided
    std::vector<std::size_t> strokes;  ///< those to come, by their places in the setup
  };
  /// Takes a puck out of the game at board time `t`, to which the game has been played.
  Withdrawn withdraw(std::size_t puck, double t, GameHistory& history);
  /// Removes everything that was written since this copy of the game was made.
  void restore(GameHistory& history) const;

  Ledger ledger() const;
  std::span<const JamNote> jams() const { return jams_; }

  /// What a puck does, by its place in the setup.
  struct CurrentLeg {
    double since = 0.0;  ///< board time at which the leg began that it follows
    Vec21 u;
    bool awaitsTurn = false;  ///< which is decided and has not come
  };
  std::vector<CurrentLeg> currentLegs() const;
  /// Two bodies that have come together and not parted since: their places in the setup, and the contact.
  struct PersistentPair {
    std::array<std::size_t, 2> pucks;
    PersistentContact since;
  };
  std::vector<PersistentPair> persistentPairs() const;

 private:
  static constexpr std::size_t kPucksWithoutCells = 32;

  // collision_scheduler.cpp: what happens next
  int storeStroke(const Stroke& stroke);
  int numberOf(std::size_t puck) const;
  bool isWithdrawn(int i) const { return pucks_[i].mass == 0.0; }
  void flashUntil(double limit, GameHistory& history);
  void step(GameHistory& history);
  bool hasDeferredBefore(double limit);
  void prefetchUpcoming();
  void meet(int i, GameHistory& history);
  void predictMembers(int i, int j);
  bool waitsForItself(int i) const;
  void changeCell(int i, int axis);

  // collision_scheduler_predict.cpp: what will happen
  void predict(int i);
  void predictBoth(int first, int second);
  void predictAmong(int i, int begin, int end);
  void predictAll();
  int enterCell(int i);
  void moveEpoch();
  CoarseFlight coarseFlightOf(int i) const { return coarseFlight(discs_[i], epoch_); }
  // Games of few pucks compare all with all.
  bool usesCells() const { return pucks_.size() > kPucksWithoutCells; }
  void layOutCells();
  void considerCushions(int i, PredictedEvent& best) const;
  void considerCushion(int i, int cushion, PredictedEvent& best) const;
  void considerStrokes(int i, PredictedEvent& best) const;
  // Whether straight flights of discs that pass tell that two pucks do not meet.
  bool excludesDiscs() const { return brake_ == 0.0 && outlines_ == nullptr; }
  int findCandidates(int i, int begin);
  int sortOut(int i, int begin);
  void considerPairs(int i, int begin, int end, PredictedEvent& best);
  void considerPair(int i, int other, PredictedEvent& best);
  static bool isEarlier(double ownTime, int with, const PredictedEvent& than);
  std::optional<Meeting> meetingOf(int first, int second) const;
  const HandledContact* dealtWith(int i, int other) const;
  double decidedAt(int i) const { return predictions_[i].hasDecided ? pucks_[i].decidedAt : -kNever; }
  void noteDecided(int i, double at) { pucks_[i].decidedAt = at, predictions_[i].hasDecided = true; }
  void noteMet(int i, const HandledContact& contact);
  void findCellExit(int i);
  double leavesCell(int i, int axis) const;
  void fetchState(int i) const {
    prefetch(&pucks_[i]);
    if (canPress_) prefetch(&pucks_[i].impactsBegan);
  }
  int wayAlong(int i, int axis) const { return (axis == 0 ? discs_[i].u.x : discs_[i].u.y) > 0.0 ? 1 : -1; }
  // Returns the axis along which the puck's centre leaves its cell first.
  int leavesFirst(int i) const { return predictions_[i].leavesAlongY ? 1 : 0; }
  void schedule(int i);
  void predictDependents(int of);
  void setPredictedEvent(int i, const PredictedEvent& a);
  // Whether the other puck has decided something since that makes it void.
  bool isVoid(const PredictedEvent& a) const {
    return a.kind == PredictedKind::pair &&
           (predictions_[a.with].legNumber != a.otherLeg || a.otherTime >= discs_[a.with].turnsAt ||
            a.otherTime < decidedAt(a.with));
  }

  // collision_scheduler_commit.cpp: what happened
  struct Place {
    LegState turn;
    bool tooLate = false;  // a later turn has already been decided
    // For the signal of a cushion: the leg touched that cushion itself, and the signal of this came first.
    std::optional<CushionContact> touchedBefore;
  };
  // What a contact comes to, in one or several kicks.
  struct PairOutcome {
    SpinningPairKick kick;
    double restitution = 1.0;
    std::array<Vec21, 2> radiated;

    PairOutcome(const SpinningPairKick& first, double e) : kick(first), restitution(e) {
      for (int k = 0; k < 2; ++k) radiated[k] = first.centres.u[k] * first.centres.heat[k];
    }
    void add(const SpinningPairKick& next) {
      for (int k = 0; k < 2; ++k) {
        radiated[k] = radiated[k] + next.centres.u[k] * next.centres.heat[k];
        kick.centres.heat[k] += next.centres.heat[k];
        kick.centres.u[k] = next.centres.u[k], kick.j[k] = next.j[k];
      }
    }
  };
  double collide(int first, int second, const PredictedEvent& a, GameHistory& history);
  void commitKick(const std::array<int, 2>& who, const PairContact& contact,
                  const std::array<LegState, 2>& turn, const PairOutcome& outcome, const PredictedEvent& a,
                  GameHistory& history);
  void bounce(int i, const PredictedEvent& a, GameHistory& history);
  void strike(int i, int stroke, GameHistory& history);
  LegState turnOnFollowedLeg(int i, int which, const PairContact& contact, bool simultaneous) const;
  Place placeTurn(int i, const Vec21& signal, int cushion, const LegState& onFollowedLeg,
                  GameHistory& history);
  Place whereSignalArrives(int i, const Vec21& signal, int cushion, GameHistory& history);
  std::optional<Vec21> cornerBefore(int cushion, const CushionContact& contact) const;
  void bounceAt(int i, int cushion, CushionContact contact, std::size_t foundOn, GameHistory& history);
  void decide(int i, const CommittedLeg& decided, const LegState& turn, GameHistory& history);
  void beginLeg(int i, const Leg& leg, const Turning& turning);
  void beginCommitted(int i);
  // Spin, all 0 in a game in which nothing can turn a puck.
  Turning lastTurning(int i) const {
    if (!turns_) return {};
    return pucks_[i].decided.empty() ? spins_[i].turning : pucks_[i].decided.back().turning;
  }
  // Returns the spin on the last leg decided, at a moment of the puck's own clock.
  Turning turningAt(int i, double properTime) const {
    return turns_ ? spunTurning(i, properTime) : Turning{};
  }
  Turning spunTurning(int i, double properTime) const;
  // Returns the rest mass that moves.
  double massOf(int i, double j) const { return j == 0.0 ? pucks_[i].mass : restMass(spins_[i].body, j); }
  std::optional<SpinningPairKick> pairKick(const std::array<int, 2>& who, const PairContact& contact,
                                           const std::array<LegState, 2>& turn,
                                           const std::array<double, 2>& j, double restitution) const;
  std::optional<SpinningCushionKick> cushionKick(int i, int cushion, const Vec21& touch, const LegState& turn,
                                                 double j, double restitution) const;
  bool receding(const std::array<int, 2>& who, const PairContact& contact, const PredictedEvent& a,
                const std::array<double, 2>& touchAt) const;
  struct Struck {
    Vec21 u;
    double j = 0.0;
  };
  Struck struckBy(int i, const PuckStroke& stroke, const Vec21& u, double j) const;
  double restitution(int i, double usual, double turnTime);
  // Returns the number of the last leg decided, counted from the start of the game.
  std::size_t lastLegNumber(int i) const { return legsBegun(i) + pucks_[i].decided.size(); }
  std::size_t legsBegun(int i) const { return predictions_[i].legNumber + std::size_t{1}; }
  // Returns the leg that the puck follows, for what does not ask for the puck's own clock.
  Leg flightOf(int i) const { return {discs_[i].start, discs_[i].u, 0.0, brake_}; }
  // Returns the leg that the puck follows.
  Leg legOf(int i) const { return {discs_[i].start, discs_[i].u, pucks_[i].properTime, brake_}; }
  Leg lastLeg(int i) const { return pucks_[i].decided.empty() ? legOf(i) : pucks_[i].decided.back().leg; }
  void placeAnew(int i, CommittedLeg kick, GameHistory& history);
  void giveAnew(int i, const Vec21& u, const Turning& turning, CommittedLeg& kick) const;
  void noteBounce(const CommittedLeg& decided, GameHistory& history) const;
  void noteKick(int i, const Vec21& turn);

  // collision_scheduler_corners.cpp: bodies with corners
  const Outline* outlineOf(int i) const {
    return outlines_ == nullptr || !(*outlines_)[i] ? nullptr : &*(*outlines_)[i];
  }
  bool hasCorners(int first, int second) const {
    return outlines_ != nullptr && (outlineOf(first) != nullptr || outlineOf(second) != nullptr);
  }
  void takeOutlines(const BilliardSetup& setup);
  MovingShape movingShape(int i, const Leg& leg, const Turning& turning) const;
  std::optional<CornerContact> cornersMeet(int first, int second) const;
  MovingShape followedFlight(int i) const { return movingShape(i, flightOf(i), spins_[i].turning); }
  const PersistentContact* persistentContact(int first, int second) const;
  bool haveOutlines(int first, int second) const {
    return outlines_ != nullptr && outlineOf(first) != nullptr && outlineOf(second) != nullptr;
  }
  // Whether the last contact of either is with the other, at another place, and its signal on its way.
  bool isStruckAgain(int i, int other) const {
    return haveOutlines(i, other) && predictions_[i].lastPartner == other &&
           predictions_[other].lastPartner == i && !pucks_[i].decided.empty() &&
           !pucks_[other].decided.empty();
  }
  void kickOtherPlaces(const std::array<int, 2>& who, const PairContact& contact, PairOutcome& outcome) const;
  void sendBack(const std::array<int, 2>& who, const PairContact& contact,
                const std::array<LegState, 2>& turn, PairOutcome& outcome) const;
  void notePersistentPair(const std::array<int, 2>& who, const PairContact& contact);
  void forgetParted(int i);
  bool haveParted(int first, int second, PersistentContact& earlier) const;
  bool approachElsewhere(const std::array<int, 2>& who, const PredictedEvent& a, PairContact& contact) const;
  std::optional<CushionContact> touchOf(int i, const Leg& leg, const Turning& turning, int cushion) const;
  std::optional<CushionContact> followedTouchOf(int i, int cushion) const;
  bool isKickedBy(int i, int cushion, const CushionContact& contact) const;
  bool liesOnCushion(int i, int cushion, const CushionContact& contact) const;
  LeveredBody levered(int i, const Vec21& touch, const LegState& at, double j) const;
  std::optional<SpinningPairKick> cornerKick(const std::array<int, 2>& who, const PairContact& contact,
                                             const std::array<Vec21, 2>& u, const std::array<double, 2>& j,
                                             double restitution) const;
  // Whether discs that are pressed, as they can be by bodies with corners, bounce off each other without
  // loss.
  bool discsStayElastic() const { return outlines_ != nullptr && puckRestitution_ == 1.0; }

  // collision_scheduler_jam.cpp: what happens to pucks that press on one another
  void noteImpact(int i, double turnTime, double closing, bool manifold);
  bool isPressed(int i, double t) const;
  void settle(const std::array<int, 2>& who, const PairContact& contact, const std::array<LegState, 2>& turn,
              GameHistory& history);
  bool settleCorners(std::span<const int> who, std::span<const LegState> turn, const Vec21& touch,
                     const Vec21& U, GameHistory& history);
  double slowIn(std::span<const int> who, double hardest) const;
  void gatherJam(const Vec21& U, double earliest);
  bool touch(const JamBody& one, const JamBody& other) const;
  std::optional<LegState> joinsAt(int i, const Vec21& touched, const Vec21& U, double earliest) const;
  JamBody jamBodyOf(int i, const LegState& turn) const;
  JamSolver jamSolver() {
    return {
        {puckRestitution_, cushionRestitution_, outlines_ != nullptr}, cushions_, jamBodies_, jamContacts_};
  }
  bool commitJam(const Vec21& touch, GameHistory& history);
  std::vector<TouchedPlace> placesOf(const JamBody& one, const JamBody& other) const;

  // Fixed by the setup.
  double c_m_s_;
  TurnConvention convention_;
  double puckRestitution_, cushionRestitution_;
  bool canPress_;                    // whether pucks or cushions are inelastic, or some have corners
  double brake_;                     // friction over c²
  RimRules puckRims_, cushionRims_;  // their coefficients of restitution aside
  double slowing_;                   // of spins by the cloth: the rim's γβ in a metre of own time
  bool turns_;                       // whether anything, strokes so far included, can turn a puck
  std::vector<CushionPlane> cushions_;
  /// By puck; null in a game of discs.
  std::shared_ptr<const std::vector<std::optional<Outline>>> outlines_;
  double largestRadius_ = 0.0;
  double boxLowX_ = 0.0, boxLowY_ = 0.0, boxWidth_ = 0.0, boxHeight_ = 0.0;
  std::vector<PuckStroke> strokes_;
  std::vector<std::pair<std::uint32_t, Event>>
      flashes_;  // in the order of time, beside their place in the setup

  // The state of the game, by puck.
  LargeArray<Disc> discs_;  // the legs being followed; the search for partners reads them
  LargeArray<Prediction> predictions_;
  LargeArray<PuckState> pucks_;
  std::vector<PuckSpin> spins_;
  DueQueue queue_;
  CellGrid cells_;
  double epoch_ = 0.0;              // the board time of the flights in the cells
  FoundFlights found_;              // scratch: neighbours
  std::vector<int> near_, void_;    // scratch
  std::vector<JamBody> jamBodies_;  // scratch: the jam that is being settled
  std::vector<JamContact> jamContacts_;
  std::vector<char> inJam_;        // by puck
  std::size_t flashed_ = 0;        // number of flashes listed so far
  std::vector<int> deferred_;      // pucks whose event waits until others have had theirs
  std::size_t deferredLater_ = 0;  // the first of them wait for something after the limit of `playUntil`
  double gammaBound_ = 1.0;        // the greatest γ for which the cells are large enough
  double pairReach_ = 0.0;         // the distance within which two pucks must be compared
  bool cellsTooSmall_ = false;
  unsigned steps_ = 0;
  double rollbackWindow_ = 0.0;
  double clock_ = 0.0;
  Accounts accounts_;
  std::vector<JamNote> jams_;
};

}  // namespace carom
