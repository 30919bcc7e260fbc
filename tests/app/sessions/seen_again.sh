#!/usr/bin/env bash
# seen_again.sh CAROM CONFIG: a session that ends by an error says how its end is seen again, and that command shows it:
# the session's own pictures, from that second on.
. "$(dirname "$0")/../../session.sh"
sed 's/^pixels = .*/pixels = [64, 36]/' "$config/rigs/single-screen.toml" >"$out/room.toml"
mkdir -p "$out/broken/screen-mono-000005.png" # this picture cannot be written
"$carom" cave --rig "$out/room.toml" --session "$out/game.db" --frames 300 --no-window --capture "$out/broken" \
  2>"$out/stderr" && fail "a session that cannot write its pictures ended well"
grep -q '^error: picture .* cannot be written' "$out/stderr" || fail "no reason: $(cat "$out/stderr")"
read -r _ _ file _ at_s < <(grep -E '^carom replay [^ ]+ --at [0-9]+\.[0-9]{3}$' "$out/stderr") ||
  fail "no word on how to see it again: $(cat "$out/stderr")"
[ "$file" = "$out/game.db" ] || fail "it names the file $file"
last=$(sqlite3 "$file" "SELECT max(number) FROM frame")
"$carom" replay "$file" --no-window --capture "$out/all" 2>"$out/stderr" || fail "replay: $(cat "$out/stderr")"
"$carom" replay "$file" --at "$at_s" --no-window --capture "$out/end" 2>"$out/stderr" || fail "its end: $(cat "$out/stderr")"
from=$(sqlite3 "$file" "SELECT max(number) FROM frame WHERE display_s <= $at_s")
[ "$from" -ge $((last - 2)) ] || fail "$at_s s is frame $from, the last is $last"
"$carom" replay "$file" --at 0.05 --no-window --capture "$out/middle" 2>"$out/stderr" || fail "from 0.05 s: $(cat "$out/stderr")"
for folder in end middle; do
  begins=$from
  [ "$folder" = end ] || begins=$(sqlite3 "$file" "SELECT max(number) FROM frame WHERE display_s <= 0.05")
  pictures=$(find "$out/$folder" -name '*.png' | wc -l)
  [ "$pictures" -eq $((last - begins + 1)) ] || fail "$folder: $pictures pictures from frame $begins to $last"
  for picture in "$out/$folder"/*.png; do
    cmp "$picture" "$out/all/$(basename "$picture")" || fail "$folder: other pictures than the session's"
  done
done
echo "ended in frame $last, its end seen again from $at_s s"
