#!/usr/bin/env bash
# Builds the Python package of src/python, installs it with NumPy and Matplotlib (from PyPI) into a folder of its own, and
# holds what it gives against the program:
#
#   cargo build --release
#   tests/tools/check_python.sh target/release/sinew
#
# Without the program nothing is held against it. PYTHON_HOME is that folder, to be kept for the next time;
# MATURIN_PEP517_ARGS="--profile dev" builds quickly and runs slowly.
set -euo pipefail

binary=${1:+$(realpath "$1")}
cd "$(dirname "$0")/../.."
home=${PYTHON_HOME:-$(mktemp -d)}
mkdir -p "$home"
if [ ! -x "$home/venv/bin/python" ]; then
  python3 -m venv "$home/venv"
  "$home/venv/bin/pip" install --quiet numpy matplotlib
fi
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$home/target}
# What is checked is what is locked.
export MATURIN_PEP517_ARGS="${MATURIN_PEP517_ARGS:-} --locked"
"$home/venv/bin/pip" install --quiet --force-reinstall --no-deps ./src/python
SINEW=$binary "$home/venv/bin/python" -m unittest -v tests/tools/check_python.py
"$home/venv/bin/python" src/python/examples/swinging.py "$home/swinging.png"
