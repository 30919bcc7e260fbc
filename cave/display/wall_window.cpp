#include "cave/display/wall_window.h"

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xatom.h>
#include <X11/extensions/scrnsaver.h>

namespace carom {
namespace {

Atom atom(Display* display, const char* name) { return XInternAtom(display, name, False); }

}  // namespace

void beginBlack(GLFWwindow* window) {
  XSetWindowBackground(glfwGetX11Display(), glfwGetX11Window(window),
                       0);  // black in every visual with OpenGL
}

// Both properties: Extended Window Manager Hints, https://specifications.freedesktop.org/wm-spec.
void claimWall(GLFWwindow* window, bool coversOneMonitor) {
  Display* const display = glfwGetX11Display();
  const ::Window id = glfwGetX11Window(window);
  const unsigned long leaveAlone = 1;
  XChangeProperty(display, id, atom(display, "_NET_WM_BYPASS_COMPOSITOR"), XA_CARDINAL, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(&leaveAlone), 1);
  if (!coversOneMonitor) return;
  const Atom fullscreen = atom(display, "_NET_WM_STATE_FULLSCREEN");
  XChangeProperty(display, id, atom(display, "_NET_WM_STATE"), XA_ATOM, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(&fullscreen), 1);
}

void keepDisplayAwake() {
  Display* const display = glfwGetX11Display();
  int event = 0, error = 0;
  if (!XScreenSaverQueryExtension(display, &event, &error)) return;
  XScreenSaverSuspend(display, True);
  XFlush(display);
}

}  // namespace carom
