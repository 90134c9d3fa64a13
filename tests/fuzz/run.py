"""python3 tests/fuzz/run.py PROGRAM SECONDS [READER ...]

Feeds the readers of a program of tests/fuzz, those named or all, for so many seconds of a core altogether. They begin
with the files and texts of the tests, from which corpora are made in a folder beside the program, where they grow from
one call to the next. An input that a reader fails on is left there, too, and the exit code is 1.
"""

import os
import pathlib
import re
import subprocess
import sys

TREE = pathlib.Path(__file__).resolve().parents[2]
LARGEST = 20_000  # bytes of a seed


def files(*patterns):
    """Returns the contents of files of the tree."""
    return [path.read_bytes() for pattern in patterns for path in sorted(TREE.glob(pattern))]


def matches(pattern, *patterns):
    """Returns all matches of a pattern in files of the tree."""
    return [found for text in files(*patterns) for found in re.findall(pattern.encode(), text, re.DOTALL | re.MULTILINE)]


def texts_of(*patterns):
    """Returns the string literals of the tests' sources."""
    return matches(r'"((?:[^"\\\n]|\\.)+)"', *patterns)


def rows(text, count=40):
    """Returns the first lines of a table."""
    return b"".join(text.splitlines(keepends=True)[:count])


def request(tag, fields=b""):
    """Returns a request of the iserver protocol."""
    data = bytes([tag]) + fields
    data += bytes(max(6 - len(data), len(data) % 2))
    return len(data).to_bytes(2, "little") + data


def text(content):
    """Returns a text as a field of a request."""
    return len(content).to_bytes(2, "little") + content


STREAM = (3).to_bytes(4, "little")
OPENED = request(10, text(b"a/file") + b"\1\5")


SEEDS = {
    "netlist": lambda: files("examples/**/*.cfs", "tests/netlist/refusals/**/*.cfs"),
    "record": lambda: [rows(text) for text in files("examples/hydraulics/records/*.csv")] + texts_of("tests/hydraulics/data/record*.cpp"),
    "machine": lambda: [rows(text, 12) for text in files("hydraulics/data/excavator.csv")],
    "policies": lambda: texts_of("tests/gaprocs/policies/*.cpp") + matches(r'= "([a-z(][^"\n]+)"', "examples/**/*.cfs"),
    "strings": lambda: texts_of("tests/gaprocs/representation/*.cpp"),
    "texts": lambda: texts_of("tests/text/*.cpp"),
    "study": lambda: files("examples/**/*.toml") + matches(r"^```toml[^\n]*\n(.*?)^```", "docs/**/*.md", "examples/**/*.md"),
    "results": lambda: [],
    "message": lambda: matches(r'\{"type".*?\}(?=[\n\'"`)])', "docs/guides/monitor.md", "tests/monitor/**/*.cpp"),
    "state": lambda: [],
    "options": lambda: [b"n=3\nt[0].link[0] silent (from = 20ms)\ncsp.sink=csp.sink", b"t.memory=2M\n\n"] + texts_of("tests/netlist/elaborate/overrides_test.cpp"),
    "diagnosis": lambda: [],
    "population": lambda: texts_of("tests/gaprocs/initial_population_test.cpp"),
    "names": lambda: [b"localhost:8080", b"[::1]:80", b"127.0.0.1", b"dXNlcjpwYXNzd29yZA==", b"0123456789abcdef0123"],
    "searches": lambda: files("examples/**/*.cfs"),
    "wish": lambda: [b"torus\n4x4\n\n\nislands", b"tree\n7\n3\n\nfarm", b"chordal-ring\n8\n\n3\nislands", b"hypercube\n8\n\n\nga.island"],
    "scenario": lambda: [b"bulk_modulus=4.1e-11 m^3/Pa", b"duration=3 s"] + texts_of("tests/app/record_test.py"),
    "answer": lambda: matches(r'\{"type".*?\}(?=[\n\'"`)])', "docs/guides/monitor.md", "tests/monitor/**/*.cpp"),
    "places": lambda: [b"127.0.0.1", b"::1", b"::ffff:127.0.0.1", b"localhost", b"0.0.0.0", b"monitor.sock", b"fe80::1%lo"],
    "request": lambda: [f"{line} HTTP/1.{minor}\r\nHost: 127.0.0.1\r\n{fields}\r\n".encode() for minor in (0, 1)
                        for line in ("GET /", "HEAD /metrics", "GET /history?machine=digger%207", "POST /snapshot")
                        for fields in ("", "Authorization: Basic dXNlcjpwYXNzd29yZA==\r\n", "Content-Length: 3\r\n",
                                       "Connection: close\r\nTransfer-Encoding: chunked\r\n")],
    "command": lambda: [b"\n".join(line.split()) for line in matches(r"^\$ placedpar ([^|<>$`\n]+)$", "docs/**/*.md", "examples/**/*.md")],
    "requests": lambda: [OPENED + request(tag, STREAM + text(b"some bytes") + bytes(8)) for tag in range(10, 26)]
                        + [request(tag, text(b"file") + text(b"link/etc")) for tag in range(10, 43)]
                        + [OPENED + request(17, STREAM + bytes([0, 8, 0, 0, 1, 0, 0, 0])) + request(13, STREAM + text(b"\x1b[2Jend"))],
    "code": lambda: [bytes([4, 0x24, 0xF2, 0x60, 0x0E]) + (bytes([60]) + bytes(range(0x40, 0x7C))) * 3
                     + bytes([3, 0x2A, 0xFB, 0x20, 0]) + bytes([0x44, 0x60, 0x5F, 0x21, 0xFB]) + b"text of a program" + bytes(20)],
    "program": lambda: files("examples/transputer/**/*.tas") + texts_of("tests/runtime/transputer/assembler_test.cpp"),
    "arguments": lambda: texts_of("tests/explore/**/*.cpp", "tests/report/*.cpp"),
}


def fuzz(program, reader, seconds):
    """Whether the reader survives the input."""
    folder = pathlib.Path(program).resolve().parent / "corpora" / reader
    folder.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(each for each in SEEDS[reader]() if len(each) <= LARGEST):
        (folder / f"seed-{number}").write_bytes(seed)
    run = subprocess.run([program, folder, f"-max_total_time={seconds}", f"-max_len={LARGEST}", "-timeout=20",
                          "-rss_limit_mb=3000", f"-artifact_prefix={folder.parent}/{reader}-", "-print_final_stats=1",
                          "-verbosity=0"],
                         env={**os.environ, "PLACEDPAR_READER": reader, "ASAN_OPTIONS": "detect_stack_use_after_return=0"},
                         stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    tried = re.search(r"number_of_executed_units: (\d+)", run.stderr)
    print(f"{reader}: {tried.group(1) if tried else 'no'} inputs in {seconds} s", flush=True)
    if run.returncode != 0:
        print(run.stderr[-6000:], flush=True)
    return run.returncode == 0


def main(program, seconds, *chosen):
    names = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    wanted = chosen or names
    stood = [fuzz(program, reader, max(1, int(seconds) // len(wanted))) for reader in wanted]
    sys.exit(0 if all(stood) else 1)


if __name__ == "__main__":
    main(*sys.argv[1:])
