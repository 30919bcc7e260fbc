#include "app/file_keys/scenario_keys.h"

#include <numbers>

#include "app/file_keys/common_keys.h"
#include "app/file_keys/lesson_keys.h"
#include "app/file_keys/task_keys.h"
#include "cave/frame/hall.h"
#include "engine/game/billiard_setup.h"
#include "engine/polygons/outline.h"
#include "engine/soft/soft_body.h"
#include "engine/soft/soft_mesh.h"
#include "engine/spacetime/observer.h"

namespace carom {
namespace {

using namespace declare;

constexpr std::string_view kMesh =
    "any format VTK reads; looked for beside this file, then in the configuration folder";
constexpr std::string_view kBodyMesh =
    "any format VTK reads, as of a puck; without it a rod of 1 m along x is drawn, or nothing of a body that "
    "holds a soft puck";
constexpr std::string_view kBeta = "v/c; magnitude below 1";

FileKey place(std::string_view name, std::string_view sentence) { return numbers(name, 3, {}, sentence); }

FileKey board() {
  return table(
      "board", "left out: an open plane without cushions",
      {required(number("length_m", kPositive, "along x, inner edge to inner edge, centred on the origin")),
       required(number("width_m", kPositive, "along y"))});
}

FileKey physics() {
  const PhysicsRules rules;
  return table("physics", "what happens to pucks",
               {number("puck_restitution", kShare,
                       "of pucks with each other; 0: they stick together, 1: elastic", rules.puckRestitution),
                number("cushion_restitution", kShare, "of pucks with cushions", rules.cushionRestitution),
                number("friction_m_s2", kNotNegative,
                       "proper deceleration of a gliding puck; times a puck's radius below half the square "
                       "of the light speed",
                       rules.friction_m_s2),
                number("puck_friction", kUnlimited,
                       "Coulomb's coefficient between the rims of pucks; inf: they never slide on each other",
                       rules.puckFriction),
                number("cushion_friction", kUnlimited,
                       "Coulomb's coefficient between a rim and a cushion; inf: it never slides",
                       rules.cushionFriction),
                number("tangential_restitution", kShare,
                       "of rims that slip on each other; 0: they rest on each other afterwards, 1: elastic",
                       rules.tangentialRestitution),
                number("spin_deceleration_m_s2", kNotNegative, "of the rim of a spinning puck, by the cloth",
                       rules.spinDeceleration_m_s2),
                number("stiff_sound_speed", {.least = 0.05, .most = kStiffestSound},
                       "over c, in a rigid puck that has become soft because a soft one came near",
                       rules.stiffSoundSpeed),
                choice("collision_event", {"centre", "contact"},
                       "centre: a puck turns when the news of the contact reaches its centre; contact: with "
                       "the contact, in the "
                       "frame of equal speeds",
                       static_cast<std::size_t>(rules.collisionEvent))});
}

FileKey observer() {
  const ObserverStart start;
  const Vec3& p = start.position_m;
  return table("observer", "where the platform starts; board frame",
               {numbers("position_m", 3, {}, "of the room's floor origin, board frame", {p.x, p.y, p.z}),
                number("facing_deg", {}, "room forward, anticlockwise from +x",
                       start.facing_rad / (std::numbers::pi / 180.0)),
                fastestBeta("v/c beyond which the drive makes the room no faster"),
                numbers("beta", 3, {}, "v/c of the platform at t = 0; magnitude below 1", {0.0, 0.0, 0.0})});
}

FileKey tour() {
  return table(
      "tour", "the platform's own way: legs of thrust, each an exact hyperbola of the person's world line",
      {choice("starts", {"asked", "at once"}, "asked: by the key G or the console; at once: with the game",
              0),
       required(ofSize(
           1, kAnyNumber,
           tables("leg", "a time of constant thrust",
                  {number("from_s", kNotNegative,
                          "since the tour set out, on the platform's clock, which is the person's while they "
                          "stand; "
                          "left out: when the leg before it ends"),
                   required(number("for_s", kPositive, "how long, on that clock")),
                   required(
                       place("thrust_m_s2",
                             "proper acceleration to the person's right, forward and up; its size is at most "
                             "light_speed_m_s squared by 2 m, and light_speed_m_s in a second"))})))});
}

FileKey soft() {
  const SoftMatter matter;
  return table("soft", "of a disc or a rectangle: matter that gives way and conducts sound",
               {number("sound_speed", {.least = 0.0, .most = kStiffestSound, .above = true},
                       "over c, in the relaxed puck", matter.soundSpeed),
                whole("cells", kFewestSoftCells, kMostSoftCells,
                      "edges of triangles along the longest half extent", matter.cells),
                number("viscosity", {.least = 0.05, .most = 1.0},
                       "settles ringing; scales with the triangles", matter.viscosity),
                tables("held", "sides of a rectangle that move as the centre of a body does",
                       {required(choice("side", {"-x", "+x"}, "which side")),
                        required(text("by", "name of a [[body]] with legs"))})});
}

FileKey puck() {
  constexpr Range kInertia{.least = 0.0, .most = 1.0, .above = true};
  constexpr double kHeight_m = 0.02;
  constexpr int kMostSectors = 48;
  FileKey keys = tables(
      "puck", "a body that collides",
      {required(text("name", "unique")), number("radius_m", kPositive, "at rest"),
       ofSize(3, kMostCorners,
              points("outline_m", 2,
                     "instead of radius_m: corners [x, y] from the centre of mass, at rest, anticlockwise")),
       choice("outline", {"mesh"},
              "it collides as its mesh looks from above; radius_m is that of the farthest corner"),
       number("height_m", kPositive, "the centre is at half of it", kHeight_m),
       required(number("mass_kg", kPositive, "rest mass")),
       required(numbers("position_m", 2, {}, "centre at t = 0")),
       required(numbers("beta", 2, {}, "v/c at t = 0; magnitude below 1")),
       number("inertia", kInertia,
              "share of the mass in the rim, at least 1e-6: a slowly spinning puck has the moment of inertia "
              "inertia · "
              "mass · radius²; 0.5 if left out, a disc's, and of a puck with corners that of an even plate"),
       number("spin_rad_s", {},
              "by its own clock, anticlockwise from above; its angle is 0 at t = 0; times the radius below "
              "light speed",
              0.0),
       number("spin_kg_m2_s", {}, "instead of spin_rad_s: angular momentum in the rest frame of its centre",
              0.0),
       soft(), text("mesh", kMesh),
       whole("sectors", 2, kMostSectors,
             "an even number: its mesh is painted in so many sectors around its axis, alternately in its "
             "colour and pale, the first with its middle on x")});
  keys.rules = {{{.with = {"sectors", "mesh"}, .without = {}}, {.with = {}, .without = {"sectors"}}},
                {{.with = {"radius_m"}, .without = {"outline_m", "outline"}},
                 {.with = {"radius_m", "outline", "mesh"}, .without = {"outline_m"}},
                 {.with = {"outline_m"}, .without = {"radius_m", "outline"}}},
                {{.with = {}, .without = {"spin_rad_s"}}, {.with = {}, .without = {"spin_kg_m2_s"}}}};
  return keys;
}

FileKey body() {
  FileKey leg =
      tables("leg", "a straight part of its way; the first reaches back to the beginning",
             {required(number("from_s", {}, "board time at which the centre turns; the first leg has none")),
              required(numbers("beta", 3, {}, kBeta))});
  leg.notInFirst = "from_s";
  FileKey keys = tables(
      "body", "moves as told, collides with nothing",
      {required(text("name", "unique")), text("mesh", kBodyMesh),
       choice("material", {"lacquer", "metal", "wood"},
              "of the mesh: of its colour, riveted sheets of 10 cm in its colour, or planks along x", 0),
       text("history",
            "instead of at and leg: a table t_s,x0_m,y0_m,z0_m,x1_m,… with a row a board time; the vertices "
            "move "
            "straight and evenly between rows"),
       (table("at", "an event its centre passes through, on whichever leg holds t_s",
              {required(number("t_s", {}, "board time")), required(place("r_m", "place on the board"))})),
       number("appears_s", {}, "board time before which it does not exist"),
       number("spin_rad_s", {},
              "by its own clock, anticlockwise from above; its angle is 0 at the event `at`", 0.0),
       ofSize(1, kAnyNumber, leg)});
  keys.rules = {{{.with = {"at", "leg"}, .without = {"history"}},
                 {.with = {"history"}, .without = {"at", "leg", "appears_s", "spin_rad_s", "material"}}}};
  return keys;
}

FileKey stroke() {
  return tables("stroke", "a kick of a cue",
                {required(number("at_s", kNotNegative,
                                 "board time of the kick; of the hand's strike where from_m is given")),
                 place("from_m", "the hand's place: light from there carries the kick"),
                 required(text("puck", "name of a puck")),
                 required(numbers("momentum_kg_m_s", 2, {}, "added to the puck's")),
                 number("offset_m", {},
                        "how far beside the centre, to the right of the momentum: turns the puck "
                        "anticlockwise; at most the radius",
                        0.0)});
}

FileKey flash() {
  return tables("flash", "light that starts from a point",
                {text("name", "unique; left out: flash and its number in the file, from 1"),
                 required(number("at_s", kNotNegative, "board time at which the light starts")),
                 required(place("r_m", "the place it starts from, at rest on the board"))});
}

FileKey pulse() {
  return tables(
      "pulse", "a pulse of light that is told: straight from place to place at c, seen by what it strikes",
      {required(text("name", "unique")), required(number("at_s", {}, "board time at which it starts")),
       required(
           ofSize(2, kAnyNumber, points("path_m", 3, "places on its way, each other than the one before")))});
}

FileKey lamp() {
  return ofSize(0, kMostLamps,
                tables("lamp", "a lamp whose light is followed; the hall's own light is then off",
                       {required(place("position_m", "the bulb")),
                        number("on_s", {}, "board time at which it goes on", 0.0),
                        numbers("colour", 3, kShare, "red, green and blue, linear", {1.0, 1.0, 1.0}),
                        number("power", {.least = 0.0, .most = 100.0, .above = true},
                               "in that of one of the hall's usual lamps", 1.0)}));
}

FileKey caption() {
  return tables("caption",
                "sentences shown in the room at given times of the observer's own clock since the game began",
                {number("from_s", kNotNegative, "left out: when the caption before it ends"),
                 required(number("for_s", kPositive, "how long")),
                 required(ofLetters(kCaptionLetters, text("text", "the sentence"))),
                 ofLetters(kCaptionLetters,
                           text("hand_text",
                                "instead of text for viewers with a wand, who have no keys; left out: text")),
                 viewsKey("time views that are on until the next caption begins"),
                 flag("colour", "Doppler colour and searchlight are on until the next caption begins")});
}

}  // namespace

const FileKey& scenarioKeys() {
  static const FileKey keys =
      table("scenario", "Carom scenario",
            {text("title", "for people"),
             flag("choices",
                  "the front wall offers Play, Lessons and Show me; left out: only where there is a lesson, "
                  "when it explains",
                  std::nullopt),
             required(number("light_speed_m_s", kPositive, "speed of light")), board(), physics(), observer(),
             tour(), puck(), body(), flash(), caption(), pulse(), lamp(), lessonKeys(), stroke(), taskKeys(),
             spacetimeKey(false)});
  return keys;
}

}  // namespace carom
