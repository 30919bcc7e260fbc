#include "app/record_tools/link.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "app/link/link_line.h"
#include "engine/linked/seats.h"

namespace carom {
namespace {

struct LinkOptions {
  std::filesystem::path newKey, show, key;
  std::string test;
};

/// Waits until the line is open. Throws std::runtime_error if it is not in time.
std::uint64_t openedOn(LinkLine& line) {
  constexpr std::chrono::seconds kMost{10};
  const auto end = LinkClock::now() + kMost;
  std::vector<LineNews> news;
  while (LinkClock::now() < end) {
    line.take(news);
    for (const LineNews& one : news)
      if (one.kind == LineNews::Kind::opened) return one.connection;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  throw std::runtime_error(
      "nobody answers with this key, expected a room with carom cave --link listen:PORT and the same key");
}

/// Measures a line for ten seconds and prints what it allows.
void measure(const LinkOptions& options) {
  constexpr std::chrono::seconds kFor{10};
  LinkAddress address = linkAddressOf(options.test);
  if (address.listens) throw std::runtime_error("--test: expected HOST or HOST:PORT");
  LinkLimits limits;
  limits.pings_1_s = 20.0;
  limits.silence = kFor;
  LinkLine line(address, LinkKey::read(options.key), limits);
  const std::uint64_t connection = openedOn(line);
  std::this_thread::sleep_for(kFor);
  const RoundTrip round = line.roundTrip(connection);
  if (round.count == 0) throw std::runtime_error("the line carried nothing");
  fmt::print(
      "round trip: median {:.1f} ms, 99 % {:.1f} ms, least {:.1f} ms, most {:.1f} ms, of {} messages\n",
      1e3 * round.median_s, 1e3 * round.p99_s, 1e3 * round.least_s, 1e3 * round.most_s, round.count);
  fmt::print("stalls: {} longer than twice the median\n", round.stalls);
  fmt::print("light (m/s)  least distance of heads at which hardly anybody waits (m)\n");
  for (const double c_m_s : {0.5, 1.0, 1.42, 3.0, 10.0})
    fmt::print("{:<12} {:.2f}\n", c_m_s, distanceFor_m(round.p99_s, c_m_s));
}

void run(const LinkOptions& options) {
  if (!options.newKey.empty()) {
    const LinkKey key = LinkKey::random();
    key.write(options.newKey);
    fmt::print("{}: the key {} is for both rooms; nobody else may read it\n", options.newKey.string(),
               key.fingerprint());
  } else if (!options.show.empty()) {
    const LinkKey key = LinkKey::read(options.show);
    fmt::print("{}\nfingerprint {}\n", key.letters(), key.fingerprint());
  } else {
    measure(options);
  }
}

}  // namespace

void addLinkTools(CLI::App& app, int& /*status*/) {
  auto options = std::make_shared<LinkOptions>();
  CLI::App* command = app.add_subcommand("link", "Keys of linked rooms, and the line between them");
  CLI::Option_group* what = command->add_option_group("What to do");
  what->add_option("--new-key", options->newKey,
                   "Make a new key in this file, which its owner alone may read")
      ->type_name("FILE");
  what->add_option(
          "--show", options->show,
          "Print the letters of a key, to be read over the phone, and its fingerprint, which logs name")
      ->type_name("FILE");
  CLI::Option* test =
      what->add_option("--test", options->test,
                       "Measure the line to a room that listens, for ten seconds: round trips, and the "
                       "distance at which the rooms need not wait")
          ->type_name("HOST[:PORT]");
  what->require_option(1);
  CLI::Option* key = command->add_option("--key", options->key, "The key, for --test")->type_name("FILE");
  test->needs(key);
  command->footer(
      "Examples:\n  carom link --new-key room.key\n  carom link --show room.key\n"
      "  carom link --test lyon.example.org --key room.key");
  command->callback([options] { run(*options); });
}

}  // namespace carom
