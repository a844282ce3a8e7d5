#!/bin/sh
# The bank: every bench whose answer is known, diagnosed and scored by one command.
#   trial/bank/replay.sh [PLUMBLINE] [FOLDER]
# Writes FOLDER (out/bank): the benches of the second maker, a trial folder and a report for each set, and prints the tables.
# The sets never change: what is tuned on them is judged on seeds that are named before they are run (RESULTS-second.md).
set -eu
here=$(dirname "$0")
plumbline=${1:-build/plumbline}
out=${2:-out/bank}
mkdir -p "$out"
[ -d "$out/second-maker" ] || python3 "$here/foreign.py" "$out/second-maker" 10 4711
set_of() {
  name=$1
  shift
  echo "== $name"
  "$plumbline" trial "$@" --json "$out/$name.json" --markdown "$out/$name.md"
}
set_of first --trials 100 --seed 2031
set_of second --second --trials 100 --seed 22017
set_of committed --experiments "$here/../../tests/experiments"
set_of second-maker --experiments "$out/second-maker"
