#include "app/file_keys/rig_keys.h"

#include "app/file_keys/common_keys.h"
#include "app/file_keys/screen_keys.h"
#include "cave/room/wall.h"
#include "devices/setup/force_factory.h"
#include "devices/setup/tracker_factory.h"

namespace carom {
namespace {

using namespace declare;
using Keys = std::vector<FileKey>;

constexpr std::string_view kPlainName = "^[A-Za-z0-9_-]+$";
constexpr int kMostPixels = 16384;  // largest texture size of common GPUs
constexpr Range kPlace_px{.least = -65536.0, .most = 65536.0};
constexpr Range kSize_px{.least = 1.0, .most = kMostPixels};
constexpr Range kLatency_ms{.least = 0.0, .most = 1000.0};

FileKey pixels(std::string_view name, const Range& range, std::string_view sentence,
               std::initializer_list<double> fallback = {}) {
  return inUnit("pixels", wholes(name, 2, range, sentence, fallback));
}

FileKey window(std::string_view name, std::string_view sentence, bool border) {
  FileKey monitor =
      whole("monitor", 0, 63,
            "the monitor by its number, or better by its name: numbers change with cables and "
            "drivers; the names of several are one window across them; carom doctor prints both",
            0);
  monitor.type = FileKey::Type::monitors;
  return table(name, sentence,
               {monitor,
                pixels("position", kPlace_px,
                       "of its upper left pixel, from the upper left of the monitor, or of the rectangle "
                       "around all of its "
                       "monitors",
                       {0.0, 0.0}),
                required(pixels("size", kSize_px, "width and height")),
                flag("fullscreen", "it covers its monitors, whatever its position and size"),
                flag("border",
                     "a title and a border, as on a desk; without them it is a wall's window, exactly where "
                     "the rig says, and "
                     "hides the cursor",
                     border)});
}

Keys sensorKeys() {
  return {required(text("tracker", "name of a [[tracker]]")),
          whole("sensor", 0, 65535, "its sensor, where it has several", 0)};
}

/// Appends the keys of a head.
Keys withHead(Keys keys) {
  for (FileKey& key : sensorKeys()) keys.push_back(std::move(key));
  keys.push_back(
      inUnit(kUnitOfRig, number("eye_separation", kUnlimited, "0.064 m if left out, at most 1 m")));
  keys.push_back(
      pose("eyes_from_sensor",
           "takes the sensor's coordinates to those of the eyes: translation is where the sensor sits, "
           "seen from the middle between the eyes"));
  return keys;
}

FileKey force() {
  constexpr Range kForce_n{.least = 0.1, .most = 50.0}, kD0_m{.least = 0.02, .most = 0.5};
  constexpr Range kStiffness_n_m{.least = 1.0, .most = 1e5};
  return table(
      "force", "a device that lets the hand feel forces",
      {required(choice("kind", forceNames(), "the device or its protocol")),
       text("source",
            "evdev: a node such as /dev/input/by-id/…, or none for the first device with force; vrpn: "
            "Arm@tcp://host"),
       inUnit("N",
              number("force_max_n", kForce_n,
                     "the strongest force of the device; required, but for a simulated one, which has 9")),
       inUnit("N/m",
              number("stiffness_max_n_m", kStiffness_n_m,
                     "the stiffest spring that it holds; left out, and at most: twice the damping of such a "
                     "device over the period of its loop")),
       inUnit("m", number("d0_m", kD0_m, "draw of the cue for one unit of rapidity", 0.08)),
       pose("room_from_device",
            "takes the device's coordinates to the room's; the device of a VRPN server is the hand's "
            "tracker, if "
            "[hand] names none")});
}

FileKey hand() {
  Keys keys = sensorKeys();
  keys.front().isRequired = false;
  keys.push_back(text("buttons",
                      "name of another [[tracker]] whose buttons and axes are the hand's; left out: those of "
                      "its own tracker"));
  keys.push_back(
      pose("hand_from_sensor",
           "takes the sensor's coordinates to those of the hand: its ray begins at the origin and points "
           "along the rig's forward"));
  keys.push_back(force());
  FileKey hand = table("hand", "a wand", std::move(keys));
  hand.rules = {{{.with = {"tracker"}, .without = {}}, {.with = {"force"}, .without = {}}}};
  return hand;
}

FileKey viewer() {
  Keys keys = withHead({required(
      fitting(kPlainName, text("name",
                               "unique; in the session file, and in the names of pictures that show "
                               "eyes of several viewers")))});
  keys.push_back(hand());
  keys.push_back(languageKey("of the words that this person reads; left out: the rig's"));
  return ofSize(
      1, kMostViewers,
      tables("viewer", "the people of a room for several, instead of [head] and [hand]", std::move(keys)));
}

FileKey osc() {
  FileKey key = table(
      "osc", "of osc: which of its messages are what; {sensor} and {n} stand for numbers in their addresses",
      {text("pose", "address of a pose, such as /head/{sensor}; without {sensor} it is that of sensor 0"),
       text(
           "values",
           "the arguments of a pose, in order: x, y, z, the quaternion's qx, qy, qz, qw or none of them, and "
           "- for what is to be ignored; left out: x y z qx qy qz qw"),
       choice("unit", kLengthUnits, "of x, y and z", kMetre),
       text("buttons", "address of a button, such as /wand/{sensor}/button/{n}: 1 pressed, 0 not"),
       text("axes", "address of an axis, such as /wand/{sensor}/axis/{n}: from -1 to 1")});
  key.rules = {{{.with = {"pose"}, .without = {}},
                {.with = {"buttons"}, .without = {}},
                {.with = {"axes"}, .without = {}}}};
  return key;
}

FileKey tracker() {
  return ofSize(
      0, kMostTrackers,
      tables("tracker", "a device that says where heads and hands are, or what stands for one",
             {required(text("name", "unique")),
              required(choice("kind", trackerNamesInRigs(), "the device or its protocol")),
              choice("person", {"moves", "still", "walks"},
                     "of a simulated tracker: someone who stands, shifts and walks about, who does not move "
                     "at all, or "
                     "who walks about from the beginning",
                     0),
              number("latency_ms", kLatency_ms,
                     "known latency of its samples, where the protocol does not say", 0.0),
              flag("start",
                   "of dtrack: the session starts the measurement of the ?controller= in the source, and "
                   "stops it at the "
                   "end"),
              text("source",
                   "recorded: the trace; vrpn: Head@tcp://host:3883; dtrack: udp://0.0.0.0:5000; natnet: "
                   "udp://host; qtm: tcp://host:22223; trackd: shm://4126?wand=4127; survive: "
                   "tcp://host:port, or none to start "
                   "survive-cli; osc: udp://0.0.0.0:9000; "
                   "polhemus-usb, hid-imu and spacemouse: vid:pid or vid:pid:serial; a spacemouse without "
                   "one: the first "
                   "that is plugged in"),
              choice("unit", kLengthUnits, "of trackd: of the lengths that its daemon writes", kFoot),
              ofLetters(100, ofSize(0, 64,
                                    declare::texts(
                                        "names",
                                        "of qtm and survive: the bodies or devices that are sensors 0, 1, "
                                        "…; left out: all that there "
                                        "are, in QTM's order, or in the order in which they come"))),
              osc(), pose("room_from_tracker", "takes the tracker's coordinates to the room's")}));
}

FileKey node() {
  FileKey keys = ofSize(
      0, kMostRanks,
      tables("node", "where a rank runs and draws",
             {required(whole("rank", 0, kMostRanks, "the MPI rank, or the first of them")),
              fitting("^[A-Za-z0-9][A-Za-z0-9._-]*$",
                      text("host", "the computer's name or IPv4 address, for carom room")),
              whole("slots", 1, kMostRanks, "number of ranks, from rank on, that this entry is for", 1),
              text("display", "X display, such as :0.0")}));
  keys.rules = {{{.with = {"host"}, .without = {}}, {.with = {"display"}, .without = {}}}};
  return keys;
}

FileKey start() {
  return table(
      "start", "how carom room starts the nodes",
      {fitting("^[A-Za-z0-9][A-Za-z0-9._/,-]*$",
               text("network", "the network of MPI's messages, such as 10.0.0.0/24 or eth0; left out: any")),
       fitting("^[0-9]{4,5}-[0-9]{4,5}$", text("ports",
                                               "the TCP ports on which MPI listens, at least 16 from 1024 to "
                                               "65535, such as 47000-47099, for a "
                                               "firewall between the computers; left out: any")),
       fitting("^[A-Za-z_][A-Za-z0-9_]*(=|$)",
               declare::texts(
                   "environment",
                   "variables of every node, as NAME=VALUE, or as NAME with the value that it has here"))});
}

FileKey headset() {
  constexpr Range kBoard_px{.least = 1.0, .most = 4096.0};
  return table("headset",
               "the displays of a headset, by OpenXR, in the place of walls, trackers, head and hand",
               {required(table(
                   "board", "stands in the room and carries words and choices",
                   {required(corner("lower_left", "a corner as seen from the front")),
                    required(corner("lower_right", "another")), required(corner("upper_left", "the third")),
                    pixels("pixels", kBoard_px, "how finely it is written", {1280.0, 800.0})}))});
}

FileKey mesh(std::string_view name, std::string_view sentence) {
  return fitting("\\.(pfm|obj|csv|xml|simcad|sgc|data|vwf)$", text(name, sentence));
}

/// Returns the keys of a projector.
Keys projectorKeys() {
  constexpr Range kGain{.least = 0.0, .most = 1.0, .above = true};
  constexpr Range kGamma{.least = 1.0, .most = 4.0};
  constexpr std::string_view kTogether =
      "such a mesh for this colour alone, for projectors whose colours do not lie upon each other; the "
      "meshes of the "
      "colours come all three or not at all, and then without warp";
  return {
      mesh("warp",
           "mesh that bends the picture to the screen: a PFM or OBJ as SGCT reads them, .csv of "
           "domeprojection, .xml or .simcad of SimCAD, .sgc of SCISS, .data of Paul Bourke, .vwf of VIOSO"),
      mesh("warp_red", kTogether),
      mesh("warp_green", kTogether),
      mesh("warp_blue", kTogether),
      fitting(
          "\\.(png|jpe?g|tiff?|vwf)$",
          text("blend",
               "picture (.png, .tif, .jpg, or that in a .vwf), stretched over the window: the share of light "
               "that passes at each place, where projectors overlap; left out: that of a .vwf of its warp "
               "or screen")),
      number("black_level", kShare,
             "the light to which black is lifted, as a share of the brightest; give all projectors of a "
             "screen that of "
             "the projector with the brightest black",
             0.0),
      numbers("gain", 3, kGain,
              "red, green and blue light of white, as shares of the brightest, above black_level, so that "
              "the whites of "
              "several projectors look alike",
              {1.0, 1.0, 1.0}),
      numbers("gamma", 3, kGamma,
              "of the projector, for red, green and blue: its light is code^gamma; left out: sRGB"),
      choice("flip", kFlips, "how the projector mirrors the picture", 0),
      number("display_latency_ms", kLatency_ms,
             "from the swap to the photons; where walls differ, by at most 100 ms, the pictures of the "
             "faster ones wait "
             "by whole frames",
             0.0)};
}

FileKey wall() {
  FileKey placed = window("window", "where it is shown; left out: in a window of its own size", false);
  placed.keys.push_back(table("viewport",
                              "the wall's part of the window, which it shares with the walls of its node "
                              "that name the same window; left "
                              "out: all of a window of its own",
                              {pixels("position", kPlace_px, "from the window's top left", {0.0, 0.0}),
                               required(pixels("size", kSize_px, "width and height"))}));
  Keys keys{
      required(fitting(kPlainName, text("name", "unique"))),
      corner("lower_left", "corners as seen from inside the room"),
      corner("lower_right", "lower right"),
      corner("upper_left", "upper left"),
      corner("upper_right", "checked when given"),
      flag("skewed",
           "the four corners are no rectangle, as a projector throws them that stands askew: the picture is "
           "bent to "
           "them by a homography; needs upper_right, excludes warp"),
      required(pixels("pixels", kSize_px, "per eye: what is drawn and captured; the window scales it")),
      whole("node", 0, kMostRanks, "MPI rank that draws it", 0),
      placed,
      choice("stereo", kStereoModes, "how the pictures of both eyes are shown", 0),
      text("viewer", "name of the [[viewer]] whose eyes it shows"),
      ofSize(
          1, 2,
          fitting("^([A-Za-z0-9_-]+\\.)?(left|middle|right)$",
                  declare::texts(
                      "eyes",
                      "the eye in each channel of the stereo mode, such as [\"anna.left\", \"ben.left\"], or "
                      "middle for one picture for both eyes of a person; left out: left and right of the "
                      "viewer")))};
  for (FileKey& key : screenKeys()) keys.push_back(std::move(key));
  for (FileKey& key : projectorKeys()) keys.push_back(std::move(key));
  FileKey walls = ofSize(1, kMostWalls, tables("wall", "a screen", std::move(keys)));
  walls.rules = {
      {{.with = {"lower_left", "lower_right", "upper_left"}, .without = {"screen", "sky"}},
       {.with = {"screen"},
        .without = {"lower_left", "lower_right", "upper_left", "upper_right", "skewed", "sky"}},
       {.with = {"sky"},
        .without = {"lower_left", "lower_right", "upper_left", "upper_right", "skewed", "screen"}}}};
  return walls;
}

FileKey comfort() {
  return table("comfort", "what the room spares its visitors",
               {fastestBeta("the drive makes the room no faster than this part of the speed of light; a "
                            "scenario may set a lower limit"),
                flag("aids",
                     "while the room moves, the edges of sight darken and a frame that rests in the room is "
                     "shown (key J)")});
}

FileKey link() {
  constexpr Range kApart_m{.least = 0.0, .most = 100.0}, kReach_m{.least = 0.3, .most = 1.2};
  constexpr Range kGone_s{.least = 2.0, .most = 60.0};
  return table(
      "link", "another room, elsewhere, that plays at the same table",
      {required(ofLetters(24, text("name", "of this room, as the other one is told"))),
       required(
           text("key",
                "the file of the key that both rooms share, beside the rig; carom link --new-key makes it")),
       text("with",
            "listen:PORT or listen:ADDRESS:PORT to wait for the other room, or HOST or HOST:PORT to call it; "
            "--link says otherwise; left out: no link without --link"),
       inUnit("m", orOneOf({"auto"},
                           number("apart_m", kApart_m,
                                  "how much farther apart the rooms stand than the scenario has them, if "
                                  "this room is called; auto: as far as the line needs"))),
       inUnit("m", number("reach_m", kReach_m,
                          "how far from the head a hand strikes and is seen by the other room", 0.8)),
       inUnit("s", number("gone_s", kGone_s, "after this time without news the other room is gone", 6.0))});
}

FileKey classroom() {
  constexpr int kMostPort = 65535;
  return table("class", "where phones find the pages of --class and --study",
               {text("address",
                     "of this computer, in numbers; left out: that in the network of its default route; "
                     "--class-address says otherwise"),
                whole("port", 0, kMostPort, "0: any that is free; --class-port says otherwise", 8080)});
}

}  // namespace

const FileKey& rigKeys() {
  constexpr Range kDisplay_hz{.least = 1.0, .most = 1000.0};
  static const FileKey keys = [&] {
    FileKey rig = table(
        "rig", "Carom rig",
        {text("title", "for people"),
         required(choice("unit", kLengthUnits, "of every length in this file")),
         required(choice("axes", {"x-right y-up z-back", "x-right y-forward z-up"},
                         "of the room; a headset has the first")),
         number("display_hz", kDisplay_hz, "refreshes of the displays in a second", 60.0),
         choice("frame_lock", kFrameLocks,
                "holds the nodes' swaps together: their messages alone, or also the graphics cards "
                "(GLX_NV_swap_group with sync cards)",
                0),
         start(),
         window("one_window",
                "left out: a window for every wall. Given: the only window of each node, and each wall's "
                "window is a "
                "place inside it",
                false),
         comfort(),
         spacetimeKey(true),
         languageKey(
             "of the words on walls and in windows: a code that carom list tells, such as fr, or a PO file "
             "beside the rig; left out: the first of languages, else English; --language says otherwise"),
         languagesKey(
             "those through which a tile on the front wall and key F9 go; a playlist may have others"),
         text("playlist",
              "the games that may be played in this room: a playlist file, beside the rig, or the name of a "
              "shipped "
              "one"),
         table("console", "where the operator's console is on node 0's display when --console opens it",
               {required(window("window", "its window", true))}),
         link(),
         classroom(),
         headset(),
         table("head", "the tracked head, of the one viewer of a room for one", withHead({})),
         hand(),
         viewer(),
         tracker(),
         node(),
         wall(),
         panelKey()});
    const std::vector<std::string_view> ofRooms{"head", "hand", "viewer",     "tracker",
                                                "wall", "node", "frame_lock", "panel"};
    rig.rules = {{{.with = {"tracker", "wall", "head"}, .without = {"viewer", "headset"}},
                  {.with = {"tracker", "wall", "viewer"}, .without = {"head", "hand", "headset"}},
                  {.with = {"headset"}, .without = ofRooms}}};
    return rig;
  }();
  return keys;
}

}  // namespace carom
