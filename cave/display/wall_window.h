#pragma once
// What windows tell the X server and the window manager beyond what GLFW does.

struct GLFWwindow;

namespace carom {

/// Makes a window black from the moment it is shown, until something is drawn in it. Call it before the
/// window is shown.
void beginBlack(GLFWwindow* window);

/// Asks the window manager to keep a window without border above panels (if it covers one monitor), and a
/// compositor to leave it alone. Call it before the window is shown.
void claimWall(GLFWwindow* window, bool coversOneMonitor);

/// Suspends the display's screen saver and power saving until this process ends.
void keepDisplayAwake();

}  // namespace carom
