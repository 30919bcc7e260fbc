#pragma once
// A VRPN server of one device for tests, over a real connection. It does with names and pings as vrpn_server
// does (vrpn_Connection.C, handle_sender_message; vrpn_BaseClass.C, handle_ping): it keeps every sender's
// name that any client names to it until it ends, and names it back to that client and to every later one;
// pings are answered by devices alone.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "devices/network_peer.h"
#include "devices/vrpn_sender.h"

namespace carom::test {

class VrpnServer {
 public:
  explicit VrpnServer(std::string device = "Head", std::uint16_t port = 0)
      : device_(std::move(device)), listener_(SOCK_STREAM, port) {
    listen(listener_.descriptor(), 1);
  }
  std::uint16_t port() const { return listener_.port(); }
  bool isCalled(int longest_ms) const { return listener_.isReadable(longest_ms); }
  /// "Head@tcp://127.0.0.1:PORT"
  std::string source(const std::string& sender = "Head") const {
    return sender + "@tcp://127.0.0.1:" + std::to_string(port());
  }

  /// The next client, greeted both ways.
  PeerSocket greet(const std::string& version = "07.35") {
    EXPECT_TRUE(listener_.isReadable(60000)) << "no client came";
    PeerSocket client = PeerSocket::acceptedBy(listener_);
    client.send(VrpnSender::cookie(version));
    const auto cookie = client.receive();
    EXPECT_TRUE(cookie && std::string(cookie->begin(), cookie->begin() + 14) == "vrpn: ver. 07.");
    return client;
  }

  /// The next client, greeted, told the names, and heard until it has named the sender that it wants.
  PeerSocket meet(const std::string& version = "07.35") {
    PeerSocket client = greet(version);
    Bytes names = VrpnSender::names(device_);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      VrpnSender::add(names,
                      VrpnSender::name(kFirstKept + static_cast<int>(i), VrpnSender::kSenderName, kept_[i]));
    }
    client.send(names);
    hear(client);
    return client;
  }

  /// Takes what the client says next and answers it.
  void hear(const PeerSocket& client) {
    const Bytes said = client.receive().value_or(Bytes{});
    Bytes answer;
    for (std::size_t at = 0; at + 24 <= said.size();) {
      const auto word = [&](std::size_t offset) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | said[at + offset + i];
        return value;
      };
      const std::size_t length = word(0);
      const auto type = static_cast<std::int32_t>(word(16));
      if (length < 24 || at + length > said.size()) break;
      const auto sender = static_cast<std::int32_t>(word(12));
      if (type == VrpnSender::kSenderName)
        keep(sender,
             {said.begin() + static_cast<long>(at) + 28, said.begin() + static_cast<long>(at + length) - 1},
             answer);
      const bool isPing = type == 0;  // as the client describes it
      if (isPing && senders_[sender] == device_)
        VrpnSender::add(answer, VrpnSender::record(1, VrpnSender::kPong, {}, 0.0));
      at += (length + 7) / 8 * 8;
    }
    if (!answer.empty()) client.send(answer);
  }

  /// The name that the last client has named first.
  const std::string& wanted() const { return wanted_; }

 private:
  static constexpr int kFirstKept = 2;

  void keep(int sender, const std::string& name, Bytes& answer) {
    if (sender == 0) {
      senders_.clear();
      wanted_ = name;
    }
    senders_[sender] = name;
    if (name == device_ || std::find(kept_.begin(), kept_.end(), name) != kept_.end()) return;
    kept_.push_back(name);
    VrpnSender::add(answer, VrpnSender::name(kFirstKept + static_cast<int>(kept_.size()) - 1,
                                             VrpnSender::kSenderName, name));
  }

  std::string device_, wanted_;
  std::map<int, std::string> senders_;  // by the client's numbers
  PeerSocket listener_;
  std::vector<std::string> kept_;
};

}  // namespace carom::test
