// The shipped twins, as the program plays them: whoever goes away and comes back has aged less, by as much as
// the sum of the hyperbolae says, at any frame rate; read from the session's file.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/journal/session_file.h"
#include "app/program.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr double kLight_m_s = 1.42, kThrust_m_s2 = 0.9, kOff_s = 2.0;  // as in twins.toml
constexpr double kExact = 1e-9;                                        // of seconds and metres of order ten

std::string rigText(double hz) {
  std::ostringstream text;
  text << "unit = \"m\"\naxes = \"x-right y-up z-back\"\ndisplay_hz = " << hz
       << "\n[head]\ntracker = \"still\"\n[[tracker]]\nname = \"still\"\nkind = \"recorded\"\nsource = "
          "\"still.csv\"\n"
          "[[wall]]\nname = \"front\"\nlower_left = [-1, 0, -1]\nlower_right = [1, 0, -1]\nupper_left = [-1, "
          "2, -1]\n"
          "pixels = [32, 32]\nstereo = \"mono\"\nwindow = { position = [0, 0], size = [32, 32] }\n";
  return text.str();
}

std::string stillText() {
  std::ostringstream text("time_s,x_m,y_m,z_m\n", std::ios::ate);
  for (int i = 0; i < 1300; ++i) text << 0.01 * i << ",0.25,1.6,-0.125\n";
  return text.str();
}

/// The shipped file without its lesson, which would fly again and again.
std::string twinsText() {
  std::ifstream file(CAROM_CONFIG_DIR "/scenarios/twins.toml");
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t lesson = text.find("[lesson]"), board = text.find("[board]");
  EXPECT_LT(lesson, board);
  return text.erase(lesson, board - lesson);
}

/// How long and how far away the board says, of the person's τ: out, back for twice as long, out again to
/// stop. t = (c/a) sinh(aτ/c), x = (c²/a)(cosh(aτ/c) − 1) in each quarter, to and fro.
struct Expected {
  double t_s, away_m;
};
Expected expectedAt(double tau_s) {
  const double k = kThrust_m_s2 / kLight_m_s;
  const double quarter_s = std::sinh(k * kOff_s) / k,
               quarter_m = kLight_m_s / k * (std::cosh(k * kOff_s) - 1.0);
  const auto since = [&](double s) {
    return Expected{std::sinh(k * s) / k, kLight_m_s / k * (std::cosh(k * s) - 1.0)};
  };
  if (tau_s <= kOff_s) return since(tau_s);
  if (tau_s <= 3.0 * kOff_s) {  // around the turning point
    const Expected e = since(tau_s - 2.0 * kOff_s);
    return {2.0 * quarter_s + e.t_s, 2.0 * quarter_m - e.away_m};
  }
  if (tau_s <= 4.0 * kOff_s) {
    const Expected e = since(tau_s - 4.0 * kOff_s);
    return {4.0 * quarter_s + e.t_s, e.away_m};
  }
  return {4.0 * quarter_s + tau_s - 4.0 * kOff_s, 0.0};
}

class Twins : public testing::TestWithParam<double> {};

TEST_P(Twins, WhoComesBackIsYounger) {
  const double hz = GetParam();
  const TemporaryFolder folder;
  folder.file("still.csv", stillText());
  const auto rig = folder.file("room.toml", rigText(hz));
  const auto scenario = folder.file("twins.toml", twinsText());
  const auto frames = static_cast<std::uint64_t>(std::ceil(8.5 * hz));
  const auto result =
      test::runCarom(folder, {"cave", "--no-window", "--rig", rig.string(), "--scenario", scenario.string(),
                              "--frames", std::to_string(frames), "--session", (folder / "s.db").string()});
  ASSERT_EQ(result.status, 0) << result.err;
  SessionFile session(folder / "s.db");
  FrameState state;
  std::uint64_t count = 0;
  bool toured = false;
  while (session.next(state)) {
    ++count;
    const ObserverView& person = state.record.viewers[0].observer;
    const Event& event = person.middle.observation;
    ASSERT_NEAR(person.properTime_s, static_cast<double>(state.record.number) / hz, kExact);
    const Expected expected = expectedAt(person.properTime_s);
    ASSERT_NEAR(event.t_s, expected.t_s, kExact) << "τ " << person.properTime_s;
    // Facing +x on a platform that starts at x = −2.2 m: the head is 0.125 m ahead of it.
    ASSERT_NEAR(event.r_m.x, -2.2 + 0.125 - expected.away_m, kExact) << "τ " << person.properTime_s;
    ASSERT_NEAR(event.r_m.y, -0.25, kExact);
    toured = toured || state.record.drive.mode == DriveMode::tour;
  }
  ASSERT_EQ(count, frames);
  EXPECT_TRUE(toured);
  EXPECT_EQ(state.record.drive.mode, DriveMode::free);
  EXPECT_LT(glm::length(state.record.boardFromRoom.u()), 1e-12);
  const double home_s = state.record.viewers[0].observer.middle.observation.t_s;
  const double k = kThrust_m_s2 / kLight_m_s;
  EXPECT_NEAR(home_s - state.record.viewers[0].observer.properTime_s,
              4.0 * (std::sinh(k * kOff_s) / k - kOff_s), kExact);
  EXPECT_GT(home_s - state.record.viewers[0].observer.properTime_s, 2.3);
}

INSTANTIATE_TEST_SUITE_P(Twins, Twins, testing::Values(60.0, 23.7), [](const auto& rate) {
  return std::to_string(static_cast<int>(rate.param)) + "Hz";
});

}  // namespace
}  // namespace carom
