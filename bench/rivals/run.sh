#!/bin/sh
# Runs bench/commstime and the same network on other kernels by turns, three times, on one processor: on the least that
# Boost.Fiber, bare contexts and stackless coroutines allow, and on those of others.
# usage: bench/rivals/run.sh [BUILD FOLDER]    build/release; needs libsystemc-dev, golang-go, python3-simpy3 and
# libsimgrid-dev of Debian, and passes over those that are missing. libsimgrid-dev asks for a Boost that excludes ours:
# install libsimgrid3.32, unpack the other package (dpkg -x), and name its usr/include by the variable SIMGRID.
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
