#include "app/room_commands/room.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <future>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "app/nodes/mpirun_line.h"
#include "app/nodes/rig_without.h"
#include "app/nodes/room_job.h"
#include "app/nodes/room_keeper.h"
#include "app/nodes/status_writer.h"
#include "app/rig/rig.h"
#include "app/room_commands/room_session.h"
#include "app/scenario/scenario.h"
#include "app/tools/option_values.h"
#include "cave/cluster/cluster.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

constexpr double kStarts_s = 180.0;  // the time until the first frame
constexpr double kJudges_s = 90.0;   // the time that `carom doctor` gets

std::atomic<bool> asked = false;  // someone asked for the end
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void notice(int) { asked = true; }

void noticeSignals() {
  struct sigaction action {};
  action.sa_handler = notice;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Returns where this program lies. Once another version has taken its place, as an update does while a room
/// runs, that one is meant.
std::string ownProgram() {
  constexpr std::string_view kReplaced = " (deleted)";  // added by Linux
  std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  if (program.ends_with(kReplaced)) program.resize(program.size() - kReplaced.size());
  return program;
}

using Hosts = std::vector<std::string>;

/// Returns the hosts of the rig, each once.
Hosts distinctHostsOf(const Rig& rig) {
  Hosts hosts = hostsOf(rig);
  hosts.erase(std::unique(hosts.begin(), hosts.end()), hosts.end());
  return hosts;
}

/// Returns the ranks that run on these hosts.
std::vector<int> ranksOf(const Rig& rig, const Hosts& hosts) {
  const Hosts all = hostsOf(rig);
  std::vector<int> ranks;
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    if (std::find(hosts.begin(), hosts.end(), all[rank]) != hosts.end())
      ranks.push_back(static_cast<int>(rank));
  }
  return ranks;
}

/// Returns the rig without the computers that are left out by hand. Throws CLI::ValidationError.
Rig rigWithoutHosts(const Rig& rig, const Hosts& without) {
  const Hosts hosts = distinctHostsOf(rig);
  for (const std::string& host : without) {
    if (std::find(hosts.begin() + 1, hosts.end(), host) != hosts.end()) continue;
    const bool isFirst = host == hosts.front();
    throw CLI::ValidationError("--without",
                               isFirst ? fmt::format("node 0 is on '{}', expected another host", host)
                                       : fmt::format("the rig has no host '{}', expected one of {}", host,
                                                     fmt::join(hosts.begin() + 1, hosts.end(), ", ")));
  }
  try {
    return rigWithout(rig, ranksOf(rig, without));
  } catch (const std::runtime_error& error) {
    throw CLI::ValidationError("--without", error.what());
  }
}

/// Returns the arguments that say which nodes of the rig are left out.
std::vector<std::string> withoutArguments(std::vector<std::string> arguments, const std::vector<int>& ranks) {
  if (!ranks.empty()) arguments.push_back(fmt::format("--without-nodes={}", fmt::join(ranks, ",")));
  return arguments;
}

/// Returns whether a job has ended with this status because it lost a node, rather than because it cannot
/// begin.
bool isOfLostNode(int status) { return status == kNodeLost || status >= 128; }

/// Returns the arguments with which `carom doctor` judges the room for a session.
std::vector<std::string> doctorArguments(const RoomOptions& options, const RoomSession* session,
                                         const std::vector<int>& without) {
  std::vector<std::string> arguments{"doctor", options.rig.string()};
  if (session) {
    arguments.emplace_back("--findings");
    if (session->options().noWindow) arguments.emplace_back("--no-window");
    if (session->options().byMouse) arguments.emplace_back("--by-mouse");
  }
  const std::filesystem::path folder = session ? session->file().parent_path() : options.folder;
  if (!folder.empty()) arguments.push_back(fmt::format("--folder={}", folder.string()));
  return withoutArguments(std::move(arguments), without);
}

