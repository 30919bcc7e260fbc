#include "cave/cluster.h"

#include <fmt/format.h>
#include <mpi.h>
#define XXH_INLINE_ALL  // used as a header
#include <xxhash.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace carom {
namespace {

constexpr int kRankOfDevices = 0;  // owns trackers, physics and the record

/// What precedes the knots in a frame's message.
struct Header {
  FrameRecord record;
  std::uint64_t knots = 0;
};

}  // namespace

Cluster::Cluster() {
  // A rank that waits gives its core to those that draw; a person's own setting stands.
  setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  digests_.resize(static_cast<std::size_t>(size_));
}

Cluster::~Cluster() { MPI_Finalize(); }

void Cluster::abort() const {
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

int Cluster::firstFailed(bool failed) const {
  const int mine = failed ? rank_ : size_;
  int first = size_;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return first < size_ ? first : -1;
}

void Cluster::share(FrameState& state) {
  if (size_ == 1) return;
  Header header{state.record, state.knots.size()};
  MPI_Bcast(&header, sizeof header, MPI_BYTE, kRankOfDevices, MPI_COMM_WORLD);
  state.record = header.record;
  state.knots.resize(header.knots);
  if (!state.knots.empty()) {
    MPI_Bcast(state.knots.data(), static_cast<int>(state.knots.size() * sizeof(BodyKnot)), MPI_BYTE,
              kRankOfDevices, MPI_COMM_WORLD);
  }
}

void Cluster::swapTogether(const FrameState& state, std::uint64_t digest) {
  if (size_ == 1) return;
  MPI_Allgather(&digest, 1, MPI_UINT64_T, digests_.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  std::string different;
  for (int node = 1; node < size_; ++node) {
    if (digests_[static_cast<std::size_t>(node)] != digests_[0]) different += fmt::format(" {}", node);
  }
  if (!different.empty()) {
    throw std::runtime_error(fmt::format("frame {}: the histories differ from rank 0's on node{}",
                                         state.record.number, different));
  }
}

std::uint64_t digestOf(const FrameState& state, std::span<const WorldLine> histories) {
  std::uint64_t digest = XXH3_64bits(&state.record.number, sizeof state.record.number);
  const auto mix = [&digest](const auto& value) {
    digest = XXH3_64bits_withSeed(&value, sizeof value, digest);
  };
  mix(state.record.display_s);
  mix(state.record.observer.headFromBoard.matrix());
  for (const EyeView& eye : state.record.observer.eyes) {
    mix(eye.observation.t_s);
    mix(eye.observation.r_m);
    mix(eye.positionInRoom_m);
  }
  for (const WorldLine& history : histories) {
    const Knot& newest = history.knots().back();
    mix(history.knots().size());
    mix(newest.turn.t_s);
    mix(newest.turn.r_m);
    mix(newest.u);
  }
  return digest;
}

}  // namespace carom
