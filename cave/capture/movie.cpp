#include "cave/capture/movie.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

#include "cave/gl/gl_state_guard.h"
#include "cave/screen/curved_screen.h"

extern char** environ;

namespace carom {
namespace {

constexpr glm::ivec2 kLargest_px{3840, 2160}, kLargestSky_px{8192, 8192};
constexpr std::size_t kMostFramesWaiting = 16;  // frames waiting for the encoder
constexpr double kLongestStay_s = 1.0;          // longest time that a frame is shown

/// ffmpeg's options for a kind of file: the container and its codec.
struct Kind {
  std::string_view ending;
  std::vector<std::string> arguments;
};
const std::array<Kind, 3>& kinds() {
  static const std::array<Kind, 3> all{
      {{".mp4", {"-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-f", "mp4"}},
       {".webm", {"-c:v", "libvpx", "-b:v", "12M", "-deadline", "realtime", "-cpu-used", "8", "-f", "webm"}},
       {".ogv", {"-c:v", "libtheora", "-q:v", "9", "-f", "ogg"}}}};
  return all;
}

const Kind* kindOf(const std::filesystem::path& file) {
  for (const Kind& kind : kinds()) {
    if (file.extension() == kind.ending) return &kind;
  }
  return nullptr;
}

/// Returns the fraction of a wall's place that one eye's picture takes.
glm::dvec2 eyesAcross(StereoMode mode) {
  if (mode == StereoMode::sideBySide) return {2.0, 1.0};
  if (mode == StereoMode::topBottom) return {1.0, 2.0};
  return {1.0, 1.0};
}

struct Place {
  glm::dvec2 position{0.0}, size{0.0};
};

std::vector<Place> placesInOneWindow(std::span<const Wall> walls) {
  glm::dvec2 eyes(2.0);  // for all walls
  for (const Wall& wall : walls) eyes = glm::min(eyes, eyesAcross(wall.stereo));
  std::vector<Place> places;
  glm::dvec2 first(1e9);
  for (const Wall& wall : walls) {
    places.push_back({glm::dvec2(wall.window.position_px) / eyes, glm::dvec2(wall.window.size_px) / eyes});
    first = glm::min(first, places.back().position);
  }
  double scale = 1e9;  // makes all pictures at least as large as their own pixels
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const glm::dvec2 own = glm::dvec2(walls[i].pixels) / places[i].size;
    scale = std::min({scale, own.x, own.y});
  }
  for (Place& place : places) place = {(place.position - first) * scale, place.size * scale};
  return places;
}

std::vector<Place> placesInARow(std::span<const Wall> walls) {
  std::vector<Place> places;
  double right = 0.0;
  for (const Wall& wall : walls) {
    places.push_back({{right, 0.0}, wall.pixels});
    right += wall.pixels.x;
  }
  return places;
}

/// Returns whether a wall's picture is one of all directions, by longitude and latitude.
bool isSpherical(const Wall& wall) {
  const Sky* sky = wall.screen ? std::get_if<Sky>(&wall.screen->shape) : nullptr;
  return sky && sky->kind == SkyKind::equirectangular;
}

/// Returns what the walls are together: one such picture, or those of a left and a right eye.
Spherical sphericalOf(std::span<const Wall> walls, bool inOneWindow) {
  if (walls.empty() || !std::all_of(walls.begin(), walls.end(), isSpherical)) return Spherical::none;
  if (walls.size() == 1) return Spherical::mono;
  const bool areTwoEyes =
      walls.size() == 2 && walls[0].stereo == StereoMode::left && walls[1].stereo == StereoMode::right;
  return areTwoEyes && inOneWindow ? Spherical::topBottom : Spherical::none;
}

}  // namespace

bool isMovieName(const std::filesystem::path& file) { return kindOf(file) != nullptr; }

std::filesystem::path movieOfNode(const std::filesystem::path& file, int rank, int ranks) {
  if (ranks == 1) return file;
  return file.parent_path() /
         fmt::format("{}-node{}{}", file.stem().string(), rank, file.extension().string());
}

