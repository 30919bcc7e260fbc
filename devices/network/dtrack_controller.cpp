#include "devices/network/dtrack_controller.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "devices/tracker/retry.h"

namespace carom {
namespace {

constexpr std::size_t kMostAnswer = 4096;
constexpr std::chrono::milliseconds kGoodbye{200};

/// Sends a command with its zero byte.
void sendCommand(Socket& socket, std::string_view command) {
  std::vector<std::uint8_t> bytes(command.begin(), command.end());
  bytes.push_back(0);
  socket.send(bytes);
}

}  // namespace

std::optional<DtrackAnswer> DtrackController::receive(std::string_view asked,
                                                      std::chrono::milliseconds longest,
                                                      const std::stop_token& stop) {
  std::string answer;
  const auto end = std::chrono::steady_clock::now() + longest;
  while (std::chrono::steady_clock::now() < end) {
    if (stop.stop_requested()) throw std::runtime_error("stopped");
    if (!waitReadable({&*socket_}, std::min(kLookAtStop, longest))) continue;
    std::array<std::uint8_t, 512> bytes{};
    const auto count = socket_->receive(bytes);
    if (!count) continue;
    if (*count == 0) throw std::runtime_error("the controller at " + toString(endpoint_) + " hung up");
    const std::string came(bytes.begin(), bytes.begin() + *count);
    answer += came.substr(0, came.find('\0'));
    if (came.find('\0') != std::string::npos) return readDtrackAnswer(answer, asked);
    if (answer.size() > kMostAnswer) {
      throw std::runtime_error("what answers at " + toString(endpoint_) +
                               " is no DTRACK controller: its answer does not end");
    }
  }
  return {};
}

DtrackAnswer DtrackController::ask(std::string_view command, std::string_view asked,
                                   const std::stop_token& stop) {
  sendCommand(*socket_, command);
  const auto answer = receive(asked, patience_, stop);
  if (answer) return *answer;
  throw std::runtime_error("the controller at " + toString(endpoint_) + " did not answer '" +
                           std::string(command) + "' within " +
                           std::to_string((patience_.count() + 999) / 1000) + " s");
}

void DtrackController::start(const std::stop_token& stop) {
  using Kind = DtrackAnswer::Kind;
  socket_.reset();
  socket_.emplace(Socket::connectedTo(resolve(endpoint_, stop), stop));
  const DtrackAnswer status = ask("dtrack2 get status active", "status active", stop);
  if (status.kind == Kind::value && (status.text == "mea" || status.text == "wait")) return;  // it measures
  if (status.kind == Kind::unknown) {
    throw std::runtime_error("what answers at " + toString(endpoint_) +
                             " is no DTRACK2 or DTRACK3: it says '" + status.text + "'");
  }
  begun_ = true;  // also if the answer comes too late: it is stopped in any case
  const DtrackAnswer started = ask("dtrack2 tracking start", {}, stop);
  if (started.kind == Kind::ok) return;
  begun_ = false;
  throw std::runtime_error("the controller at " + toString(endpoint_) +
                           " does not start measuring: it says '" + started.text +
                           "'. Another program may hold its full access, or the room is not calibrated");
}

void DtrackController::stop() noexcept {
  if (!begun_) return;
  begun_ = false;
  try {
    sendCommand(*socket_, "dtrack2 tracking stop");
    receive({}, kGoodbye, {});
  } catch (const std::exception&) {
    // The controller is gone, and with it what could be stopped.
  }
}

}  // namespace carom
