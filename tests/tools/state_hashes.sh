#!/usr/bin/env bash
# Hashes of the state of every body of every shipped scene after a twentieth of a second, one scene a line. What leaves them
# as they were changes no motion:
#
#   tests/tools/state_hashes.sh target/release/sinew > before.txt
#   (change the code, build again)
#   tests/tools/state_hashes.sh target/release/sinew | diff before.txt -
#
# With --window first, the tests of what the window shows run too, and their hashes follow: of scenes that were edited by
# pointer and keys, each the same as that of a run without the window. This builds the tests.
#
# Hashes are to be compared on one machine only. Further arguments name the scenes; SECONDS_RUN is the time that is
# simulated [s], CARGO the cargo that is called.
set -euo pipefail

window=
if [ "${1:-}" = --window ]; then
  window=yes
  shift
fi
binary=$(realpath "${1:?usage: state_hashes.sh [--window] BINARY [SCENE...]}")
shift
cd "$(dirname "$0")/../.."
export binary seconds=${SECONDS_RUN:-0.05}

hash_scene() {
  local report
  report=$(mktemp)
  "$binary" simulate "$1" --seconds "$seconds" --threads 1 --report "$report" >/dev/null 2>&1 || echo "$1 failed"
  echo "$1" $(grep -o '"state_hash": *"[0-9a-f]*"' "$report" | grep -o '[0-9a-f]\{16\}')
  rm -f "$report"
}
export -f hash_scene

if [ $# -eq 0 ]; then set -- scenes/*.json; fi
printf '%s\n' "$@" | xargs -P "$(nproc)" -I{} bash -c 'hash_scene {}' | sort

if [ -n "$window" ]; then
  shown=$("${CARGO:-cargo}" test --locked --test window -- --test-threads 1 --nocapture hashes:: 2>/dev/null) ||
    { echo "window failed"; exit 1; }
  grep -o 'state_hash window/[a-z-]* [0-9a-f]\{16\}' <<<"$shown" | sed 's/^state_hash //' | sort
fi
