#pragma once
// The keys of a session. They work in any of rank 0's windows; ending it, in any window of any node.

#include "cave/wall_controls.h"
#include "cave/window.h"
#include "engine/switches.h"

namespace carom {

/// Escape, Q, or a window's own button.
bool wantsToEnd(const WindowInput& input);

/// Turns the switches whose keys were pressed, 1 to 5, and says so on standard error.
void turnSwitches(const WindowInput& input, Switches& switches);

/// T shows the test patterns, the seam pattern, the session again (`inSession`; where there is none, the test
/// patterns again); B makes all walls black and lit again; X
/// swaps the eyes. Says so on standard error.
void steerWalls(const WindowInput& input, WallControls& controls, bool inSession = true);

/// Between 0 and this (metres), in whole steps, the eyes can be set apart.
inline constexpr double kMostEyeSeparation_m = 0.08;
inline constexpr double kEyeSeparationStep_m = 0.001;

/// + and − set the eyes further apart and closer by a step, and say how far they are.
void setEyesApart(const WindowInput& input, double& eyeSeparation_m);

/// Says on standard error what the keys do.
void sayKeys();
void sayPatternKeys();  ///< where there is no session

}  // namespace carom
