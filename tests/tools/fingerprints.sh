#!/usr/bin/env bash
# fingerprints.sh [COMPILER …]: prints the fingerprint of the arithmetic (engine/linked/final_digest.h) as each compiler builds
# it, by -O2, by -O3, and by -O3 with all that this processor can do, and says whether all are equal. Linked rooms whose
# fingerprints differ do not play together. Takes some minutes a compiler; run it by hand. JOBS=N: so many at once.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
[ $# -gt 0 ] || set -- g++-12 clang++-19
cat >"$out/main.cpp" <<'CODE'
#include <cinttypes>
#include <cstdio>

#include "engine/linked/final_digest.h"
int main() { std::printf("%016" PRIx64 "\n", carom::arithmeticFingerprint()); }
CODE
for compiler in "$@"; do
  for options in "-O2" "-O3" "-O3 -march=native"; do
    rm -f "$out"/*.o
    ls "$root"/engine/{base,spacetime,light,collision,soft,billiard}/*.cpp "$root/engine/linked/final_digest.cpp" "$out/main.cpp" |
      xargs -P "${JOBS:-1}" -I SOURCE sh -c "$compiler -std=c++20 -DNDEBUG -ffp-contract=off $options -I'$root' -w -c SOURCE \
        -o '$out'/\$(echo SOURCE | tr / -).o"
    "$compiler" "$out"/*.o -o "$out/print" -lfmt -ltbb
    printf '%-12s %-20s %s\n' "$compiler" "$options" "$("$out/print")" | tee -a "$out/all"
  done
done
[ "$(awk '{print $NF}' "$out/all" | sort -u | wc -l)" -eq 1 ] && echo "all are equal"
