#include "cave/cluster/cluster.h"

#include <fmt/format.h>
#include <mpi.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <thread>
#include <type_traits>

#include "cave/process/termination.h"
#include "engine/base/xxh3.h"
#include "engine/text/log.h"

namespace carom {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr int kRankOfDevices = 0;         // owns trackers, physics and the record
constexpr std::uint64_t kWarmUp = 3;      // frames in which drivers still compile and allocate
constexpr double kLate_s = 0.5;           // a node that keeps the others waiting for so long is late
constexpr double kLost_s = 10.0;          // and after this it is lost
constexpr double kLostAtStart_s = 60.0;   // the same for the frames of the warm-up
constexpr double kGone_s = 0.1;           // after this it is looked whether its process lives
constexpr double kLastWords_s = 0.25;     // how long a frame may still take once the end is requested
constexpr double kRankZerosTurn_s = 0.2;  // each rank gives up this much later than the one before it
constexpr double kSpin_s = 0.002;         // shorter waits do not sleep
constexpr std::chrono::microseconds kNap{100};
constexpr int kShared = 1, kDrawn = 2, kLastWords = 3;  // message tags

/// The head of a frame's message, before the knots, events and rows.
struct Header {
  FrameRecord record;
  std::uint64_t knots = 0;
  std::uint64_t events = 0;
  std::uint64_t rows = 0;
  std::uint64_t rowNodes = 0;
  std::uint64_t told = 0;
};

/// A rank's message that it has drawn a frame.
struct Drawn {
  FrameDigest digest;
  std::uint64_t wantsToEnd = 0;
  NodeReport before;
};

/// Rank 0's conclusion from these messages.
struct Verdict {
  std::int32_t different = -1;  // the first rank that drew from other numbers
  std::uint32_t field = 0;      // the first field that differed
  std::uint64_t end = 0;
};
static_assert(std::is_trivially_copyable_v<Header> && std::is_trivially_copyable_v<Drawn>);

Verdict judge(std::span<const Drawn> drawn) {
  Verdict verdict;
  for (std::size_t rank = 0; rank < drawn.size(); ++rank) {
    verdict.end |= drawn[rank].wantsToEnd;
    if (verdict.different >= 0 || drawn[rank].digest == drawn[0].digest) continue;
    verdict.different = static_cast<std::int32_t>(rank);
    while (drawn[rank].digest.fields[verdict.field] == drawn[0].digest.fields[verdict.field]) ++verdict.field;
  }
  return verdict;
}

/// The host and process of a rank.
struct Place {
  std::array<char, 64> host{};
  std::int64_t process = 0;
};

Place ownPlace() {
  Place place;
  gethostname(place.host.data(), place.host.size() - 1);
  place.process = getpid();
  return place;
}

/// Returns whether the process that started this one was told how to bind, on its command line: "--bind-to
/// none",
/// "--bind-to=none", or with one dash, as Open MPI 4 takes it, too.
bool starterWasTold() {
  std::ifstream line("/proc/" + std::to_string(getppid()) + "/cmdline", std::ios::binary);
  const std::string words{std::istreambuf_iterator<char>(line), {}};
  return words.find("-bind-to") != std::string::npos;
}

/// Returns whether mpirun may have pinned this process to one core without having been told to. Open MPI 4
/// says so, and how it was told; of Open MPI 5 only the command line and a variable of its own tell.
bool isPinnedUnasked() {
  if (std::getenv("OMPI_MCA_orte_bound_at_launch")) return !std::getenv("OMPI_MCA_hwloc_base_binding_policy");
  return std::getenv("PRTE_LAUNCHED") && !std::getenv("PRTE_MCA_hwloc_default_binding_policy") &&
         !starterWasTold();
}

/// Open MPI pins each of one or two processes of a machine to one core, unless it is told otherwise; drawing
/// and dividing bodies need them all. The system grants those of the requested cores that it allows. Call it
/// before there are threads.
void useEveryCore() {
  if (!isPinnedUnasked()) return;
  cpu_set_t all;
  std::fill_n(reinterpret_cast<unsigned char*>(&all), sizeof all, static_cast<unsigned char>(0xff));
  sched_setaffinity(0, sizeof all, &all);
}

/// Leaves TCP out where all ranks run on this machine, unless the user says otherwise: they talk through
/// memory, and Open MPI 5 would complain on a machine without a network.
void talkThroughMemory() {
  const char* here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const char* all = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (here && all && std::string_view(here) == all) setenv("OMPI_MCA_btl", "^tcp", 0);
}

}  // namespace

