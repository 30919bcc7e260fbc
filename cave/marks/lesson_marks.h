#pragma once
// Draws what a lesson measures (cave/frame/lesson_plan.h) among the bodies. Lines and plates rest on the
// board, but counters and gauges go with their bodies, and lines of simultaneity are drawn where their events
// are in the observer's frame if the view "my now" is on.

#include "cave/frame/lesson_plan.h"
#include "cave/marks/mark_context.h"
#include "cave/record/lesson_words.h"

namespace carom {

/// Adds the lesson's marks: its lines on the cloth and its labels always; counters, gauges and the plates of
/// stopwatches once the question is over; lines of simultaneity, and labels that explain, while it explains;
/// arrows while it shows or while it explains.
/// `tops_m` is, for every body of the scene, how far it reaches up from its centre.
void addLessonMarks(const MarkContext& sight, const LessonPlan& plan, std::span<const double> tops_m,
                    LabelLayout& crowd, MarkBuffer& batch);

/// Adds a plate above each puck that is seen to move, with its apparent speed over c.
void addSeenSpeeds(const MarkContext& sight, std::span<const double> tops_m, LabelLayout& crowd,
                   MarkBuffer& batch);

/// Returns how many of these events the eye has seen.
std::size_t seenTicks(const MarkContext& sight, const TickCounter& counter);

}  // namespace carom
