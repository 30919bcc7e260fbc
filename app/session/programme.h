#pragma once
// Which game follows by itself: the playlist's next one after its time, the first one when a visitor has
// gone, and one after the other to attract people while the room is empty.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/operator/command.h"
#include "app/scenario/playlist.h"
#include "app/session/idle_watch.h"

namespace carom {

/// The game to play after this one.
struct NextGame {
  std::string file;                   ///< scenario; empty: none was requested
  bool isForNextVisitor = false;      ///< all settings are as the session began
  bool attracts = false;              ///< the room is empty: it is not recorded
  bool afresh = false;                ///< it begins with its own settings, even if it is the same game
  std::optional<std::size_t> task{};  ///< with which of its tasks it begins; empty: the same, or the first
  std::string recordTo{};             ///< session file from now on; empty: as before
};

/// What a frame tells of the visitor.
struct SignsOfLife {
  double now_s = 0.0;
  bool acted = false;    ///< they did anything
  bool watches = false;  ///< something is shown to them, such as a scripted flight
  Vec3 head_m{0.0};
  bool discusses = false;  ///< a lesson's question stands
};

class Programme {
 public:
  /// How long a game attracts if the playlist does not say.
  static constexpr double kAttract_s = 75.0;
  /// For so long before a visitor is taken to have gone they are asked; for half of the patience at most.
  static constexpr double kCountdown_s = 10.0;

  /// `patience_s`: the next visitor is welcomed after so long without a sign of life; empty: never. Without a
  /// playlist the show and the first game attract by turns.
  Programme(std::string firstGame, std::shared_ptr<const Playlist> playlist,
            std::optional<double> patience_s);

  /// Takes a frame of this game and returns the game that is to follow it now; its file is empty if none is.
  NextGame look(const SignsOfLife& signs, const std::string& playing);
  /// Returns how many seconds are left to a visitor who is to be asked whether they are still there; empty:
  /// none is.
  std::optional<int> countdown(double now_s) const;
  /// From now on no game follows by itself, and none may be chosen but those that `isAllowed` says of their
  /// file: visitors stay in the game that a study gives them.
  using Allowed = std::function<bool(const std::string& file)>;
  void allowOnly(Allowed isAllowed) { isAllowed_ = std::move(isAllowed); }
  /// Returns whether the command chooses a game that is not allowed.
  bool refuses(const Command& command) const;
  /// Says that another game begins, which somebody has chosen.
  void begin() { began_s_.reset(); }
  /// Says that the next visitor is welcomed.
  void welcome();

  /// Returns the game that follows by itself and in how many seconds, for the console; nothing if none does.
  struct Following {
    const PlaylistGame* game;
    double in_s;
  };
  std::optional<Following> following(double now_s, const std::string& playing);

 private:
  NextGame attract(double now_s);

  Allowed isAllowed_;  ///< empty: all are
  std::string firstGame_;
  std::shared_ptr<const Playlist> playlist_;
  std::optional<double> patience_s_;
  std::vector<PlaylistGame> attracting_;
  IdleWatch idle_;
  bool isEmpty_ = true;  ///< no sign of life since the last visitor
  std::optional<double> emptyFrom_s_;
  std::string numbered_;  ///< the scenario whose number in the playlist is `number_`
  std::size_t number_ = 0;
  std::optional<double> began_s_;     ///< of this game; empty: its first frame is to come
  std::optional<std::size_t> shown_;  ///< which of `attracting_` is played
  double shownFrom_s_ = 0.0;
};

}  // namespace carom
