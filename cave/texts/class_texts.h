#pragma once
// The catalogue's texts of a class that answers by phone (cave/texts/texts.h): on phones, on the teacher's
// page and on the front wall.

#include <array>

#include "cave/texts/texts.h"

namespace carom::texts {

// The pages of a class that answers by phone: what app/classroom/pages names, and what phones are told.
namespace phone {
struct Named {
  Text name, words;
};
inline constexpr std::array<Named, 12> kPage{{{"title", "Class"},
                                              {"connecting", "Connecting …"},
                                              {"noScript", "This page needs JavaScript. Please turn it on."},
                                              {"pin", "The teacher's PIN, as terminal and console show it"},
                                              {"enter", "Enter"},
                                              {"answer", "Your answer"},
                                              {"sure", "How sure are you?"},
                                              {"why", "Why? (if you like, at most 200 letters)"},
                                              {"send", "Send my answer"},
                                              {"teacher", "Teacher"},
                                              {"reasons", "Reasons that were given"},
                                              {"privacy",
                                               "Answers carry no names. They stay on the computer of this "
                                               "room, and the Wi-Fi is the room's own. Write "
                                               "nothing personal."}}};
inline constexpr std::array<Named, 19> kScript{
    {{"connecting", "Connecting …"},
     {"away", "The connection is gone. Trying again …"},
     {"joined", "Joined"},
     {"idle", "Wait for the question"},
     {"vote", "Vote {} of 2"},
     {"closed", "Vote {} is closed"},
     {"discuss", "Discuss it with your neighbours"},
     {"shown", "Watch the wall"},
     {"explained", "The explanation"},
     {"count", "{} of {} have answered"},
     {"phones", "Phones that have joined: {}"},
     {"counted", "Counted: “{}”. You may change it until the vote is closed."},
     {"yours", "Your answer: “{}”"},
     {"first", "Your first answer: “{}”"},
     {"right", "✓ correct"},
     {"bar", "Vote {}: {}"},
     {"chooseFirst", "Choose an answer first."},
     {"newPin", "The session has begun anew and has another PIN."},
     {"taken", "Somebody else has entered the PIN and is the teacher now."}}};
inline constexpr std::array<Text, 4> kConfidence{"Guessed", "Unsure", "Fairly sure", "Certain"};
// The teacher's steps, in the order of ClassStep.
inline constexpr std::array<Text, 7> kSteps{"Ask",     "Close the vote", "Discuss",    "Vote again",
                                            "Show it", "Explain",        "Next lesson"};
inline constexpr Text kNoMessage = "That could not be understood.";
inline constexpr Text kHelloFirst = "Join first.";
inline constexpr Text kVoteClosed = "This vote is closed.";
inline constexpr Text kAnswerFirst = "Answer first.";
inline constexpr Text kTeacherOnly = "Only the teacher can do that.";
inline constexpr Text kWrongPin = "This is not the PIN.";
inline constexpr Text kTooManyPins = "Too many wrong PINs. Try again in a minute.";
inline constexpr Text kFull = "The class is full.";
inline constexpr Text kNotNow = "That is not possible now.";
inline constexpr Text kNoQuestion = "This game asks no question. Choose a lesson.";
inline constexpr Text kTooFew = "Fewer than {} answers: nobody sees how they were given.";
inline constexpr Text kHintFew = "{:.0f} % right: give a hint and let them discuss, or show it.";
inline constexpr Text kHintDiscuss = "{:.0f} % right: let them discuss, then vote again.";
inline constexpr Text kHintMany = "{:.0f} % right: show it.";
inline constexpr Text kHintShow = "{:.0f} % right after the discussion: show it.";
/// Words for rooms, easily told apart when they are read aloud.
inline constexpr std::array<Text, 40> kRoomWords{
    "ANCHOR", "APPLE",  "BANJO",  "BEAVER", "CACTUS", "CANDLE", "CHERRY", "COMET",  "DOLPHIN", "EAGLE",
    "FERRY",  "GARLIC", "GINGER", "HAMMER", "HARBOR", "IGLOO",  "JACKET", "KIWI",   "LADDER",  "LEMON",
    "MAGNET", "MANGO",  "MEADOW", "NUTMEG", "OCEAN",  "OLIVE",  "ORANGE", "PANDA",  "PEPPER",  "PIANO",
    "PILOT",  "QUARTZ", "RIVER",  "SALMON", "SPIDER", "TIGER",  "TULIP",  "VIOLIN", "WALNUT",  "ZEBRA"};
}  // namespace phone

// A class on the front wall.
namespace classroom {
inline constexpr Text kJoin = "Join by phone:", kRoom = "Room {}";
inline constexpr Text kPhones = "phones: {}";
inline constexpr Text kVote = "Vote {}:  {} of {} answered";
inline constexpr Text kClosed = "Vote {} is closed:  {} answered";
inline constexpr Text kDiscuss = "Discuss it, then vote again";
inline constexpr Text kTooFew = "Too few answers to show how they were given";
inline constexpr std::array<Text, 2> kVotes{"vote 1", "vote 2"};
inline constexpr Text kRight = "✓";
inline constexpr Text kByPhone = "Answer by phone.";
}  // namespace classroom

}  // namespace carom::texts
