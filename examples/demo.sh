#!/usr/bin/env bash
# The main job on real input: check the paper's model 1 as printed, tune it, draw it, take it to CAD.
# usage: demo.sh PROGRAM FOLDER
set -euo pipefail
bodyline=$(realpath "$1")
folder=$2
cars=$(realpath "$(dirname "$0")/../cars")
mkdir -p "$folder"
cd "$folder"

step() { printf '[%s/7] %s\n' "$1" "$2"; }

step 1 'checking model 1 as printed'
"$bodyline" check "$cars/model1.toml" >check-before.txt || [ $? -eq 1 ]

step 2 'tuning it: shape, cuts, fullness, lean, and curves within 10 mm'
"$bodyline" fair "$cars/model1.toml" -o tuned.toml --within 10 --report report.html --overwrite

step 3 'checking the result'
"$bodyline" check tuned.toml >check-after.txt || [ $? -eq 1 ]

step 4 'drawing both'
for map in shade zebra mean-curvature; do
  "$bodyline" render "$cars/model1.toml" -o "before-$map.png" --map "$map" --overwrite
  "$bodyline" render tuned.toml -o "after-$map.png" --map "$map" --overwrite
done

step 5 'writing a STEP file'
"$bodyline" export tuned.toml -o tuned.step --overwrite

step 6 'writing a mesh'
"$bodyline" export tuned.toml -o tuned.glb --tolerance 0.2 --overwrite

step 7 'done'
cat <<TEXT

In $PWD:
  report.html             before and after, what moved, how the search went: open it in a browser
  tuned.toml              the tuned model, to edit or to tune on
  tuned.step, tuned.glb   for CAD, and as a mesh
  before-*.png, after-*.png
  check-before.txt, check-after.txt
TEXT
