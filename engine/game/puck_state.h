#pragma once
// What the scheduler of a game keeps of each puck: its predicted event, the legs that are decided, the
// contacts that are dealt with, its runs of impacts. Times in metres of light.

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/never.h"
#include "engine/collision/puck_leg.h"
#include "engine/collision/turning.h"
#include "engine/polygons/persistent_contact.h"

namespace carom {

/// In the order of equal times.
enum class PredictedKind : unsigned char { none, turn, stroke, cushion, pair };

/// The next event of a puck.
struct PredictedEvent {
  double ownTime = kNever;     // board time of this puck's centre
  double otherTime = -kNever;  // and of the other's
  int with = -1;               // the other puck, the cushion or the stroke
  unsigned otherLeg = 0;       // the number of the leg on which the other puck was found
  PredictedKind kind = PredictedKind::none;
  bool withoutDelay = false;
  double due() const { return ownTime > otherTime ? ownTime : otherTime; }
};

/// A leg that is decided, but that the centre has not begun.
struct CommittedLeg {
  Leg leg;
  Turning turning;
  Vec21 signal;
  Vec21 uBefore;
  double jBefore = 0.0;
  std::uint64_t event = 0;  // its number
  int cushion = -1;
  bool atOnce = false;
  // For the kick of a cushion: its contact, and the number of the leg on which it was found.
  Vec21 contact;
  double ownTime = 0.0;
  bool withoutDelay = false;
  std::size_t foundOn = 0;
  // Whether a stroke has prevented the contact: it was found on a leg that the stroke has replaced, and the
  // puck did not have it before the stroke.
  bool isPrevented(std::size_t struckLeg, double struckAt) const {
    return foundOn > struckLeg || (foundOn == struckLeg && ownTime > struckAt);
  }
  double heat = 0.0;              // of this puck
  Vec21 radiated, taken, braked;  // four-momenta booked with it
};

/// A pair whose contacts on the legs that both follow are dealt with.
struct HandledContact {
  int puck;
  unsigned leg;
  double until;  // bodies with corners that turn: the time of the contact in their frame; else for good
};

/// What, besides its disc, the predictions of a puck and of its neighbours read and write: one cache line.
struct alignas(64) Prediction {
  PredictedEvent next;
  double leavesCell = kNever;  // when its centre leaves its cell
  unsigned legNumber = 0;      // legs begun before the one that it follows
  int lastPartner = -1;        // the puck it collided with last, if nothing else happened to it since
  int firstDependent = -1;     // of the pucks whose next predicted event is with this one
  int nextDependent = -1, dependentBefore = -1;  // neighbours in the list of the puck that it will meet
  unsigned char metCushions = 0;                 // dealt with on this leg, one bit each
  bool leavesAlongY = false;                     // its cell
  bool hasMet = false;                           // something is in `PuckState::met`
  bool hasDecided = false;                       // `PuckState::decidedAt` is not -kNever
  int leavesAlong() const { return leavesAlongY ? 1 : 0; }  // the axis
};

/// The contact at which a body with corners and another came together, while they have not parted since.
struct PersistentPartner {
  int other;
  PersistentContact contact;     // the puck with the smaller number first
  std::array<unsigned, 2> legs;  // on which they were last found not to have parted
};

/// The rest of a puck's state: a cache line that every collision needs, and seldom needed parts.
struct alignas(64) PuckState {
  std::vector<CommittedLeg> decided;
  double properTime = 0.0;  // when the leg began
  double mass = 0.0;        // 0: the puck has left the game
  double runBegan = -kNever, lastKick = -kNever;
  unsigned file = 0;  // place in the setup
  unsigned short kicksInRun = 0;
  bool jammed = false;

  // The current run of impacts by other pucks, and the hardest of them, as a celerity.
  alignas(64) double impactsBegan = -kNever;
  double lastImpact = -kNever, hardestImpact = 0.0;
  int impacts = 0, jams = 0;  // since other pucks last left it alone; `jams` counts its turns in jams
  double height = 0.0;        // of the centre
  std::vector<int> strokes;   // those still to come

  alignas(64) double decidedAt = -kNever;  // own moment of the last contact that was decided on this leg
  std::vector<HandledContact>
      met;  // pucks whose contact with this leg is dealt with, and the number of their leg
  std::vector<PersistentPartner> partners;

  /// Counts a kick. Returns whether it was the one that makes further kicks plastic (`jammed`).
  bool noteKick(double turnTime, double radius);
  /// Ends `jammed` if the puck has been left in peace.
  void noteRest(double turnTime, double radius);
  /// Counts an impact by another puck; one of many at once, by what presses or lies on the puck, as more.
  void noteImpact(double turnTime, double radius, double closing, bool byMany);
  /// Returns whether other pucks press it at board time `t`: kick it without end in a short time.
  bool isPressed(double t, double radius) const {
    return impacts >= kImpactsOfAJam && !(t - lastImpact > radius);
  }
  static constexpr int kImpactsOfAJam = 64;
};

/// The spin of a puck on the leg that it follows, and what it depends on.
struct PuckSpin {
  SpinningBody body;
  Turning turning;
};

/// A stroke that is to come. c = 1.
struct PuckStroke {
  Vec21 hand;
  double height = 0.0;  // of the hand above the centre
  bool fromHand = false;
  double px = 0.0, py = 0.0;  // momentum over c
  double offset = 0.0;        // to the right of it
};

/// Four-momenta that have left or entered the game, and the heat.
struct Accounts {
  Vec21 radiated, taken, braked, given;
  double heat = 0.0;
};

}  // namespace carom
