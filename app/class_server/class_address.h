#pragma once
// The address, the word and the PIN of a class.

#include <string>

namespace carom {

/// Returns the address of this computer in the network of its default route, in numbers. Throws
/// std::runtime_error if there is no such route.
std::string addressOfDefaultRoute();

/// Returns a word for the room, and six digits, by chance from the operating system.
std::string anyRoomWord();
std::string anyPin();

/// Returns the code of a page to take home: eight letters by chance from the operating system, without those
/// that look like digits. There are 10¹¹ codes.
std::string anyTakeCode();

}  // namespace carom
