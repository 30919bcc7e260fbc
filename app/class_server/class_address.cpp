#include "app/class_server/class_address.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace carom {
namespace {

// Words for rooms, easily told apart when they are read aloud; the same in every language.
constexpr std::array<const char*, 40> kRoomWords{
    "ANCHOR", "APPLE",  "BANJO",  "BEAVER", "CACTUS", "CANDLE", "CHERRY", "COMET",  "DOLPHIN", "EAGLE",
    "FERRY",  "GARLIC", "GINGER", "HAMMER", "HARBOR", "IGLOO",  "JACKET", "KIWI",   "LADDER",  "LEMON",
    "MAGNET", "MANGO",  "MEADOW", "NUTMEG", "OCEAN",  "OLIVE",  "ORANGE", "PANDA",  "PEPPER",  "PIANO",
    "PILOT",  "QUARTZ", "RIVER",  "SALMON", "SPIDER", "TIGER",  "TULIP",  "VIOLIN", "WALNUT",  "ZEBRA"};

/// Returns a random number below `end`, each equally likely: those beyond its last multiple are drawn again.
std::uint32_t anyBelow(std::uint32_t end) {
  const std::uint32_t most = UINT32_MAX - UINT32_MAX % end;
  for (;;) {
    std::uint32_t number = 0;
    if (getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number))
      throw std::runtime_error("the operating system gave no random numbers");
    if (number < most) return number % end;
  }
}

}  // namespace

std::string addressOfDefaultRoute() {
  // Connecting a datagram socket sends nothing. It chooses the route to an address, here one of those that
  // RFC 5737 keeps free.
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(9);
  inet_pton(AF_INET, "192.0.2.1", &address.sin_addr);
  socklen_t size = sizeof address;
  std::array<char, INET_ADDRSTRLEN> text{};
  const bool found = connect(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                     getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
                     inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) != nullptr;
  close(socket);
  if (!found)
    throw std::runtime_error(
        "class: this computer has no default route, expected the address for phones: --class-address "
        "192.168.1.20");
  return text.data();
}

std::string anyRoomWord() { return kRoomWords.at(anyBelow(static_cast<std::uint32_t>(kRoomWords.size()))); }

std::string anyPin() { return fmt::format("{:06}", anyBelow(1000000)); }

std::string anyTakeCode() {
  constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  constexpr std::size_t kLength = 8;
  std::string code;
  while (code.size() < kLength) code += kLetters[anyBelow(static_cast<std::uint32_t>(kLetters.size()))];
  return code;
}

}  // namespace carom
