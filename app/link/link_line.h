#pragma once
// The line between two rooms: TLS 1.3 by a shared key over one TCP port, which listens or calls, in a thread
// of its own that frames never wait for. A present that has not been sent is replaced by a newer one; nothing
// else is ever left out. A line that breaks or falls silent is called again.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/link/line.h"
#include "app/link/link_address.h"
#include "app/link/link_key.h"

namespace carom {

class LinkLine : public Line {
 public:
  /// Begins to listen or to call. Throws std::runtime_error if it cannot listen there.
  LinkLine(const LinkAddress& address, const LinkKey& key, const LinkLimits& limits = {});
  ~LinkLine() override;
  LinkLine(const LinkLine&) = delete;
  LinkLine& operator=(const LinkLine&) = delete;

  void take(std::vector<LineNews>& news) override;
  void send(std::uint64_t connection, const LinkMessage& message) override;
  void present(std::uint64_t connection, const LinkPresent& present) override;
  void close(std::uint64_t connection, const std::string& reason) override;
  RoundTrip roundTrip(std::uint64_t connection) const override;

  LineTraffic traffic() const override;
  std::uint16_t port() const;  ///< on which it listens

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace carom
