#include "devices/network/only_session.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <functional>

#include "devices/tracker/retry.h"

namespace carom {

/// A name of an abstract socket (unix(7)) is taken by one process, and free when that has ended.
OnlySession::OnlySession(const std::string& device)
    : descriptor_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const std::string name = "carom-device-" + std::to_string(std::hash<std::string>()(device));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path + 1);  // behind a zero: abstract
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (descriptor_ < 0 || ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), size) == 0) return;
  const bool isTaken = errno == EADDRINUSE;
  if (!isTaken) return;  // a system without such names: sessions do not know of each other
  ::close(descriptor_);
  throw NeedsHelp(device + " is the force device of another session");
}

OnlySession::~OnlySession() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace carom
