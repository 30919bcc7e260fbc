// Writes the shipped trace of a simulated person: make_walk_trace FILE.

#include <cstdio>
#include <exception>

#include "devices/tracker/trace.h"
#include "devices/walk_trace.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_walk_trace FILE\n", stderr);
    return 2;
  }
  try {
    carom::TraceWriter writer(argv[1], true,
                              "A simulated person in a room with axes x-right y-up z-back, metres, 60 Hz,\n"
                              "tracker noise 0.3 mm: stands five seconds facing the front wall (-z), shifts\n"
                              "from foot to foot, then walks about and looks around.");
    for (const carom::TrackerSample& sample : carom::walkTrace()) writer.add(sample);
    writer.commit();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
