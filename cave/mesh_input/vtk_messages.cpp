#include "cave/mesh_input/vtk_messages.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <string>

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>

#include "engine/text/log.h"

namespace carom {
namespace {

class LogWindow : public vtkOutputWindow {
 public:
  static LogWindow* New() { return new LogWindow; }
  void DisplayText(const char* text) override { say(text); }
  void DisplayErrorText(const char* text) override { say(text); }
  void DisplayWarningText(const char* text) override { say(text); }
  void DisplayGenericWarningText(const char* text) override { say(text); }
  void DisplayDebugText(const char*) override {}

 private:
  /// Says the message on one line, without the source file and the object that it came from. A picture may
  /// complain in every frame.
  void say(std::string text) {
    constexpr std::size_t kMostSaid = 100, kLongest = 300;
    if (const std::size_t after = text.find("): "); after != std::string::npos) text = text.substr(after + 3);
    text = text.substr(0, std::min(text.find('\n'), kLongest));
    const std::scoped_lock hold(mutex_);
    if (said_.size() < kMostSaid && said_.insert(text).second) log::warn("VTK: " + text);
  }

  std::mutex mutex_;
  std::set<std::string> said_;
};

}  // namespace

void sendVtkMessagesToLog() {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // which writes beside the window, in colours
  vtkNew<LogWindow> window;
  vtkOutputWindow::SetInstance(window);
}

}  // namespace carom
