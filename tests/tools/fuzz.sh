#!/usr/bin/env bash
# Reads files of any bytes for so many seconds, or so many of every target: those of tests/corpus, changed by chance, by
# everything that reads. What panics, takes longer than two seconds or never ends is told and its input kept; a table of
# how many were read, and how many a second, ends it.
#
#   tests/tools/fuzz.sh SECONDS|INPUTSx [TARGET [SEED]]
#   tests/tools/fuzz.sh 1000000x
#
# Targets stand in tests/hostile/fuzz.rs; without one, or with "all", each has its turn. CARGO is the cargo that is called,
# PROFILE=--release (unless given otherwise) how the program is built, SINEW_FUZZ_THREADS on how many threads it runs.
set -euo pipefail
cd "$(dirname "$0")/../.."
SINEW_FUZZ="${1:?usage: fuzz.sh SECONDS|INPUTSx [TARGET [SEED]]} ${2:-all} ${3:-1}" \
  ${CARGO:-cargo} test --locked ${PROFILE---release} --test hostile -- --ignored --exact fuzz::for_any_time --nocapture
