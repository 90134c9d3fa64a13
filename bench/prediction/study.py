#!/usr/bin/env python3
"""usage: study.py PLACEDPAR FOLDER [--quick]

Calibrates this computer, and compares predicted with measured times of native runs of 20 netlists on two threads, and on
two ranks of mpirun if it is installed: farms of 1 to 7 slaves, islands and pipelines, with evaluations of about 1 us to
10 ms. Then compares two threads with one, with DEAP, and with pagmo.
Writes calibration, tables (CSV) and plots (SVG, by gnuplot) into FOLDER. Takes some minutes; --quick makes a few runs
only. A measured time is the median of the runs. The least time is printed beside it, because other programs may delay a run.
"""

import argparse
import csv
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "native"
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
WORK = {"1 us": 30, "10 us": 300, "100 us": 3000, "1 ms": 30000, "10 ms": 300000}
BAND = 0.15  # largest relative error, as a share of the measured time
AIM_S = 0.4  # intended length of a run

FARMS = [(1, "1 us"), (3, "1 us"), (7, "1 us"), (1, "10 us"), (2, "10 us"), (5, "10 us"), (3, "100 us"), (6, "100 us"),
         (4, "1 ms"), (7, "1 ms"), (2, "10 ms")]
ISLANDS = [(2, "1 us"), (4, "1 us"), (4, "10 us"), (8, "100 us"), (4, "1 ms")]
PIPELINES = [(1, "10 us"), (2, "100 us"), (3, "100 us"), (2, "1 ms")]


# mpirun refuses to run as root without these variables.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def mpirun(ranks):
    return ["mpirun", "-n", str(ranks)]


def problem(length):
    return f"costly(work = {WORK[length]})"


def netlists():
    """Yields name, file, settings and the number of evaluations in a generation."""
    for kind, sizes, count, individuals in (("farm", FARMS, "slaves", lambda n: 48), ("islands", ISLANDS, "islands", lambda n: 30 * n),
                                            ("pipeline", PIPELINES, "slaves", lambda n: 60)):
        for size, length in sizes:
            evaluations = individuals(size)
            seconds = evaluations * {"1 us": 3e-6, "10 us": 12e-6, "100 us": 1e-4, "1 ms": 1e-3, "10 ms": 1e-2}[length] / 2
            generations = max(2, min(20000, round(AIM_S / seconds)))
            yield (f"{kind} {size}, {length}", EXAMPLES / f"{kind}.cfs",
                   {count: size, "problem": problem(length), "generations": generations})


class Program:
    def __init__(self, path):
        self.path = path

    def seconds(self, netlist, settings, *options, start=()):
        command = [*start, self.path, "run", str(netlist), *options]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        first = subprocess.run(command, check=True, capture_output=True, text=True, env=ENVIRONMENT).stdout.splitlines()[0]
        number, unit = re.search(r"(?:after|at) ([\d.]+) (\w+)$", first).groups()
        return float(number) * UNITS[unit]

    def measured(self, netlist, settings, threads, runs):
        return [self.seconds(netlist, settings, "--native", "--threads", str(threads)) for _ in range(runs)]

    def measured_on_ranks(self, netlist, settings, ranks, runs):
        return [self.seconds(netlist, settings, "--native", start=mpirun(ranks)) for _ in range(runs)]


def compare(program, calibration, places, runs, quick):
    """Compares predicted and measured times on two threads or two ranks: `places` is "threads" or "ranks"."""
    rows = []
    chosen = list(netlists())
    measured = program.measured if places == "threads" else program.measured_on_ranks
    print(f"two {places}:")
    print(f"{'netlist':22} {'predicted':>12} {'median':>12} {'least':>12} {'error':>8} {'to least':>8}")
    for name, netlist, settings in chosen[::7] if quick else chosen:
        predicted = program.seconds(netlist, settings, "--predict", calibration, f"--{places}", "2")
        times = measured(netlist, settings, 2, runs)
        median, least = statistics.median(times), min(times)
        rows.append((name, predicted, median, least))
        print(f"{name:22} {predicted * 1e3:9.3f} ms {median * 1e3:9.3f} ms {least * 1e3:9.3f} ms "
              f"{predicted / median - 1:+8.1%} {predicted / least - 1:+8.1%}", flush=True)
    for what, column in (("median", 2), ("least", 3)):
        within = sum(abs(row[1] / row[column] - 1) <= BAND for row in rows)
        print(f"within {BAND:.0%} of the {what}: {within} of {len(rows)}")
    return rows


