#include "app/stage/window_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <system_error>

#include "app/toml/toml_file.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWindows = 32, kMostLetters = 200;

/// Returns the keys of the file, which the program alone writes.
const FileKey& windowKeys() {
  using namespace declare;
  constexpr Range kPlace_px{.least = 0.0, .most = 32767.0};  // X11 counts in 16 bits
  constexpr Range kSize_px{.least = 100.0, .most = 32767.0};
  static const FileKey keys =
      table("windows", "where windows lay",
            {tables("window", "one of them",
                    {required(text("name", "its title")), required(text("monitor", "its name")),
                     required(wholes("position", 2, kPlace_px, "on the monitor")),
                     required(wholes("size", 2, kSize_px, "width and height"))})});
  return keys;
}

std::array<int, 2> pixels(const std::array<double, 2>& numbers) {
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

std::vector<RememberedWindow> windowsIn(const fs::path& path) {
  const TomlFile file(path, windowKeys());
  std::vector<RememberedWindow> windows;
  for (const TomlTable& table : file.root().tables("window")) {
    RememberedWindow window{table.text("name"), table.text("monitor"), pixels(table.numbers<2>("position")),
                            pixels(table.numbers<2>("size"))};
    if (window.name.size() > kMostLetters) table.fault("name", "a name that is too long");
    windows.push_back(std::move(window));
  }
  if (windows.size() > kMostWindows)
    file.root().fault("window", fmt::format("{} windows, expected at most {}", windows.size(), kMostWindows));
  file.throwFaults();
  return windows;
}

/// Returns the text as a basic string of TOML, without what must not stand in one.
std::string asToml(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text.substr(0, kMostLetters)) {
    if (letter == '"' || letter == '\\') result += '\\';
    if (static_cast<unsigned char>(letter) >= 0x20 && letter != 0x7f) result += letter;
  }
  return result + '"';
}

}  // namespace

fs::path userFolder() {
  const char* own = std::getenv("XDG_CONFIG_HOME");
  if (own && fs::path(own).is_absolute()) return fs::path(own) / "carom";
  const char* home = std::getenv("HOME");
  if (home && fs::path(home).is_absolute()) return fs::path(home) / ".config/carom";
  return {};
}

std::vector<RememberedWindow> readWindowMemory(const fs::path& file) try {
  std::error_code failed;
  if (file.empty() || !fs::is_regular_file(file, failed)) return {};
  return windowsIn(file);
} catch (const std::exception& error) {
  log::warn(fmt::format("{}. The windows open as if it were not there.", error.what()));
  return {};
}

void writeWindowMemory(const fs::path& file, const std::vector<RememberedWindow>& windows) {
  if (file.empty() || windows.empty()) return;
  std::vector<RememberedWindow> all = windows;
  for (const RememberedWindow& old : readWindowMemory(file)) {
    const bool isNew = std::none_of(windows.begin(), windows.end(),
                                    [&](const RememberedWindow& window) { return window.name == old.name; });
    if (isNew) all.push_back(old);
  }
  all.resize(std::min(all.size(), kMostWindows));
  std::string text = "# Where Carom's windows lay; delete this file, and they open in their usual places.\n";
  for (const RememberedWindow& window : all) {
    text += fmt::format("\n[[window]]\nname = {}\nmonitor = {}\nposition = [{}, {}]\nsize = [{}, {}]\n",
                        asToml(window.name), asToml(window.monitor), window.position[0], window.position[1],
                        window.size[0], window.size[1]);
  }
  try {
    fs::create_directories(file.parent_path());
    WholeFile(file).commit(text);
  } catch (const std::exception& error) {
    log::warn(fmt::format("{}. The windows' places are not remembered.", error.what()));
  }
}

}  // namespace carom
