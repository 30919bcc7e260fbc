#pragma once
// Keeps a room playing: starts its nodes again whenever they end before they were asked to, waits for hosts
// that do not answer, and leaves out the walls of those that stay away until they answer again.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/nodes/host_question.h"

namespace carom {

/// The keeper's waiting times.
struct RoomPatience {
  std::vector<double> again_s{5.0, 15.0,
                              60.0};  ///< before the first, second, third and every later new start
  double missing_s = 60.0;            ///< a host that has not answered for so long is left out
  double askAgain_s =
      15.0;  ///< between two questions to hosts that are left out; two answers bring them back
  double playsWell_s = 10.0;  ///< nodes that have played for so long are started again at once
  double noReturn_s = 60.0;  ///< a host that came back in vain stays out for so long, then twice, … as long
  double mostNoReturn_s = 900.0;
};

/// Said of a start that came to nothing, in a session that goes on.
inline constexpr const char* kNoFirstFrame = "the nodes ended before their first frame.";

/// One run of all nodes that take part.
struct RoomRun {
  enum class End {
    finished,     ///< it has come to its end
    askedToEnd,   ///< by a person
    refused,      ///< it cannot begin: the rig, the game or an option is wrong
    cutOff,       ///< a node died or hung, or a host went away
    broughtBack,  ///< the keeper ended it, because a host answers again
  };
  End end = End::finished;
  int status = 0;         ///< exit status
  double played_s = 0.0;  ///< since its first frame; 0 if there was none
};

/// The computers and nodes of the room, as the keeper sees them.
class RoomNodes {
 public:
  virtual ~RoomNodes() = default;
  virtual double now_s() = 0;
  /// Waits. `why` is for those who are not at the terminal. Returns false if the end is asked for.
  virtual bool wait(double duration_s, const std::string& why) = 0;
  /// Returns whether a person has asked for the end.
  virtual bool isAskedToEnd() = 0;
  /// Asks these hosts whether they can take part, and waits for their answers. Returns those that cannot.
  virtual std::vector<HostFault> ask(const std::vector<std::string>& hosts) = 0;
  /// Does the same while the nodes play: begins to ask, and returns the answers at a later call.
  virtual std::optional<std::vector<HostFault>> poll(const std::vector<std::string>& hosts) = 0;
  /// Returns whether the room can play without these hosts: node 0 is on none of them, and a wall is left.
  virtual bool canPlayWithout(const std::vector<std::string>& hosts) = 0;
  /// Returns the walls that these hosts draw, for messages.
  virtual std::string wallsOf(const std::vector<std::string>& hosts) = 0;
  /// Starts the nodes of all other hosts, from where they were, and returns when they have ended. About once
  /// a second `isToEnd` says whether they are to end.
  virtual RoomRun run(const std::vector<std::string>& without, const std::function<bool()>& isToEnd) = 0;
};

class RoomKeeper {
 public:
  /// `hosts`: those of the rig, each once. `leftOut`: those that are to stay out.
  RoomKeeper(RoomNodes& nodes, const std::vector<std::string>& hosts, const std::vector<std::string>& leftOut,
             RoomPatience patience = {});

  /// Keeps the room playing until it has come to its end, is asked to end, or cannot begin at all. Returns
  /// the exit status.
  int keep();

 private:
  struct Host {
    std::string name;
    bool isOutForGood = false;
    bool isOut = false;
    std::optional<double> missing_s{};  ///< since when it has not answered; until it has played well
    int vainStarts = 0;                 ///< without a frame, since it was missing
    int returns = 0;                    ///< in vain
    double returnsFrom_s = 0.0;         ///< while it is out: its answers count from then on
    int answers = 0;                    ///< while it is out: one after the other
  };
  std::optional<int> gather();
  void note(const std::vector<HostFault>& faults, double asked_s, bool isFirst);
  bool leaveOutMissing(const std::vector<HostFault>& faults);
  void leaveOut(Host& host);
  double untilLeftOut_s() const;
  bool hasReturned();
  void learnFrom(const RoomRun& run);
  double pauseAfter(const RoomRun& run);
  std::vector<std::string> names(bool out) const;

  RoomNodes& nodes_;
  RoomPatience patience_;
  std::vector<Host> hosts_;
  bool hasPlayed_ = false;
  bool mayStartAtOnce_ = true;  // once, until the nodes have played well
  std::size_t pauses_ = 0;      // since then
  double nextQuestion_s_ = 0.0;
  std::vector<std::string> asked_;  // the hosts of a question that is not answered yet
};

}  // namespace carom
