#pragma once
// The board's speed of light in the tests.

namespace carom::test {

inline constexpr double kC_m_s = 1.42;

}  // namespace carom::test
