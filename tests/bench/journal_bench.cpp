// What a session's journal costs: time on the frame's thread, bytes, and time to read it again. A minute of a
// game of three pucks at 60 Hz, four times as fast, with a walking head tracked at 120 Hz.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "app/journal/journal.h"
#include "app/journal/session_file.h"
#include "app/scenario/scenario.h"
#include "engine/billiard/billiard.h"
#include "engine/spacetime/observers.h"
#include "places.h"

using namespace carom;

int main() {
  constexpr int kFrames = 3600;
  constexpr double kStep_s = 1.0 / 60.0, kNoise_m = 1e-4;
  const std::filesystem::path config = CAROM_CONFIG_DIR;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("journal_bench_{}.db", std::random_device()());
  const Scenario scenario = readScenario(config / "scenarios/three-pucks.toml");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  std::mt19937 random(1);
  std::normal_distribution<double> noise_m(0.0, kNoise_m);
  const auto headAt = [&](double time_s) {
    Head head;
    head.roomFromHead.position_m = {std::sin(time_s) + noise_m(random), noise_m(random),
                                    1.7 + noise_m(random)};
    head.roomFromHead.orientation =
        glm::normalize(glm::dquat(1.0, 0.01 * std::sin(time_s), noise_m(random), 0.1));
    head.celerity_m_s = {std::cos(time_s), noise_m(random), noise_m(random)};
    return head;
  };
  Billiard billiard(scenario.billiard);
  Observers observer(Lorentz(c_m_s), {0.0, scenario.observer.position_m}, headAt(0.0));
  std::vector<double> took_us;
  {
    Journal journal(file, {"bench", config, config, "", "", c_m_s}, false);
    for (int number = 0; number < kFrames; ++number) {
      const double time_s = number * kStep_s;
      const Head head = headAt(time_s);
      observer.step(kStep_s, head);
      FrameState state;
      state.record.number = static_cast<std::uint64_t>(number);
      state.record.display_s = time_s;
      state.record.lightSpeed_m_s = c_m_s;
      state.record.viewers[0].observer = observer.view(0.064);
      state.record.boardFromRoom = observer.boardFromRoom();
      state.record.pucks = billiard.worldLines().size();
      state.record.viewers[0].tracked = {head.roomFromHead, {}, 1, 0};
      billiard.advanceTo(observer.headEvent().t_s);
      const Changes changes = billiard.takeChanges();
      for (const Changes::NewKnot& knot : changes.knots) state.knots.push_back({1 + knot.puck, knot.knot});
      state.record.eventsKept = changes.eventsKept;
      state.events = changes.events;
      HeadEstimate estimate;
      estimate.celerity_m_s = head.celerity_m_s;
      std::vector<TrackerSample> samples(2);
      for (TrackerSample& sample : samples) sample.time_s = time_s, sample.pose = headAt(time_s).roomFromHead;
      const auto start = std::chrono::steady_clock::now();
      journal.add(state, {&estimate, 1}, std::vector<TrackerSamples>{{0, samples}});
      took_us.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
  }
  const double bytes = static_cast<double>(std::filesystem::file_size(file));
  const auto start = std::chrono::steady_clock::now();
  {
    SessionFile session(file);
    for (FrameState state; session.next(state);) {
    }
  }
  const double read_us =
      std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  std::filesystem::remove(file);
  std::sort(took_us.begin(), took_us.end());
  fmt::print("{:.0f} bytes a frame with its samples: {:.2f} MB a minute; read again in {:.1f} us a frame\n",
             bytes / kFrames, bytes * 1e-6, read_us / kFrames);
  fmt::print(
      "on the frame's thread: median {:.1f} us, 99th percentile {:.1f} us, longest {:.0f} us a frame; the "
      "99th is {:.2f} % of a frame\n",
      took_us[kFrames / 2], took_us[kFrames * 99 / 100], took_us.back(),
      took_us[kFrames * 99 / 100] / (1e6 * kStep_s) * 100.0);
}
