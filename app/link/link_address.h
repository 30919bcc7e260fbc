#pragma once
// Where a link listens or whom it calls, as people write it.

#include <cstdint>
#include <string>
#include <string_view>

namespace carom {

inline constexpr std::uint16_t kLinkPort = 7314;

struct LinkAddress {
  bool listens = false;
  std::string host;  ///< name or address; of one that listens, empty: all addresses
  std::uint16_t port = kLinkPort;

  /// Returns it as people write it.
  std::string text() const;
};

/// Returns the address that is written as "listen:[ADDRESS:]PORT" or "HOST[:PORT]", with IPv6 addresses in
/// brackets. Throws std::invalid_argument with the fault and the expected form.
LinkAddress linkAddressOf(std::string_view text);

}  // namespace carom