def speedups(program, runs, quick):
    for length, generations in (("10 us", 400), ("100 us", 40)):
        settings = {"islands": 8, "problem": problem(length), "generations": generations // 10 if quick else generations}
        one, two = ([*program.measured(EXAMPLES / "islands.cfs", settings, threads, runs)] for threads in (1, 2))
        print(f"8 islands, {length}: two threads are {min(one) / min(two):.2f} times as fast as one "
              f"(least times; medians: {statistics.median(one) / statistics.median(two):.2f})", flush=True)


def rivals(program, runs, quick):
    """Compares wall times on Rastrigin's function of 20 numbers with equal evaluations: 200 in each generation."""
    generations = 50 if quick else 500
    settings = {"islands": 2, "population": 100, "problem": "rastrigin", "generations": generations}
    ours = min(program.measured(EXAMPLES / "islands.cfs", settings, 2, runs))
    print(f"rastrigin, {200 * generations} evaluations, two threads: {ours:.3f} s")
    python = next((each for each in (sys.executable, "/usr/bin/python3")
                   if subprocess.run([each, "-c", "import deap"], capture_output=True, check=False).returncode == 0), None)
    if python is None:
        print("... DEAP: skipped, because it is not installed (Debian's python3-deap)")
        return
    script = pathlib.Path(__file__).with_name("rival_deap.py")
    answers = [subprocess.run([python, script, str(generations)], check=True, capture_output=True, text=True).stdout.split()
               for _ in range(runs)]
    print(f"... DEAP with multiprocessing, two processes: {min(float(answer[0]) for answer in answers):.3f} s")
    rival = pathlib.Path(program.path).resolve().parents[1] / "bench" / "rastrigin" / "rastrigin_archipelago"
    if not rival.exists():
        print("... pagmo: skipped, because it was missing when PlacedPar was built: fetch it by tools/rivals.sh, and build again")
        return
    answers = [subprocess.run([rival, str(generations)], check=True, capture_output=True, text=True).stdout for _ in range(runs)]
    print(f"... pagmo's archipelago, two islands: {min(answers, key=lambda each: float(each.split()[0])).strip()}")


def draw(rows, folder, name):
    """Draws predicted over measured times, with the band."""
    with open(folder / f"{name}.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("netlist", "predicted_s", "median_s", "least_s"))
        writer.writerows(rows)
    if not shutil.which("gnuplot"):
        print("no plot: gnuplot is missing")
        return
    with tempfile.NamedTemporaryFile("w", suffix=".dat", encoding="utf-8") as data:
        data.writelines(f"{1000 * median} {1000 * predicted}\n" for _, predicted, median, _ in rows)
        data.flush()
        low, high = (f(time for row in rows for time in row[1:3]) * 1000 for f in (min, max))
        script = f"""set terminal svg size 640,480; set output "{folder / (name + '.svg')}"
set logscale xy; set xlabel "measured [ms]"; set ylabel "predicted [ms]"; set key top left; set size square
set xrange [{low / 1.2}:{high * 1.2}]; set yrange [{low / 1.2}:{high * 1.2}]
set xtics (100, 150, 200, 300, 400, 500, 700, 1000); set ytics (100, 150, 200, 300, 400, 500, 700, 1000)
plot x title "equal", {1 + BAND} * x title "15 % more" dashtype 2, {1 - BAND} * x title "15 % less" dashtype 2, \\
     "{data.name}" title "netlists" with points pointtype 7
"""
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="PLACEDPAR")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    calibration = str(options.folder / "here.inc")
    print(f"load: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores", flush=True)
    ranks = shutil.which("mpirun") and pathlib.Path(options.program).with_name("placedpar_mpi.so").exists()
    subprocess.run([*(mpirun(2) if ranks else ()), options.program, "calibrate", "-o", calibration, "--repetitions",
                    "6" if options.quick else "15",
                    *(word for length in WORK for word in ("--problem", problem(length)))], check=True, env=ENVIRONMENT)
    program = Program(options.program)
    runs = 2 if options.quick else 7
    draw(compare(program, calibration, "threads", runs, options.quick), options.folder, "prediction")
    if ranks:
        draw(compare(program, calibration, "ranks", runs, options.quick), options.folder, "prediction-ranks")
    else:
        print("two ranks: skipped, because mpirun is missing, or PlacedPar was built without MPI")
    speedups(program, runs, options.quick)
    rivals(program, runs, options.quick)
    print(f"load: {os.getloadavg()[0]:.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
