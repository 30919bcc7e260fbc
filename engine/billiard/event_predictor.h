#pragma once
// Finds what each puck will meet next (`Prediction::next`), and gives it its place in the queue. c = 1.

#include <vector>

#include "engine/billiard/due_queue.h"
#include "engine/game/game_state.h"
#include "engine/impact/neighbours.h"

namespace carom {

class EventPredictor {
 public:
  /// For the state of a game as it is now, at the board time `clock`. `scratch` is memory to use again.
  EventPredictor(GameState& game, Neighbours& neighbours, DueQueue& queue, std::vector<int>& scratch,
                 double clock)
      : game_(game), neighbours_(neighbours), queue_(queue), void_(scratch), clock_(clock) {
    neighbours_.update(game_, clock_);
  }

  /// Lays out the cells and predicts all.
  void predictAll();
  void predict(int i);
  void predictBoth(int first, int second);
  /// Predicts those that counted on meeting this puck, if that has become void.
  void predictDependents(int of);
  /// Puts a puck into the cell that it enters, and looks at the pucks that come near with this.
  void crossCells(int i);

 private:
  void predictAmong(int i, int begin, int end);
  int findNear(int i, int begin);
  void considerCushions(int i, PredictedEvent& best) const;
  void considerCushion(int i, const Leg& leg, int cushion, PredictedEvent& best) const;
  void considerStrokes(int i, PredictedEvent& best) const;
  void considerPairs(int i, int begin, int end, PredictedEvent& best);
  void considerPair(int i, int other, PredictedEvent& best);
  void setPredictedEvent(int i, const PredictedEvent& a);
  void schedule(int i);
  bool isVoid(const PredictedEvent& a) const;

  GameState& game_;
  Neighbours& neighbours_;
  DueQueue& queue_;
  std::vector<int>& void_;
  double clock_;
};

}  // namespace carom