/// Runs `carom doctor` on the nodes of the rig. Returns its exit status.
int judge(const Rig& rig, const std::vector<std::string>& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const JobEnd end = runJob(mpirunLine(rig, ownProgram(), arguments), asked, [start] {
    return std::chrono::steady_clock::now() - start > std::chrono::duration<double>(kJudges_s);
  });
  if (end.wasAsked) return 0;
  if (end.wasStopped)
    log::error(
        fmt::format("carom doctor did not come to its end within {:g} s, expected nodes that reach each "
                    "other; does a firewall "
                    "stand between them ([start] ports of the rig)?",
                    kJudges_s));
  return end.wasStopped ? kNodeLost : end.status;
}

/// A file for the status where the operator wants none, in a folder that goes with it.
class PrivateStatus {
 public:
  PrivateStatus() {
    std::string name = std::filesystem::temp_directory_path() / "carom-room-XXXXXX";
    if (!mkdtemp(name.data())) throw NotWritten(name, "no folder for the room's status");
    folder_ = name;
  }
  ~PrivateStatus() {
    std::error_code failed;
    std::filesystem::remove_all(folder_, failed);
  }
  PrivateStatus(const PrivateStatus&) = delete;
  PrivateStatus& operator=(const PrivateStatus&) = delete;

  std::filesystem::path file() const { return folder_ / "status.json"; }

 private:
  std::filesystem::path folder_;
};

/// The status file while node 0 does not write it.
class RoomStatus {
 public:
  explicit RoomStatus(const std::optional<std::filesystem::path>& file)
      : own_(file ? nullptr : std::make_unique<PrivateStatus>()),
        file_(file ? *file : own_->file()),
        writer_(file_, [this] { return text(); }) {}

  const std::filesystem::path& file() const { return file_; }

  /// Says so in the place of the status that a node 0 has left.
  void start() { say("starting", ""); }
  void wait(const std::string& why) { say("waiting", why); }
  void leaveOut(nlohmann::ordered_json missing) {
    const std::scoped_lock hold(mutex_);
    missing_ = std::move(missing);
  }
  void end() try {
    writer_.end(
        [this] { return readStatus(file_).state == "ended" ? std::string() : linesOf(statusOf("ended")); });
  } catch (const NotWritten& error) {
    log::warn(error.what());
  }

 private:
  void say(const char* state, const std::string& why) {
    {
      const std::scoped_lock hold(mutex_);
      state_ = state;
      why_ = why;
      isNew_ = true;
    }
    writer_.write();
  }
  /// Returns whether the file is another process's: of a node 0 that lives, or that has written its end.
  bool isByNodes() const {
    const ReadStatus status = readStatus(file_);
    if (status.process <= 0 || status.process == getpid()) return false;
    return status.state == "ended" || kill(status.process, 0) == 0;
  }
  std::string text() {
    const std::scoped_lock hold(mutex_);
    if (!std::exchange(isNew_, false) && isByNodes()) return withNewTime(file_);
    nlohmann::ordered_json status = statusOf(state_);
    if (!why_.empty()) status["message"] = why_;
    if (!missing_.empty()) status["missing"] = missing_;
    return linesOf(status);
  }

  std::unique_ptr<PrivateStatus> own_;
  std::filesystem::path file_;
  std::mutex mutex_;  // of:
  const char* state_ = "starting";
  bool isNew_ = true;
  std::string why_;
  nlohmann::ordered_json missing_ = nlohmann::ordered_json::array();
  StatusWriter writer_;  // last: it uses the rest
};

/// The computers of the rig, by ssh, and its nodes, by mpirun.
class RealNodes : public RoomNodes {
 public:
  RealNodes(const Rig& rig, const RoomOptions& options, const RoomSession& session)
      : rig_(rig),
        options_(options),
        session_(session),
        leadsHere_(isThisComputer(hostsOf(rig).front())),
        status_(leadsHere_ ? session.options().status : std::nullopt) {}
  ~RealNodes() override { status_.end(); }

