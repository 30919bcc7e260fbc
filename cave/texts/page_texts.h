#pragma once
// The words of the page that a visit leaves in a browser: part of the catalogue (cave/texts/texts.h).

#include <array>

namespace carom::texts::page {

struct PageText {
  const char *name, *words;
};

/// In the page itself.
inline constexpr std::array<PageText, 3> kPage{
    {{"about", "A visit to a billiard table on which light is slow"},
     {"noScript",
      "This page computes what was seen. It needs scripts and WebGL 2, which every browser of the last years "
      "has: "
      "on an iPhone open it from a web site instead of from the files. The picture shows one moment of it."},
     {"still", "What was seen, halfway through"}}};

/// For its script.
inline constexpr std::array<PageText, 50> kScript{{
    {"cut", "This page is not whole: it was cut off on its way. Please fetch it again."},
    {"noWebgl",
     "This browser cannot draw the visit: it lacks WebGL 2. The picture shows one moment of it. Another "
     "browser will "
     "show all of it."},
    {"trapped",
     "The computation has failed and has stopped. The picture shows one moment of the visit; reload the page "
     "to try again."},
    {"play", "Play"},
    {"pause", "Pause"},
    {"speed", "Speed"},
    {"time", "Time"},
    {"observer", "Observer"},
    {"recorded", "As it was seen"},
    {"look", "Look round"},
    {"stand", "Stand elsewhere"},
    {"ride", "Ride on {}"},
    {"drive", "Drive"},
    {"wall", "Wall: {}"},
    {"free", "All around"},
    {"effects", "Effects"},
    {"retardation", "Light takes its time"},
    {"contraction", "Bodies contract"},
    {"aberration", "Directions tilt"},
    {"ghosts", "Ghosts"},
    {"boardNow", "Now, for the table"},
    {"myNow", "Now, for you"},
    {"events", "Events"},
    {"event", "{} at {} s, here number {}"},
    {"puckPuck", "{} meets {}"},
    {"puckCushion", "{} meets a cushion"},
    {"stroke", "{} is struck"},
    {"flash", "A flash"},
    {"jam", "{} is pressed"},
    {"light", "Light: {} m/s"},
    {"clock", "Your clock: {} s. The table's: {} s. Your speed: {} of light's."},
    {"held", "The recording ends here: more was not seen by anybody."},
    {"heldPast", "Nobody is faster than 0.999 of light here."},
    {"lookHow",
     "Drag to look round; two fingers or the wheel widen the view. Choices: the eyes of other observers."},
    {"playOn", "Try it: play on yourself."},
    {"order",
     "What you have heard of, by the table's clocks, and as which number it happened by your own time: "
     "others "
     "may count otherwise."},
    {"driveHow", "W A S D or the arrows push you, or drag in the lower left corner."},
    {"standHow", "Drag to look; arrows choose where you stand."},
    {"menu", "Choices"},
    {"tryIt", "Try it"},
    {"tryHow", "Drag from a puck and let go: your stroke travels to it at the speed of light."},
    {"back", "Back"},
    {"lost", "The graphics card was taken away. Waiting for it …"},
    {"before", "Back one frame"},
    {"after", "On one frame"},
    {"open", "Choices and events"},
    {"told", "The visitor was told: {}"},
    {"nothing", "This page has no such picture."},
    {"away", "The connection to the room is gone. Trying again …"},
    {"liveHeld", "Here it is later than for those in the room: this has not happened to them yet."},
}};

/// On the walls, and for phones that ask for a page which does not exist.
inline constexpr const char *kTakeHome = "Take your game home:", *kForAnHour = "For an hour from now";
inline constexpr const char* kNoSuchCode = "There is no page of this code. Look at the wall again, please.";
inline constexpr const char* kExpired = "The hour of this page is over: it is no longer here.";
inline constexpr const char* kSilence = "Too many codes that do not exist. Wait a minute, please.";
inline constexpr const char* kNotYet = "The game's page is being made. In a few seconds, please.";
inline constexpr const char* kFollow = "Follow the game by your own eyes";

}  // namespace carom::texts::page
