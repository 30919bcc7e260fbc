#pragma once
// For programs linked with counted_new.cpp: what `new` was asked for.

#include <cstddef>

namespace carom::test {

std::size_t allocationCount();  ///< since the start
std::size_t bytesHeld();        ///< now, as malloc rounds them

}  // namespace carom::test
