#include "cave/display/monitors.h"

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/extensions/Xrandr.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <memory>
#include <stdexcept>

namespace carom {
namespace {

using Resources = std::unique_ptr<XRRScreenResources, decltype(&XRRFreeScreenResources)>;

/// Returns the refresh rate of a mode: its pixel clock over the pixels of a whole picture with its blanking
/// (VESA, Coordinated Video Timings). A doubly scanned line counts twice, an interlaced picture is half of
/// one.
double rateOf_hz(const XRRModeInfo& mode) {
  double pixels = static_cast<double>(mode.hTotal) * mode.vTotal;
  if (mode.modeFlags & RR_DoubleScan) pixels *= 2.0;
  if (mode.modeFlags & RR_Interlace) pixels *= 0.5;
  return pixels > 0.0 ? static_cast<double>(mode.dotClock) / pixels : 0.0;
}

double rateOf_hz(Display* display, XRRScreenResources* resources, RROutput output) {
  const std::unique_ptr<XRROutputInfo, decltype(&XRRFreeOutputInfo)> info(
      XRRGetOutputInfo(display, resources, output), XRRFreeOutputInfo);
  if (!info || info->crtc == None) return 0.0;
  const std::unique_ptr<XRRCrtcInfo, decltype(&XRRFreeCrtcInfo)> crtc(
      XRRGetCrtcInfo(display, resources, info->crtc), XRRFreeCrtcInfo);
  if (!crtc) return 0.0;
  for (int i = 0; i < resources->nmode; ++i) {
    if (resources->modes[i].id == crtc->mode) return rateOf_hz(resources->modes[i]);
  }
  return 0.0;
}

std::string atomName(Display* display, Atom atom) {
  const std::unique_ptr<char, decltype(&XFree)> name(XGetAtomName(display, atom), XFree);
  return name ? name.get() : "";
}

/// Returns whether the display knows monitors, which came with RandR 1.5.
bool hasMonitors(Display* display) {
  int event = 0, error = 0, major = 0, minor = 0;
  return XRRQueryExtension(display, &event, &error) && XRRQueryVersion(display, &major, &minor) &&
         (major > 1 || minor >= 5);
}

}  // namespace

std::vector<Monitor> monitors() {
  Display* const display = glfwGetX11Display();
  const ::Window root = DefaultRootWindow(display);
  std::vector<Monitor> found;
  if (hasMonitors(display)) {
    int count = 0;
    const std::unique_ptr<XRRMonitorInfo, decltype(&XRRFreeMonitors)> all(
        XRRGetMonitors(display, root, True, &count), XRRFreeMonitors);
    const Resources resources(XRRGetScreenResourcesCurrent(display, root), XRRFreeScreenResources);
    std::stable_partition(all.get(), all.get() + std::max(count, 0),
                          [](const XRRMonitorInfo& monitor) { return monitor.primary != 0; });
    for (int i = 0; i < count; ++i) {
      const XRRMonitorInfo& monitor = all.get()[i];
      const double rate_hz =
          resources && monitor.noutput > 0 ? rateOf_hz(display, resources.get(), monitor.outputs[0]) : 0.0;
      found.push_back({atomName(display, monitor.name),
                       {monitor.x, monitor.y},
                       {monitor.width, monitor.height},
                       rate_hz});
    }
  }
  const int screen = DefaultScreen(display);
  if (found.empty())
    found.push_back({"screen", {0, 0}, {DisplayWidth(display, screen), DisplayHeight(display, screen)}, 0.0});
  return found;
}

std::string namesOf(std::span<const Monitor> monitors) {
  std::string names;
  for (std::size_t i = 0; i < monitors.size(); ++i)
    names += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, monitors[i].name);
  return names;
}

std::vector<Monitor> monitorsOf(const WindowPlacement& placement, std::span<const Monitor> monitors) {
  std::vector<Monitor> chosen;
  for (const std::string& name : placement.monitorNames) {
    const auto named = std::find_if(monitors.begin(), monitors.end(),
                                    [&](const Monitor& monitor) { return monitor.name == name; });
    if (named == monitors.end()) {
      throw std::runtime_error(
          fmt::format("there is no monitor \"{}\", expected one of {}", name, namesOf(monitors)));
    }
    chosen.push_back(*named);
  }
  if (!chosen.empty()) return chosen;
  if (placement.monitor < 0 || static_cast<std::size_t>(placement.monitor) >= monitors.size()) {
    throw std::runtime_error(
        fmt::format("there is no monitor {}, expected one of {}", placement.monitor, namesOf(monitors)));
  }
  return {monitors[static_cast<std::size_t>(placement.monitor)]};
}

ScreenPlace placeOf(const WindowPlacement& placement, std::span<const Monitor> monitors) {
  const std::vector<Monitor> chosen = monitorsOf(placement, monitors);
  glm::ivec2 low = chosen.front().position_px, high = low;
  for (const Monitor& monitor : chosen) {
    low = glm::min(low, monitor.position_px);
    high = glm::max(high, monitor.position_px + monitor.size_px);
  }
  if (placement.fullscreen) return {low, high - low};
  return {low + placement.position_px, placement.size_px};
}

std::vector<ScreenPlace> workAreas(std::span<const Monitor> monitors) {
  std::vector<ScreenPlace> areas;
  int count = 0;
  GLFWmonitor** const known = glfwGetMonitors(&count);
  for (const Monitor& monitor : monitors) {
    areas.push_back({monitor.position_px, monitor.size_px});
    for (int i = 0; i < count; ++i) {
      ScreenPlace work;
      glm::ivec2 at{0};
      glfwGetMonitorPos(known[i], &at.x, &at.y);
      if (at != monitor.position_px) continue;
      glfwGetMonitorWorkarea(known[i], &work.position_px.x, &work.position_px.y, &work.size_px.x,
                             &work.size_px.y);
      if (work.size_px.x > 0 && work.size_px.y > 0) areas.back() = work;
    }
  }
  return areas;
}

void checkMonitors(std::span<const Wall> walls, const std::optional<WindowPlacement>& oneWindow) {
  const std::vector<Monitor> present = monitors();
  for (const Wall& wall : walls) {
    try {
      monitorsOf(oneWindow.value_or(wall.window), present);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("wall {}: {}", wall.name, error.what()));
    }
  }
}

}  // namespace carom
