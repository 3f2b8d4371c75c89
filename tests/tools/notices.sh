#!/usr/bin/env bash
# Writes what has to go along with a program that is passed on: the licences of all that is built into it, fonts included.
# A test of tests/house holds it complete.
#
#   tests/tools/notices.sh FILE
set -euo pipefail
case "${1:?usage: notices.sh FILE}" in /*) SINEW_NOTICES=$1 ;; *) SINEW_NOTICES=$PWD/$1 ;; esac
export SINEW_NOTICES
cd "$(dirname "$0")/../.."
${CARGO:-cargo} test --locked --quiet --test house notices
