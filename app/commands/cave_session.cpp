#include "app/commands/cave_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/class_server/class_address.h"
#include "app/class_server/class_desk.h"
#include "app/class_server/study_desk.h"
#include "app/commands/cave_link.h"
#include "app/commands/cave_phones.h"
#include "app/commands/session_frames.h"
#include "app/journal/session_file.h"
#include "app/journal/session_series.h"
#include "app/live/live_source.h"
#include "app/operator/lesson.h"
#include "app/operator/room_languages.h"
#include "app/operator/visitor_choices.h"
#include "app/rig/rig_viewers.h"
#include "app/session/game_settings.h"
#include "app/session/study_listener.h"
#include "app/stage/all_ranks.h"
#include "app/stage/scenario_scene.h"
#include "app/study/slips.h"
#include "app/toml/config_folder.h"
#include "devices/setup/tracker_factory.h"
#include "engine/text/log.h"

namespace carom {
namespace {

/// Returns the session's clock: simulated for a given number of frames, unless a device tracks the head.
std::unique_ptr<Clock> clockOf(const SessionSetup& setup, const CaveOptions& options,
                               std::chrono::steady_clock::time_point start) {
  if (!setup.realTime) return std::make_unique<SimulatedClock>();
  if (options.frames) {
    log::note(fmt::format("The head is {}: the frames are shown in real time.",
                          setup.rig.byMouse ? "moved by mouse and keys" : "tracked by a device"));
  }
  return std::make_unique<SteadyClock>(start);
}

KeysOf keysOf(const CaveOptions& options) { return options.byMouse ? KeysOf::dryRun : KeysOf::session; }

/// Returns the keyboard whose layout names the keys; none without windows.
std::optional<KeyboardLayout> keyboardOf(const SessionSetup& setup, const CaveOptions& options) {
  if (!setup.realTime || options.noWindow) return {};
  return KeyboardLayout();
}

/// Gives all nodes the names that the keys have on that of rank 0, as the session begins.
void shareKeyNames(const Cluster& cluster) {
  std::string names = keyNamesInUse();
  cluster.share(names);
  useKeyNames(names);
}

/// Returns whether the keys that end the session are always locked: it runs unattended or with a study.
bool isLockedAlways(const CaveOptions& options) { return options.unattended_s || !options.study.empty(); }

/// Prints what will be shown, on rank 0.
void announce(const SessionSetup& setup, const Cluster& cluster, const CaveOptions& options) {
  const std::vector<Wall>& walls = setup.rig.walls;
  log::note(fmt::format("{} (light at {} m/s) in {}: {} wall{}, {} node{}.", setup.scenario.title,
                        setup.scenario.billiard.lightSpeed_m_s, setup.rig.title, walls.size(),
                        walls.size() == 1 ? "" : "s", cluster.size(), cluster.size() == 1 ? "" : "s"));
  for (const Wall& wall : walls) {
    if (wall.node < cluster.size()) continue;
    log::note(fmt::format("Wall {} asks for node {}; node {} draws it.", wall.name, wall.node,
                          wall.node % cluster.size()));
  }
  for (int rank = 0; rank < cluster.size(); ++rank) {
    const bool draws = std::any_of(walls.begin(), walls.end(),
                                   [&](const Wall& wall) { return wall.node % cluster.size() == rank; });
    if (!draws) log::warn(fmt::format("node {} has no wall to draw.", rank));
  }
  const bool drawsHere = std::any_of(walls.begin(), walls.end(),
                                     [&](const Wall& wall) { return wall.node % cluster.size() == 0; });
  const bool hasWindow = !options.noWindow && (drawsHere || options.extra.outside || options.extra.console);
  if (hasWindow) sayKeys(keysOf(options));
  if (hasWindow && isLockedAlways(options) && options.pin.empty())
    log::note("Escape, Q and the windows' close buttons are locked. Ctrl+C or SIGTERM ends the session.");
  if (!hasWindow && !options.frames) {
    log::note("There are no keys: node 0 has no window. Ctrl+C ends the session.");
  }
  if (setup.graphics->inSoftware()) {
    log::note(fmt::format("Drawn without a graphics card, by {}: slower than the display.",
                          setup.graphics->rendererName()));
  }
  log::note(tessellationReport(setup.scene, setup.tessellation));
}

/// Which game is written to a session file.
enum class WrittenGame { first, resumed, another };

/// Opens the session file, if there is one.
std::unique_ptr<Journal> openJournal(const CaveOptions& options, WrittenGame game, const SetupOptions& inputs,
                                     const SessionSetup& setup) {
  if (!options.session) return nullptr;
  SessionFacts facts{CAROM_VERSION,      inputs.rig.file,         inputs.scenario.file,
                     textOf(inputs.rig), textOf(inputs.scenario), setup.scenario.billiard.lightSpeed_m_s};
  for (const Puck& puck : setup.scenario.billiard.pucks) facts.pucks.push_back(puck.name);
  facts.viewers = namesOf(setup.rig.viewers);
  for (const TrackerSetup& tracker : setup.rig.trackers) facts.trackers.push_back(tracker.name);
  facts.textSize = inputs.textSize;
  facts.languages = inputs.languages;
  if (setup.headset) facts.eyePixels = {setup.headset->pixels().x, setup.headset->pixels().y};
  facts.hasClass = options.hasClass;
  facts.isLinked = !options.link.empty();
  facts.isAnotherGame = game == WrittenGame::another;
  return std::make_unique<Journal>(*options.session, facts, game != WrittenGame::first);
}

/// The state from which a session is continued.
struct Before {
  SessionFacts facts;
  ClassLeft classroom;
  std::optional<FrameRecord> last;  ///< empty if it ended before its first frame
};

Before whatWas(const std::filesystem::path& file) {
  SessionFile session(file);
  session.scenario();  // refuses one that the session does not belong to
  Before before{session.facts(), session.classLeft(), {}};
  const auto frames = session.frames();
  if (!frames) return before;
  // A session may have been cut off while the best shot was shown again, from where it was seen. The
  // observers go on from the latest events before that.
  constexpr std::uint64_t kLongestShot = 2 * ShotMemory::kMostViews;
  session.goTo(std::max(frames->first, frames->second - std::min(frames->second, kLongestShot)));
  FrameState state;
  std::optional<FrameRecord> latest;
  while (session.next(state)) {
    before.last = state.record;
    const bool isLesson = state.record.lesson.phase != LessonPhase::none;
    const auto seenAt_s = [](const FrameRecord& record) {
      return record.viewers.front().observer.middle.observation.t_s;
    };
    if (!latest || isLesson || seenAt_s(state.record) >= seenAt_s(*latest)) latest = state.record;
  }
  if (!latest) return before;
  for (std::size_t viewer = 0; viewer < latest->viewerCount; ++viewer)
    before.last->viewers[viewer].observer = latest->viewers[viewer].observer;
  before.last->boardFromRoom = latest->boardFromRoom;
  return before;
}

/// Returns the settings with which the session begins.
Beginning beginningOf(const CaveOptions& options) {
  return {options.switches, options.views, options.lesson, !options.frames, options.games, options.languages};
}

/// Returns the initial settings of the session: from the options, or from the session that is continued.
OperatorSettings firstSettings(const SessionSetup& setup, const CaveOptions& options, const std::string& file,
                               const Before& before) {
  OperatorSettings settings = settingsOf(setup.rig, setup.scenario, file, beginningOf(options));
  settings.console = consoleAtStart(setup.desk);
  if (!before.last) return settings;
  // A question without an answer is asked again.
  if (before.last->lesson.phase != LessonPhase::asks) settings.lesson = before.last->lesson;
  explainInMotion(settings);
  settings.switches = before.last->switches;
  settings.views = before.last->views;
  settings.views.frozen = 0;
  settings.lightSpeed_m_s = before.last->lightSpeed_m_s;
  if (options.language.empty()) {
    for (std::size_t viewer = 0; viewer < kMostViewers; ++viewer)
      settings.languageOf[viewer] = before.last->viewers[viewer].language;
  }
  const ObserverView& observer = before.last->viewers.front().observer;
  // Rounded to a tenth of a micrometre, which restores the value without its rounding errors.
  settings.eyeSeparation_m =
      std::round(glm::distance(observer.left.positionInRoom_m, observer.right.positionInRoom_m) * 1e7) / 1e7;
  return settings;
}

/// Returns the lesson of the game, or null.
const Lesson* lessonOf(const SessionSetup& setup) {
  return setup.scenario.lesson ? &*setup.scenario.lesson : nullptr;
}

/// Returns where phones find the pages: as the command line says, else as the rig does.
ClassServerOptions pagesOf(const CaveOptions& options, const ClassSetup& rig) {
  const std::string& address = options.classAddress.empty() ? rig.address : options.classAddress;
  return {address.empty() ? addressOfDefaultRoute() : address, options.classPort.value_or(rig.port), "", ""};
}

/// Opens the class, if one takes part, and prints how to join.
std::unique_ptr<ClassDesk> openClass(const CaveOptions& options, const SessionSetup& setup,
                                     const SetupOptions& inputs, const Before& before, CavePhones* phones) {
  if (!options.hasClass) return nullptr;
  ClassServerOptions server = pagesOf(options, setup.rig.classroom);
  server.word = anyRoomWord();
  server.pin = anyPin();
  if (phones) server.followed = phones->followed();
  auto desk = std::make_unique<ClassDesk>(server, before.classroom);
  desk->play(lessonOf(setup), inputs.scenario.file.string());
  const ClassInvitation& invitation = desk->invitation();
  fmt::print("class: {} {} teacher {}\n", invitation.address, invitation.word, invitation.pin);
  std::fflush(stdout);
  return desk;
}

/// A study and its codes, read before a session file is begun.
struct StudyInputs {
  explicit StudyInputs(const CaveOptions& options)
      : study(readStudy(options.study)), slips(readSlips(options.slips, study.participants)) {}
  Study study;
  std::map<std::string, std::size_t> slips;
};

/// Opens the study with its codes, and prints where its pages are.
std::unique_ptr<StudyDesk> openStudy(StudyInputs given, const CaveOptions& options,
                                     const SetupOptions& inputs, const ClassSetup& rig) {
  StudyDeskOptions desk{
      *options.session, std::move(given.slips), options.isAmended, inputs.scenario.file.string(), {},
      inputs.rig.file};
  desk.server = pagesOf(options, rig);
  auto opened = std::make_unique<StudyDesk>(std::move(given.study), std::move(desk));
  fmt::print("study: {}\n", opened->address());
  std::fflush(stdout);
  return opened;
}

/// Rank 0's objects for all games of the session.
struct LivePlay {
  /// `linked`: null without another room.
  LivePlay(const SessionSetup& setup, const CaveOptions& options, const SetupOptions& inputs,
           const Before& before, const LiveStart& start, std::unique_ptr<CaveLink> linked)
      : link(std::move(linked)),
        clock(clockOf(setup, options, start.sessionStart)),
        pacer(pacerFor(setup, *clock, livedOf_s(start), start.firstFrame())),
        source(setup.rig, setup.scenario, setup.world, start),
        leader(source, keysOf(options), firstSettings(setup, options, inputs.scenario.file.string(), before),
               devicesOf(setup.realTime ? setup.walls.get() : nullptr, keysOf(options),
                         keyboardOf(setup, options)),
               options.unattended_s, options.scenario.string()),
        sounds(soundsFor(setup, options.silent || options.noWindow)),
        phones(options.takes || options.follows ? std::make_unique<CavePhones>(options) : nullptr),
        classroom(openClass(options, setup, inputs, before, phones.get())) {
    journal.endWith([this] { return source.endForces(); });
    if (classroom) leader.teach(*classroom);
    std::optional<StudyInputs> given;
    if (!options.study.empty()) given.emplace(options);
    const WrittenGame game = options.resume ? WrittenGame::resumed : WrittenGame::first;
    const bool isHall = link && link->joins();
    const bool isNew = !isHall && (options.study.empty() || !std::filesystem::exists(*options.session));
    if (isNew) journal.keep(openJournal(options, game, inputs, setup));
    if (phones) phones->play(setup, options.session.value_or(""));
    if (!given) return;
    journal.keep(nullptr);  // of a study the lessons alone are written
    study = openStudy(*std::move(given), options, inputs, setup.rig.classroom);
    studyListener.emplace(*study, leader);
    leader.allowOnly([this](const std::string& file) { return study->allows(file); });
    OperatorSettings settings = leader.settings();
    study->applyTo(settings);
    leader.begin(settings);
  }

