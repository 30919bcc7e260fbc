#include "app/nodes/host_question.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <future>
#include <map>
#include <optional>
#include <string_view>

#include "app/nodes/timed_command.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

constexpr int kConnects_s = 5;  // the time to connect; the rest is for the login

std::string_view lastLineOf(std::string_view text) {
  const std::size_t end = text.rfind('\n');
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

/// Returns what a host said in one line that can be printed.
std::string inOneLine(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3)
    text.replace(at, 1, " / ");
  return printable(text);
}

std::optional<HostFault> faultOf(const std::string& host, const std::string& program,
                                 const std::atomic<bool>& cancelled, double limit_s) {
  constexpr bool kSilent = true;
  const CommandResult said =
      runTimed({"ssh", "-o", "BatchMode=yes", "-o", "LogLevel=ERROR", "-o",
                fmt::format("ConnectTimeout={}", kConnects_s), host, program, "--version"},
               limit_s, cancelled);
  if (said.isCancelled) return {};
  if (said.isTooLate)
    return HostFault{
        host,
        fmt::format("host {} does not answer: ssh was not through within {:g} s, expected its version; does "
                    "its login wait, for example for a network folder?",
                    host, limit_s),
        kSilent};
  if (said.status == 255 || said.status < 0)  // of ssh itself
    return HostFault{
        host,
        fmt::format("host {} does not answer: {}, expected to reach it by ssh without a password", host,
                    inOneLine(said.text)),
        kSilent};
  if (said.status != 0)
    return HostFault{host, fmt::format("host {} does not run {}: {}, expected {} there", host, program,
                                       inOneLine(said.text), CAROM_VERSION)};
  if (lastLineOf(said.text) == CAROM_VERSION) return {};  // shells may greet or warn before it
  return HostFault{host, fmt::format("host {} has another version, {}, expected {} as here", host,
                                     inOneLine(said.text), CAROM_VERSION)};
}

}  // namespace

bool isThisComputer(const std::string& host) {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return host == "localhost" || host == name.data();
}

std::vector<HostFault> askHosts(const std::vector<std::string>& hosts, const std::string& program,
                                const std::atomic<bool>& cancelled, double limit_s) {
  std::map<std::string, std::future<std::optional<HostFault>>> answers;
  for (const std::string& host : hosts) {
    if (isThisComputer(host) || answers.contains(host)) continue;
    answers[host] =
        std::async(std::launch::async, [&, host] { return faultOf(host, program, cancelled, limit_s); });
  }
  std::vector<HostFault> faults;
  for (auto& [host, answer] : answers) {
    if (auto fault = answer.get()) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace carom
