// A visitor's way by one device alone, with mouse, finger, wand or gamepad: welcome, lesson, answer,
// velocities, explanation, and out again; the show; the game. Everything is pressed on the front wall, where
// the last frame showed it. The wand is a Flystick whose datagrams come over the network, in real time.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "app/live/live_source.h"
#include "app/operator/room_languages.h"
#include "app/operator/visitor_choices.h"
#include "app/scenario/starting_histories.h"
#include "app/session/director.h"
#include "app/session/game_settings.h"
#include "app/temporary_folder.h"
#include "cave/overlay/band_layout.h"
#include "cave/texts/texts.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

using Kind = WallAction::Kind;

Beginning beginningIn(const Rig& rig) {
  Beginning beginning;
  beginning.languages = std::make_shared<const SessionLanguages>(languagesOf(rig, nullptr, ""));
  return beginning;
}

/// A session of a desk's rig, without its pictures.
class Session {
 public:
  Session(Rig rig, std::unique_ptr<Clock> clock, LiveStart start)
      : rig_(std::move(rig)),
        clock_(std::move(clock)),
        scenario_(readScenario(fileOfGame(kWelcome))),
        world_{startingHistories(scenario_), {}},
        source_(rig_, scenario_, world_, start),
        beginning_(beginningIn(rig_)),
        leader_(source_, KeysOf::session, settingsOf(rig_, scenario_, fileOfGame(kWelcome), beginning_),
                [this](const WindowInput&, bool) { return desk_; }) {
    text_.setWall(wall(), {});
    frame();
  }

  const Wall& wall() const { return rig_.walls.front(); }
  const FrameRecord& record() const { return decision_.frame.record; }
  const Decision& decision() const { return decision_; }
  const OperatorSettings& settings() const { return leader_.settings(); }
  std::string playing() const { return std::filesystem::path(settings().playing).stem().string(); }

  /// Plays a frame, and begins the next game where one was chosen.
  void frame(const DeskInput& desk = {}) {
    desk_ = desk;
    leader_.decide(pacer_.next(), {}, decision_);
    applyFrame(decision_.frame, world_);
    strokes += decision_.strokes.size();
    answers += decision_.answers.size();
    pacer_.awaitTick(0.0);
    pacer_.swapped();
    if (!record().last) return;
    const NextGame next = leader_.takeNextGame();
    scenario_ = readScenario(next.file);
    world_ = {startingHistories(scenario_), {}};
    source_.playAnew();
    leader_.begin(settingsOfNext(leader_.settings(), next, rig_, scenario_, beginning_));
    leader_.decide(pacer_.next(), {}, decision_);
    applyFrame(decision_.frame, world_);
  }

  /// Returns the place of a button in the room, as the last frame shows it.
  std::optional<Vec3> placeOf(const WallAction& action) {
    const Lesson lesson = scenario_.lesson.value_or(Lesson{});
    text_.setLesson(lesson.words, lesson.plan);
    text_.follow(record());
    std::vector<WallButton> buttons;
    if (text_.isBand()) addBand(wall(), text_.lines(), buttons);
    addTiles(wall(), record(), {scenario_.choices, true, false}, buttons);
    for (const WallButton& button : buttons) {
      if (button.action == action) return middleOf(wall(), button.place);
    }
    return {};
  }

  void welcome() { leader_.inbox().emplace_back(WelcomeNextVisitor{}); }

  bool await(const std::function<bool()>& holds, int frames = 200) {
    for (int i = 0; i < frames && !holds(); ++i) frame();
    return holds();
  }

  std::size_t strokes = 0, answers = 0;

 private:
  Rig rig_;
  std::unique_ptr<Clock> clock_;
  Scenario scenario_;
  World world_;
  LiveSource source_;
  DeskInput desk_;
  Beginning beginning_;
  FrameLeader leader_;
  Pacer pacer_{*clock_, 60.0, 0.0, false, 0};
  HudText text_;
  Decision decision_;
};

Rig playRig() { return readRig(CAROM_CONFIG_DIR "/rigs/play.toml"); }

using Press = std::function<void(Session&, const Vec3&)>;

/// Presses a button that must be there, and awaits what follows.
#define PRESSED(action, follows)                                                                       \
  do {                                                                                                 \
    const std::optional<Vec3> place_m = session.placeOf(action);                                       \
    ASSERT_TRUE(place_m) << "there is no such button in " << session.playing();                        \
    press(session, *place_m);                                                                          \
    ASSERT_TRUE(session.await([&] { return (follows); })) << #follows << ", in " << session.playing(); \
  } while (false)

