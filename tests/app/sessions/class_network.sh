#!/usr/bin/env bash
# class_network.sh CAROM CONFIG: the Wi-Fi of a class goes away and comes back (class_network.py), in a network of the test's
# own, whose only address is taken away. Left out where no such network can be made.
. "$(dirname "$0")/../../session.sh"
needs python3 ip unshare
unshare -rn true 2>/dev/null || { echo "skipped: this machine lets nobody make a network of their own"; exit 77; }
sed -e 's/^pixels = .*/pixels = [96, 54]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
# One process without the launcher of MPI, which wants a network that leads somewhere.
OMPI_MCA_ess_singleton_isolated=1 unshare -rn python3 "$(dirname "$0")/class_network.py" "$carom" "$config" "$out" || fail "the class's network"