  LivePlay(const LivePlay&) = delete;
  LivePlay& operator=(const LivePlay&) = delete;
  ~LivePlay() {
    endForces();
    if (phones) phones->finish();
  }

  /// Whatever ends the session, a hand is left without force, and the session file says so.
  void endForces() noexcept {
    try {
      journal.add(source.endForces());
    } catch (const std::exception& error) {
      log::error(error.what());
    }
  }

  static double livedOf_s(const LiveStart& start) { return start.before ? start.before->display_s : 0.0; }

  std::unique_ptr<CaveLink> link;  // null without --link
  std::unique_ptr<Clock> clock;
  std::unique_ptr<FramePacer> pacer;
  LiveSource source;
  FrameLeader leader;
  std::unique_ptr<Sounds> sounds;
  std::unique_ptr<CavePhones> phones;    // null without --take and --follow
  std::unique_ptr<ClassDesk> classroom;  // null without --class
  JournalListener journal;
  std::unique_ptr<StudyDesk> study;  // null without --study
  std::optional<StudyListener> studyListener;
  std::unique_ptr<StatusFile> status;  // null without --status
};

/// Creates the play, at the start of the game or after the last frame of the session that is continued.
std::unique_ptr<LivePlay> playOf(SessionSetup& setup, const CaveOptions& options, const SetupOptions& inputs,
                                 const Before& before) {
  using SystemClock = std::chrono::steady_clock;
  LiveStart start{{}, before.last, options.frames};
  start.sessionStart = SystemClock::now() - std::chrono::duration_cast<SystemClock::duration>(
                                                std::chrono::duration<double>(LivePlay::livedOf_s(start)));
  if (options.resume) {
    constexpr bool kQuiet = true;  // whatWas has logged the warnings
    start.struck = SessionFile(*options.session, {}, kQuiet).strokes(setup.scenario.billiard.pucks);
  }
  std::unique_ptr<CaveLink> link = openLink(setup, options, inputs);
  if (link) start.link = &link->room();
  return std::make_unique<LivePlay>(setup, options, inputs, before, std::move(start), std::move(link));
}

/// Shows in the console why a scenario cannot be played.
void tellConsole(Console& console, const std::string& file) try {
  console.say(fmt::format("{} cannot be played", file));
  openMeshes(readScenario(file));
} catch (const InputErrors& errors) {
  for (const InputError& error : errors.faults()) console.say(error.what());
} catch (const std::exception& error) {
  console.say(error.what());
}

/// Prints the command that replays the end of a session that was ended by an error.
void sayHowItIsSeenAgain(const Cluster& cluster, const std::optional<std::filesystem::path>& session) {
  if (!session || std::isnan(cluster.newest_s())) return;
  // Rounded up, so as not to start a frame early.
  const double at_s = std::ceil(cluster.newest_s() * 1e3) / 1e3;
  log::note(fmt::format("carom replay {} --at {:.3f}", session->string(), at_s));
}

/// Writes the next game to the session file, if there is one and if it is not a game that attracts people. If
/// it cannot be written, logs this, and the game is played without. Returns whether it is written.
bool writeNext(JournalListener& journal, CaveOptions& options, const NextGame& next,
               const SetupOptions& inputs, const SessionSetup& setup) try {
  journal.keep(nullptr);  // before the file is opened again
  if (!next.recordTo.empty() && options.study.empty()) options.session = next.recordTo;
  if (!options.session || next.attracts) return false;
  const WrittenGame game =
      std::filesystem::exists(*options.session) ? WrittenGame::another : WrittenGame::first;
  journal.keep(openJournal(options, game, inputs, setup));
  return true;
} catch (const std::runtime_error& error) {
  log::error(fmt::format("{}. This game is not written.", error.what()));
  return false;
}

constexpr const char* kSameGame = "-";  // in the place of a file: no other one follows

/// Continues on every node with the game that rank 0 has chosen, which may be the same from its beginning.
/// Returns false if none was chosen, which ends the session. `play` is null on ranks other than 0.
bool goOnWithAnother(Cluster& cluster, CaveOptions& options, SetupOptions& inputs, SessionSetup& setup,
                     OperatorWindows& windows, LivePlay* play) {
  const NextGame next = play ? play->leader.takeNextGame() : NextGame{};
  std::string file = next.file;
  CaveLink* const link = play ? play->link.get() : nullptr;
  const bool isInvited = link && link->room().invitation() && file == CaveLink::invitedFile();
  if (link && link->joins() && !isInvited && !file.empty() && !link->mayChoose(play->source))
    file = kSameGame;
  cluster.share(file);
  if (file.empty()) return false;
  if (file == kSameGame) return true;
  InputFile game{file, {}};
  if (isInvited) game.kept = link->room().invitation()->scenario;
  if (!playNext(cluster, setup, game)) {
    if (isInvited) link->refuse("its game cannot be played here");
    if (windows.console) tellConsole(*windows.console, file);
    if (play) play->source.announce(texts::message::kGameMistake);
    return true;
  }
  inputs.scenario = game;
  onAllRanks(cluster, [&] {
    if (!play) return;
    if (link) link->begin(isInvited, game, setup.scenario);
    windows.play(setup);
    play->source.playAnew();
    if (play->classroom) play->classroom->play(lessonOf(setup), file);
    std::optional<std::filesystem::path> session;
    play->journal.keep(nullptr);  // before the study writes, and before the page of the game is made
    if (play->phones) play->phones->end(*play->classroom);
    const bool isWanted = !play->study || play->study->play(file);
    play->source.holdHeads(play->study && play->study->isStill());
    if (isWanted && writeNext(play->journal, options, next, inputs, setup)) session = options.session;
    if (play->study && session) play->study->begun();
    if (play->phones) play->phones->play(setup, session.value_or(""));
    if (windows.console) windows.console->writeTo(session);
    setup.recording->writeBeside(session);
    if (play->status)
      play->status->play(setup.rig, setup.scenario.title, session.value_or(""), setup.languages);
    OperatorSettings settings =
        settingsOfNext(play->leader.settings(), next, setup.rig, setup.scenario, beginningOf(options));
    if (play->study) play->study->applyTo(settings);
    play->leader.begin(settings);
    log::note(
        fmt::format("{}{}", setup.scenario.title, session ? " is written to " + session->string() : ""));
  });
  setup.graphics->discardInput();  // that arrived during the setup
  return true;
}

/// Runs one game's frames. Returns whether someone asked to quit.
bool playGame(Cluster& cluster, SessionSetup& setup, OperatorWindows& windows, LivePlay* play, KeysOf keys,
              KeyLock& lock) {
  FramePacer follows;
  if (!play) {
    SessionFrames frames(cluster, setup, follows, nullptr, keys);
    frames.context().keyLock = &lock;
    return runFrames(frames.context());
  }
  const LeaderParts lead{play->source,
                         play->leader,
                         windows,
                         play->sounds.get(),
                         &play->journal,
                         play->status.get(),
                         play->classroom.get(),
                         play->study ? &*play->studyListener : nullptr,
                         play->phones.get()};
  SessionFrames frames(cluster, setup, *play->pacer, &lead, keys);
  frames.context().keyLock = &lock;
  const bool isAskedToEnd = runFrames(frames.context());
  if (isAskedToEnd) play->endForces();
  if (setup.realTime) frames.statistics().sayHowItWent();
  return isAskedToEnd;
}

/// Reads the playlist, of the options or of the rig, and begins with its first game if no other was asked
/// for. A session that goes on begins with its own game.
void takePlaylist(CaveOptions& options, SetupOptions& inputs, const Rig& rig) {
  if (options.playlist.empty()) options.playlist = rig.playlist;
  if (options.playlist.empty()) return;
  const auto playlist = std::make_shared<const Playlist>(readPlaylist(options.playlist));
  for (const PlaylistGame& game : playlist->games) openMeshes(readScenario(game.scenario));
  options.games = playlist;
  if (options.isUsualGame) options.scenario = playlist->games.front().scenario;
  if (options.isUsualGame && !options.resume) inputs.scenario.file = options.scenario;
  if (numberOf(*playlist, options.scenario) < playlist->games.size()) return;
  throw std::runtime_error(fmt::format("--scenario: {} is not in the playlist {}, expected one of its games",
                                       options.scenario.string(), options.playlist.string()));
}

/// Lets another game follow in the session file: clocks and frames go on, while its last game is over.
void endItsGame(CaveOptions& options, Before& before) {
  options.resume = false;
  if (!before.last) return;
  before.last->lesson = {};
  before.last->switches = options.switches;
  before.last->views = options.views;
  before.last->lightSpeed_m_s = readScenario(options.scenario).billiard.lightSpeed_m_s;
}

/// Returns where a session with a study was. The next participant's lessons are further games of the file.
Before beforeNextParticipant(CaveOptions& options, SetupOptions& inputs) {
  Before before = whatWas(*options.session);
  inputs.rig = {before.facts.rig, before.facts.rigText};
  endItsGame(options, before);
  return before;
}

/// Settles which session file is written and, if it goes on, with which rig and scenario. Returns where it
/// was.
Before settleSession(CaveOptions& options, SetupOptions& inputs) {
  if (!options.session) return {};
  if (!options.study.empty() && options.resume) return beforeNextParticipant(options, inputs);
  const std::filesystem::path name = namedToday(*options.session);
  if (options.resumeOrNew) {
    options.session = newestOf(name);
    options.resume = std::filesystem::exists(*options.session);
  }
  if (options.resume) try {
      Before before = whatWas(*options.session);
      if (!options.link.empty() && !before.facts.isLinked)
        throw std::runtime_error(fmt::format(
            "session file {}: it has no linked game to go on with, expected one of carom cave --link",
            options.session->string()));
      inputs.rig = {before.facts.rig, before.facts.rigText};
      inputs.scenario = {before.facts.scenario, before.facts.scenarioText};
      inputs.textSize = before.facts.textSize;
      return before;
    } catch (const std::exception& error) {
      if (!options.resumeOrNew) throw;
      log::warn(fmt::format("{}. The session begins anew in another file.", error.what()));
      options.resume = false;
      options.session = fileAfter(name);
    }
  if (!options.resumeOrNew) options.session = datedFile(*options.session);
  if (std::filesystem::exists(*options.session)) {
    throw std::runtime_error(
        fmt::format("session file {}: it is there already, expected a new name, or --resume to go on with it",
                    options.session->string()));
  }
  return {};
}

/// Settles which languages there are, and which each viewer reads at first. Those of a session that goes on
/// keep their numbers.
void settleLanguages(CaveOptions& options, SetupOptions& inputs, const Rig& rig, const Before& before) {
  inputs.languages = languagesOf(rig, options.games.get(), options.language);
  const bool goesOn = !before.facts.program.empty();
  if (goesOn) inputs.languages = goingOnWith(before.facts.languages, inputs.languages);
  options.languages = std::make_shared<const SessionLanguages>(inputs.languages);
}

/// Settles on rank 0 where the session is written, whether it goes on, with which games and languages.
Before prepare(CaveOptions& options, SetupOptions& inputs) {
  Before before = settleSession(options, inputs);
  settleLink(options, inputs, before.facts.isLinked);
  const bool isCaller = !options.link.empty() && !linkAddressOf(options.link).listens;
  const Rig rig = readRig(inputs.rig);
  if (!isCaller) takePlaylist(options, inputs, rig);
  settleLanguages(options, inputs, rig, before);
  if (isCaller && options.resume) endItsGame(options, before);  // the host's follows
  if (options.lesson && options.study.empty() && !options.scenario.empty() &&
      !readScenario(options.scenario).lesson) {
    throw std::runtime_error(fmt::format(
        "--lesson: {} has no [lesson], expected a scenario with one: carom list", options.scenario.string()));
  }
  return before;
}

void runSession(Cluster& cluster, CaveOptions options, std::optional<std::filesystem::path>& opened) {
  SetupOptions inputs{{options.rig, {}}, {options.scenario, {}},     true,         options.recording,
                      options.noWindow,  options.frames.has_value(), options.extra};
  inputs.byMouse = options.byMouse;
  inputs.hideRight = options.hideRight;
  inputs.mayLeave = options.study.empty();
  inputs.textSize = options.textSize;
  inputs.withoutNodes = options.withoutNodes;
  Before before;
  std::unique_ptr<StatusFile> status;
  onAllRanks(cluster, [&] {
    if (cluster.rank() > 0) return;
    if (options.status) status = std::make_unique<StatusFile>(*options.status, cluster);
    before = prepare(options, inputs);
    inputs.people = !options.link.empty();
  });
  opened = options.session;
  SessionSetup setup = setUpSession(cluster, inputs);
  OperatorWindows windows = openWindows(cluster, setup, keysOf(options));
  if (windows.console) windows.console->writeTo(options.session);
  setup.recording->writeBeside(options.session);
  std::unique_ptr<LivePlay> play;
  onAllRanks(cluster, [&] {
    if (cluster.rank() > 0) return;
    play = playOf(setup, options, inputs, before);
    play->status = std::move(status);
    if (play->status)
      play->status->play(setup.rig, setup.scenario.title, options.session.value_or(""), setup.languages);
  });
  shareKeyNames(cluster);
  if (play) announce(setup, cluster, options);
  KeyLock lock(options.pin, isLockedAlways(options));
  while (!playGame(cluster, setup, windows, play.get(), keysOf(options), lock) &&
         goOnWithAnother(cluster, options, inputs, setup, windows, play.get())) {
  }
  const bool leads = play != nullptr;
  if (leads) rememberWindows(setup, windows);
  play.reset();  // completes the session file
  if (leads && options.session) log::note(fmt::format("The session is in {}.", options.session->string()));
  setup.recording->finish();
  if (leads && options.recording.capture)
    log::note(fmt::format("The pictures are in {}.", options.recording.capture->string()));
  cluster.leave();
}

}  // namespace

int runCave(const CaveOptions& options) {
  std::optional<std::filesystem::path> session;  // as it was opened
  return runOnCluster([&](Cluster& cluster) { runSession(cluster, options, session); },
                      [&](const Cluster& cluster) { sayHowItIsSeenAgain(cluster, session); });
}

namespace {

/// The room of a study is that of its first arm, unless that of another arm is asked for.
void chooseRigOfStudy(CaveOptions& options) {
  if (options.study.empty()) return;
  const Study study = readStudy(options.study);
  if (options.rig.empty()) options.rig = study.arms.front().rig;
  const auto isThis = [&](const StudyArm& arm) { return isSameFile(arm.rig, options.rig); };
  if (std::any_of(study.arms.begin(), study.arms.end(), isThis)) return;
  throw std::runtime_error(fmt::format("the rig {} is that of no arm of the study, expected {}",
                                       options.rig.string(), fmt::join(rigsOf(study), " or ")));
}

}  // namespace

void addCave(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("cave", "The immersive session: walk beside the board");
  const auto options = addCaveOptions(*command);
  command->footer(
      "Examples:\n  carom cave\n  carom cave --scenario twins --console\n  carom cave --frames 90 --capture "
      "pictures --no-window\n"
      "  carom cave --switch colour=on --switch searchlight=on\n"
      "  mpirun -n 4 carom cave --rig four-walls-cluster");
  command->callback([options, &status] {
    chooseRigOfStudy(*options);
    chooseRest(*options);
    status = runCave(*options);
  });
}

}  // namespace carom
