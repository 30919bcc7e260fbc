#include "cave/display/display_facts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <vtk_glew.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace carom {
namespace {

/// Returns whether a compositing manager has announced itself as the Extended Window Manager Hints ask: it
/// owns the selection _NET_WM_CM_Sn of screen n.
bool hasCompositor(Display* display) {
  const std::string name = "_NET_WM_CM_S" + std::to_string(DefaultScreen(display));
  const Atom selection = XInternAtom(display, name.c_str(), True);
  return selection != None && XGetSelectionOwner(display, selection) != None;
}

bool hasExtension(Display* display, const char* name) {
  int opcode = 0, event = 0, error = 0;
  return XQueryExtension(display, name, &opcode, &event, &error) != 0;
}

bool hasQuadBuffer() {
  hintContext();
  glfwWindowHint(GLFW_STEREO, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(16, 16, "stereo", nullptr, nullptr);
  if (window) glfwDestroyWindow(window);
  return window != nullptr;
}

}  // namespace

DisplayFacts displayFacts(const Graphics& graphics) {
  DisplayFacts facts;
  facts.monitors = monitors();
  const std::unique_ptr<Display, int (*)(Display*)> connection(XOpenDisplay(nullptr), XCloseDisplay);
  if (!connection) throw std::runtime_error("the X display does not take another program");
  Display* display = connection.get();
  facts.display = DisplayString(display);
  facts.isXwayland = hasExtension(display, "XWAYLAND") ||
                     std::any_of(facts.monitors.begin(), facts.monitors.end(), [](const Monitor& monitor) {
                       return monitor.name.rfind("XWAYLAND", 0) == 0;
                     });
  facts.hasCompositor = hasCompositor(display);
  facts.hasQuadBuffer = hasQuadBuffer();
  graphics.makeCurrent();
  facts.openGl = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  facts.renderer = graphics.rendererName();
  return facts;
}

}  // namespace carom
