#!/bin/sh
# Makes docs/sketch.png: model 1 drawn in four views, built again from the drawing, and rendered. Run it in the repository with
# bodyline on the PATH; the argument is the picture to write.
set -e
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
bodyline sketch --template cars/model1.toml -o "$folder/views.svg"
bodyline sketch "$folder/views.svg" -o "$folder/sketched.toml"
bodyline render "$folder/sketched.toml" -o "$1" --view -40,25 --map zebra --size 400x240 --title 'Model 1 from its drawing'
