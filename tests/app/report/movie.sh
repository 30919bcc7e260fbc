#!/usr/bin/env bash
# movie.sh CAROM CONFIG: the movie of a session has its frames, looks as its pictures do, is one for each node, and is
# made again from the session file and whole where a picture cannot be written; without ffmpeg nothing begins.
. "$(dirname "$0")/../../session.sh"
facts() { # FILE: size, rate and number of frames
  ffprobe -loglevel error -count_frames -select_streams v:0 -show_entries \
    stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 "$1"
}
like() { # MOVIE FRAME PICTURE X Y: in dB, the frame's part at X, Y against the picture
  ffmpeg -nostdin -hide_banner -i "$1" -i "$3" -filter_complex \
    "[0:v]select=eq(n\\,$2),setpts=0,crop=200:200:$4:$5,format=rgb24[a];[1:v]setpts=0,format=rgb24[b];[a][b]psnr" \
    -frames:v 1 -f null - 2>&1 | sed -n 's/.*average:\([0-9.]*\).*/\1/p'
}
alike() { # NAME MOVIE FRAME PICTURE X Y
  local psnr_dB
  psnr_dB=$(like "${@:2}")
  awk -v psnr="${psnr_dB:-0}" 'BEGIN { exit !(psnr > 28) }' || fail "$1: ${psnr_dB:-no} dB, expected over 28 dB"
}

sed 's/^pixels = .*/pixels = [200, 200]/' "$config/rigs/desk.toml" >"$out/desk.toml"
sed 's/^pixels = .*/pixels = [200, 200]/' "$config/rigs/four-walls-cluster.toml" >"$out/cluster.toml"

"$carom" cave --rig "$out/desk.toml" --frames 6 --capture "$out/seen" --movie "$out/desk.mp4" --session "$out/game.db" \
  --no-window 2>"$out/stderr" || fail "the session: $(cat "$out/stderr")"
grep -qF "The movie is in $out/desk.mp4." "$out/stderr" || fail "it does not say where the movie is: $(cat "$out/stderr")"
[ "$(facts "$out/desk.mp4")" = "600,400,60/1,6" ] || fail "walls as in the window: $(facts "$out/desk.mp4")"
alike "the front wall" "$out/desk.mp4" 4 "$out/seen/front-left-000004.png" 200 0
alike "the floor" "$out/desk.mp4" 5 "$out/seen/floor-left-000005.png" 200 200
other=$(like "$out/desk.mp4" 4 "$out/seen/right-left-000004.png" 200 0)
awk -v psnr="$other" 'BEGIN { exit !(psnr < 25) }' || fail "another wall looks the same: $other dB"

"$carom" replay "$out/game.db" --movie "$out/again.mp4" --no-window 2>"$out/stderr" || fail "replay: $(cat "$out/stderr")"
[ "$(facts "$out/again.mp4")" = "600,400,60/1,6" ] || fail "the replay's movie: $(facts "$out/again.mp4")"

mkdir -p "$out/live/front-left-000000.png" # in real time: this picture cannot be written, the movie goes on
"$carom" replay "$out/game.db" --capture "$out/live" --movie "$out/live.mp4" 2>"$out/stderr"
[ $? -eq 1 ] || fail "pictures are missing, expected exit status 1: $(cat "$out/stderr")"
[ "$(grep -c "^error: .*front-left-000000.png" "$out/stderr")" = 1 ] || fail "what is missing, once: $(cat "$out/stderr")"
grep -qF "The movie is in $out/live.mp4." "$out/stderr" && [ -s "$out/live.mp4" ] ||
  fail "no movie where a picture cannot be written: $(cat "$out/stderr")"

mpirun --allow-run-as-root --oversubscribe -n 2 "$carom" cave --rig "$out/cluster.toml" --frames 5 --no-window \
  --movie "$out/cave.webm" 2>"$out/stderr" || fail "two nodes: $(cat "$out/stderr")"
for rank in 0 1; do
  [ "$(facts "$out/cave-node$rank.webm")" = "400,200,60/1,5" ] || fail "node $rank: $(facts "$out/cave-node$rank.webm")"
done

"$carom" cave --frames 1 --no-window --movie "$out/cave.avi" 2>"$out/stderr"
[ $? -eq 2 ] && grep -q "expected a name that ends in .mp4, .webm or .ogv" "$out/stderr" || fail "an unknown kind of movie"
mkdir "$out/bin"
ln -s /usr/bin/* "$out/bin" # all but one
rm "$out/bin/ffmpeg"
PATH=$out/bin "$carom" cave --frames 1 --no-window --movie "$out/none.mp4" 2>"$out/stderr"
[ $? -eq 1 ] && grep -q "error: movie $out/none.mp4: the program ffmpeg, which encodes it, is not installed" "$out/stderr" ||
  fail "no ffmpeg: $(cat "$out/stderr")"
[ -z "$(find "$out" -name '*.partial' -o -name 'none*')" ] || fail "something was left behind: $(ls "$out")"
echo "six frames at 600 x 400, the same from the session file, five on each of two nodes"
