// Random games with every invariant on: see README.md.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "app/scenario/scenario.h"
#include "engine/game_invariants.h"
#include "engine/game_shrinker.h"
#include "engine/random_game.h"

namespace carom::test {
namespace {

constexpr std::size_t kMostEvents = 300;
constexpr double kMostShrinking_s = 10.0;

struct Options {
  double minutes = 10.0;
  std::uint64_t seed = 1, games = ~std::uint64_t{0};
  std::size_t shown = 3;  // of each kind of violation, with their scenarios
  std::string scenario;
  double until_s = 10.0;
};

class Bench {
 public:
  explicit Bench(const Options& given) : options_(given) {}

  int run() {
    if (!options_.scenario.empty()) {
      RandomGame game;
      game.kind = options_.scenario;
      game.setup = readScenario(options_.scenario).billiard;
      game.until_s = options_.until_s;
      play(game);
    } else {
      std::printf("from seed %lu, for %g minutes\n", options_.seed, options_.minutes);
      for (std::uint64_t i = 0; i < options_.games && elapsed_s() < 60.0 * options_.minutes; ++i) {
        report(options_.seed + i);
        play(randomGame(options_.seed + i, {.events = kMostEvents}));
      }
    }
    reported_s_ = 0.0;
    report(options_.seed + played_);
    std::fputc('\n', stderr);
    for (const auto& [what, count] : tally_) std::printf("%12zu %s\n", count, what.c_str());
    for (const auto& [kind, count] : kinds_) std::printf("%12zu games: %s\n", count, kind.c_str());
    for (const auto& [kind, count] : violations_)
      std::printf("%12zu games with a violation: %s\n", count, kind.c_str());
    return violations_.empty() ? 0 : 1;
  }

 private:
  double elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  }

  void report(std::uint64_t seed) {
    const double s = elapsed_s();
    if (s - reported_s_ < 0.5) return;
    reported_s_ = s;
    const double collisions = static_cast<double>(count("collisions") + count("bounces"));
    std::fprintf(
        stderr,
        "\r%.0f s: %zu games (%.1f a second), %.0f collisions (%.0f a second), %zu games violate; seed %lu ",
        s, played_, static_cast<double>(played_) / s, collisions, collisions / s, wrong_, seed);
  }
  std::size_t count(const char* what) const {
    const auto found = tally_.find(what);
    return found == tally_.end() ? 0 : found->second;
  }

  void play(const RandomGame& game) {
    const std::vector<Violation> found = violationsOf(game.setup, game.until_s, kMostEvents, tally_);
    ++played_, ++kinds_[game.kind];
    if (!found.empty()) ++wrong_;
    std::vector<std::string> said;
    for (const Violation& violation : found) {
      if (std::find(said.begin(), said.end(), violation.kind) != said.end()) continue;
      said.push_back(violation.kind);
      if (violations_[violation.kind]++ < options_.shown) show(game, violation);
    }
  }

  // With the smallest game that has a violation of its kind.
  void show(const RandomGame& game, const Violation& violation) const {
    std::string what = violation.what;
    if (violation.kind == "no progress")
      return static_cast<void>(
          std::printf("# no progress: seed %lu (%s): %s\n", game.seed, game.kind.c_str(), what.c_str()));
    const double begun_s = elapsed_s();
    const RandomGame small = shrunk(game, [&](const RandomGame& smaller) {
      if (elapsed_s() - begun_s > kMostShrinking_s) return false;
      Tally none;
      for (const Violation& v : violationsOf(smaller.setup, smaller.until_s, kMostEvents, none)) {
        if (v.kind == violation.kind) return what = v.what, true;
      }
      return false;
    });
    std::printf("\n# %s: seed %lu (%s): %s\n# of it, %s\n# to be played until %.17g s\n%s\n",
                violation.kind.c_str(), game.seed, game.kind.c_str(), violation.what.c_str(), what.c_str(),
                small.until_s, scenarioText(small.setup).c_str());
    std::fflush(stdout);
  }

  Options options_;
  Tally tally_, kinds_, violations_;
  std::size_t played_ = 0, wrong_ = 0;
  double reported_s_ = 0.0;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace
}  // namespace carom::test

int main(int argc, char** argv) {
  carom::test::Options options;
  CLI::App app("Random games with every invariant on.");
  app.add_option("minutes", options.minutes, "how long")->capture_default_str();
  app.add_option("--seed", options.seed, "of the first game; the others follow")->capture_default_str();
  app.add_option("--games", options.games, "so many at most");
  app.add_option("--shown", options.shown, "violations of each kind to be shown with their games")
      ->capture_default_str();
  app.add_option("--scenario", options.scenario, "this game instead of random ones");
  app.add_option("--until", options.until_s, "board time to which it is played, in seconds")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    return carom::test::Bench(options).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
