// What an eye sees of the bodies of a visit, for a page in a browser: legs for the graphics card, and single
// points in double.

#include <algorithm>
#include <limits>
#include <optional>

#include "app/page/engine/exchange.h"
#include "engine/colour/doppler_colour.h"
#include "engine/colour/exposure.h"
#include "engine/light/light_cone.h"
#include "engine/spacetime/lorentz.h"

namespace carom::page {

std::vector<double>& exchange() {
  static std::vector<double> numbers;
  return numbers;
}

Bodies& bodies() {
  static Bodies all;
  return all;
}

namespace {

/// What the eye that looked last sees.
struct Sight {
  std::vector<BodyView> views;
  std::vector<kernel_float::LegView> legs;
  std::vector<double> ranges;  ///< of each body: its first leg, their number, `appears_m`
};

Sight& sight() {
  static Sight last;
  return last;
}

Switches switchesOf(int bits) {
  const auto bit = [bits](int i) { return static_cast<std::uint8_t>(bits >> i & 1); };
  return {bit(0), bit(1), bit(2), bit(3), bit(4)};
}

std::vector<float>& colours() {
  static std::vector<float> texels;
  return texels;
}

}  // namespace

extern "C" {

/// Makes room for `count` numbers. Returns their address, which holds until the next call.
CAROM_EXPORTED(give) double* give(int count) {
  exchange().resize(static_cast<std::size_t>(count));
  return exchange().data();
}
CAROM_EXPORTED(answered) double* answered() { return exchange().data(); }
CAROM_EXPORTED(answerCount) int answerCount() { return static_cast<int>(exchange().size()); }

/// Begins a visit to a game with this speed of light, without bodies.
CAROM_EXPORTED(beginVisit) void beginVisit(double c_m_s) { bodies() = {c_m_s, {}}; }

/// Adds a body, which begins with the given knot.
CAROM_EXPORTED(addBody) void addBody(double radius_m, double appears_s) {
  bodies().lines.emplace_back(Given().knot(), bodies().lightSpeed_m_s, radius_m, appears_s);
}

/// Removes what the pucks, bodies 1 to `pucks`, were to do from a board time on.
CAROM_EXPORTED(truncatePucks) void truncatePucks(int pucks, double from_s) {
  for (int body = 1; body <= pucks; ++body)
    bodies().lines[static_cast<std::size_t>(body)].truncateFrom(from_s);
}

/// Adds the given knot to a body's world line.
CAROM_EXPORTED(appendKnot) void appendKnot(int body) {
  bodies().lines[static_cast<std::size_t>(body)].append(Given().knot());
}

/// Views all bodies by the given eye: its event, the transform headFromBoard. The legs follow in `legs`; the
/// answer has three numbers for each body.
CAROM_EXPORTED(look) void look(int switches, int moment) {
  Given given;
  const Event observation = given.event();
  const Lorentz headFromBoard = given.transform(bodies().lightSpeed_m_s);
  Sight& seen = sight();
  seen.views.resize(bodies().lines.size());
  seen.legs.clear();
  Answer answer;
  for (std::size_t body = 0; body < seen.views.size(); ++body) {
    BodyView& view = seen.views[body];
    viewBody(bodies().lines[body], observation, headFromBoard, view, switchesOf(switches),
             static_cast<ViewTime>(moment));
    answer.number(static_cast<double>(seen.legs.size()));
    answer.number(static_cast<double>(view.legs.size()));
    answer.number(view.appears_m);
    for (const LegView& leg : view.legs) seen.legs.push_back(toFloat(leg));
  }
}
CAROM_EXPORTED(legs) const float* legs() { return reinterpret_cast<const float*>(sight().legs.data()); }
CAROM_EXPORTED(legCount) int legCount() { return static_cast<int>(sight().legs.size()); }

/// The frames in which the given transform headFromBoard sees: the answer is drawnFromSeen, boardFromDrawn,
/// γ and γβ of the head on the board, and the exposure.
CAROM_EXPORTED(frames) void frames(int switches, int moment) {
  const Lorentz headFromBoard = Given().transform(bodies().lightSpeed_m_s);
  const Switches effects = switchesOf(switches);
  const ViewFrame ofMoment(headFromBoard, effects, static_cast<ViewTime>(moment));
  const ViewFrame frame(headFromBoard, effects);
  const Vec3 u = headFromBoard.inverse().u();
  const Exposure exposure =
      exposureFor(glm::length(betaFromU(u)), effects.colour != 0, effects.searchlight != 0);
  Answer answer;
  answer.matrix(ofMoment.drawnFromSeen.matrix());
  answer.matrix(frame.drawnFromBoard.inverse().matrix());
  answer.number(gammaFromU(u));
  answer.vector(u);
  for (const float value : {exposure.gain, exposure.rise, exposure.fall}) answer.number(double{value});
}

/// Where the eye that looked last sees the given places of a body: three numbers each and, of the emission,
/// c (t − t_o). Unseen ones have no number. By the kernel in double: what the graphics card computes.
CAROM_EXPORTED(seenPlaces) void seenPlaces(int body, int count) {
  const BodyView& view = sight().views[static_cast<std::size_t>(body)];
  std::vector<Vec3> places(static_cast<std::size_t>(count));
  Given given;
  for (Vec3& place : places) place = given.vector();
  Answer answer;
  for (const Vec3& place : places) {
    const kernel::VertexEmission emission = emissionIn(view, place);
    const LegView& leg = view.legs[static_cast<std::size_t>(emission.leg)];
    const double boardTime_m = kernel::boardTimeOf(leg, emission.event);
    const bool isSeen = boardTime_m >= view.appears_m;
    answer.vector(isSeen ? seenFromEye(view, emission) : Vec3(std::numeric_limits<double>::quiet_NaN()));
    answer.number(boardTime_m);
  }
}

/// The emission of one point by its whole world line, as `carom observe` has it: the given place, eye event
/// and transform headFromBoard. The answer is the emission event, the seen place, γβ, the Doppler factor and
/// the point's own clock; nothing if it is unseen.
CAROM_EXPORTED(seenPoint) void seenPoint(int body) {
  Given given;
  const Vec3 place_m = given.vector();
  const Event observation = given.event();
  const Lorentz headFromBoard = given.transform(bodies().lightSpeed_m_s);
  const std::optional<Emission> seen =
      emission(bodies().lines[static_cast<std::size_t>(body)], place_m, observation, headFromBoard);
  Answer answer;
  if (!seen) return;
  answer.event(seen->event);
  answer.vector(seen->seen.dr_m);
  answer.vector(seen->u);
  answer.number(seen->doppler);
  answer.number(seen->properTime_s);
}

/// The motion of a body at a board time: its event, γβ, own clock.
CAROM_EXPORTED(motionAt) void motionAt(int body, double t_s) {
  const Motion motion = bodies().lines[static_cast<std::size_t>(body)].at(t_s);
  Answer answer;
  answer.event(motion.event);
  answer.vector(motion.u);
  answer.number(motion.properTime_s);
}

/// The motion of a body's centre as the given eye sees it, in the same way.
CAROM_EXPORTED(centreMotion) void centreMotion(int body) {
  const Motion motion = centreSeen(bodies().lines[static_cast<std::size_t>(body)], Given().event());
  Answer answer;
  answer.event(motion.event);
  answer.vector(motion.u);
  answer.number(motion.properTime_s);
}

/// The table of shifted colours, for a texture of 1024 × 9 texels of four floats.
CAROM_EXPORTED(colourTexels) const float* colourTexels() {
  if (colours().empty()) {
    const ColourTable table;
    const auto* const first = reinterpret_cast<const float*>(table.texels().data());
    colours().assign(first, first + 4 * table.texels().size());
  }
  return colours().data();
}

}  // extern "C"

}  // namespace carom::page
