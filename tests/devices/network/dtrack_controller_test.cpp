// DTRACK started and stopped, against a controller of our own that answers as ART's DTrackSDK expects.

#include "devices/network/dtrack_controller.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <mutex>

#include "devices/network/dtrack_tracker.h"
#include "devices/network_peer.h"

namespace carom {
namespace {

using test::bytesOf;
using test::PeerSocket;
using test::Watched;
using Answers = std::function<std::string(const std::string&)>;

/// A command port: it answers each command, and says what it was asked.
class CommandPort {
 public:
  explicit CommandPort(Answers answers, int clients = 1)
      : answers_(std::move(answers)), listener_(SOCK_STREAM) {
    ::listen(listener_.descriptor(), 4);
    thread_ = std::jthread([this, clients](const std::stop_token& stop) {
      for (int i = 0; i < clients && !stop.stop_requested();) {
        if (!listener_.isReadable(20)) continue;
        serve(stop);
        ++i;
      }
    });
  }
  std::uint16_t port() const { return listener_.port(); }
  Endpoint endpoint() const { return {"127.0.0.1", port()}; }
  std::vector<std::string> asked() const {
    const std::lock_guard lock(mutex_);
    return asked_;
  }

 private:
  void serve(const std::stop_token& stop) {
    const PeerSocket client = PeerSocket::acceptedBy(listener_);
    std::string command;
    while (!stop.stop_requested()) {
      if (!client.isReadable(20)) continue;
      const auto bytes = client.receive();
      if (!bytes) return;
      for (const std::uint8_t byte : *bytes) {
        if (byte != 0) {
          command += static_cast<char>(byte);
          continue;
        }
        const std::string answer = answers_(command);
        {
          const std::lock_guard lock(mutex_);
          asked_.push_back(std::exchange(command, {}));
        }
        if (answer == "hang up") return;
        if (answer.empty()) continue;
        // In two pieces, as a network may bring it.
        test::Bytes whole = bytesOf(answer);
        whole.push_back(0);
        client.send({whole.begin(), whole.begin() + 3});
        client.send({whole.begin() + 3, whole.end()});
      }
    }
  }