struct Cluster::Room {
  std::vector<MPI_Request> requests;
  std::vector<Place> places;  // by rank
  std::vector<Drawn> drawn;   // by rank
};

Cluster::Cluster() {
  useEveryCore();
  talkThroughMemory();
  // A waiting rank yields its core to those that draw; a setting by the user stays in force.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  noticeTermination();
  const auto ranks = static_cast<std::size_t>(size_);
  names_.resize(ranks);
  room_ = std::make_unique<Room>();
  room_->requests.resize(ranks, MPI_REQUEST_NULL);
  room_->drawn.resize(ranks);
  room_->places.resize(ranks);
  const Place own = ownPlace();
  MPI_Allgather(&own, sizeof own, MPI_BYTE, room_->places.data(), sizeof own, MPI_BYTE, MPI_COMM_WORLD);
}

Cluster::~Cluster() { MPI_Finalize(); }

void Cluster::leave() const {
  carom::leave([] { MPI_Finalize(); });  // MPI_Finalize waits for ever if mpirun was asked to end
}

void Cluster::abort(int status) const {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::abort();
}

int Cluster::firstFailed(bool failed) const {
  const int mine = failed ? rank_ : size_;
  int first = size_;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return first < size_ ? first : -1;
}

void Cluster::agree(const std::string& what, std::string_view content) const {
  const std::uint64_t digest = XXH3_64bits(content.data(), content.size());
  std::uint64_t rankZeros = digest;
  MPI_Bcast(&rankZeros, 1, MPI_UINT64_T, kRankOfDevices, MPI_COMM_WORLD);
  const int different = firstFailed(digest != rankZeros);
  if (different < 0) return;
  throw NodesDiffer(
      fmt::format("{} has another {} than node 0, expected the same on every node", nameOf(different), what));
}

std::vector<Wall> Cluster::wallsOf(std::span<const Wall> walls) const {
  std::vector<Wall> drawn;
  for (const Wall& wall : walls) {
    if (draws(wall)) drawn.push_back(wall);
  }
  return drawn;
}

void Cluster::nameNodes(std::span<const Wall> walls) {
  for (std::string& name : names_) name.clear();
  for (const Wall& wall : walls) {
    std::string& name = names_[static_cast<std::size_t>(wall.node % size_)];
    name += (name.empty() ? "" : ", ") + wall.name;
  }
}

std::string Cluster::nameOf(int rank) const {
  const std::string& walls = names_[static_cast<std::size_t>(rank)];
  const bool severalHosts = !std::all_of(room_->places.begin(), room_->places.end(), [&](const Place& place) {
    return place.host == room_->places.front().host;
  });
  return fmt::format(
      "node {}{}{}", rank, walls.empty() ? "" : " (" + walls + ")",
      severalHosts ? fmt::format(" on {}", room_->places[static_cast<std::size_t>(rank)].host.data()) : "");
}

void Cluster::share(std::string& text) const {
  std::uint64_t bytes = text.size();
  MPI_Bcast(&bytes, 1, MPI_UINT64_T, kRankOfDevices, MPI_COMM_WORLD);
  text.resize(bytes);
  constexpr std::uint64_t kMost = 1U << 30U;  // MPI counts in int
  for (std::uint64_t from = 0; from < bytes; from += kMost) {
    MPI_Bcast(text.data() + from, static_cast<int>(std::min(bytes - from, kMost)), MPI_BYTE, kRankOfDevices,
              MPI_COMM_WORLD);
  }
}

std::vector<std::string> Cluster::gather(const std::string& text) const {
  const int bytes = static_cast<int>(text.size());
  std::vector<int> sizes(static_cast<std::size_t>(size_)), places(sizes.size(), 0);
  MPI_Gather(&bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, kRankOfDevices, MPI_COMM_WORLD);
  if (rank_ != kRankOfDevices) {
    MPI_Gatherv(text.data(), bytes, MPI_BYTE, nullptr, nullptr, nullptr, MPI_BYTE, kRankOfDevices,
                MPI_COMM_WORLD);
    return {};
  }
  for (std::size_t i = 1; i < sizes.size(); ++i) places[i] = places[i - 1] + sizes[i - 1];
  std::string all(static_cast<std::size_t>(places.back() + sizes.back()), '\0');
  MPI_Gatherv(text.data(), bytes, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE, kRankOfDevices,
              MPI_COMM_WORLD);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    texts.push_back(all.substr(static_cast<std::size_t>(places[i]), static_cast<std::size_t>(sizes[i])));
  return texts;
}

