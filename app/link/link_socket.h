#pragma once
// The TCP sockets of a link. None of them ever blocks.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/link/link_address.h"

namespace carom {

/// A socket that is closed in the end.
class LinkSocket {
 public:
  LinkSocket() = default;
  explicit LinkSocket(int number) : number_(number) {}
  ~LinkSocket() { reset(); }
  LinkSocket(LinkSocket&& other) noexcept : number_(other.release()) {}
  LinkSocket& operator=(LinkSocket&& other) noexcept;

  int operator*() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  int release();
  void reset();

 private:
  int number_ = -1;
};

/// Returns a socket that listens. An address that is left out means all, of IPv6 and IPv4. Throws
/// std::runtime_error with the address and the fault.
LinkSocket listenAt(const LinkAddress& address);

/// Returns the port on which a socket listens.
std::uint16_t portOf(const LinkSocket& socket);

/// A caller, and from where.
struct Called {
  LinkSocket socket;
  std::string from;
};
/// Returns the next caller who waits, or nothing.
std::optional<Called> nextCaller(const LinkSocket& listening);

/// Begins to call; where a name has several addresses, the next one with each `attempt`. Returns no socket,
/// and the reason in `why`, if it cannot. Looking up a name may take seconds.
LinkSocket callTo(const LinkAddress& address, std::size_t attempt, std::string& why);

/// Returns whether a socket that calls has been answered; nothing while it is not known. Puts the
/// fault into `why`.
std::optional<bool> isAnswered(const LinkSocket& calling, std::string& why);

}  // namespace carom