void walk(Session& session, const Press& press) {
  const test::LogLines log;
  const auto phase = [&] { return session.settings().lesson.phase; };
  const auto isShown = [&](const char* game) {
    return session.playing() == game && session.record().fade == 0.0;
  };
  const WallAction goOn{Kind::goOn}, again{Kind::again}, leave = actionOf(Choice::play);
  ASSERT_TRUE(session.await([&] { return isShown("welcome"); }));
  PRESSED(actionOf(Choice::lessons), isShown("comes-and-goes"));
  EXPECT_EQ(phase(), LessonPhase::asks);
  PRESSED((WallAction{Kind::choose, 2}), phase() == LessonPhase::shows);
  EXPECT_EQ(session.settings().lesson.answer, 2);
  PRESSED(goOn, phase() == LessonPhase::explains);
  PRESSED(goOn, phase() == LessonPhase::shows);
  const double shown_s = session.record().display_s;
  PRESSED(again, session.record().viewers[0].observer.properTime_s < 0.1 &&
                     session.record().display_s > shown_s + 0.5);
  EXPECT_EQ(phase(), LessonPhase::shows);
  ASSERT_TRUE(session.await([&] { return isShown("comes-and-goes"); }));
  PRESSED(goOn, phase() == LessonPhase::explains);
  PRESSED(actionOf(Choice::lessons), isShown("seen-at-once"));
  PRESSED(goOn, phase() == LessonPhase::shows);
  EXPECT_EQ(session.settings().lesson.answer, 0) << "skipped";
  PRESSED((WallAction{Kind::choose, 2}), session.settings().lessonObserver == 1);
  PRESSED((WallAction{Kind::choose, 1}), session.settings().lessonObserver == 0);
  PRESSED(goOn, phase() == LessonPhase::explains);
  PRESSED(goOn, phase() == LessonPhase::shows);
  PRESSED(leave, isShown("welcome"));
  PRESSED(actionOf(Choice::showMe), isShown("show-me"));
  PRESSED(actionOf(Choice::play), isShown("welcome"));
  PRESSED(actionOf(Choice::lessons), isShown("seen-length"));
  PRESSED(leave, isShown("welcome"));  // while it asks
  EXPECT_EQ(session.answers, 2U);
  EXPECT_EQ(session.strokes, 0U);
}

DeskInput mouseAt(const Vec3& place_m, bool held) {
  DeskInput desk;
  desk.mouse = PointedWall{place_m, Eye::middle};
  desk.mouseHeld = held;
  return desk;
}

Session deskSession() { return {playRig(), std::make_unique<SimulatedClock>(), {}}; }

TEST(WallPath, ByMouseAlone) {
  Session session = deskSession();
  walk(session, [](Session& here, const Vec3& place_m) {
    for (const bool held : {false, false, true, true, false}) here.frame(mouseAt(place_m, held));
  });
}

// A finger is nowhere before it comes down, and nowhere after.
TEST(WallPath, ByFingerAlone) {
  Session session = deskSession();
  walk(session, [](Session& here, const Vec3& place_m) {
    here.frame();
    here.frame(mouseAt(place_m, true));
    here.frame();
  });
}

TEST(WallPath, ByGamepadAlone) {
  Session session = deskSession();
  walk(session, [](Session& here, const Vec3& place_m) {
    DeskInput pad;
    pad.hasPad = true;
    const auto isThere = [&] { return glm::distance(here.record().viewers[0].hand.to_m, place_m) < 1e-6; };
    for (int steps = 0; steps < 12 && !isThere(); ++steps) {
      pad.padStep = 1;
      here.frame(pad);
      pad.padStep = 0;
      here.frame(pad);
    }
    EXPECT_TRUE(isThere()) << "the cross does not come to it";
    pad.padHeld = true;
    here.frame(pad);
    pad.padHeld = false;
    here.frame(pad);
  });
}