  double now_s() override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  bool isAskedToEnd() override { return asked; }
  bool wait(double duration_s, const std::string& why) override {
    status_.wait(why);
    const double until_s = now_s() + duration_s;
    while (!asked && now_s() < until_s) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return !asked;
  }
  std::vector<HostFault> ask(const Hosts& hosts) override {
    status_.start();
    return askHosts(hosts, ownProgram(), asked);
  }
  std::optional<std::vector<HostFault>> poll(const Hosts& hosts) override {
    if (!answers_.valid())
      answers_ = std::async(std::launch::async, [hosts] { return askHosts(hosts, ownProgram(), asked); });
    if (answers_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    return answers_.get();
  }
  bool canPlayWithout(const Hosts& hosts) override try {
    rigWithout(rig_, ranksOf(rig_, hosts));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
  std::string wallsOf(const Hosts& hosts) override {
    const std::vector<int> ranks = ranksOf(rig_, hosts);
    std::vector<std::string> names;
    for (const Wall& wall : rig_.walls) {
      if (std::find(ranks.begin(), ranks.end(), wall.node) != ranks.end()) names.push_back(wall.name);
    }
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
  }
  RoomRun run(const Hosts& without, const std::function<bool()>& isToEnd) override;

 private:
  RoomRun endOf(const JobEnd& job, const JobWatch& watch, bool hangs) const;

  const Rig& rig_;
  const RoomOptions& options_;
  const RoomSession& session_;
  bool leadsHere_;  // node 0 runs on this computer
  bool isJudged_ = false;
  RoomStatus status_;
  std::future<std::vector<HostFault>> answers_;
};

RoomRun RealNodes::run(const Hosts& without, const std::function<bool()>& isToEnd) {
  const std::vector<int> ranks = ranksOf(rig_, without);
  const Rig rig = rigWithout(rig_, ranks);
  auto missing = nlohmann::ordered_json::array();
  for (const MissingNode& node : rig.missing) missing.push_back({{"name", node.name}, {"walls", node.walls}});
  status_.leaveOut(missing);
  status_.start();
  if (!options_.noDoctor && !isJudged_) {
    const int verdict = judge(rig, doctorArguments(options_, &session_, ranks));
    if (asked) return {RoomRun::End::askedToEnd};
    if (isOfLostNode(verdict)) return {RoomRun::End::cutOff, verdict};
    if (verdict != 0) return {RoomRun::End::refused, verdict};
    isJudged_ = true;
  }
  auto arguments = session_.nextArguments(session_.progress());
  if (leadsHere_) arguments = withValue(arguments, "--status", status_.file().string());
  JobWatch watch(status_.file(), kStarts_s);
  const double start_s = now_s();
  bool hangs = false;
  const auto isToStop = [&] {
    const std::string fault = leadsHere_ ? watch.look(now_s() - start_s) : std::string();
    hangs = !fault.empty();
    if (hangs) log::error(fmt::format("{}: they are ended.", fault));
    return hangs || isToEnd();
  };
  const JobEnd job =
      runJob(mpirunLine(rig, ownProgram(), withoutArguments(arguments, ranks)), asked, isToStop);
  watch.look(now_s() - start_s);
  return endOf(job, watch, hangs);
}

/// Returns how a run has ended. Logs it if the session goes on.
RoomRun RealNodes::endOf(const JobEnd& job, const JobWatch& watch, bool hangs) const {
  RoomRun run{RoomRun::End::cutOff, job.status, watch.played_s()};
  if (job.wasAsked)
    run.end = RoomRun::End::askedToEnd;  // mpirun calls the end that was asked for a failure
  else if (job.wasStopped && !hangs)
    run.end = RoomRun::End::broughtBack;
  else if (job.status == 0 && !hangs)
    run.end = RoomRun::End::finished;
  else if (!leadsHere_ || session_.isComplete(session_.progress()))
    run.end = RoomRun::End::finished;
  else if (run.played_s <= 0.0 && !isOfLostNode(job.status))
    run.end = RoomRun::End::refused;
  if (run.end != RoomRun::End::cutOff) return run;
  const auto reached = session_.progress();
  if (run.played_s > 0.0 && reached && reached->frame)
    log::warn(fmt::format("the session was cut off after frame {}: it goes on by itself.", *reached->frame));
  else
    log::warn(kNoFirstFrame);
  return run;
}

/// Runs the session, and again from where it was cut off.
int keepPlaying(const Rig& rig, const RoomOptions& options, const RoomSession& session) {
  const std::string leader = hostsOf(rig).front();
  if (!isThisComputer(leader)) {
    log::warn(
        fmt::format("node 0 is {}, not this computer: the session file lies there, so a session that loses a "
                    "node does not go on by itself",
                    leader));
  }
  RealNodes nodes(rig, options, session);
  return RoomKeeper(nodes, distinctHostsOf(rig), options.without).keep();
}

/// Returns whether every host can take part; logs those that cannot.
bool allAnswer(const Rig& rig) {
  const std::vector<HostFault> faults = askHosts(hostsOf(rig), ownProgram(), asked);
  for (const HostFault& fault : faults) log::error(fault.words);
  return faults.empty();
}

/// Runs `carom doctor`, or the test patterns, on every node.
int runOnce(const Rig& rig, const std::vector<std::string>& arguments, bool isDoctor) {
  if (!allAnswer(rig)) return 1;
  if (isDoctor) return judge(rig, arguments);
  return runJob(mpirunLine(rig, ownProgram(), arguments), asked, [] { return false; }).status;
}

}  // namespace

int runRoom(const RoomOptions& options) {
  const Rig rig = readRig(options.rig);
  const std::vector<int> without = ranksOf(rig, options.without);
  const Rig present = rigWithoutHosts(rig, options.without);
  std::optional<RoomSession> session;
  std::vector<std::string> arguments;
  if (options.doctor) arguments = doctorArguments(options, nullptr, without);
  if (options.pattern) arguments = {"check", options.rig.string(), "--pattern"};
  if (arguments.empty()) {
    session.emplace(options.rig, options.arguments);
    arguments = withoutArguments(session->nextArguments(session->progress()), without);
    const std::filesystem::path& scenario = session->options().scenario;
    if (isThisComputer(hostsOf(rig).front()) && !scenario.empty()) readScenario(scenario);
  }
  if (options.lineOnly) {
    fmt::print("{}\n", shellLine(mpirunLine(present, ownProgram(), arguments)));
    return 0;
  }
  noticeSignals();
  return session ? keepPlaying(rig, options, *session) : runOnce(present, arguments, options.doctor);
}

void addRoom(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "room", "Start a session on every host of a rig by mpirun, and again whenever it loses a node");
  auto options = std::make_shared<RoomOptions>();
  command->add_flag("--line", options->lineOnly, "Print the line of mpirun and start nothing");
  auto* doctor = command->add_flag("--doctor", options->doctor,
                                   "Judge the room instead, and start nothing: carom doctor RIG");
  command->add_flag("--no-doctor", options->noDoctor, "Do not judge the room before the session starts")
      ->excludes(doctor);
  auto* pattern = command
                      ->add_flag("--pattern", options->pattern,
                                 "Show the test patterns instead: carom check RIG --pattern")
                      ->excludes(doctor);
  command
      ->add_option(
          "--without", options->without,
          "Leave out this host and its walls. May be given several times. A host that does not answer "
          "for a minute is left out by itself, until it answers")
      ->type_name("HOST")
      ->allow_extra_args(false)
      ->excludes(pattern);
  command
      ->add_option("RIG", options->rig,
                   "Rig file; a [[node]] with a host for each rank that is on another computer")
      ->required()
      ->transform(shipped({"rigs"}));
  command->prefix_command();
  command->footer(
      "Examples:\n  carom room my-cave.toml --scenario twins --session monday.db\n"
      "  carom room --doctor my-cave.toml\n  carom room --without cave-left my-cave.toml\n"
      "What follows the rig are arguments of carom cave. Without --session, the session is written to a new "
      "file\nhere, RIG-DATE-TIME.db, from which it goes on if a node is lost.");
  command->callback([=, &status] {
    options->arguments = command->remaining();
    status = runRoom(*options);
  });
}

}  // namespace carom
