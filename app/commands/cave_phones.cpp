#include "app/commands/cave_phones.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "app/class_server/class_address.h"
#include "app/journal/session_file.h"
#include "app/page/page_file.h"
#include "app/scenario/starting_histories.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr int kNice = 10;  // frames come first

/// Returns the part of a session that a page to take home has: all of a game, by as many frames as a page
/// holds.
VisitOptions wholeGame(const std::filesystem::path& session, std::size_t game) {
  VisitOptions options;
  options.game = game;
  const auto frames = SessionFile(session, game).frames();
  if (frames)
    options.every = std::max(options.every, 1 + (frames->second - frames->first) / kMostVisitFrames);
  return options;
}

}  // namespace

CavePhones::CavePhones(const CaveOptions& options) : takes_(options.takes), follows_(options.follows) {
  if (!canMakePages())
    throw std::runtime_error(
        "--take, --follow: this program was built without the engine for browsers, expected one that was "
        "built after config/install-packages page");
  worker_ = std::jthread([this](const std::stop_token& ends) { work(ends); });
}

void CavePhones::finish() {
  worker_.request_stop();
  if (worker_.joinable()) worker_.join();
}

std::optional<FollowedGame> CavePhones::followed() {
  if (!follows_) return {};
  return FollowedGame{[this] {
                        const std::scoped_lock hold(mutex_);
                        return followed_;
                      },
                      [this] { return live_.more(); }, [this] { return live_.whole(); }};
}

void CavePhones::play(const SessionSetup& setup, const std::filesystem::path& session) {
  session_ = session;
  scene_ = std::make_shared<const Scene>(setup.scene);
  const std::uint64_t game = games_++;
  if (!follows_) return;
  {
    const std::scoped_lock hold(mutex_);
    followed_.reset();
  }
  live_.begin(game, startingHistories(setup.scenario));
  afterwards([this, rig = setup.rig, scenario = setup.scenario, scene = scene_, game] {
    const texts::InLanguage read(texts::ofSession(0));
    const Page page = std::make_shared<const std::string>(pageOf(visitToFollow(rig, scenario, game), *scene));
    const std::scoped_lock hold(mutex_);
    followed_ = page;
  });
}

void CavePhones::end(ClassDesk& desk) {
  if (!takes_ || session_.empty()) return;
  const std::filesystem::path session = std::exchange(session_, {});
  constexpr bool kQuiet = true;
  const std::size_t game = SessionFile(session, {}, kQuiet).game();
  afterwards([session, game, scene = scene_, &desk] {
    const Visit visit = visitOf(session, wholeGame(session, game));
    if (visit.frames.back().display_s - visit.frames.front().display_s < kLeast_s) return;
    const texts::InLanguage read(texts::ofSession(0));
    desk.offer(anyTakeCode(), pageOf(visit, *scene));
  });
}

void CavePhones::shown(const Decision& decision) {
  if (follows_) live_.add(decision.frame);
}

void CavePhones::afterwards(std::function<void()> job) {
  const std::scoped_lock hold(mutex_);
  jobs_.push_back(std::move(job));
  hasJob_.notify_all();
}

void CavePhones::work(const std::stop_token& ends) {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
  while (!ends.stop_requested()) {
    std::function<void()> job;
    {
      std::unique_lock hold(mutex_);
      if (!hasJob_.wait(hold, ends, [this] { return !jobs_.empty(); })) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    try {
      job();
    } catch (const std::exception& error) {
      log::note(fmt::format("No page for phones: {}", error.what()));
    }
  }
}

}  // namespace carom
