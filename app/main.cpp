// carom: a billiard at a light speed of walking pace, played, looked at and walked into.

#include <exception>

#include <fmt/format.h>

#include "app/toml/toml_file.h"
#include "cave/mesh_input/vtk_messages.h"
#include "engine/text/log.h"
#include "options.h"

namespace {

/// Logs an error of a command and returns exit status 1.
int report(const std::exception& error) {
  if (const auto* faults = dynamic_cast<const carom::InputErrors*>(&error)) {
    for (const carom::InputError& fault : faults->faults()) carom::log::error(fault.what());
  } else {
    carom::log::error(error.what());
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  carom::sendVtkMessagesToLog();
  try {
    return carom::runCommandLine(argc, argv);
  } catch (const std::exception& error) {
    return report(error);
  }
}
