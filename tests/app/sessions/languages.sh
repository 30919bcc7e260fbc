#!/usr/bin/env bash
# languages.sh CAROM CONFIG: who reads which language. Key F9 goes to the next one in the next frame, and the next visitor
# begins with the first; the session file, its replay and the status file have it. Two people read two languages, on 1 and on
# 4 processes with the same pictures, again in a replay and in a replay as either. A session in French has the rows of one in
# English, but for the language. Wrong names are refused before anything starts.
. "$(dirname "$0")/../../session.sh"
needs xdotool sqlite3
quietly() { "$@" 2>"$out/stderr" || fail "$*"; }
rows() { [ -s "$1" ] && sqlite3 -cmd '.timeout 5000' "$1" "$2" 2>/dev/null; }
small='s/^pixels = .*/pixels = [64, 64]/'
session="SELECT group_concat(key || '=' || value, ' ') FROM (SELECT * FROM session WHERE key LIKE 'language%' ORDER BY key)"

# Wrong names.
wrong() { # WORDS STATUS ARGUMENTS…
  local words=$1 expected=$2 status=0
  shift 2
  "$carom" "$@" >/dev/null 2>"$out/stderr" || status=$?
  [ "$status" -eq "$expected" ] || fail "$*: ended with $status, expected $expected"
  grep -qF -- "$words" "$out/stderr" || fail "$*: '$words' is not said"
}
for command in "cave" "replay none.db" "diagram twins -o $out/d.svg" "page twins -o $out/p.html" "check desk --pattern"; do
  wrong "'../fr' is no language, expected a code" 2 $command --language ../fr
  wrong "there is no file '$out/gone.po', expected a PO file" 2 $command --language "$out/gone.po"
done
sed '1i language = "f r"' "$config/rigs/desk.toml" >"$out/wrong.toml"
wrong "error: $out/wrong.toml:1:12: 'f r' is no language" 1 cave --rig "$out/wrong.toml" --frames 1 --no-window
wrong "error: $out/wrong.toml:1:12: 'f r' is no language" 1 check "$out/wrong.toml"
sed '1i languages = ["fr", "en"]' "$config/rigs/desk.toml" >"$out/right.toml"
quietly "$carom" check "$out/right.toml" >"$out/told"
grep -qx "languages: fr, en; the front wall has a tile for the next one" "$out/told" || fail "check does not tell the languages"

# The same rows.
sed "$small" "$config/rigs/desk.toml" >"$out/desk.toml"
for language in en fr de ja; do
  quietly "$carom" cave --rig "$out/desk.toml" --scenario welcome --frames 30 --language $language \
    --session "$out/$language.db" --no-window --status "$out/$language.json"
  [ "$(rows "$out/$language.db" "$session")" = "language=$language" ] || fail "$(rows "$out/$language.db" "$session")"
  grep -q "\"language\": \"$language\"" "$out/$language.json" || fail "the status does not tell $language"
  sqlite3 "$out/$language.db" .dump | grep -vE "INTO (session|run|game) VALUES" >"$out/$language.sql"
  cmp "$out/en.sql" "$out/$language.sql" || fail "a session in $language has other rows than one in English"
done

# Two people.
sed "$small" "$config/rigs/desk-two.toml" |
  awk '/^title/ { print "languages = [\"fr\", \"en\"]" } { print } /^name = "ben"/ { if (!n) print "language = \"ja\""; n = 1 }
       /^stereo =/ { print "node = " walls++ % 4 }' >"$out/two.toml"
for ranks in 1 4; do
  quietly "${mpi[@]}" -n "$ranks" "$carom" cave --rig "$out/two.toml" --frames 4 --session "$out/two-$ranks.db" \
    --capture "$out/two-$ranks" --status "$out/two.json" --no-window
  quietly "${mpi[@]}" -n "$ranks" "$carom" replay "$out/two-$ranks.db" --capture "$out/again-$ranks" --no-window
done
[ "$(rows "$out/two-1.db" "$session")" = "language.anna=fr language.ben=ja language_1=fr language_2=en language_3=ja" ] ||
  fail "two people: $(rows "$out/two-1.db" "$session")"
