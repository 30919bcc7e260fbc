#include "app/link/link_stream.h"

#include <algorithm>

namespace carom {

void LinkStream::Bucket::put(double amount, double now_s) {
  content = std::max(0.0, content - (now_s - at_s) * most_1_s) + amount;
  at_s = now_s;
  if (content > most_1_s * kFloods_s) throw BrokenLink("it sent more than a room that plays");
}

void LinkStream::add(std::span<const std::uint8_t> bytes, double now_s) {
  now_s_ = now_s;
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(taken_));
  taken_ = 0;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<LinkMessage> LinkStream::next() {
  const auto rest = std::span<const std::uint8_t>(bytes_).subspan(taken_);
  const std::optional<std::size_t> size = sizeOfLinkMessage(rest);
  if (!size || *size > rest.size()) return std::nullopt;
  LinkMessage message = linkMessageOf(rest.first(*size));
  taken_ += *size;
  if (std::holds_alternative<LinkWelcome>(message) && !isWelcomed_) {
    isWelcomed_ = true;
    return message;
  }
  messages_.put(1.0, now_s_);
  size_.put(static_cast<double>(*size), now_s_);
  return message;
}

}  // namespace carom
