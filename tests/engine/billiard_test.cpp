#include "engine/billiard.h"
#include <gtest/gtest.h>
TEST(Billiard, dummy) {}
