#!/usr/bin/env bash
# force_session.sh CAROM CONFIG [PICTURES]: a stroke with a simulated force device in a real window. The mouse draws, the
# device pulls back; the session file has places and forces, the draw, the blows that were seen; the replay shows the
# same pictures, and no device. With PICTURES, screenshots are left there to be looked at.
. "$(dirname "$0")/../../session.sh"
needs xdotool ffmpeg python3
python3 "$(dirname "$0")/force_session.py" "$1" "$2" "$out" "${3:-$out}"
