#!/usr/bin/env bash
# package.sh BUILD_DIRECTORY: an installed carom uses the files that were installed with it, not the sources', and the
# Debian package holds what it needs and asks for the libraries that it is linked to.
set -euo pipefail
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
fail() { echo "FAILED: $*"; status=1; }

DESTDIR=$work cmake --install "$build" --component program --prefix /usr >"$work/log" || { cat "$work/log"; exit 1; }
carom=$work/usr/bin/carom
share=$work/usr/share/carom
for file in bin/carom lib/carom/libcarom_report.so lib/carom/libcarom_meshes.so lib/carom/libcarom_pictures.so share/carom/rig.schema.json share/carom/scenario.schema.json share/carom/playlist.schema.json share/carom/study.schema.json share/carom/items.schema.json share/carom/studies/items.toml share/carom/studies/analyse.R share/doc/carom/app/doc/keys-of-rigs.md share/carom/rigs/desk.toml share/carom/traces/walk.csv \
  lib/udev/rules.d/70-carom.rules lib/systemd/user/carom.service lib/systemd/user/carom-room.service share/applications/carom.desktop share/man/man1/carom.1.gz share/doc/carom/copyright share/doc/carom/README.md \
  share/carom/models/train.obj share/carom/walls/xinitrc share/carom/walls/carom-walls@.service; do
  [ -s "$work/usr/$file" ] || fail "$file is not installed"
done
for page in "$(dirname "$0")"/../../../app/doc/*.md "$(dirname "$0")"/../../../app/doc/*.html "$(dirname "$0")"/../../../app/pictures/*.png; do
  page=share/doc/carom/app/$(basename "$(dirname "$page")")/$(basename "$page")
  [ -s "$work/usr/$page" ] || fail "$page is not installed"
done
stray=$(cd "$share" && find . -name '*.cmake' -o -name build -o -name install-packages -o -name "packages*.txt" -o -name udev -o -name desktop -o -name systemd)
[ -z "$stray" ] || fail "of no use once installed: $stray"

# Installed files that the sources do not have: only from the prefix can the program know them.
cd "$work"
sed -i 's/^title = .*/title = "Of the prefix"/' "$share/scenarios/three-pucks.toml" "$share/rigs/desk.toml"
for name in three-pucks desk; do
  said=$("$carom" check "$name" 2>&1) || fail "check $name: $said"
  grep -q "^Of the prefix: " <<<"$said" || fail "check $name read another file: $said"
done
grep -qF "$share/rigs/play.toml" <<<"$("$carom" cave --help)" || fail "the usual rig is not the installed one"
said=$("$carom" diagram three-pucks -o chart.svg 2>&1) && [ -s chart.svg ] || fail "the installed program draws no chart: $said"
mv "$share/traces/walk.csv" "$share/traces/moveUnseen.csv"
! said=$("$carom" check desk 2>&1) || fail "the rig's trace came from elsewhere: $said"
grep -qF "expected one beside this file or in $share" <<<"$said" || fail "of the missing trace it said: $said"
"$carom" filter moveUnseen >"$work/filtered" || fail "a trace is not found by its name"

# A file that is here goes before a shipped one of its name.
sed 's/^title = .*/title = "Of this folder"/' "$share/scenarios/three-pucks.toml" >three-pucks
said=$("$carom" check three-pucks 2>&1) || fail "check ./three-pucks: $said"
grep -q "^Of this folder: " <<<"$said" || fail "the shipped file was taken for the one here: $said"
! said=$("$carom" check no-such-name 2>&1) || fail "a name of nothing was read"
grep -q "there is no file 'no-such-name', expected" <<<"$said" || fail "of a name of nothing it said: $said"

command -v dpkg-shlibdeps >/dev/null || { echo "the package is not tried: dpkg-dev is not installed"; exit $status; }
(cd "$build" && cpack -B "$work/packages" >"$work/log") || { cat "$work/log"; exit 1; }
package=$(echo "$work"/packages/carom_*.deb)
dpkg-deb -c "$package" | awk '{print $6}' | grep -v '/$' | sort >"$work/held"
(cd "$work/usr" && find . -type f | sed 's|^\.|./usr|; s|/moveUnseen.csv$|/walk.csv|') | sort >"$work/expected"
differences=$(diff "$work/expected" "$work/held") || fail "the package (>) holds other files than an installation (<): $differences"
depends=$(dpkg-deb -f "$package" Depends)
# Debian 12 has libvtk9.1 and libopenmpi3, Debian 13 libvtk9.3 and libopenmpi40.
for library in 'libvtk9\.[0-9]' 'libopenmpi[0-9]' libglfw3 libusb-1.0-0 openmpi-bin fonts-dejavu-core; do
  grep -q "$library" <<<"$depends" || fail "the package does not ask for $library: $depends"
done
exit $status
