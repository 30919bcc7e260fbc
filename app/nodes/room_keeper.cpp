#include "app/nodes/room_keeper.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/text/log.h"

namespace carom {

RoomKeeper::RoomKeeper(RoomNodes& nodes, const std::vector<std::string>& hosts,
                       const std::vector<std::string>& leftOut, RoomPatience patience)
    : nodes_(nodes), patience_(std::move(patience)) {
  for (const std::string& host : hosts) {
    const bool isOut = std::find(leftOut.begin(), leftOut.end(), host) != leftOut.end();
    hosts_.push_back({.name = host, .isOutForGood = isOut, .isOut = isOut});
  }
}

/// Returns the hosts that are left out, or those that are not.
std::vector<std::string> RoomKeeper::names(bool out) const {
  std::vector<std::string> names;
  for (const Host& host : hosts_) {
    if (host.isOut == out) names.push_back(host.name);
  }
  return names;
}

int RoomKeeper::keep() {
  for (;;) {
    if (const auto status = gather()) return *status;
    const RoomRun run = nodes_.run(names(true), [this] { return hasReturned(); });
    switch (run.end) {
      case RoomRun::End::askedToEnd:
        return 0;
      case RoomRun::End::finished:
        return run.status;
      case RoomRun::End::refused:
        if (!hasPlayed_) return run.status;
        log::warn(kNoFirstFrame);
        break;
      case RoomRun::End::cutOff:
      case RoomRun::End::broughtBack:
        break;
    }
    learnFrom(run);
    const double pause_s = pauseAfter(run);
    if (pause_s <= 0.0) continue;
    const std::string why = fmt::format("the nodes are started again in {:g} s", pause_s);
    log::warn(fmt::format("{} (Ctrl-C ends).", why));
    if (!nodes_.wait(pause_s, why)) return 0;
  }
}

/// Asks the hosts until each either answers or is left out. Returns the exit status if the room ends before
/// that.
std::optional<int> RoomKeeper::gather() {
  leaveOutMissing({});  // those that came back in vain
  for (std::size_t turn = 0;; ++turn) {
    const double asked_s = nodes_.now_s();
    const std::vector<HostFault> faults = nodes_.ask(names(false));
    if (nodes_.isAskedToEnd()) return 0;
    const bool isUnfit =
        std::any_of(faults.begin(), faults.end(), [](const HostFault& fault) { return !fault.isSilent; });
    if (isUnfit && !hasPlayed_) {
      for (const HostFault& fault : faults) log::error(fault.words);
      return 1;
    }
    if (faults.empty()) return {};
    note(faults, asked_s, turn == 0);
    if (leaveOutMissing(faults)) continue;
    const double usual_s = patience_.again_s[std::min(turn, patience_.again_s.size() - 1)];
    const double pause_s = std::max(1.0, std::min(usual_s, untilLeftOut_s()));
    std::vector<std::string> missing;
    for (const HostFault& fault : faults) missing.push_back(fault.host);
    const std::string why = fmt::format("the room waits for {}", fmt::join(missing, ", "));
    log::warn(fmt::format("{}: asked again in {:.0f} s (Ctrl-C ends).", why, pause_s));
    if (!nodes_.wait(pause_s, why)) return 0;
  }
}

/// Notes since when hosts are missing. Logs it if they were asked for the first time.
void RoomKeeper::note(const std::vector<HostFault>& faults, double asked_s, bool isFirst) {
  for (const HostFault& fault : faults) {
    const auto found =
        std::find_if(hosts_.begin(), hosts_.end(), [&](const Host& host) { return host.name == fault.host; });
    if (found == hosts_.end()) continue;
    if (!found->missing_s) found->missing_s = asked_s;
    if (isFirst) log::warn(fault.words);
  }
}

/// Leaves out the hosts among the faults that have been missing for too long, and those that were back in
/// vain, if the room can play without them. Returns whether it left any out.
bool RoomKeeper::leaveOutMissing(const std::vector<HostFault>& faults) {
  constexpr int kVainStarts = 2;
  bool isAny = false;
  for (Host& host : hosts_) {
    if (host.isOut || !host.missing_s) continue;
    const bool isMissing = std::any_of(faults.begin(), faults.end(),
                                       [&](const HostFault& fault) { return fault.host == host.name; });
    const bool isLate = isMissing && nodes_.now_s() - *host.missing_s >= patience_.missing_s;
    if (!isLate && host.vainStarts < kVainStarts) continue;
    std::vector<std::string> out = names(true);
    out.push_back(host.name);
    if (!nodes_.canPlayWithout(out)) continue;
    leaveOut(host);
    isAny = true;
  }
  return isAny;
}

void RoomKeeper::leaveOut(Host& host) {
  host.isOut = true;
  host.answers = 0;
  host.vainStarts = 0;
  const double stays_s = patience_.noReturn_s * (std::pow(2.0, host.returns) - 1.0);
  host.returnsFrom_s = nodes_.now_s() + std::min(stays_s, patience_.mostNoReturn_s);
  constexpr int kMostReturns = 16;
  host.returns = std::min(host.returns + 1, kMostReturns);
  log::warn(fmt::format("host {} is left out: its walls ({}) stay dark until it answers again.", host.name,
                        nodes_.wallsOf({host.name})));
}

/// Returns the time until the next missing host may be left out.
double RoomKeeper::untilLeftOut_s() const {
  double least_s = patience_.again_s.back();
  for (const Host& host : hosts_) {
    if (host.isOut || !host.missing_s) continue;
    const double left_s = *host.missing_s + patience_.missing_s - nodes_.now_s();
    if (left_s > 0.0) least_s = std::min(least_s, left_s);
  }
  return least_s;
}

/// Asks the hosts that are left out, while the others play. Returns whether one is back.
bool RoomKeeper::hasReturned() {
  const double now_s = nodes_.now_s();
  if (now_s < nextQuestion_s_) return false;
  if (asked_.empty()) {
    for (const Host& host : hosts_) {
      if (host.isOut && !host.isOutForGood && now_s >= host.returnsFrom_s) asked_.push_back(host.name);
    }
  }
  if (asked_.empty()) return false;
  const auto faults = nodes_.poll(asked_);
  if (!faults) return false;
  const std::vector<std::string> asked = std::exchange(asked_, {});
  nextQuestion_s_ = now_s + patience_.askAgain_s;
  bool isBack = false;
  constexpr int kAnswers = 2;  // a computer that has just begun answers before it can draw
  for (Host& host : hosts_) {
    if (!host.isOut || std::find(asked.begin(), asked.end(), host.name) == asked.end()) continue;
    const bool answers = std::none_of(faults->begin(), faults->end(),
                                      [&](const HostFault& fault) { return fault.host == host.name; });
    host.answers = answers ? host.answers + 1 : 0;
    if (host.answers < kAnswers) continue;
    host.isOut = false;
    isBack = true;
    log::note(fmt::format("Host {} answers again: the nodes are started again with its walls ({}).",
                          host.name, nodes_.wallsOf({host.name})));
  }
  return isBack;
}

/// Notes which of the hosts that were missing have played.
void RoomKeeper::learnFrom(const RoomRun& run) {
  hasPlayed_ = hasPlayed_ || run.played_s > 0.0;
  for (Host& host : hosts_) {
    const bool hasJustReturned = run.end == RoomRun::End::broughtBack && host.answers > 0;
    if (host.isOut || hasJustReturned || !host.missing_s) continue;
    host.answers = 0;
    if (run.played_s >= patience_.playsWell_s) {
      host.missing_s.reset();
      host.vainStarts = 0;
      host.returns = 0;
    } else if (run.played_s <= 0.0) {
      ++host.vainStarts;
    }
  }
}

/// Returns the time to wait before the nodes are started again.
double RoomKeeper::pauseAfter(const RoomRun& run) {
  if (run.end == RoomRun::End::broughtBack) return 0.0;
  if (run.played_s >= patience_.playsWell_s) {
    mayStartAtOnce_ = true;
    pauses_ = 0;
  }
  if (run.played_s > 0.0 && std::exchange(mayStartAtOnce_, false)) return 0.0;
  const std::size_t at = std::min(pauses_, patience_.again_s.size() - 1);
  ++pauses_;
  return patience_.again_s[at];
}

}  // namespace carom
