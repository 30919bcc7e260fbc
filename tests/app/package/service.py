"""service.py CAROM FOLDER: the shipped unit (config/systemd/carom.service) begins again after any end, and the program
knows every option that it gives."""

import configparser
import pathlib
import re
import subprocess
import sys

carom, folder = sys.argv[1], pathlib.Path(sys.argv[2])
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


unit = configparser.ConfigParser(interpolation=None, strict=True)
unit.optionxform = str
unit.read(folder / "carom.service")
service = unit["Service"]
expect(service["Restart"] == "always", f"Restart={service['Restart']}, expected always: a visitor's end is an end, too")
expect(0 < float(service["RestartSec"]) <= 10, f"RestartSec={service['RestartSec']}, expected up to 10 s")
# Otherwise systemd gives up after five ends in a short time.
expect(unit["Unit"].get("StartLimitIntervalSec") == "0", "StartLimitIntervalSec is not 0: it gives up after some ends")
expect(unit["Install"]["WantedBy"] == "graphical-session.target", "it does not begin with the desktop")
program, command, *options = service["ExecStart"].split()
expect((program, command) == ("/usr/bin/carom", "cave"), f"it starts {program} {command}")
expect("--unattended" in options, "it does not put everything back for the next visitor")
known = subprocess.run([carom, command, "--help"], capture_output=True, text=True, check=True).stdout
for option in options:
    if option.startswith("--"):
        expect(re.search(rf"{option}\b", known), f"the program has no option {option}")
for failure in failures:
    print("FAILED:", failure)
sys.exit(1 if failures else 0)
