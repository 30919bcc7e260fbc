#include "app/room_commands/link_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/link/link_line.h"
#include "app/link/link_socket.h"
#include "engine/linked/final_digest.h"
#include "engine/linked/seats.h"

namespace carom {
namespace {

/// Returns the round trips of the line to another room; nothing if no one there answers with the key.
std::optional<RoundTrip> roundTripTo(const LinkAddress& address, const LinkKey& key) {
  constexpr std::chrono::seconds kAnswers{5}, kMeasures{2};
  LinkLimits limits;
  limits.pings_1_s = 20.0;
  LinkLine line(address, key, limits);
  const auto end = LinkClock::now() + kAnswers;
  std::vector<LineNews> news;
  while (LinkClock::now() < end) {
    line.take(news);
    const auto opened = std::ranges::find(news, LineNews::Kind::opened, &LineNews::kind);
    if (opened != news.end()) {
      std::this_thread::sleep_for(kMeasures);
      return line.roundTrip(opened->connection);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return std::nullopt;
}

void lookAtLine(const LinkAddress& address, const LinkKey& key, NodeHealth& report) {
  if (address.listens) {
    listenAt(address);
    report.facts.emplace_back("link", fmt::format("{} is free", address.text()));
    return;
  }
  const std::optional<RoundTrip> round = roundTripTo(address, key);
  if (!round) {
    report.warnings.push_back(fmt::format(
        "link: {} does not answer with this key, expected a room with carom cave --link listen:{}",
        address.text(), address.port));
    return;
  }
  constexpr double kUsual_m_s = 1.42;
  report.facts.emplace_back(
      "link",
      fmt::format(
          "{} answers: round trip {:.1f} ms, 99 % {:.1f} ms; at {} m/s hardly anybody waits where heads "
          "stay {:.2f} m apart",
          address.text(), 1e3 * round->median_s, 1e3 * round->p99_s, kUsual_m_s,
          distanceFor_m(round->p99_s, kUsual_m_s)));
}

}  // namespace

void lookAtLink(const Rig& rig, NodeHealth& report) try {
  if (!rig.link) return;
  const LinkKey key = LinkKey::read(rig.link->key);
  report.facts.emplace_back("link", fmt::format("{}, key {}, arithmetic {:016x}", rig.link->name,
                                                key.fingerprint(), arithmeticFingerprint()));
  if (!rig.link->with.empty()) lookAtLine(linkAddressOf(rig.link->with), key, report);
} catch (const std::exception& error) {
  report.errors.emplace_back(error.what());
}

}  // namespace carom
