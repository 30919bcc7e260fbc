// A force device behind a VRPN server, against a server of the test's own.

#include "devices/network/vrpn_force.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "devices/force/force_loop.h"
#include "devices/network/only_session.h"
#include "devices/network_peer.h"
#include "devices/protocol/vrpn_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/vrpn_sender.h"
#include "devices/vrpn_server.h"

namespace carom {
namespace {

using test::Bytes;
using test::PeerSocket;
using test::VrpnSender;

/// A device that has connected, and the server's end of it.
struct Connected {
  test::VrpnServer server;
  std::unique_ptr<ForceDevice> device;
  std::optional<PeerSocket> client;

  Connected() {
    std::jthread greets([this] { client.emplace(server.greet()); });
    device = openVrpnForce(readVrpnSource(server.source()), {});
    greets.join();
    client->send(VrpnSender::names("Head"));
  }
  /// Reads until a place has come.
  ForceDeviceState readAt(double now_s) const {
    ForceDeviceState state;
    for (int i = 0; i < 200 && state.time_s != now_s; ++i) {
      state = device->read(now_s);
      std::this_thread::sleep_for(test::milliseconds(5));
    }
    return state;
  }
};

std::uint32_t wordIn(const Bytes& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | bytes.at(at + i);
  return word;
}

/// Returns the 16 floats of the last field of force that the client has sent; empty if there is none.
std::vector<float> fieldIn(const Bytes& bytes) {
  std::vector<float> field;
  for (std::size_t at = 0; at + 24 <= bytes.size();) {
    const std::size_t length = wordIn(bytes, at);
    if (length < 24 || at + length > bytes.size()) break;
    if (wordIn(bytes, at + 16) == 2 && length == 24 + 64) {
      field.clear();
      for (std::size_t i = 0; i < 16; ++i)
        field.push_back(std::bit_cast<float>(wordIn(bytes, at + 24 + 4 * i)));
    }
    at += (length + 7) / 8 * 8;
  }
  return field;
}

/// Returns the next field that the client sends; what it describes before that may have come with its
/// greeting.
std::vector<float> nextField(const PeerSocket& client) {
  for (int i = 0; i < 5; ++i) {
    const auto bytes = client.receive();
    if (!bytes) break;
    const std::vector<float> field = fieldIn(*bytes);
    if (!field.empty()) return field;
  }
  return {};
}

TEST(VrpnForce, SendsTheLawAtItsLastPlace) {
  Connected arm;
  const Bytes description = vrpnForceDescription();
  EXPECT_NE(std::string(description.begin(), description.end()).find("vrpn_ForceDevice Force_Field"),
            std::string::npos);
  ForceCommand command;
  command.at_m = {0.1, 0.2, 0.3};
  command.force_n = {1.0, -2.0, 3.5};
  command.stiffness_n_m = glm::dmat3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);  // by columns
  arm.device->write(command);
  const std::vector<float> field = nextField(*arm.client);
  ASSERT_EQ(field.size(), 16u);
  const std::vector<float> expected{0.1F, 0.2F, 0.3F, 1.0F, -2.0F, 3.5F, 1.0F, 4.0F,
                                    7.0F, 2.0F, 5.0F, 8.0F, 3.0F,  6.0F, 9.0F, 0.02F};
  EXPECT_EQ(field, expected) << "the jacobian row by row";
  command.force_n = glm::dvec3(0.0);
  arm.device->write(command);
  EXPECT_EQ(nextField(*arm.client).at(15), 0.0F) << "no force, no field";
}

// A server lets any number of clients push, so sessions agree among themselves.
TEST(VrpnForce, IsOfOneSessionAtATime) {
  std::string source;
  {
    Connected arm;
    source = arm.server.source();
    try {
      openVrpnForce(readVrpnSource(source), {});
      ADD_FAILURE() << "a second session pushes";
    } catch (const NeedsHelp& error) {
      EXPECT_NE(std::string(error.what()).find("Head at 127.0.0.1:"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("is the force device of another session"), std::string::npos);
    }
    EXPECT_TRUE(arm.device) << "the first goes on";
    arm.client->send(VrpnSender::pose(0, 0.25, 0.1, 1.0));
    EXPECT_EQ(arm.readAt(7.0).position_m.x, 0.25);
  }
  const OnlySession free("Head at 127.0.0.1:1");  // after the first has ended, and of another device
  const OnlySession other("Head at 127.0.0.1:2");
  EXPECT_THROW(OnlySession("Head at 127.0.0.1:1"), NeedsHelp);
}

TEST(VrpnForce, LeavesTheDeviceAtZero) {
  Connected arm;
  ForceCommand command;
  command.force_n = {1.0, 0.0, 0.0};
  arm.device->write(command);
  EXPECT_EQ(nextField(*arm.client).at(3), 1.0F);
  arm.device.reset();
  EXPECT_EQ(nextField(*arm.client), std::vector<float>(16, 0.0F));
}

TEST(VrpnForce, ReadsPlacesAndButtons) {
  Connected arm;
  arm.client->send(VrpnSender::pose(0, 0.25, 0.1, 1.0));
  EXPECT_EQ(arm.readAt(7.0).position_m, glm::dvec3(0.25, 1.7, -0.25));
  EXPECT_FALSE(arm.device->read(7.0).pressed);
  arm.client->send(VrpnSender::button(1, true, 1.0));
  arm.client->send(VrpnSender::pose(0, 0.26, 0.1, 1.0));
  EXPECT_TRUE(arm.readAt(8.0).pressed);
}

TEST(VrpnForce, APlaceThatIsNoNumberIsNotTakenAndGrowsOld) {
  Connected arm;
  arm.client->send(VrpnSender::pose(0, 0.25, 0.1, 1.0));
  arm.readAt(7.0);
  arm.client->send(VrpnSender::pose(0, std::numeric_limits<double>::quiet_NaN(), 0.1, 1.0));
  std::this_thread::sleep_for(test::milliseconds(50));
  const ForceDeviceState state = arm.device->read(7.1);
  EXPECT_EQ(state.position_m.x, 0.25);
  EXPECT_EQ(state.time_s, 7.0) << "the watch sees that it is old";
  ForceLoop loop({9.0, 600.0, 5e-3, 1e-3, 0.3, 60.0, 2e-5, 1});
  ForceLaw law;
  law.held = true;
  law.posted_s = 7.1;
  loop.tick(7.1, state, law);
  EXPECT_EQ(loop.report().fall, ForceFall::poseOld);
}

TEST(VrpnForce, SaysThatTheServerIsGoneOrIsNone) {
  {
    Connected arm;
    arm.client.reset();
    std::this_thread::sleep_for(test::milliseconds(50));
    try {
      for (int i = 0; i < 100; ++i) {
        arm.device->read(1.0);
        std::this_thread::sleep_for(test::milliseconds(5));
      }
      ADD_FAILURE();
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.ends_with("hung up") || said.starts_with("the connection broke")) << said;
    }
  }
  EXPECT_THROW(openVrpnForce(readVrpnSource("Arm@tcp://127.0.0.1:1"), {}), std::runtime_error);
  Connected arm;
  arm.client->send(Bytes(64, 0xff));
  std::this_thread::sleep_for(test::milliseconds(50));
  EXPECT_THROW(for (int i = 0; i < 100; ++i) arm.device->read(1.0), std::runtime_error);
}

}  // namespace
}  // namespace carom
