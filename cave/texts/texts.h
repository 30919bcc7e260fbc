#pragma once
// The catalogue of texts: every text of the program that a visitor, student, teacher or operator reads on
// walls, in the console and in the other windows. A translation is another file with the same names; the
// compiler finds names that are missing, and values that a text has no place for ("{}", in the notation of
// the library fmt).
//
// Not here: the texts of games and lessons, which stand in their files (config/scenarios), one file a game;
// the messages of the command line, of the log and of trackers, which name facts of the code that writes them
// and stand beside it; names that files contain (keys of a scenario, words of a session file), which no
// translation may change. tests/app/texts.py finds texts that are elsewhere.

#include <array>

namespace carom::texts {

using Text = const char*;

/// The language of this catalogue, as HTML names it.
inline constexpr Text kLanguage = "en";

// The choices on the front wall, in the order of Choice, and their keys.
inline constexpr std::array<Text, 3> kChoices{"Play", "Lessons", "Show me"};
inline constexpr std::array<Text, 3> kChoiceKeys{"F7", "F6", "F5"};

// Tiles below them; their keys stand behind the names.
namespace tile {
inline constexpr Text kBestShot = "Best shot", kHome = "Back to the table", kTimeGoesOn = "Let time go on";
inline constexpr Text kKeys = "Keys", kTasks = "Tasks", kNextTask = "Next task", kTryAgain = "Try again";
}  // namespace tile

// Tasks for who plays.
namespace task {
inline constexpr Text kText = "{} of {}: {}", kBest = " (best: {:.2f} J)";
inline constexpr Text kSolved = "Done, with {1:.2f} J: {0} of 3 stars. The next task follows.";
inline constexpr Text kNotYet = "Not yet. Strike again, or try again from the beginning: Y.";
}  // namespace task

// The devices that hold the cue, in the order of InputDevices.
inline constexpr std::array<Text, 3> kDevices{"wand", "mouse", "gamepad"};
inline constexpr Text kWand = kDevices[0], kGamepad = kDevices[2];

namespace lesson {
inline constexpr Text kQuestion = "Question:  ";
inline constexpr std::array<Text, 4> kAnswerNumbers{"1   ", "2   ", "3   ", "4   "};
inline constexpr Text kChoose = "Choose an answer.";
inline constexpr Text kReading = "{}: {:.2f} s";
inline constexpr Text kYouMove = "You move:";
inline constexpr Text kObserver = "{}  F{}";
inline constexpr Text kYourAnswer = "Your answer:  ";
inline constexpr Text kRight = "{}. Correct.";
inline constexpr Text kWrong = "{}. Correct: {}.";
inline constexpr Text kTryThis = "Try this:  ", kLookFor = "Look for:  ";
inline constexpr Text kSlowMotion = "Slow motion: 1/{:g}";
// Buttons, each with its key.
inline constexpr Text kSkip = "Skip  Enter", kAgain = "Again  Y", kExplanation = "Explanation  Enter";
inline constexpr Text kBackToScene = "Scene  Enter", kAskAgain = "Ask again  Y";
inline constexpr Text kTimeGoesOn = "Let time go on  F", kLeave = "Leave  F7";
inline constexpr Text kSpacetime = "Spacetime  I";
inline constexpr Text kSkipped = "(skipped)";
}  // namespace lesson

// The legend of the views of time and of the drive, on the front wall.
namespace legend {
inline constexpr Text kSeen = "as seen: light that reaches me now";
inline constexpr Text kBoardNow = "now, in the table's frame";
inline constexpr Text kMyNow = "now, in my frame: simultaneous with me";
inline constexpr Text kEinsteinNewton = "left: Einstein, right: Newton";
inline constexpr Text kChosenOtherwise = "left: as chosen, right: otherwise";
inline constexpr Text kPaths = "paths: solid = seen, dashed = still to come";
inline constexpr Text kEvents = "numbered flags: events";
inline constexpr Text kFlash = "light of a flash, on its way";
inline constexpr Text kRuler = "ruler: 1 m, and light travelling along it";
inline constexpr Text kAngles = "angles between the outgoing paths";
inline constexpr Text kStrain = "colours: soft matter pressed (blue) or stretched (red)";
inline constexpr Text kHeat = "colours: the heat of soft matter, dark to yellow";
inline constexpr Text kSpeeds = "plates: the speed that you see";
inline constexpr Text kNews = "rings: news of a hit, at light speed";
inline constexpr Text kSpacetime =
    "glass: the game with time upwards; white line: what you see, blue: now on the board, pink: your now";
inline constexpr Text kFrozen = "frozen view: walk around it";
inline constexpr Text kClocks = "labels: each puck's proper time";
inline constexpr Text kScore = "caroms  {}   strokes  {}";
inline constexpr Text kYourTurn = "your turn", kTheirTurn = "{}'s turn";
inline constexpr Text kScoreOf = "{}:  caroms  {}   strokes  {}", kMe = "you";
inline constexpr Text kOlder = "{}: {:.1f} s, older than you by {:.1f} s";
inline constexpr Text kYounger = "{}: {:.1f} s, younger than you by {:.1f} s";
inline constexpr Text kAsOld = "{}: {:.1f} s, as old as you";
inline constexpr Text kMyTime = "my proper time  {:.1f} s";
inline constexpr Text kMySpeed = "my speed  {:.2f} c   γ = {:.2f}";
inline constexpr Text kLight = "light  {:.2f} m/s";
inline constexpr Text kPlatform = "my speed on the table: {:.3f} c, γ = {:.2f}";
inline constexpr Text kLightRing = "the speed of light";
inline constexpr Text kContracted = "a circle on the table, contracted to {:.2f}";
inline constexpr Text kThrust = "thrust: {:.0f} % of maximum{}";
inline constexpr std::array<Text, 4> kDriveModes{"", " (braking)", " (returning home)", " (round trip)"};
inline constexpr Text kEffectsOff = "off: {}", kEffectsOn = "on: {}";
inline constexpr Text kNearerBar = "of the two bars the right one is nearer";
}  // namespace legend

// Messages on the front wall, a few seconds each.
namespace message {
inline constexpr Text kNoFlight = "This game has no round trip.";
inline constexpr Text kFlightUnderWay = "The round trip is under way already.";
inline constexpr Text kFlightBeginsAtRest =
    "The round trip begins at rest: brake (Space) or return to the table (Home) first.";
inline constexpr Text kFlightFinished = "Flight finished: {:.1f} s on the table's clocks, {:.1f} s on yours.";
inline constexpr Text kFlightInterrupted = "Flight interrupted: you drive yourself.";
inline constexpr Text kFarFromTable = "You have left the table far behind. Home brings you back.";
inline constexpr Text kStrongestThrust =
    "The strongest thrust. With more, light from {:.2g} m behind you would never catch up with you.";
inline constexpr Text kFastest = "No faster here: at {:.3g} c, {:.3g} s pass on the table in one of yours.";
inline constexpr Text kHallWall =
    "The drive stops in front of the hall's walls. Home brings you back to the table.";
inline constexpr Text kLinkCalls = "The other room is being called.";
inline constexpr Text kLinkWaitsFor = "Waiting for the game of {}.";
inline constexpr Text kLinkPaired = "{} plays at this table now.";
inline constexpr Text kLinkGone = "{} has left: the game goes on here.";
inline constexpr Text kLinkBack = "{} is back.";
inline constexpr Text kLinkMismatch = "The game of {}: each room plays on alone.";
inline constexpr Text kLinkResynchronised = "The game was built anew: {}.";
inline constexpr Text kLinkStill = "The light of {} is not here yet: time stands still.";
inline constexpr Text kLinkYourTurn = "It is your turn.", kLinkTheirTurn = "It is {}'s turn.";
inline constexpr Text kLinkPerson = " {}, {:.1f} s old as you see them: caroms {}, strokes {}.";
inline constexpr Text kLinkMark = " {} is {:.1f} s of light away.";
inline constexpr Text kLinkNoShot = "In a linked game nothing is shown again: time goes on for both rooms.";
inline constexpr Text kLinkHostChooses = "The next game is for {} to choose.";
inline constexpr Text kLeftRoom = "You have left the room: you are behind its wall '{}'. Step back in.";
inline constexpr Text kStillThere = "Still there? {}    Move or press to stay.";
inline constexpr Text kSculptureFastest = "The glass is shown up to {:.2f} c, and no faster.";
inline constexpr Text kSculptureSpeed = "The glass is shown as somebody at {:.2f} c has it.";
inline constexpr Text kPicked =
    "Event {}: what lies outside its double cone has no order of its own. Press on another event to compare.";
inline constexpr Text kPickedTwo = "Events {} and {}: {:.2f} m apart, {:.2f} m of light between them. {}";
inline constexpr Text kOneOrder = "Light can connect them: {} is first for everyone.";
inline constexpr Text kNoOrder = "No light connects them. First is {} for the table, {} for you";
inline constexpr Text kOrderOf = ", {} for {}", kNeitherFirst = "neither";
inline constexpr Text kNotSculpted = "Spacetime shows the {} pucks nearest to the middle; {} are left out.";
inline constexpr Text kStarting = "Starting …";
inline constexpr Text kNoConsole = "There is no console. carom cave --console opens one.";
inline constexpr Text kReadOnly = "A recording cannot be changed: strokes and drive need a live game";
inline constexpr Text kTurnedOn = "{}: on", kTurnedOff = "{}: off";
inline constexpr Text kCarom =
    "Carom! Your puck touched two others (cushions: {}). Enter: your best shot again";
inline constexpr Text kCaromOf = "Carom by {}! (cushions: {})";
inline constexpr Text kSawHitFirst = "{} saw the hit first", kYouSawHitFirst = "You saw the hit first";
inline constexpr Text kSawHitLater = "; {} {:.2f} s later: its light had {:.2f} m further to go";
inline constexpr Text kBestShot = "Your best shot, as you saw it (cushions: {})";
inline constexpr Text kBestShotOf = "The best shot of {}, seen with the same eyes (cushions: {})";
inline constexpr Text kBackToGame = ". Enter: back to the game", kLastShot = "The game is over. {}";
inline constexpr Text kNoCarom = "No carom so far: strike a puck so that it touches two others.";
inline constexpr Text kFrozen = "The view is frozen: F lets time go on.";
inline constexpr Text kAsks = "Time stands still until you choose an answer. Point at it and press.";
inline constexpr Text kAnswerFirst = "Answer the question first, or skip it.";
inline constexpr Text kHowUnwell =
    "How unwell do you feel? Answer on the tablet, or tell the person who leads. You may stop at any time.";
inline constexpr Text kNoVelocities = "F2 to F4 choose a velocity in lessons that offer some.";
inline constexpr Text kNoSuchKey = "This key does nothing here. H lists the keys.";
inline constexpr Text kOneLanguage = "This session has one language only.";
inline constexpr Text kNoLesson = "There is no lesson in today's programme.";
inline constexpr Text kNoTasks = "There are no tasks in today's programme.";
inline constexpr Text kNoShow = "This show is not in today's programme.";
inline constexpr Text kWayHome = "table, {} m away";
inline constexpr Text kTimeStands = "Nothing can be struck while time stands still or in a lesson";
inline constexpr Text kPuckBehind = "The puck is behind your hand: point the other way";
inline constexpr Text kNoPuck = "Point at a puck, then drag back";
inline constexpr Text kDeviceLost = "The {} is lost: no stroke";
inline constexpr Text kStoppedStroke = "Time stands still: no stroke";
inline constexpr Text kLetGo = "Let go: no stroke";
inline constexpr Text kBeforeGame = "No stroke: where your hand is, the game has not begun yet";
inline constexpr Text kStroke =
    "Your stroke runs to {} at the speed of light: {:.1f} s there, {:.1f} s back{}";
inline constexpr Text kRightOfCentre = ", {:.0f} mm right of its centre";
inline constexpr Text kLeftOfCentre = ", {:.0f} mm left of its centre";
inline constexpr Text kForceOff = "No force in the hand: {}. Let go and press again";
inline constexpr Text kForceLowered = "The force in the hand is softer than the rig asks: see the warning";
inline constexpr Text kFeltMass =
    "Your hand felt {:.2f} kg. At {:g} c it is γ³m = {:.2f} kg along the motion, γm = {:.2f} kg across";
inline constexpr Text kHiddenMass =
    "At {:g} c this device is too soft for so heavy a puck: no number. γ³m = {:.2f} kg along, γm = {:.2f} kg "
    "across";
inline constexpr Text kOutOfReach = "No stroke: {} can no longer be reached from here";
inline constexpr std::array<Text, 3> kCueTaken{
    "The cue is in the wand's hand", "The cue is in the mouse's hand", "The cue is in the gamepad's hand"};
}  // namespace message

// The question before a session ends.
namespace ending {
inline constexpr Text kAgain = "Press Escape again to end.";
inline constexpr Text kEnd = "End   Escape", kGoOn = "Go on";
}  // namespace ending

// Plates that stand in the scene, of at most twelve letters; what a font of plates has: ASCII and °βγτΔ²×±≈−.
namespace plate {
inline constexpr Text kLength = "{:.1f} m", kAngle = "{:.1f}°";
// Of a body, in the order of GaugeQuantity.
// Of a picked event of spacetime: whose order, and which one it is; at most twelve letters each.
inline constexpr Text kInterval = "interval", kTable = "table", kYou = "you", kOther = "other";
inline constexpr Text kViewer = "viewer {}", kPlaceOf = "{} of {}", kThen = "{} then {}";
inline constexpr Text kTogether = "{} with {}";
inline constexpr Text kIntervalOfTime = "{:.2f} s", kIntervalOfSpace = "{:.2f} m";
inline constexpr std::array<Text, 4> kGauges{"speed {:.2f} c", "looks {:.2f} c", "γ {:.2f}", "length {:.2f}"};
}  // namespace plate

// The scale beside a drawn cue: marks of speed, and the stroke's speed and energy. The wall draws digits,
// '.', ' ', '=', 'c', 'm', 'N' and '^', which is a raised 2.
namespace cue {
inline constexpr std::array<Text, 4> kMarks{"0.5 c", "0.8 c", "0.9 c", "0.95 c"};
inline constexpr Text kSpeed = "{:.2f} c", kEnergy = "{:.2f} mc^";
// With a force device: what the hand feels, and how the scale of the room makes it.
inline constexpr Text kForce = "{:.1f} N", kForceScale = "1 N = {:.2g} N";
}  // namespace cue

// The latency overlay. Parts in the order of FramePart, states in that of LockState.
namespace latency {
inline constexpr std::array<Text, 8> kParts{"sample", "decide", "share", "submit",
                                            "draw",   "wait",   "swap",  "late"};
inline constexpr std::array<Text, 5> kPartColumns{"ms", "  median", "    99 %", "  jitter",
                                                  "the line: one period"};
inline constexpr std::array<Text, 5> kNodeColumns{"late, ms", "  median", "    99 %", "  jitter",
                                                  "frame lock"};
inline constexpr std::array<Text, 3> kWallColumns{"wall", "  triangles", "graphics card, ms"};
inline constexpr std::array<Text, 4> kLockStates{"software", "swap group pending", "swap group joined",
                                                 "swap group LOST"};
inline constexpr Text kNode = "{}   frame {}   {:.5g} Hz";
inline constexpr Text kFrameLock = "frame lock:";
}  // namespace latency

// Test patterns on the walls.
namespace pattern {
inline constexpr Text kWall = "node {}, {} × {} pixels";
inline constexpr Text kFineLines = "{:.3f} × {:.3f} m, lines every 1 and 10 cm";
inline constexpr Text kCoarseLines = "{:.3f} × {:.3f} m, lines every 10 cm";
inline constexpr Text kCorner = "({:.3f}, {:.3f}, {:.3f}) m";
}  // namespace pattern

// Titles of windows.
namespace title {
inline constexpr Text kWalls = "Carom: {}";
inline constexpr Text kConsole = "Carom: console";
inline constexpr Text kOutside = "Carom: the room from outside";
inline constexpr Text kDiagram = "Carom: spacetime diagram";
}  // namespace title

// What each key does, and the names of keys that are words.
namespace keys {
inline constexpr Text kRetardation = "light delay (retardation)";
inline constexpr Text kContraction = "contraction";
inline constexpr Text kAberration = "aberration of directions";
inline constexpr Text kColour = "Doppler colour";
inline constexpr Text kSearchlight = "beaming (searchlight)";
inline constexpr Text kBoardNow = "ghosts: now, in the table's frame";
inline constexpr Text kMyNow = "ghosts: now, in my frame";
inline constexpr Text kPaths = "paths", kEvents = "events", kClocks = "clocks";
inline constexpr Text kRuler = "ruler", kAngles = "angles";
inline constexpr Text kStrain = "strain of soft pucks", kHeat = "heat of soft pucks";
inline constexpr Text kNews = "rings of news at each hit";
inline constexpr Text kSpacetime = "spacetime as a thing in the room";
inline constexpr Text kSpeeds = "how fast each puck looks";
inline constexpr Text kSplit = "Newton beside Einstein";
inline constexpr Text kRightRetardation = "right half: light delay";
inline constexpr Text kRightContraction = "right half: contraction";
inline constexpr Text kRightAberration = "right half: aberration";
inline constexpr Text kRightColour = "right half: Doppler colour";
inline constexpr Text kRightSearchlight = "right half: beaming";
inline constexpr Text kFreeze = "freeze the view and walk around it";
inline constexpr Text kLight = "slower and faster light";
inline constexpr Text kPause = "pause";
inline constexpr Text kSecond = "one second back, one second on";
inline constexpr Text kRate = "twice as fast, half as fast";
inline constexpr Text kBackwards = "backwards and forwards";
inline constexpr Text kBeginning = "from the beginning";
inline constexpr Text kOnwards = "continue the lesson; best shot again";
inline constexpr Text kVelocities = "the velocities that a lesson offers";
inline constexpr Text kRestart = "restart this game";
inline constexpr Text kShowMe = "Show me: relativity in a minute";
inline constexpr Text kLessons = "Lessons: the next one";
inline constexpr Text kPlay = "Play: back to the table";
inline constexpr Text kNextVisitor = "the next visitor: everything as at the beginning";
inline constexpr Text kNextLanguage = "the next language";
inline constexpr Text kFlight = "start the round trip";
inline constexpr Text kPatterns = "patterns";
inline constexpr Text kBlack = "black walls";
inline constexpr Text kSwapEyes = "swapped eyes";
inline constexpr Text kEyesApart = "eye separation";
inline constexpr Text kSensors = "show the tracked sensors";
inline constexpr Text kLatency = "latency overlay";
inline constexpr Text kComfort = "comfort: dark edges, resting frame";
inline constexpr Text kWalk = "walk in the room", kHeadHeight = "head higher, lower";
inline constexpr Text kLook = "turn head and wand";
inline constexpr Text kSteer = "steer: forward, left, back, right";
inline constexpr Text kBrake = "brake";
inline constexpr Text kHome = "return to the table";
inline constexpr Text kStrike = "point at a puck, press, draw back, let go: a stroke";
inline constexpr Text kTurn = "turn the view";
inline constexpr Text kAnswer = "answer a lesson's question";
inline constexpr Text kList = "this list";
inline constexpr Text kConsole = "the operator's console";
inline constexpr Text kQuit = "end, pressed twice";

inline constexpr Text kSpaceKey = "Space", kHomeKey = "Home", kEnterKey = "Enter";
inline constexpr Text kVelocityKeys = "F2 to F4", kAnswerKeys = "1 to 4", kQuitKeys = "Escape Q";
inline constexpr Text kPageKeys = "Page Up, Page Down", kLookKeys = "Delete, End";
inline constexpr Text kMouse = "Mouse", kRightButton = "Right button";
}  // namespace keys

// The spacetime diagram.
namespace diagram {
inline constexpr Text kTitle = "{} (light, {} m/s, goes at 45°)";
inline constexpr Text kAcross = "{} (m)", kUpwards = "ct (m)";
inline constexpr Text kCushions = "cushions";
inline constexpr Text kLightCone = "my light cone";
inline constexpr Text kTimeAxis = "my time axis ({:.2f} c)";
inline constexpr Text kSimultaneity = "my line of simultaneity";
inline constexpr Text kSimultaneityOf = "{}: line of simultaneity";
inline constexpr Text kEvents = "events", kFlash = "flash: {}";
inline constexpr Text kMe = "me";
}  // namespace diagram

// The operator's console, part by part.
namespace console {
inline constexpr Text kTrackers = "trackers";
inline constexpr Text kTrackersTip =
    "Green: all deliver. Yellow: one is late or looked for. Red: one needs help.";
inline constexpr Text kKeysButton = "Keys   H";
inline constexpr Text kNextVisitor = "Next visitor   F8";
inline constexpr Text kNextVisitorTip = "The first game from its beginning, everything as the session began.";
inline constexpr Text kLightWalls = "Light the walls   B", kBlackWalls = "Black walls   B";
inline constexpr Text kBlackTip = "All walls black at once, and lit again. The game goes on.";
inline constexpr Text kGamesTab = "Games", kTrackersTab = "Trackers", kLatencyTab = "Latency";
inline constexpr Text kEventsTab = "Events", kDiagramTab = "Diagram", kRecordingTab = "Recording";
inline constexpr Text kClassTab = "Class";
inline constexpr Text kClassPage = "{}teacher", kClassCounted = "{}:  {}";
inline constexpr Text kClassJoin = "Phones", kClassTeacher = "Teacher's page", kClassPin = "PIN {}";
inline constexpr Text kClassTeacherTip =
    "Whoever enters the PIN there leads the class, in the place of the one before.";
inline constexpr Text kClassCount = "{} phones, {} answered";
inline constexpr Text kStudyTab = "Study", kStudyCode = "Code of the slip", kStudyLetIn = "Let in";
inline constexpr Text kStudyCodeTip = "Or the participant types it on the tablet.";
inline constexpr Text kStudyPeople = "Taking part", kStudyNobody = "Nobody yet", kStudyStanding = "{}  {}";
inline constexpr Text kStudyUnwell = "How unwell they say they feel: 0 not at all, 10 very";
inline constexpr Text kStudyStop = "They want to stop";
inline constexpr Text kSaidAt = "{:7.1f} s";
inline constexpr Text kKeys = "Keys";
inline constexpr Text kKeysWhere = "In this window and in any of this computer's walls.";
inline constexpr Text kClose = "Close   Escape";
inline constexpr Text kShow = "Console   F10", kHide = "Game   F10";
inline constexpr Text kHideTip = "Back to the game, which lies below this window.";

// Clocks and playback.
inline constexpr Text kClock = "{:7.1f} s", kSeconds = "{:9.2f} s";
inline constexpr Text kSession = "session";
inline constexpr Text kSessionTip = "Since the session began, by the clock on the wall.";
inline constexpr Text kProperTime = "proper time";
inline constexpr Text kProperTimeTip = "What the observer's own clock shows.";
inline constexpr Text kOwnTimeAndPace = "{}  × {:.2f}";
inline constexpr Text kOwnTimeTip =
    "What this person's own clock shows, and its pace: 1 for whoever moves fastest, more for the others.";
inline constexpr Text kTableTime = "table time";
inline constexpr Text kTableTimeTip =
    "What the table's clocks show where the observer is. It runs ahead of the observer's proper time while "
    "they move.";
inline constexpr Text kRoomSpeed = "room speed", kAtRest = "at rest", kSpeed3 = "{:.3f} c",
                      kSpeed2 = "{:.2f} c";
inline constexpr Text kRoomSpeedTip = "Speed of the room relative to the table.";
inline constexpr Text kObserverSpeed = "observer's speed";
inline constexpr Text kObserverSpeedTip =
    "Speed of the observer relative to the table, the room's motion included.";
inline constexpr Text kLight = "light", kLightSpeed = "{:.2f} m/s", kLightTip = "The speed of light.";
inline constexpr Text kBeginning = "Beginning", kBeginningTip = "From the beginning (Home).";
inline constexpr Text kSecondBack = "- 1 s", kSecondOn = "+ 1 s";
inline constexpr Text kContinue = "Continue", kPause = "Pause", kPauseTip = "Space does the same.";
inline constexpr Text kEnd = "End", kRate = "speed", kBackwards = "backwards";
inline constexpr Text kPlaceTip = "Drag to where you want to be in the session.";

// Effects, light, views, walls.
inline constexpr Text kEffects = "Effects of relativity";
inline constexpr Text kRetardationTip =
    "Light delay: things are seen where they were when their light left them. Off: they are drawn where they "
    "are now, "
    "and all clocks agree.";
inline constexpr Text kContractionTip =
    "What moves is shorter along its motion. Off: it keeps the shape that it has at rest.";
inline constexpr Text kAberrationTip =
    "For a moving observer, directions swing towards where the observer goes. Off: your own motion does not "
    "show.";
inline constexpr Text kColourTip =
    "Doppler effect: light from what approaches is bluer, from what recedes redder, ultraviolet and infrared "
    "included. "
    "Off: surfaces keep their colours.";
inline constexpr Text kSearchlightTip =
    "Beaming: light from ahead is brighter for a moving observer. Off: brightness keeps.";
inline constexpr Text kBoardNowTip =
    "Striped ghosts where things are now, in the table's frame: their light is still on its way.";
inline constexpr Text kMyNowTip =
    "Crossed ghosts where things are now, in your frame. It is another now as soon as you move.";
inline constexpr Text kPathsTip =
    "The paths of the pucks over the cloth: solid = already seen, dashed = still to come.";
inline constexpr Text kEventsTip =
    "A numbered flag at each event, from the moment you see it; and the light of a flash on its way.";
inline constexpr Text kClocksTip =
    "Each puck's proper time as you see it; your proper time, your speed, the speed of light.";
inline constexpr Text kSplitTip =
    "The right half of every wall without relativity, or with what is ticked under \"right\".";
inline constexpr Text kFrozenTip = "Time stands still: walk around what you see at this moment.";
inline constexpr Text kRulerTip = "A metre on the cloth, with light travelling along it.";
inline constexpr Text kAnglesTip = "The angles between the outgoing paths of two pucks that met.";
inline constexpr Text kStrainTip =
    "Soft pucks in colours: blue where their matter is pressed, red where it is stretched.";
inline constexpr Text kHeatTip = "Soft pucks in colours of their heat, from dark through red to yellow.";
inline constexpr Text kSpacetimeTip =
    "The game stands in the room as a body of glass, with time upwards. A white line shows where you see "
    "each "
    "puck in it.";
inline constexpr Text kSpeedsTip =
    "A plate above each moving puck: the speed with which you see it move. What comes towards you can look "
    "faster than light.";
inline constexpr Text kNewsTip =
    "Rings over the cloth, in both pucks' colours: how far the news of each hit has come at the speed of "
    "light.";
inline constexpr Text kOn = "on", kLeft = "left", kRight = "right", kKeyColumn = "keys";
inline constexpr Text kRightTip =
    "For the right half of every wall, when it is drawn otherwise (\"Newton beside Einstein\").";
inline constexpr Text kLanguage = "Language", kLanguageOf = "Language of {}";
inline constexpr Text kLightAndEyes = "Light and eyes";
inline constexpr Text kLightSlider = "%.2f m/s", kEyesSlider = "%.1f mm", kPlaceSlider = "%.2f s";
inline constexpr Text kLightSliderTip =
    "In metres of the room per second of yours (keys [ and ]). Nothing jumps: what changes is how many "
    "seconds of the "
    "game pass in one of yours. The game's own is {:.4g} m/s.";
inline constexpr Text kUsual = "reset", kUsualTip = "As fast as the game's own.";
inline constexpr Text kBetweenEyes = "between eyes";
inline constexpr Text kBetweenEyesTip =
    "How far the observer's eyes are apart (keys + and -). 0: without depth.";
inline constexpr Text kRecordedTip = "As they were when this was recorded.";
inline constexpr Text kViews = "Views of time";
inline constexpr Text kWalls = "Walls";
inline constexpr std::array<Text, 3> kShown{"the game", "test patterns", "seams"};
inline constexpr std::array<Text, 3> kShownTips{
    "What the observer sees.",
    "A picture for each wall and eye: is it on the right wall, upright, in the right eye's colour, sharp?",
    "A grid that stands in the room and goes through the edges of the walls: do they meet?"};

// Events.
inline constexpr Text kMeet = "meet", kMeetsCushion = "meets cushion", kIsStruck = "is struck";
inline constexpr Text kFlashes = "flashes", kJam = "moves on in a jam";
inline constexpr Text kParts = "parted", kFarSide = "hears of it on the far side";
inline constexpr Text kSeen = "seen", kNotYet = "not yet";
inline constexpr Text kHappened = "What has happened until now,";
inline constexpr Text kTableFrame = "in the table's frame", kObserverFrame = "in the observer's frame";
inline constexpr Text kObserverFrameTip =
    "For a moving observer other events are simultaneous: some of these may be in another order, or not have "
    "happened "
    "yet. The observer's times are such that now is what their own clock shows.";
inline constexpr std::array<Text, 6> kEventColumns{
    "n", "who", "what", "  table time", "  observer's time", "its light"};
inline constexpr Text kNothingYet = "Nothing yet.";

// Games and lessons.
inline constexpr Text kAsks = "Phase: question. Time stands still until it is answered.";
inline constexpr Text kShows = "Phase: observe", kExplains = "Phase: explain",
                      kSkippedPhase = "Phase: skipped";
inline constexpr Text kIsLesson = "lesson", kIsPlayed = "now", kIsPlayedLesson = "lesson, now";
inline constexpr Text kPlay = "Play", kPlayTip = "Play the chosen game from its beginning.";
inline constexpr Text kRestart = "Restart", kRestartTip = "Play the present game from its beginning.";
inline constexpr Text kVelocity = "Observer's velocity";
inline constexpr Text kLesson = "Lesson: {}", kNumbered = "{}  {}", kListed = "    {}";
inline constexpr Text kTryThis = "Try this", kLookFor = "Look for", kAnswer = "Answer", kCorrect = "Correct";
inline constexpr Text kSkip = "Skip the question", kNext = "Next";
inline constexpr Text kPlayBegins = "Play begins it.";
inline constexpr Text kPlayBeginsLesson = "A lesson. Play begins it, with its question:";
inline constexpr Text kPucksAndLight = "{} pucks, light at {:.4g} m/s";
inline constexpr Text kStartFlight = "Start the round trip";
inline constexpr Text kStartFlightTip = "The room moves as the scenario prescribes.";

// Recording.
inline constexpr Text kSessionFile = "Session file", kCapture = "Pictures of every wall and eye",
                      kMovie = "Movie";
inline constexpr Text kCaptureOption = "--capture DIR", kMovieOption = "--movie FILE";
inline constexpr Text kNotMade = "Not recording. Start Carom with {}.";
inline constexpr Text kFrames = "{} frames since the session began";
inline constexpr Text kLeftOut = "{} dropped: they came faster than they are written";
inline constexpr Text kRecording = "recording {}", kRecorded = "a recorded session",
                      kNotRecorded = "not recorded";
inline constexpr Text kRecordedSessionTip = "What you do here is not written.";
inline constexpr Text kNotRecordedTip = "Start with --session FILE to keep the session.";
inline constexpr Text kRecordedSession = "This is a recorded session: nothing is written.";
inline constexpr Text kNotRecordedSession = "The session is not recorded: start with --session FILE.";
inline constexpr Text kFileSize = "{:.1f} MB, up to frame {}";

inline constexpr Text kStartMovie = "Start a movie", kEndMovie = "End the movie";
inline constexpr Text kStartMovieTip =
    "Of the walls that this node draws, the left eye's, beside the session file or in the present folder.";
inline constexpr Text kEndMovieTip = "The session stands still until the movie is whole.";
inline constexpr Text kTakePictures = "Take pictures";
inline constexpr Text kTakePicturesTip = "Of every wall and eye of this node, now.";
inline constexpr Text kRecordAnew = "Restart and record";
inline constexpr Text kRecordAnewTip =
    "A session file holds games from their beginning: this one starts again, and from then on all are kept.";

// The playlist and the best shot.
inline constexpr Text kNote = "Note";
inline constexpr Text kNextGame = "Next: {}, in {:.0f} s";
inline constexpr Text kBestShot = "Best shot again", kBestShotTip = "On the walls, as the visitor saw it.";

// Trackers.
inline constexpr Text kConnecting = "being looked for", kDelivering = "delivers", kSilent = "silent",
                      kUntouched = "no presses yet";
inline constexpr Text kFailed = "needs help";
struct Column {
  Text name;
  float width_em;
  Text tip;
};
inline constexpr std::array<Column, 10> kTrackerColumns{
    {{"", 1.2F, ""},
     {"tracker", 8.0F, "Its name in the rig's file."},
     {"drives", 5.0F, "What of the observer it tells of."},
     {"state", 7.5F, "Whether its samples come."},
     {"rate", 5.0F, "Samples per second, over the last second."},
     {"age", 5.0F, "Of the newest sample, when the frame began."},
     {"samples", 6.0F, "That have come so far."},
     {"gaps", 4.0F, "Samples that the device numbered and that never came."},
     {"late", 4.0F, "Came after a later one, or much too late."},
     {"rejected", 5.0F, "Packets that were not understood."}}};
inline constexpr Text kHertz = "{:.0f} Hz", kMilliseconds = "{:.0f} ms";
inline constexpr Text kTrackerMessage = "{}: {}";
inline constexpr Text kHeadFilter = "Head filter";
inline constexpr Text kHeadFilterTip =
    "measured: at a sample; predicted: a little after it; held: kept where the prediction ended, because "
    "samples are "
    "overdue or the picture is shown long after the newest one; lost: none for long. The speed turns what is "
    "seen: its "
    "uncertainty should stay below a few hundredths of light's speed.";
inline constexpr Text kNoTracker = "No tracker has been heard of.";
inline constexpr Text kRecordedHead = "The head is a recorded one: no tracker is asked.";

// Walls in small.
inline constexpr Text kDrawnBy = "drawn by";
inline constexpr Text kLate = "99th percentile: {:.1f} ms late";
inline constexpr Text kNodeOf = "node {}", kNodeDrawnHere = "node {}, drawn here";
inline constexpr Text kBlack = "black";
inline constexpr Text kWallTip = "Wall \"{}\", {} × {} pixels, {}, drawn by {}. Here: {}.";
inline constexpr Text kForMiddle = "for the point between the eyes";
inline constexpr Text kForLeftEye = "its left eye's picture, if it has two";
inline constexpr Text kMissing = "{} is missing: {}";
inline constexpr Text kMissingWalls = "walls {} are dark", kNoWalls = "no wall is dark";
inline constexpr Text kMissingTip =
    "This computer did not answer, or was left out. The other walls play on. Once it answers, 'carom room' "
    "starts the nodes again with its walls.";
inline constexpr Text kDrawAbsent = "draw other nodes' walls here, too, once a second";
inline constexpr Text kDrawAbsentTip =
    "For looking only: small, for one eye. It costs this node a little; the first time, the session stops "
    "for a moment.";
}  // namespace console

}  // namespace carom::texts
