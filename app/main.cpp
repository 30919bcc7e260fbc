// carom: a billiard at a light speed of walking pace, played, looked at and walked into.

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string>
#include <system_error>

#include "app/files/toml_file.h"
#include "engine/base/log.h"
#include "options.h"

namespace {

/// Bad input and what else can go wrong while a command runs: status 1.
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
  CLI::App app("carom: billiards where light is slow, shown as special relativity says it would look.",
               "carom");
  int status = 0;
  carom::addCommands(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    return report(error);
  }
  return status;
}