MovieLayout movieLayout(std::span<const Wall> walls, bool inOneWindow) {
  const std::vector<Place> places = inOneWindow ? placesInOneWindow(walls) : placesInARow(walls);
  glm::dvec2 all(0.0);
  for (const Place& place : places) all = glm::max(all, place.position + place.size);
  const bool isSky = std::any_of(walls.begin(), walls.end(), [](const Wall& wall) { return wall.sky; });
  const glm::dvec2 fit = glm::dvec2(isSky ? kLargestSky_px : kLargest_px) / all;
  const double scale = std::min({1.0, fit.x, fit.y});
  MovieLayout layout;
  for (const Place& place : places) {
    const glm::ivec2 from = glm::round(place.position * scale);
    const glm::ivec2 to = glm::round((place.position + place.size) * scale);
    layout.places.push_back({from, glm::max(to - from, glm::ivec2(1))});
    layout.size_px = glm::max(layout.size_px, from + layout.places.back().size_px);
  }
  layout.size_px += layout.size_px % 2;
  layout.spherical = sphericalOf(walls, inOneWindow);
  return layout;
}

/// The ffmpeg process and the pipe into it.
class Movie::Encoder {
 public:
  Encoder(const std::filesystem::path& file, const MovieLayout& layout, double frames_hz)
      : file_(file), spherical_(file.extension() == ".mp4" ? layout.spherical : Spherical::none) {
    std::error_code notThere;
    if (std::filesystem::is_directory(file, notThere)) fail("it is a folder, expected the name of a file");
    partial_ = file;
    partial_ += ".partial";
    const int made = open(partial_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (made < 0) fail(std::strerror(errno));
    close(made);
    try {
      start(layout.size_px, frames_hz);
    } catch (...) {
      unlink(partial_.c_str());
      throw;
    }
  }

  ~Encoder() {
    if (pipe_ >= 0) close(pipe_);
    if (child_ > 0) waitpid(child_, nullptr, 0);
    if (!kept_) unlink(partial_.c_str());
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// Runs on the encoding thread: repeats the previous frame up to this one's tick, then writes this one.
  void add(Job& job) {
    for (; next_ < job.tick; ++next_) write(last_);
    write(job.rgba);
    ++next_;
    std::swap(last_, job.rgba);
  }

  /// Ends the movie after its last frame.
  void finish() {
    close(pipe_);
    pipe_ = -1;
    const int status = wait();
    if (status != 0) fail(fmt::format("ffmpeg ended with status {}", status));
    markSpherical(partial_, spherical_);
    std::error_code failed;
    std::filesystem::rename(partial_, file_, failed);
    kept_ = true;
    if (!failed) return;
    const std::string why = failed.message();
    if (!std::filesystem::exists(partial_, failed)) fail(why);
    fail(fmt::format("{}; the whole movie is {}", why, partial_.string()));
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(fmt::format("movie {}: {}", file_.string(), why));
  }

  void start(const glm::ivec2& size_px, double frames_hz) {
    std::vector<std::string> words{"ffmpeg",
                                   "-hide_banner",
                                   "-loglevel",
                                   "error",
                                   "-y",
                                   "-f",
                                   "rawvideo",
                                   "-pix_fmt",
                                   "rgb0",
                                   "-s",
                                   fmt::format("{}x{}", size_px.x, size_px.y),
                                   "-r",
                                   fmt::format("{}", frames_hz),
                                   "-i",
                                   "pipe:0",
                                   "-vf",
                                   "vflip",
                                   "-pix_fmt",
                                   "yuv420p"};
    const std::vector<std::string>& kind = kindOf(file_)->arguments;
    words.insert(words.end(), kind.begin(), kind.end());
    // A file with its index in front can be watched while it is loaded; what marks a movie of all directions
    // wants it at the end.
    if (spherical_ == Spherical::none && file_.extension() == ".mp4")
      words.insert(words.end(), {"-movflags", "+faststart"});
    words.push_back("file:" + partial_.string());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // The process gets a group of its own: Ctrl-C ends the session, which then closes the movie.
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = posix_spawnp(&child_, "ffmpeg", &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(ends[0]);
    pipe_ = ends[1];
    if (failed == 0) return;
    child_ = -1;
    close(pipe_);
    pipe_ = -1;
    if (failed == ENOENT)
      fail("the program ffmpeg, which encodes it, is not installed; on Debian: apt install ffmpeg");
    fail(fmt::format("the program ffmpeg cannot be started: {}", std::strerror(failed)));
  }

  int wait() {
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  void write(std::span<const std::uint8_t> bytes) {
    holdBackPipeSignal();
    while (!bytes.empty()) {
      const ssize_t written = ::write(pipe_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(errno == EPIPE ? "ffmpeg has ended before the movie" : std::strerror(errno));
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  /// Blocks SIGPIPE, on the encoding thread alone: once ffmpeg is gone, a write then fails instead of ending
  /// the whole program.
  void holdBackPipeSignal() {
    if (held_) return;
    sigset_t pipe;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    held_ = true;
  }

  std::filesystem::path file_, partial_;
  Spherical spherical_;
  pid_t child_ = -1;
  int pipe_ = -1;
  bool held_ = false;
  bool kept_ = false;
  std::uint64_t next_ = 0;  // the next tick
  std::vector<std::uint8_t> last_;
};

Movie::Movie(std::filesystem::path file, MovieLayout layout, double frames_hz, WhenFull whenFull)
    : file_(std::move(file)),
      layout_(std::move(layout)),
      frames_hz_(frames_hz),
      whenFull_(whenFull),
      picture_(layout_.size_px),
      encoder_(std::make_unique<Encoder>(file_, layout_, frames_hz)),
      queue_(std::make_unique<WorkQueue<Job>>(kMostFramesWaiting, 1,
                                              [this](Job& job) { encoder_->add(job); })) {}

Movie::~Movie() {
  {
    const std::scoped_lock hold(finishing_);
    finished_ = true;
  }
  queue_.reset();
  encoder_.reset();
}

void Movie::add(double display_s, std::span<const RenderTarget* const> pictures) {
  fetch(1);
  if (pace_.previous_s) {
    const double stayed_s = display_s - *pace_.previous_s;
    const bool jumped = !(std::abs(stayed_s) <= kLongestStay_s);
    const double ticks = jumped ? 1.0 : std::max(1.0, std::round(stayed_s * frames_hz_));
    pace_.tick += static_cast<std::uint64_t>(ticks);
  }
  const bool first = !pace_.previous_s;
  pace_.previous_s = display_s;
  if (whenFull_ == WhenFull::drop && !first && queue_->room() < 1 + reader_.underWay()) {
    ++pace_.dropped;
    return;
  }
  {
    const GlStateGuard state(picture_.framebuffer(), picture_.size_px());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const Viewport& place = layout_.places[i];
      packer_.draw({pictures[i], nullptr, StereoMode::mono, place.position_px, place.size_px},
                   picture_.size_px());
    }
  }
  reader_.ask(picture_, 0);
  asked_.push_back(pace_.tick);
}

void Movie::fetch(std::size_t most) {
  reader_.fetch(most, [this](const glm::ivec2&, std::span<const std::uint8_t> rgba) {
    Job job = queue_->spare();
    job.tick = asked_.front();
    asked_.pop_front();
    job.rgba.assign(rgba.begin(), rgba.end());
    queue_->add(std::move(job));
  });
}

void Movie::finish() {
  fetch(0);
  conclude();
}

/// Completes the movie from all that has been read back; does so once.
void Movie::conclude() {
  const std::scoped_lock hold(finishing_);
  if (std::exchange(finished_, true)) return;
  queue_->finish();
  encoder_->finish();
}

}  // namespace carom
