#pragma once
// Draws what a lesson measures (cave/frame/lesson_plan.h) among the bodies. Lines and plates rest on the
// board, but counters and gauges go with their bodies, and lines of simultaneity are drawn where their events
// are in the observer's frame if the view "my now" is on.

#include "cave/frame/lesson_plan.h"
#include "cave/record/lesson_words.h"
#include "cave/render/mark_context.h"

namespace carom {

/// Adds the lesson's marks: its lines on the cloth always; counters, gauges and the plates of stopwatches
/// once the question is over; lines of simultaneity while it explains. `reach_m` is, for every body of the
/// scene, how far it reaches from its centre.
void addLessonMarks(const MarkContext& sight, const LessonPlan& plan, std::span<const double> reach_m,
                    LabelLayout& crowd, MarkBuffer& batch);

/// Returns how many of these events the eye has seen.
std::size_t seenTicks(const MarkContext& sight, const TickCounter& counter);

}  // namespace carom
