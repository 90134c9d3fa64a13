"""python3 tests/app/trend_rates.py PROGRAM [MACHINES [FIRST_SEED]]

Measures how often the trend of simulated machines reports a change. Each machine has eight records with the noise and the
motion of their own seeds; a fault comes after the fourth. Nothing in the program was tuned to these seeds. Prints the
share of machines whose boom changes (a tenth as many machines dig, with all links), and how many of the changes are found at their place. Exit code 1: sound machines have
a change more often than the stated 1 %, with a probability of less than 0.1 % that this is chance.
"""

import concurrent.futures
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

FAULTS = {"sound": None, "sound, digging": None, "compliance + 20 %": "boom.inlet_compliance=0.01032", "compliance + 40 %": "boom.inlet_compliance=0.01204",
          "leak": "fault.leak=0.0028", "spool offset": "fault.spool_offset=0.01"}
DIG = pathlib.Path(__file__).parents[2] / "examples/hydraulics/digging/dig.toml"
RECORDS, STATED = 8, 0.01


def changes_of(program, fault, machine):
    """Returns the changes of one machine, each as (what, index of the first record after it)."""
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for i in range(RECORDS):
            seed = machine * RECORDS + i
            draw = random.Random(seed)
            digs = fault.endswith("digging")
            motion = [] if digs else [f"excavator.servo_desired={draw.uniform(0.25, 0.4):.3f}", f"excavator.servo_ramp={draw.uniform(0, 0.6):.3f}"]
            if FAULTS[fault] and i >= RECORDS // 2:
                motion.append(FAULTS[fault])
            paths.append(f"{folder}/{i}.csv")
            subprocess.run([program, "record", "excavator", "--seed", str(seed), "--out", paths[-1], *(["--job", str(DIG)] if digs else []),
                            *[word for setting in motion for word in ("--set", setting)]], check=True, capture_output=True)
        subprocess.run([program, "identify", *paths, "--json", f"{folder}/trend.json"], check=True, capture_output=True)
        found = json.loads(pathlib.Path(f"{folder}/trend.json").read_text(encoding="utf-8"))
        return [(each["what"], int(pathlib.Path(each["until"]).stem)) for each in found["changes"] if each["link"] == "boom"]


def tail(count, machines):
    """Returns the probability of at least so many machines by chance."""
    return sum(math.comb(machines, k) * STATED ** k * (1 - STATED) ** (machines - k) for k in range(count, machines + 1))


def main(program, machines=200, first=100_000):
    failed = False
    for number, fault in enumerate(FAULTS):
        start = first + number * machines
        several = range(start, start + (max(1, machines // 10) if fault.endswith("digging") else machines))
        with concurrent.futures.ThreadPoolExecutor() as pool:
            found = list(pool.map(lambda machine, fault=fault: changes_of(program, fault, machine), several))
        changed = sum(bool(each) for each in found)
        there = sum(any(at == RECORDS // 2 for _, at in each) for each in found)
        what = {name: sum(any(each[0] == name for each in changes) for changes in found)
                for name in ("compliance", "leak", "spool offset")}
        print(f"{fault}: {changed} of {len(several)} machines change, {there} at the right record; {what}", flush=True)
        failed = failed or (fault.startswith("sound") and tail(changed, len(several)) < 0.001)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], *map(int, sys.argv[2:])))
