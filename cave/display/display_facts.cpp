#include "cave/display/display_facts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "cave/cluster/frame_lock.h"

namespace carom {
namespace {

/// Returns the window of the compositing manager, or None. It announces itself as the Extended Window Manager
/// Hints ask: it owns the selection _NET_WM_CM_Sn of screen n.
::Window compositorOf(Display* display) {
  const std::string name = "_NET_WM_CM_S" + std::to_string(DefaultScreen(display));
  const Atom selection = XInternAtom(display, name.c_str(), True);
  return selection == None ? None : XGetSelectionOwner(display, selection);
}

/// Returns the bytes of a window's property; empty if it has none.
std::string propertyOf(Display* display, ::Window window, const char* property) {
  const Atom atom = XInternAtom(display, property, True);
  if (atom == None || window == None) return {};
  Atom type = None;
  int format = 0;
  unsigned long items = 0, more = 0;
  unsigned char* bytes = nullptr;
  // The window may be gone. Xlib would then end the program.
  const auto before = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  const int status = XGetWindowProperty(display, window, atom, 0, 64, False, AnyPropertyType, &type, &format,
                                        &items, &more, &bytes);
  XSetErrorHandler(before);
  const std::unique_ptr<unsigned char, int (*)(void*)> owned(bytes, XFree);
  if (status != Success || !bytes || format == 0) return {};
  const std::size_t size = format == 32 ? sizeof(long) : static_cast<std::size_t>(format) / 8;
  return {reinterpret_cast<const char*>(bytes), items * size};
}

std::string windowName(Display* display, ::Window window) {
  const std::string name = propertyOf(display, window, "_NET_WM_NAME");
  return name.empty() ? propertyOf(display, window, "WM_NAME") : name;
}

/// Returns the name of the window manager, by the window that its root window names.
std::string windowManagerOf(Display* display) {
  const std::string bytes = propertyOf(display, DefaultRootWindow(display), "_NET_SUPPORTING_WM_CHECK");
  ::Window window = None;
  if (bytes.size() == sizeof window) std::memcpy(&window, bytes.data(), sizeof window);
  return windowName(display, window);
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
  const ::Window compositor = compositorOf(display);
  facts.hasCompositor = compositor != None;
  facts.compositor = windowName(display, compositor);
  if (facts.compositor.empty()) facts.compositor = windowManagerOf(display);
  facts.hasQuadBuffer = hasQuadBuffer();
  graphics.makeCurrent();
  facts.noSwapGroup = whyNoSwapGroup(swapGroupOfDriver());
  facts.openGl = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  facts.renderer = graphics.rendererName();
  return facts;
}

}  // namespace carom
