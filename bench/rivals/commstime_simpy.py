"""Runs the four processes of bench/commstime.cpp on SimPy, whose Store of capacity 1 is most similar to a channel."""

import sys
import time

import simpy


def commstime(loops, pause):
    env = simpy.Environment()
    a, b, c, d = (simpy.Store(env, capacity=1) for _ in range(4))

    def prefix():
        yield a.put(0)
        while True:
            x = yield b.get()
            if pause:
                yield env.timeout(pause)
            yield a.put(x)

    def delta():
        while True:
            x = yield a.get()
            if pause:
                yield env.timeout(pause)
            yield c.put(x)
            yield d.put(x)

    def successor():
        while True:
            x = yield c.get()
            if pause:
                yield env.timeout(pause)
            yield b.put(x + 1)

    def consumer():
        for i in range(loops):
            x = yield d.get()
            assert x == i
            if pause:
                yield env.timeout(pause)

    for process in (prefix, delta, successor):
        env.process(process())
    start = time.process_time()
    env.run(until=env.process(consumer()))
    return (time.process_time() - start) * 1e9 / loops


loops = int(sys.argv[1]) if len(sys.argv) > 1 else 10000
print(f"SimPy {'no time passing':26} {commstime(loops, 0):8.1f} ns/loop")
print(f"SimPy {'1 unit passing':26} {commstime(loops, 1):8.1f} ns/loop")
