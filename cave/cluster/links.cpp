#include "cave/cluster/links.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

namespace carom {
namespace {

constexpr int kTag = 100;
constexpr int kPings = 100, kBlocks = 4, kBlock_bytes = 4 << 20;
constexpr std::chrono::milliseconds kBetweenPings{4};
using Ping = std::array<char, 64>;

double since_s(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Answers node 0's messages. Until its turn a node sleeps, so that it takes no time from the others of its
/// computer.
void answer(std::vector<char>& block) {
  for (int arrived = 0; !arrived;) {
    MPI_Iprobe(0, kTag, MPI_COMM_WORLD, &arrived, MPI_STATUS_IGNORE);
    if (!arrived) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  Ping ping{};
  const auto reply = [&ping] { MPI_Send(ping.data(), sizeof ping, MPI_BYTE, 0, kTag, MPI_COMM_WORLD); };
  for (int i = 0; i <= kPings; ++i) {
    MPI_Recv(ping.data(), sizeof ping, MPI_BYTE, 0, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    reply();
  }
  for (int i = 0; i < kBlocks; ++i)
    MPI_Recv(block.data(), kBlock_bytes, MPI_BYTE, 0, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  reply();
}

LinkFigures figuresOf(int rank, std::vector<char>& block) {
  Ping ping{};
  const auto roundTrip_s = [&] {
    const auto start = std::chrono::steady_clock::now();
    MPI_Send(ping.data(), sizeof ping, MPI_BYTE, rank, kTag, MPI_COMM_WORLD);
    MPI_Recv(ping.data(), sizeof ping, MPI_BYTE, rank, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return since_s(start);
  };
  roundTrip_s();  // the first one wakes the node and opens the connection
  std::array<double, kPings> trips_s{};
  for (double& trip_s : trips_s) {
    std::this_thread::sleep_for(kBetweenPings);
    trip_s = roundTrip_s();
  }
  std::sort(trips_s.begin(), trips_s.end());
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kBlocks; ++i)
    MPI_Send(block.data(), kBlock_bytes, MPI_BYTE, rank, kTag, MPI_COMM_WORLD);
  MPI_Recv(ping.data(), sizeof ping, MPI_BYTE, rank, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return {trips_s[kPings / 2], trips_s[kPings * 95 / 100],
          static_cast<double>(kBlocks) * kBlock_bytes / since_s(start)};
}

}  // namespace

std::vector<LinkFigures> measureLinks(const Cluster& cluster) {
  std::vector<char> block(kBlock_bytes);
  if (cluster.rank() > 0) {
    answer(block);
    return {};
  }
  std::vector<LinkFigures> links(1);
  for (int rank = 1; rank < cluster.size(); ++rank) links.push_back(figuresOf(rank, block));
  return links;
}

}  // namespace carom