std::string Cluster::libraryVersion() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string version(text.data(), static_cast<std::size_t>(length));
  return version.substr(0, version.find(','));
}

void Cluster::share(FrameState& state) {
  shareFrame(state);
  newest_s_ = state.record.display_s;
}

void Cluster::shareFrame(FrameState& state) const {
  if (size_ == 1) return;
  Header header{state.record,      state.knots.size(),    state.events.size(),
                state.rows.size(), state.rowNodes.size(), state.told.size()};
  fromRankZero(&header, sizeof header);
  state.record = header.record;
  const auto shareList = [this](auto& list, std::uint64_t size) {
    list.resize(size);
    if (!list.empty()) fromRankZero(list.data(), list.size() * sizeof(list[0]));
  };
  shareList(state.knots, header.knots);
  shareList(state.events, header.events);
  shareList(state.rows, header.rows);
  shareList(state.rowNodes, header.rowNodes);
  shareList(state.told, header.told);
}

/// Sends rank 0's bytes to every rank, in one message each: a broadcast, which forwards along a tree, would
/// hide which rank is late.
void Cluster::fromRankZero(void* bytes, std::size_t count) const {
  std::vector<MPI_Request>& requests = room_->requests;
  const int length = static_cast<int>(count);
  if (rank_ != kRankOfDevices) {
    MPI_Irecv(bytes, length, MPI_BYTE, kRankOfDevices, kShared, MPI_COMM_WORLD, &requests[0]);
    return await(1, false);
  }
  for (int rank = 1; rank < size_; ++rank) {
    MPI_Isend(bytes, length, MPI_BYTE, rank, kShared, MPI_COMM_WORLD,
              &requests[static_cast<std::size_t>(rank - 1)]);
  }
  await(static_cast<std::size_t>(size_ - 1), true);
}

void Cluster::report(const NodeReport& mine) { room_->drawn[static_cast<std::size_t>(rank_)].before = mine; }

const NodeReport& Cluster::reportOf(int rank) const {
  return room_->drawn[static_cast<std::size_t>(rank)].before;
}

void Cluster::gatherDrawn(const FrameState& state, const World& world, bool wantsToEnd) {
  drawn_ = state.record.number;
  wantsToEnd_ = wantsToEnd || terminationAsked();
  if (size_ == 1) return;
  std::vector<MPI_Request>& requests = room_->requests;
  Drawn& mine = room_->drawn[static_cast<std::size_t>(rank_)];
  mine.digest = digestOf(state, world);
  mine.wantsToEnd = wantsToEnd_;

  if (rank_ == kRankOfDevices) {
    for (int rank = 1; rank < size_; ++rank) {
      const auto at = static_cast<std::size_t>(rank);
      MPI_Irecv(&room_->drawn[at], sizeof(Drawn), MPI_BYTE, rank, kDrawn, MPI_COMM_WORLD, &requests[at - 1]);
    }
    await(static_cast<std::size_t>(size_ - 1), true);
  } else {
    MPI_Isend(&mine, sizeof mine, MPI_BYTE, kRankOfDevices, kDrawn, MPI_COMM_WORLD, &requests[0]);
    await(1, false);
  }
}

bool Cluster::releaseSwap(const World& world) {
  if (size_ == 1) return wantsToEnd_;
  Verdict verdict = rank_ == kRankOfDevices ? judge(room_->drawn) : Verdict{};
  fromRankZero(&verdict, sizeof verdict);
  ++frames_;

  if (verdict.different < 0) return verdict.end != 0;
  const std::string_view field = FrameDigest::kFields[verdict.field];
  throw NodesDiffer(fmt::format(
      "frame {}: {} drew from other numbers than node 0: {}{}", drawn_, nameOf(verdict.different), field,
      field == "histories" ? whereHistoriesPart(world.histories, verdict.different) : std::string()));
}

/// Returns the first body and field in which two nodes' histories differ. Every rank must call it.
std::string Cluster::whereHistoriesPart(std::span<const WorldLine> histories, int other) const {
  for (std::size_t body = 0; body < histories.size(); ++body) {
    const HistoryDigest mine = digestOf(histories[body]);
    HistoryDigest rankZeros = mine, others = mine;
    MPI_Bcast(&rankZeros, sizeof mine, MPI_BYTE, kRankOfDevices, MPI_COMM_WORLD);
    MPI_Bcast(&others, sizeof mine, MPI_BYTE, other, MPI_COMM_WORLD);
    if (others == rankZeros) continue;
    std::size_t field = 0;
    while (others.fields[field] == rankZeros.fields[field]) ++field;
    return fmt::format(", body {}, {}", body, HistoryDigest::kFields[field]);
  }
  return {};
}

