#!/usr/bin/env bash
# Runs some scenes into files for other programs, and reads these by the programs' own readers: Pixar's usd-core, trimesh and plyfile
# (from PyPI), Khronos' gltf-validator (from npm), which are installed into a folder of their own:
#
#   cargo build --release
#   tests/tools/check_exports.sh target/release/sinew
#
# READERS is that folder, to be kept for the next time; CARGO=cargo runs the same as a test of the suite too. Further
# arguments name the scenes.
set -euo pipefail

binary=$(realpath "${1:?usage: check_exports.sh BINARY [SCENE...]}")
shift
cd "$(dirname "$0")/../.."
readers=${READERS:-$(mktemp -d)}
mkdir -p "$readers"
if [ ! -x "$readers/venv/bin/python" ]; then
  python3 -m venv "$readers/venv"
  "$readers/venv/bin/pip" install --quiet usd-core trimesh plyfile
fi
if [ ! -d "$readers/node_modules/gltf-validator" ] && command -v npm >/dev/null; then
  npm install --silent --no-save --prefix "$readers" gltf-validator >/dev/null
fi
export NODE_PATH=$readers/node_modules SINEW_PYTHON=$readers/venv/bin/python

if [ $# -eq 0 ]; then set -- scenes/leaf.json scenes/short_bar_mesh.json scenes/two_layer_mesh.json scenes/two_layer_2d.json; fi
made=$(mktemp -d)
"$SINEW_PYTHON" tests/tools/check_exports.py --make "$made"
for scene in "$@" "$made/scene.json"; do
  out=$(mktemp -d)
  echo "$scene"
  "$binary" simulate "$scene" --seconds 0.2 --format usd,gltf,obj,ply --out "$out" >/dev/null 2>"$out/said" ||
    { cat "$out/said"; exit 1; }
  model=()
  if [ "$scene" = "$made/scene.json" ]; then model=("$made/prism.obj"); fi
  "$SINEW_PYTHON" tests/tools/check_exports.py "$out" "${model[@]}"
  rm -rf "$out"
done
rm -rf "$made"
if [ -n "${CARGO:-}" ]; then "$CARGO" test --test cli -- --nocapture export::readers; fi