  Answers answers_;
  PeerSocket listener_;
  mutable std::mutex mutex_;
  std::vector<std::string> asked_;
  std::jthread thread_;
};

std::string fullController(const std::string& command) {
  return command == "dtrack2 get status active" ? "dtrack2 set status active none" : "dtrack2 ok";
}

/// What `start` throws; empty where it starts.
std::string faultOf(DtrackController& controller) {
  try {
    controller.start({});
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

const std::vector<std::string> kWhole{"dtrack2 get status active", "dtrack2 tracking start",
                                      "dtrack2 tracking stop"};

TEST(DtrackController, StartsAndStops) {
  CommandPort port(fullController);
  {
    DtrackController controller(port.endpoint());
    EXPECT_EQ(faultOf(controller), "");
    EXPECT_EQ(port.asked().size(), 2u);
  }
  EXPECT_EQ(port.asked(), kWhole);
}

// What others have started is not stopped by us.
TEST(DtrackController, LeavesARunningMeasurementAlone) {
  for (const char* status : {"mea", "wait"}) {
    CommandPort port([&](const std::string&) { return std::string("dtrack2 set status active ") + status; });
    {
      DtrackController controller(port.endpoint());
      EXPECT_EQ(faultOf(controller), "");
    }
    EXPECT_EQ(port.asked(), std::vector<std::string>{"dtrack2 get status active"});
  }
}

TEST(DtrackController, SaysWhyItIsRefused) {
  CommandPort port([](const std::string& command) {
    return command == "dtrack2 tracking start" ? "dtrack2 err 8 \"no full access\"" : fullController(command);
  });
  {
    DtrackController controller(port.endpoint());
    EXPECT_EQ(
        faultOf(controller),
        fmt::format("the controller at 127.0.0.1:{} does not start measuring: it says 'error 8: no full "
                    "access'. Another program may hold its full access, or the room is not calibrated",
                    port.port()));
  }
  EXPECT_EQ(port.asked().size(), 2u);  // nothing to stop
}

// An older controller may not know the question.
TEST(DtrackController, StartsWhereTheStatusIsRefused) {
  CommandPort port([](const std::string& command) {
    return command == "dtrack2 tracking start" ? "dtrack2 ok" : "dtrack2 err 1 \"unknown parameter\"";
  });
  DtrackController controller(port.endpoint());
  EXPECT_EQ(faultOf(controller), "");
}

TEST(DtrackController, SaysWhatElseGoesWrong) {
  const auto says = [](const Answers& answers, const std::string& words) {
    CommandPort port(answers);
    DtrackController controller(port.endpoint(), std::chrono::milliseconds(300));
    const std::string fault = faultOf(controller);
    EXPECT_NE(fault.find(words), std::string::npos) << fault;
  };
  says([](const std::string&) { return ""; }, "did not answer 'dtrack2 get status active' within 1 s");
  says([](const std::string&) { return "hang up"; }, "hung up");
  says([](const std::string&) { return "HTTP/1.1 400 Bad\tRequest"; },
       "is no DTRACK2 or DTRACK3: it says 'HTTP/1.1 400 Bad?Request'");
  says([](const std::string&) { return std::string(6000, 'x'); }, "its answer does not end");
  std::uint16_t closed = PeerSocket(SOCK_STREAM).port();
  DtrackController nobody({"127.0.0.1", closed});
  EXPECT_NE(faultOf(nobody).find("no connection to 127.0.0.1"), std::string::npos) << faultOf(nobody);
}

TEST(DtrackController, AGoneControllerDoesNotHoldTheEnd) {
  CommandPort port([](const std::string& command) {
    return command == "dtrack2 tracking stop" ? "" : fullController(command);
  });
  DtrackController controller(port.endpoint());
  EXPECT_EQ(faultOf(controller), "");
  const auto before = test::Clock::now();
  controller.stop();
  controller.stop();                                                 // once is enough
  EXPECT_LT(test::Clock::now() - before, std::chrono::seconds(10));  // 0.2 s, and a busy machine
  EXPECT_EQ(port.asked(), kWhole);
}

Transport transportWith(std::uint16_t data, std::uint16_t commands) {
  DtrackSource source =
      readDtrackSource(fmt::format("udp://127.0.0.1:{}?controller=127.0.0.1:{}", data, commands));
  source.start = true;
  return dtrackTransport(source);
}

TEST(DtrackController, ATrackerStartsItAndStopsItAtTheEnd) {
  const std::uint16_t data = PeerSocket(SOCK_DGRAM).port();
  CommandPort port(fullController);
  {
    Watched head(transportWith(data, port.port()));
    EXPECT_TRUE(head.comesTrue([&] { return port.asked().size() == 2; }));
    const PeerSocket sender(SOCK_DGRAM);
    EXPECT_TRUE(head.comesTrue([&] {
      sender.sendTo(bytesOf("fr 1\r\n6d 1 [0 1.000][0 1700 0][1 0 0 0 1 0 0 0 1]\r\n"), data);
      return !head.samples.empty();
    }));
    EXPECT_EQ(head.health().message, "");
  }
  EXPECT_EQ(port.asked(), kWhole);
}

// Somebody else may have started it: its poses count, whatever the command port says.
TEST(DtrackController, ATrackerListensToOneThatRefuses) {
  const std::uint16_t data = PeerSocket(SOCK_DGRAM).port();
  CommandPort port([](const std::string& command) {
    return command == "dtrack2 tracking start" ? "dtrack2 err 8 \"no full access\"" : fullController(command);
  });
  Watched head(transportWith(data, port.port()));
  EXPECT_TRUE(head.comesTrue([&] { return head.health().message.find("error 8") != std::string::npos; }));
  EXPECT_EQ(head.health().state, TrackerHealth::State::connecting);
  const PeerSocket sender(SOCK_DGRAM);
  EXPECT_TRUE(head.comesTrue([&] {
    sender.sendTo(bytesOf("fr 1\r\n6d 1 [0 1.000][0 1700 0][1 0 0 0 1 0 0 0 1]\r\n"), data);
    return head.health().state == TrackerHealth::State::delivering;
  }));
}

// A controller wakes its cameras up, or does not answer at all; poses may come all the same.
TEST(DtrackController, ATrackerListensWhileItWaitsForTheAnswer) {
  const std::uint16_t data = PeerSocket(SOCK_DGRAM).port();
  std::atomic<bool> poseCame = false;
  CommandPort port([&](const std::string& command) {
    while (!poseCame) std::this_thread::sleep_for(test::milliseconds(5));
    return fullController(command);
  });
  Watched head(transportWith(data, port.port()));
  const PeerSocket sender(SOCK_DGRAM);
  EXPECT_TRUE(head.comesTrue([&] {
    sender.sendTo(bytesOf("fr 1\r\n6d 1 [0 1.000][0 1700 0][1 0 0 0 1 0 0 0 1]\r\n"), data);
    return !head.samples.empty();
  }));
  poseCame = true;
  EXPECT_TRUE(head.comesTrue([&] { return port.asked().size() == 2; }))
      << "the pose came after the answer was given up";
}

TEST(DtrackController, TheSourceNamesIt) {
  EXPECT_FALSE(readDtrackSource("udp://0.0.0.0:5000").controller);
  const auto controller = readDtrackSource("udp://0.0.0.0:5000?controller=art.lab").controller;
  ASSERT_TRUE(controller);
  EXPECT_EQ(controller->host, "art.lab");
  EXPECT_EQ(controller->port, 50105);
  EXPECT_EQ(readDtrackSource("udp://0.0.0.0:5000?controller=10.0.0.7:99").controller->port, 99);
  EXPECT_THROW(readDtrackSource("udp://0.0.0.0:5000?controller="), std::invalid_argument);
}

TEST(DtrackAnswer, IsReadAsItIs) {
  using Kind = DtrackAnswer::Kind;
  const auto expect = [](const DtrackAnswer& answer, Kind kind, const std::string& text) {
    EXPECT_EQ(answer.kind, kind);
    EXPECT_EQ(answer.text, text);
  };
  expect(readDtrackAnswer("dtrack2 ok"), Kind::ok, "");
  expect(readDtrackAnswer("dtrack2 err 12 \"camera 3 is missing\""), Kind::refused,
         "error 12: camera 3 is missing");
  expect(readDtrackAnswer("dtrack2 err -1"), Kind::refused, "error -1");
  expect(readDtrackAnswer("dtrack2 err x"), Kind::unknown, "dtrack2 err x");
  expect(readDtrackAnswer("dtrack2 set status active mea", "status active"), Kind::value, "mea");
  expect(readDtrackAnswer("dtrack2 set status activemea", "status active"), Kind::unknown,
         "dtrack2 set status activemea");
  expect(readDtrackAnswer("dtrack2 set status active mea"), Kind::unknown, "dtrack2 set status active mea");
  expect(readDtrackAnswer(""), Kind::unknown, "");
}

}  // namespace
}  // namespace carom
