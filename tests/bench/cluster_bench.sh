#!/usr/bin/env bash
# cluster_bench.sh [PROGRAM]: sharing a frame and swapping together, with 1, 2, 4 and 5 ranks on this machine.
set -euo pipefail
program=${1:-"$(dirname "$(readlink -f "$0")")/../../build/release/bin/cluster_bench"}
for ranks in 1 2 4 5; do
  mpirun --allow-run-as-root --oversubscribe -n "$ranks" "$program"
done
