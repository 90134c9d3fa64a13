#!/bin/sh
# Runs bench/commstime on our kernel and on others in turn, three times, on one processor. The others are the smallest
# kernels on Boost.Fiber, bare contexts and stackless coroutines, and the rivals SystemC, SimGrid, Go and SimPy.
# usage: bench/rivals/run.sh [BUILD FOLDER]    default: build/release
# The rivals need Debian's libsystemc-dev, golang-go, python3-simpy3 and libsimgrid-dev; a missing rival is left out.
# libsimgrid-dev depends on a version of Boost that excludes ours. Therefore install libsimgrid3.32, unpack
# libsimgrid-dev by dpkg -x, and set the variable SIMGRID to its usr/include.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
build=${1:-$here/../../build/release}
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT

for least in fiber context coroutine; do
    g++ -std=c++20 -O2 "$here/commstime_$least.cpp" -l:libboost_fiber.a -l:libboost_context.a -o "$made/$least"
done
[ -f /usr/include/systemc.h ] && g++ -O2 "$here/commstime_systemc.cpp" -lsystemc -o "$made/systemc"
simgrid=${SIMGRID:-/usr/include}
[ -f "$simgrid/simgrid/s4u.hpp" ] &&
    g++ -O2 -I "$simgrid" "$here/commstime_simgrid.cpp" -l:libsimgrid.so.3.32 -o "$made/simgrid"
command -v go >/dev/null && GOCACHE="$made/cache" go build -o "$made/go" "$here/commstime.go"
for turn in 1 2 3; do
    echo "turn $turn"
    taskset -c 0 "$build/bench/commstime"
    for least in fiber context coroutine; do
        taskset -c 0 "$made/$least"
        taskset -c 0 "$made/$least" 1000000 pauses
    done
    if [ -x "$made/systemc" ]; then
        SYSTEMC_DISABLE_COPYRIGHT_MESSAGE=1 taskset -c 0 "$made/systemc" 300000
        SYSTEMC_DISABLE_COPYRIGHT_MESSAGE=1 taskset -c 0 "$made/systemc" 300000 pauses
    fi
    if [ -x "$made/simgrid" ]; then
        taskset -c 0 "$made/simgrid" 100000
        taskset -c 0 "$made/simgrid" 100000 pauses
    fi
    if [ -x "$made/go" ]; then taskset -c 0 "$made/go"; fi
    if /usr/bin/python3 -c 'import simpy' 2>/dev/null; then taskset -c 0 /usr/bin/python3 "$here/commstime_simpy.py"; fi
done