/// Waits for the first `requests` of the room's requests. If they come from all other ranks (`fromAll`;
/// request i from rank i + 1), late ranks are named; otherwise the wait is for rank 0, which names them.
void Cluster::await(std::size_t requests, bool fromAll) const {
  const auto start = std::chrono::steady_clock::now();
  const double patience_s = (frames_ < kWarmUp ? kLostAtStart_s : kLost_s) + rank_ * kRankZerosTurn_s;
  double asked_s = std::numeric_limits<double>::infinity();
  int late = -1;
  double waited_s = 0.0;
  for (unsigned turn = 1; !done(requests); ++turn) {
    waited_s < kSpin_s ? std::this_thread::yield() : std::this_thread::sleep_for(kNap);
    if (turn % 16 != 0) continue;
    waited_s = Seconds(std::chrono::steady_clock::now() - start).count();
    if (terminationAsked()) asked_s = std::min(asked_s, waited_s);
    const int pending = fromAll ? firstPending(requests) : 0;
    if (pending == static_cast<int>(requests)) continue;  // the last one has just arrived
    const int awaited = fromAll ? pending + 1 : kRankOfDevices;
    const double turn_s = rank_ * kRankZerosTurn_s;
    const bool isGone = waited_s > kGone_s + turn_s && isHere(awaited) && !livesHere(awaited);
    const bool isSilent = waited_s - asked_s > kLastWords_s + turn_s && !isHere(awaited);
    if (isGone || isSilent || isReported()) {
      const char* what = isSilent ? "does not answer" : "is gone";
      giveUp(fmt::format("{} {}: the session ends.", nameOf(awaited), what), false);
    }
    if (waited_s > patience_s) {
      giveUp(fmt::format("{} has not answered for {:.0f} s: the session ends.", nameOf(awaited), waited_s),
             true);
    }
    if (fromAll && late < 0 && frames_ >= kWarmUp && waited_s > kLate_s) {
      late_ = late = awaited;
      log::note(fmt::format("{} is late: every wall keeps the last whole frame.", nameOf(late)));
    }
  }
  if (late < 0) return;
  late_ = -1;
  log::note(fmt::format("{} is back after {:.1f} s.", nameOf(late), waited_s));
}

bool Cluster::done(std::size_t requests) const {
  int all = 0;
  MPI_Testall(static_cast<int>(requests), room_->requests.data(), &all, MPI_STATUSES_IGNORE);
  return all != 0;
}

bool Cluster::isHere(int rank) const {
  return room_->places[static_cast<std::size_t>(rank)].host ==
         room_->places[static_cast<std::size_t>(rank_)].host;
}

/// Returns whether a rank is a living process of this machine. Nothing is known of other machines.
bool Cluster::livesHere(int rank) const {
  const auto process = static_cast<pid_t>(room_->places[static_cast<std::size_t>(rank)].process);
  return isHere(rank) && kill(process, 0) == 0;
}

int Cluster::firstPending(std::size_t requests) const {
  int at = 0;
  for (int done = 1; at < static_cast<int>(requests); ++at) {
    MPI_Request_get_status(room_->requests[static_cast<std::size_t>(at)], &done, MPI_STATUS_IGNORE);
    if (!done) break;
  }
  return at;
}

/// Returns whether another rank has reported why the session ends.
bool Cluster::isReported() const {
  int said = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, kLastWords, MPI_COMM_WORLD, &said, MPI_STATUS_IGNORE);
  return said != 0;
}

/// Reports why and ends, unless another rank has reported it. `others`: ends the other ranks, too; when a
/// node has died, mpirun does so.
void Cluster::giveUp(const std::string& why, bool others) const {
  closeAll();  // first: as soon as other ranks end, mpirun kills those that are left
  if (!isReported()) {
    log::error(why);
    for (int rank = 0; rank < size_; ++rank) {
      MPI_Request sent;
      if (rank != rank_) MPI_Isend(nullptr, 0, MPI_BYTE, rank, kLastWords, MPI_COMM_WORLD, &sent);
    }
    // What a process that has ended has sent can be lost: it stays until the next rank looks for it.
    std::this_thread::sleep_for(Seconds(kRankZerosTurn_s));
  }
  if (others) abort(kNodeLost);
  std::_Exit(kNodeLost);
}

}  // namespace carom