[ "$(rows "$out/two-1.db" "SELECT DISTINCT frame.language || other_viewer.language || languages_on_tile FROM frame, other_viewer")" = 023 ] ||
  fail "the frames of two people"
for words in '"language.anna": "fr"' '"language.ben": "ja"'; do
  grep -qF "$words" "$out/two.json" || fail "the status of two people: $(cat "$out/two.json")"
done
for other in two-4 again-1 again-4; do
  diff -r "$out/two-1" "$out/$other" || fail "the pictures of two people differ: $other"
done
for name in anna ben; do
  quietly "$carom" replay "$out/two-1.db" --as $name --capture "$out/as-$name" --no-window
  for picture in "$out/as-$name"/*.png; do
    cmp "$picture" "$out/two-1/$(basename "$picture")" || fail "as $name a replay differs from what $name saw"
  done
done
quietly "$carom" replay "$out/two-1.db" --language de --capture "$out/german" --no-window
[ "$(find "$out/german" -name '*.png' | wc -l)" -eq "$(find "$out/two-1" -name '*.png' | wc -l)" ] ||
  fail "a replay in another language has other pictures"

# It goes on in the language that was read, with the numbers that it had.
quietly "$carom" cave --resume --session "$out/two-1.db" --frames 2 --no-window
quietly "$carom" cave --resume --session "$out/two-1.db" --frames 2 --no-window --language de
[ "$(rows "$out/two-1.db" "SELECT group_concat(language, '') FROM (SELECT language FROM frame ORDER BY number)")" = 00000033 ] ||
  fail "a session that goes on: $(rows "$out/two-1.db" "SELECT group_concat(language, '') FROM frame")"
[ "$(rows "$out/two-1.db" "SELECT value FROM session WHERE key = 'language_4'")" = de ] || fail "a language that was added"

# The key.
sed '1i languages = ["fr", "en", "ja"]' "$config/rigs/play.toml" >"$out/play.toml"
db=$out/visit.db
await() { # WHAT SQL VALUE
  for _ in $(seq 900); do
    [ "$(rows "$db" "$2")" = "$3" ] && return
    kill -0 "$job" 2>/dev/null || fail "$1: the session has ended"
    sleep 0.1
  done
  fail "$1: '$(rows "$db" "$2")', expected '$3'"
}
newest() { echo "SELECT $1 FROM frame ORDER BY number DESC LIMIT 1"; }
"$carom" cave --rig "$out/play.toml" --silent --session "$db" 2>"$out/stderr" &
job=$!
await "the session begins" 'SELECT count(*) > 5 FROM frame' 1
await "the first language" "$(newest language)" 0
press F9 screen
await "the second one" "$(newest language)" 1
press F9 screen
await "the third one" "$(newest language)" 2
await "both are kept" "SELECT group_concat(value) FROM (SELECT value FROM input WHERE what = 'language' ORDER BY frame)" en,ja
[ "$(rows "$db" "SELECT count(*) FROM input JOIN frame ON number = frame WHERE what = 'language' AND language = (value = 'ja') + 1")" = 2 ] ||
  fail "a language does not change with the frame of its key"
press F7 screen
await "another game" 'SELECT count(*) FROM game' 2
await "another game keeps the language" "$(newest language)" 2
press F8 screen
await "the next visitor" 'SELECT count(*) FROM game' 3
await "the next visitor's language" "$(newest language)" 0
end_session screen
wait "$job" || fail "the session did not end well"
job=

db=$out/one.db
"$carom" cave --language fr --silent --session "$db" 2>"$out/stderr" &
job=$!
await "the session begins" 'SELECT count(*) > 5 FROM frame' 1
press F9 screen
await "one language" "SELECT value FROM input WHERE what = 'refused'" "This session has one language only."
await "no tile" "$(newest languages_on_tile)" 0
end_session screen
wait "$job" || fail "the session did not end well"
job=
echo "languages by key, by viewer, in the file, on 1 and 4 processes and again"
