#include "devices/setup/force_factory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "devices/force/simulated_force.h"
#include "devices/force/stepped_force.h"
#include "devices/network/vrpn_force.h"
#include "devices/usb/evdev_force.h"

namespace carom {
namespace {

using Device = std::unique_ptr<ForceDevice>;

Device openSimulated(const ForceSetup&, const ForceLimits& limits, const RoomAxes&, const std::stop_token&) {
  return std::make_unique<SimulatedForce>(limits);
}
Device openEvdev(const ForceSetup& setup, const ForceLimits&, const RoomAxes& axes, const std::stop_token&) {
  return openEvdevForce(setup.source, setup.forceMax_n, axes);
}
Device openVrpn(const ForceSetup& setup, const ForceLimits&, const RoomAxes&, const std::stop_token& stop) {
  return openVrpnForce(readVrpnSource(setup.source), stop);
}

// Period of the loop, period of the spring, damping of the device, least rate, step of the encoder. A VRPN
// server holds the spring in a loop of its own, at 1 kHz.
constexpr std::array kForceRows{
    ForceRow{ForceKind::simulated,
             "simulated",
             false,
             true,
             {9.0, 600.0, 1e-3, 1e-3, 0.3, 500.0, 2e-5},
             openSimulated},
    ForceRow{ForceKind::evdev, "evdev", false, false, {9.0, 250.0, 8e-3, 8e-3, 1.0, 60.0, 1e-4}, openEvdev},
    ForceRow{ForceKind::vrpn, "vrpn", true, true, {9.0, 600.0, 5e-3, 1e-3, 0.3, 60.0, 2e-5}, openVrpn}};

}  // namespace

std::span<const ForceRow> forceRows() { return kForceRows; }

const ForceRow& rowOf(ForceKind kind) {
  return *std::find_if(kForceRows.begin(), kForceRows.end(),
                       [&](const ForceRow& row) { return row.kind == kind; });
}

std::vector<std::string_view> forceNames() {
  std::vector<std::string_view> names;
  for (const ForceRow& row : kForceRows) names.push_back(row.name);
  return names;
}

ForceLimits limitsOf(const ForceSetup& setup) {
  ForceLimits limits = rowOf(setup.kind).limits;
  limits.force_n = setup.forceMax_n;
  const double passive_n_m = passiveStiffness_n_m(limits);
  limits.stiffness_n_m = std::min(setup.stiffnessMax_n_m.value_or(passive_n_m), passive_n_m);
  return limits;
}

std::string loweredStiffness(const ForceSetup& setup) {
  const ForceLimits& limits = rowOf(setup.kind).limits;
  const double passive_n_m = passiveStiffness_n_m(limits);
  if (!(setup.stiffnessMax_n_m.value_or(0.0) > passive_n_m)) return {};
  return fmt::format(
      "stiffness_max_n_m is {:g}, expected at most {:g}, twice the damping of such a device over its period: "
      "it is "
      "lowered, and so is the force",
      *setup.stiffnessMax_n_m, passive_n_m);
}

void checkForceSource(const ForceSetup& setup) {
  if (setup.kind == ForceKind::vrpn) readVrpnSource(setup.source);
  if (setup.kind == ForceKind::evdev && !setup.source.empty() && !setup.source.starts_with("/"))
    throw std::invalid_argument("source is '" + setup.source +
                                "', expected a node such as '/dev/input/by-id/…'");
}

std::string nameOf(const ForceSetup& setup) {
  const std::string kind = "force device " + std::string(rowOf(setup.kind).name);
  return setup.source.empty() ? kind : kind + " " + setup.source;
}

ForceTrial tryForce(const ForceSetup& setup, const RoomAxes& axes) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kListens{1000}, kPause{5};
  const ForceRow& row = rowOf(setup.kind);
  const ForceLimits limits = limitsOf(setup);
  const std::string can = fmt::format("at most {:g} N, {:g} N/m, {:g} Hz", limits.force_n,
                                      limits.stiffness_n_m, 1.0 / limits.period_s);
  if (setup.kind == ForceKind::simulated) return {true, can};
  try {
    const Device device = row.open(setup, limits, axes, {});
    if (!row.hasPose) return {true, can + "; it is there"};
    const double begun_s = device->read(0.0).time_s;
    for (const Clock::time_point begun = Clock::now(); Clock::now() - begun < kListens;) {
      std::this_thread::sleep_for(kPause);
      if (device->read(1.0).time_s != begun_s) return {true, can + "; it is there and sends its place"};
    }
    return {false, can + "; it is there, but sends no place, expected 100 a second at least"};
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

std::unique_ptr<ForceChannel> createForce(const ForceSetup& setup, const RoomAxes& axes,
                                          std::chrono::steady_clock::time_point sessionStart) {
  const ForceLimits limits = limitsOf(setup);
  if (setup.kind == ForceKind::simulated) return std::make_unique<SteppedForce>(limits);
  OpenForce open = [setup, limits, axes](const std::stop_token& stop) {
    return rowOf(setup.kind).open(setup, limits, axes, stop);
  };
  return std::make_unique<ForceThread>(nameOf(setup), std::move(open), limits, sessionStart);
}

}  // namespace carom
