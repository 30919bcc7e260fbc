#include "devices/protocol/qtm_packets.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "devices/wire/wire_reader.h"

namespace carom {
namespace {

constexpr std::size_t kQtmHeader = 8;

void appendQtm(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

}  // namespace

std::string_view QtmPacket::text() const {
  const auto end = std::find(content.begin(), content.end(), std::uint8_t{0});
  return {reinterpret_cast<const char*>(content.data()), static_cast<std::size_t>(end - content.begin())};
}

void QtmPackets::add(std::span<const std::uint8_t> bytes) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(read_));
  read_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<QtmPacket> QtmPackets::next() {
  const std::span<const std::uint8_t> rest = std::span(bytes_).subspan(read_);
  if (rest.size() < kQtmHeader) return {};
  WireReader wire(rest, std::endian::little);
  const std::size_t size = wire.read<std::uint32_t>();
  if (size < kQtmHeader || size > kMostBytes) {
    throw std::runtime_error("a packet says that it has " + std::to_string(size) +
                             " bytes, expected from 8 to " + std::to_string(kMostBytes));
  }
  const auto type = static_cast<QtmPacket::Type>(wire.read<std::uint32_t>());
  if (rest.size() < size) return {};
  read_ += size;
  return QtmPacket{type, rest.subspan(kQtmHeader, size - kQtmHeader)};
}

std::vector<std::uint8_t> qtmCommand(std::string_view command) {
  std::vector<std::uint8_t> bytes;
  appendQtm(bytes, static_cast<std::uint32_t>(kQtmHeader + command.size() + 1));
  appendQtm(bytes, static_cast<std::uint32_t>(QtmPacket::Type::command));
  bytes.insert(bytes.end(), command.begin(), command.end());
  bytes.push_back(0);
  return bytes;
}

}  // namespace carom
