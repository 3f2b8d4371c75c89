#!/usr/bin/env bash
# How long each test program ran, slowest first, out of what `cargo test` says:
#
#   cargo test 2>&1 | tee test.log; tests/tools/test_times.sh < test.log
#
# Builds are not counted. BUDGET is what all of them together should stay within [s]; what goes beyond it is told, no more:
# a time depends on the machine.
set -euo pipefail

awk -v budget="${BUDGET:-300}" '
  { gsub(/\033\[[0-9;]*m/, "") }
  / Running / { name = $2 == "unittests" ? $3 : $2 }
  / Doc-tests / { name = "doc-tests" }
  /^test result: .* finished in / {
    seconds = $NF
    sub(/s$/, "", seconds)
    if (!(name in spent)) { programs++ }
    spent[name] += seconds
    tests[name] += $4
    sum += seconds
  }
  END {
    if (!programs) { print "no test program ran"; exit }
    printf "\n%-32s %7s %9s\n", "test program", "tests", "seconds"
    sort = "sort -k3,3 -n -r"
    for (name in spent) { printf "%-32s %7d %9.1f\n", name, tests[name], spent[name] | sort }
    close(sort)
    printf "%-32s %7s %9.1f of %d\n", "together", "", sum, budget
    if (sum > budget) { printf "warning: the tests ran for %.0f s, %.0f s more than their budget\n", sum, sum - budget }
  }
'