/// A Flystick at rest in the air before the wall, whose datagrams go to this port.
class Flystick {
 public:
  explicit Flystick(int port) : socket_(socket(AF_INET, SOCK_DGRAM, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_port = htons(static_cast<std::uint16_t>(port));
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  ~Flystick() { close(socket_); }
  Flystick(const Flystick&) = delete;
  Flystick& operator=(const Flystick&) = delete;

  void send(const Vec3& aim_m, bool pressed) {
    const Vec3 back = glm::normalize(kPlace_m - aim_m),
               right = glm::normalize(glm::cross(Vec3(0, 1, 0), back)), up = glm::cross(back, right);
    std::string words = fmt::format("fr {}\n6df2 1 1 [0 1.000 4 2]", ++frame_);
    const auto list = [&](std::initializer_list<double> numbers) {
      words += "[";
      for (const double number : numbers)
        words += fmt::format("{}{:.9f}", words.back() == '[' ? "" : " ", number);
      words += "]";
    };
    list({1e3 * kPlace_m.x, 1e3 * kPlace_m.y, 1e3 * kPlace_m.z});
    list({right.x, right.y, right.z, up.x, up.y, up.z, back.x, back.y, back.z});
    words += fmt::format("[{} 0.00 0.00]\n", pressed ? 1 : 0);
    sendto(socket_, words.data(), words.size(), 0, reinterpret_cast<const sockaddr*>(&address_),
           sizeof address_);
  }

 private:
  static constexpr Vec3 kPlace_m{0.25, 1.2, -0.2};
  int socket_;
  sockaddr_in address_{};
  int frame_ = 0;
};

/// Returns a port that is free now.
int freePort() {
  const int probe = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  bind(probe, reinterpret_cast<const sockaddr*>(&address), size);
  getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size);
  close(probe);
  return ntohs(address.sin_port);
}

TEST(WallPath, ByWandAlone) {
  const int port = freePort();
  const test::TemporaryFolder folder;
  std::ifstream play(CAROM_CONFIG_DIR "/rigs/play.toml");
  const std::string text{std::istreambuf_iterator<char>(play), {}};
  const Rig rig = readRig(folder.file(
      "wand.toml",
      text + fmt::format("\n[hand]\ntracker = \"stick\"\nsensor = 100\n[[tracker]]\nname = \"stick\"\n"
                         "kind = \"dtrack\"\nsource = \"udp://127.0.0.1:{}\"\n",
                         port)));
  const auto begun = std::chrono::steady_clock::now();
  LiveStart start;
  start.sessionStart = begun;
  Session session(rig, std::make_unique<SteadyClock>(begun), start);
  Flystick stick(port);
  walk(session, [&](Session& here, const Vec3& place_m) {
    const auto aims = [&] { return glm::distance(here.record().viewers[0].hand.to_m, place_m) < 1e-3; };
    for (int i = 0; i < 600 && !aims(); ++i) {
      stick.send(place_m, false);
      here.frame();
    }
    EXPECT_TRUE(aims()) << "the wand's ray does not come there";
    stick.send(place_m, true);  // a press shorter than a frame
    stick.send(place_m, false);
    for (int i = 0; i < 5; ++i) {
      here.frame();
      stick.send(place_m, false);
    }
  });
}

TEST(WallPath, APressBesideTheAnswersSaysHowToAnswer) {
  Session session = deskSession();
  const test::LogLines log;
  const Vec3 tile_m = session.placeOf(actionOf(Choice::lessons)).value();
  session.frame(mouseAt(tile_m, true));
  ASSERT_TRUE(session.await([&] { return session.playing() == "comes-and-goes"; }));
  session.frame();
  const Wall& wall = session.wall();
  const Vec3 table_m = 0.5 * (wall.lowerLeft_m + wall.lowerRight_m) + Vec3(0.0, 0.2, 0.0);
  session.frame(mouseAt(table_m, true));
  EXPECT_EQ(session.record().viewers[0].notice.words(), texts::message::kAsks.english());
  EXPECT_EQ(session.settings().lesson.phase, LessonPhase::asks);
}

// Driven away, back by a press.
TEST(WallPath, TheWayHomeIsAButton) {
  Session session = deskSession();
  const test::LogLines log;
  EXPECT_FALSE(session.placeOf({Kind::home}));
  DeskInput drives;
  drives.steer = {0.0, 1.0, 0.0};
  for (int i = 0; i < 60; ++i) session.frame(drives);
  session.frame();
  const std::optional<Vec3> home_m = session.placeOf({Kind::home});
  ASSERT_TRUE(home_m);
  session.frame(mouseAt(*home_m, false));
  session.frame(mouseAt(*home_m, true));
  session.frame();
  EXPECT_EQ(session.record().drive.mode, DriveMode::home);
  session.frame();
  EXPECT_FALSE(session.placeOf({Kind::home})) << "it is under way";
}

// From tile to tile, also while a lesson asks; the next visitor begins with the first.
TEST(WallPath, ATileGoesThroughTheLanguages) {
  Rig rig = playRig();
  EXPECT_FALSE(deskSession().placeOf({Kind::language, 1})) << "there is one language";
  rig.languages = {"fr", "en"};
  Session session(rig, std::make_unique<SimulatedClock>(), {});
  const test::LogLines log;
  const auto press = [](Session& here, const Vec3& place_m) {
    here.frame(mouseAt(place_m, false));
    here.frame(mouseAt(place_m, true));
    here.frame();
  };
  const auto language = [&] { return session.record().viewers[0].language; };
  PRESSED((WallAction{Kind::language, 1}), language() == 1);
  EXPECT_FALSE(session.placeOf({Kind::language, 1})) << "it leads to the other one now";
  PRESSED(actionOf(Choice::lessons), session.playing() == "comes-and-goes" && session.record().fade == 0.0);
  EXPECT_EQ(session.settings().lesson.phase, LessonPhase::asks);
  EXPECT_EQ(language(), 1) << "it stays so in another game";
  PRESSED((WallAction{Kind::language, 0}), language() == 0);
  PRESSED((WallAction{Kind::language, 1}), language() == 1);
  EXPECT_EQ(session.settings().lesson.phase, LessonPhase::asks) << "the question still stands";
  session.welcome();
  ASSERT_TRUE(session.await([&] { return session.playing() == "welcome" && session.record().fade == 0.0; }));
  EXPECT_EQ(language(), 0);
}

}  // namespace
}  // namespace carom
