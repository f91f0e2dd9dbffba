#!/usr/bin/env bash
# Draws the figures of the papers that can be reproduced, as in docs/families.md.
# usage: examples/figures.sh BODYLINE FOLDER [SIZE]
set -euo pipefail
bodyline=$1 out=$2 size=${3:-320x240}
examples=$(dirname "$0")
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# set_shape MODEL PATCH "U VALUES" "V VALUES" RESULT
set_shape() {
  local assignments=() k=0 value
  for value in $3; do assignments+=("shape.$2.u[$k]=$value") && k=$((k + 1)); done
  k=0
  for value in $4; do assignments+=("shape.$2.v[$k]=$value") && k=$((k + 1)); done
  "$bodyline" --quiet set "$1" "${assignments[@]}" -o "$5" --overwrite >/dev/null
}

mean_curvature() {
  "$bodyline" --quiet render "$1" -o "$2" --overwrite --left --stage base --map mean-curvature --range "$3" \
    --view "$4" --size "$size" --title "$5" >/dev/null
}

# Figure 13 of Liu, Ji and Gao: nine sets of shape parameters of a patch of degree (5,4).
figure13() {
  local label=$1 u=$2 v=$3
  set_shape "$examples/sheet.toml" sheet "$u" "$v" "$work/sheet.toml"
  mean_curvature "$work/sheet.toml" "$out/sheet-$label.png" 8 "60,50" "($label)"
}
figure13 a "1 4 4 1" "1 3 1"
figure13 b "1 4 4 1" "-3 2 1"
figure13 c "1 4 4 1" "-3 0 3"
figure13 d "-2 0 -2 1" "1 3 1"
figure13 e "0 1 -4 0" "-2 1 0"
figure13 f "-1 -2 2 -3" "-3 0 -3"
figure13 g "-4 -6 -6 -4" "1 3 1"
figure13 h "-4 -6 -6 -4" "-2 0 3"
figure13 i "-4 -6 -6 -4" "-3 0 3"

# Figure 26: the hood with all four shape parameters 1, and -3.
for value in 1 -3; do
  set_shape "$examples/hood.toml" hood "$value $value" "$value $value" "$work/hood.toml"
  mean_curvature "$work/hood.toml" "$out/hood$value.png" 2 "40,35" "all shape values $value"
done

chain() { "$bodyline" --quiet chain "$@" --overwrite --size "$size" >/dev/null; }

# Figures 11 and 13 of Li et al.: a headlight's outline from eight curves, a hull from four patches.
chain "$examples/headlight.toml" -o "$out/headlight.svg" --view front
sed 's/^shape = .*/shape = [8, 0.5, 8]/' "$examples/headlight.toml" >"$work/headlight.toml"
chain "$work/headlight.toml" -o "$out/headlight-tense.svg" --view front
# The same outline with curvature combs, as drawn and tuned.
chain "$examples/headlight.toml" -o "$out/headlight-comb.svg" --view front --comb 10
chain "$examples/headlight.toml" --fair --vary '*' --hold 'point.*.x' -o "$out/headlight-fair.svg" --view front --comb 10
chain "$examples/hull.toml" -o "$out/hull.png" --view 60,10 --map zebra

# Figure 5 of Hu et al.: two patches joined with equal curvature, and the same with another lambda.
chain "$examples/pair.toml" -o "$out/pair.png" --view 60,45 --map zebra
sed 's/^shape.u = .*/shape.u = [-1]/' "$examples/pair.toml" >"$work/pair.toml"
chain "$work/pair.toml" -o "$out/pair-lambda.png" --view 60,45 --map zebra
