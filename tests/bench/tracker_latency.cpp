// How long a sample takes from its sending until a frame loop can read it: through the loopback, the
// transport's thread, the decoder and the queue. With a core to spare, and with every core loaded by other
// work. (Times are kept on one clock, since sender and reader are one program.)
//   tracker_latency [SECONDS]     each of the parts takes so long; 10 if not given
//
// The device's thread asks the system to be prompt (devices/tracker/realtime_thread.h); what it was granted
// is printed. Sender and reader ask for a little more, so that their own waiting for a processor is not
// counted; where that is refused, it is.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "devices/network/dtrack_tracker.h"
#include "devices/network/osc_tracker.h"
#include "devices/osc_sender.h"
#include "devices/tracker/realtime_thread.h"

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr std::uint16_t kPort = 45123;
constexpr std::chrono::milliseconds kBegin{200};  // the tracker listens by then

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Lets the calling thread run before the device's.
void goBeforeTheDevice() {
  const sched_param second{sched_get_priority_min(SCHED_RR) + 1};
  sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &second);
}

/// What is sent at which rate, and what reads it. Poses have their number as x, in millimetres.
struct Sender {
  int rate_hz;
  std::string (*frame)(std::size_t number, double due_s);
  carom::Transport (*transport)();
};

std::string source() { return "udp://127.0.0.1:" + std::to_string(kPort); }

std::string dtrackFrame(std::size_t number, double due_s) {
  return "fr " + std::to_string(number + 1) + "\r\nts " + std::to_string(due_s) + "\r\n6d 1 [0 1.000][" +
         std::to_string(number) + " 0 0][1 0 0 0 1 0 0 0 1]\r\n";
}
carom::Transport dtrack() { return carom::dtrackTransport(carom::readDtrackSource(source())); }

std::string oscFrame(std::size_t number, double due_s) {
  using carom::test::OscSender;
  constexpr double kAnyDay_s = 4e9;  // since 1900
  const auto bytes = OscSender::bundle(
      {OscSender::message("/head/0", {static_cast<float>(number) * 1e-3F, 0, 0, 0, 0, 0, 1})},
      kAnyDay_s + due_s);
  return {bytes.begin(), bytes.end()};
}
carom::Transport osc() {
  carom::OscMapping mapping;
  mapping.pose.emplace("/head/{sensor}", false);
  mapping.values = carom::readOscValues("x y z qx qy qz qw");
  return carom::oscTransport(carom::readOscSource(source()), mapping);
}

/// Sends frames and notes when each was sent.
void send(const Sender& sender, std::vector<std::atomic<double>>& sent_s, Clock::time_point start) {
  goBeforeTheDevice();
  const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(kPort);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (std::size_t i = 0; i < sent_s.size(); ++i) {
    std::this_thread::sleep_until(start + kBegin + i * microseconds(1'000'000 / sender.rate_hz));
    const std::string frame = sender.frame(i, static_cast<double>(i) / sender.rate_hz);
    sent_s[i] = since_s(start);
    sendto(descriptor, frame.data(), frame.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
  close(descriptor);
}

void measure(const char* what, const Sender& by, int seconds, unsigned loaded) {
  std::atomic<bool> ended = false;
  std::vector<std::jthread> load;
  for (unsigned i = 0; i < loaded; ++i) {
    load.emplace_back([&ended] {
      volatile double x = 1.0;
      while (!ended) x = std::sqrt(x + 1.0);
    });
  }
  const Clock::time_point start = Clock::now();
  carom::DeviceTracker tracker(by.transport(), start);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  std::vector<std::atomic<double>> sent_s(static_cast<std::size_t>(seconds * by.rate_hz));
  std::jthread sender([&] { send(by, sent_s, start); });
  std::vector<double> delays_s;
  delays_s.reserve(sent_s.size());
  std::vector<carom::TrackerSample> samples;
  samples.reserve(4096);
  // A frame loop polls once a frame; this one, all the time, so that only the way to the queue is seen.
  while (delays_s.size() < sent_s.size() && since_s(start) < seconds + 2.0) {
    samples.clear();
    tracker.poll(1e9, samples);
    const double now_s = since_s(start);
    for (const carom::TrackerSample& sample : samples) {
      const auto number = static_cast<std::size_t>(std::lround(sample.pose.position_m.x * 1e3));
      delays_s.push_back(now_s - sent_s.at(number));
    }
    std::this_thread::sleep_for(microseconds(20));
  }
  ended = true;
  if (delays_s.empty()) {
    std::fprintf(stderr, "nothing came: is port %d taken?\n", kPort);
    std::exit(1);
  }
  std::sort(delays_s.begin(), delays_s.end());
  const auto part = [&](double p) {
    return delays_s[static_cast<std::size_t>(p * static_cast<double>(delays_s.size() - 1))] * 1e6;
  };
  std::printf(
      "%-28s %6zu of %zu samples   median %5.0f µs   99 %% %5.0f µs   99.9 %% %5.0f µs   all %5.0f µs\n",
      what, delays_s.size(), sent_s.size(), part(0.5), part(0.99), part(0.999), part(1.0));
}

const char* nameOf(carom::Promptness granted) {
  switch (granted) {
    case carom::Promptness::realTime:
      return "real-time";
    case carom::Promptness::nicer:
      return "a better nice value";
    case carom::Promptness::usual:
      break;
  }
  return "nothing: refused";
}

}  // namespace

int main(int argc, char** argv) {
  const int seconds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
  std::jthread([] {
    std::printf("granted to a device's thread: %s\n", nameOf(carom::askForPromptness()));
  }).join();
  goBeforeTheDevice();
  const unsigned all = std::max(1U, std::thread::hardware_concurrency());
  measure("DTRACK, a core to spare:", {240, dtrackFrame, dtrack}, seconds, 0);
  measure("DTRACK, every core loaded:", {240, dtrackFrame, dtrack}, seconds, all);
  measure("OSC at 60 Hz:", {60, oscFrame, osc}, seconds, 0);
  measure("OSC at 240 Hz:", {240, oscFrame, osc}, seconds, 0);
  measure("OSC at 1000 Hz:", {1000, oscFrame, osc}, seconds, 0);
  measure("OSC, every core loaded:", {1000, oscFrame, osc}, seconds, all);
  return 0;
}
