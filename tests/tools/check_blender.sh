#!/usr/bin/env bash
# Takes a mesh through sinew and back in Blender itself, as the Python package `bpy` (from PyPI, for Python 3.11), which is installed
# into a folder of its own: by the add-on of assets/blender as a Mesh Cache on the same mesh, and by USD.
#
#   cargo build --release
#   tests/tools/check_blender.sh target/release/sinew
#
# READERS is that folder, to be kept for the next time; PYTHON a Python 3.11.
set -euo pipefail

binary=$(realpath "${1:?usage: check_blender.sh BINARY}")
cd "$(dirname "$0")/../.."
readers=${READERS:-$(mktemp -d)}
mkdir -p "$readers"
if [ ! -x "$readers/blender/bin/python" ]; then
  "${PYTHON:-python3.11}" -m venv "$readers/blender"
  "$readers/blender/bin/pip" install --quiet bpy==4.2.0 numpy
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$readers/blender/bin/python" tests/tools/check_blender.py "$binary" "$work"
