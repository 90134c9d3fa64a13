#!/bin/sh
# Runs each program with 31 seeds and 25,000 evaluations, and compares what they found.
# usage: study.sh COMPARE PROGRAM...
set -eu
compare=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for program in "$@"; do
    "$program" 31 25000 25000 > "$folder/$(basename "$program")"
done
python3 "$compare" "$folder"/*
