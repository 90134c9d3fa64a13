"""python3 tests/fuzz/run.py PROGRAM SECONDS [READER ...]
python3 tests/fuzz/run.py PROGRAM again READER INPUT

Feeds the readers of a program of tests/fuzz, those named or all, for so many seconds of a core altogether. They begin
with the files and texts of the tests, from which corpora are made in a folder beside the program, where they grow from
one call to the next. An input that a reader fails on is left there, too, and the exit code is 1. The second form, which
such a failure prints, reads this input again.
"""

import base64
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

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
    "record": lambda: [rows(text) for text in files("examples/hydraulics/records/*.csv", "examples/hydraulics/loggers/*.*")] + texts_of("tests/hydraulics/data/record*.cpp"),
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
    "tour": lambda: texts_of("tests/problems/benchmark/tour_file_test.cpp"),
    "names": lambda: [b"localhost:8080", b"[::1]:80", b"127.0.0.1", b"dXNlcjpwYXNzd29yZA==", b"0123456789abcdef0123"],
    "searches": lambda: files("examples/**/*.cfs"),
    "wish": lambda: [b"torus\n4x4\n\n\nislands", b"tree\n7\n3\n\nfarm", b"chordal-ring\n8\n\n3\nislands", b"hypercube\n8\n\n\nga.island"],
    "graph": lambda: files("tests/explore/generate/graphs/*.graphml", "tests/explore/generate/graphs/*.dot"),
    "tasks": lambda: files("tests/explore/generate/graphs/*.csv", "examples/explore/task-graph/*.csv"),
    "scenario": lambda: [b"bulk_modulus=4.1e-11 m^3/Pa", b"duration=3 s"] + texts_of("tests/app/record_test.py"),
    "answer": lambda: matches(r'\{"type".*?\}(?=[\n\'"`)])', "docs/guides/monitor.md", "tests/monitor/**/*.cpp"),
    "places": lambda: [b"127.0.0.1", b"::1", b"::ffff:127.0.0.1", b"localhost", b"0.0.0.0", b"monitor.sock", b"fe80::1%lo"],
    "request": lambda: [f"{line} HTTP/1.{minor}\r\nHost: 127.0.0.1\r\n{fields}\r\n".encode() for minor in (0, 1)
                        for line in ("GET /", "HEAD /metrics", "GET /history?machine=digger%207", "POST /snapshot")
                        for fields in ("", "Authorization: Basic dXNlcjpwYXNzd29yZA==\r\n", "Content-Length: 3\r\n",
                                       "Connection: close\r\nTransfer-Encoding: chunked\r\n")],
    "command": lambda: [b"\n".join(line.split()) for line in matches(r"^\$ placedpar ([^|<>$`\n]+)$", "docs/**/*.md", "examples/**/*.md")],
    "job": lambda: [json.dumps({"do": do, "main": name, "files": {name: file.read_text()}, "exercise": "1.1"}).encode()
                    for do in ("check", "run", "exercise") for file in TREE.glob("examples/*/hello/hello.*") if file.suffix in (".cfs", ".occ") for name in [file.name]],
    "requests": lambda: [OPENED + request(tag, STREAM + text(b"some bytes") + bytes(8)) for tag in range(10, 26)]
                        + [request(tag, text(b"file") + text(b"link/etc")) for tag in range(10, 43)]
                        + [OPENED + request(17, STREAM + bytes([0, 8, 0, 0, 1, 0, 0, 0])) + request(13, STREAM + text(b"\x1b[2Jend"))],
    "code": lambda: [bytes([4, 0x24, 0xF2, 0x60, 0x0E]) + (bytes([60]) + bytes(range(0x40, 0x7C))) * 3
                     + bytes([3, 0x2A, 0xFB, 0x20, 0]) + bytes([0x44, 0x60, 0x5F, 0x21, 0xFB]) + b"text of a program" + bytes(20)],
    "program": lambda: files("examples/transputer/**/*.tas") + texts_of("tests/runtime/transputer/assembler_test.cpp"),
    "lines": lambda: texts_of("tests/runtime/transputer/code_lines_test.cpp"),
    "occam": lambda: [bytes([how]) + text + b"\0" + bytes(range(7 * how, 7 * how + 10))
                      for text in files("tests/occam/**/*.occ", "examples/occam/**/*.occ", "docs/occam-course/answers/*.occ")
                      + matches(r"^== accepted: [^\n]*\n(.*?)(?=^== |\Z)", "tests/occam/check/verdicts/*.txt")
                      for how in (0, 1, 3, 30)],
    "configuration": lambda: [text + b"\0" + bytes(range(7 * how, 7 * how + 15))
                              for text in files("examples/occam/**/*.pgm", "tests/occam/**/*.pgm") for how in (0, 1, 3, 30)],
    "boot": lambda: [booted((link, packet(program) + bytes(range(40))), machine=bytes([model, 2 + 3 * (model % 2), model, model, 25]))
                     for program in PROGRAMS for model in range(5) for link in (0, 3)]
                    + [booted((0, PEEK + POKE + packet(program)), (1, bytes(60)), (2, packet(program)), (3, packet(program)), (4, PEEK),
                              machine=bytes([3, 4, 3, how, 30])) for how, program in enumerate(PROGRAMS)],
    "editor": lambda: [session(f"file:///nowhere/a{path.suffix}", path.read_text()[:2000])
                       for pattern in ("csp/*/*.cfs", "occam/*/*.occ", "occam/*/*.pgm", "explore/*/*.toml")
                       for path in sorted((TREE / "examples").glob(pattern))],
    "words": lambda: files("examples/**/*.cfs"),
    "keys": lambda: files("examples/**/*.toml"),
    "arguments": lambda: texts_of("tests/explore/**/*.cpp", "tests/report/*.cpp"),
}


def spoken(*messages):
    """Returns messages to a language server."""
    bodies = [json.dumps({"jsonrpc": "2.0", **message}).encode() for message in messages]
    return b"".join(b"Content-Length: %d\r\n\r\n" % len(body) + body for body in bodies)


def session(uri, text):
    """Returns what an editor sends that opens a text, changes it, and asks everything about a place in it."""
    document = {"textDocument": {"uri": uri, "version": 2}}
    place = {**document, "position": {"line": 3, "character": 9}}
    change = {"range": {"start": {"line": 1, "character": 2}, "end": {"line": 1, "character": 4}}, "text": "\U0001f600;"}
    questions = [{"id": number, "method": f"textDocument/{name}", "params": {**place, "newName": "other"}} for number, name in
                 enumerate(("hover", "completion", "definition", "rename", "formatting", "documentSymbol"))]
    return spoken({"id": 0, "method": "initialize", "params": {}},
                  {"method": "textDocument/didOpen", "params": {"textDocument": {"uri": uri, "languageId": "", "version": 1, "text": text}}},
                  *questions, {"method": "textDocument/didChange", "params": {**document, "contentChanges": [change]}},
                  {"method": "textDocument/didClose", "params": document})


def instruction(function, operand):
    """Returns the bytes of an instruction of a transputer: a function from 0 to 15, with prefixes for its operand."""
    def prefixed(value):
        if 0 <= value < 16:
            return b""
        upper = value >> 4 if value >= 0 else ~value >> 4
        return prefixed(upper) + bytes([(0x20 if value >= 0 else 0x60) | upper & 15])
    return prefixed(operand) + bytes([function << 4 | operand & 15])


def code(*instructions):
    """Returns the bytes of instructions: pairs of a function's name and an operand, or the code of an operation."""
    functions = "j ldlp pfix ldnl ldc ldnlp nfix ldl adc call cj ajw eqc stl stnl opr".split()
    return b"".join(instruction(15, each) if isinstance(each, int) else instruction(functions.index(each[0]), each[1])
                    for each in instructions)


def booted(*parts, machine=bytes([3, 2, 1, 0, 0])):
    """Returns an input of the reader `boot`: bytes for links 0 to 5."""
    return machine + b"".join(bytes([link, len(part) - 1]) + part for link, part in parts)


def packet(program):
    return bytes([len(program)]) + program


IN, OUT, LEND, STARTP, RUNP, TIN, LDTIMER, STTIMER, MINT, MOVE = 0x07, 0x0B, 0x21, 0x0D, 0x39, 0x2B, 0x22, 0x54, 0x42, 0x4A
CLOCKS = code(("ldc", 0), STTIMER)
TO_NEIGHBOUR = code(("ldlp", 16), MINT, ("ldnlp", 7), ("ldc", 20), IN) # the event channel is next
PROGRAMS = [
    code(("ldc", 1), ("stl", 1), ("ldl", 1), ("adc", 1), ("stl", 1), ("j", -6)),
    code(("ldc", 0), ("stl", 1), ("ldc", 0), ("stl", 2), ("ldlp", 1), ("ldc", 4), LEND, 0x15),
    CLOCKS + code(LDTIMER, ("adc", 20), TIN, LDTIMER, ("adc", 30), TIN, 0x15),
    CLOCKS + code(("ldc", 10), ("ldlp", 20), STARTP, ("ldlp", 40), RUNP, ("ldc", 7), ("stl", 1), ("j", -3)),
    code(("ldlp", 4), MINT, ("ldnlp", 4), ("ldc", 8), IN, ("ldlp", 4), MINT, ("ldc", 8), OUT, ("j", -15)),
    code(MINT, ("ldlp", 1), ("ldc", 4000), MOVE, ("ldlp", 1), MINT, ("ldc", 4000), MOVE),
    code(("ldc", 3), ("ldc", 8), ("ldc", 8), 0x5B, ("ldlp", 1), ("ldlp", 9), ("ldc", 5), 0x5C, 0x5D, 0x5E),
    CLOCKS + code(0x4E, LDTIMER, ("adc", 5), ("ldc", 1), 0x47, MINT, ("ldnlp", 5), ("ldc", 1), 0x48, 0x51, 0x45),
    code(("ldlp", 1), 0x8E, ("ldlp", 2), 0x8E, 0x87, 0x8B, 0x8C, ("ldlp", 1), 0x88, ("ldc", 1), 0xAB, 0x83),
    code(("ldc", 9), ("ldc", 0x70), MINT, 0x02, 0x3B, ("j", 0)),
    code(MINT, ("ldnlp", 0x1C), ("ldc", 1), ("stl", -1), 0x20),
    code(0x58, ("ldc", 1), ("ldc", 0), 0x2C, 0x10), code(0x3E, 0x3D, 0x18, 0x50, 0x1C, 0x17),
    code(("ldlp", 8), ("ldc", 1), MINT, ("ldnlp", 3), OUT, ("ldlp", 8), MINT, ("ldnlp", 3), ("ldc", 90), OUT),
]
PEEK, POKE = b"\1" + bytes([0x70, 0, 0, 0x80]), b"\0" + bytes([0, 1, 0, 0x80, 1, 2, 3, 4])


def again(program, reader, seed):
    """Reads an input that a reader has failed on."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(base64.b64decode(seed))
        file.flush()
        return subprocess.run([program, file.name], env={**os.environ, "PLACEDPAR_READER": reader}, check=False).returncode


def print_failure(program, reader, folder, since):
    """Prints how to repeat a failure."""
    for kept in folder.glob(f"{reader}-*"):
        if kept.is_file() and kept.stat().st_mtime >= since:
            print(f"again: python3 tests/fuzz/run.py {program} again {reader} {base64.b64encode(kept.read_bytes()).decode()}",
                  flush=True)


def fuzz(program, reader, seconds):
    """Whether the reader survives the input."""
    begun = time.time() - 1
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
        print_failure(program, reader, folder.parent, begun)
    return run.returncode == 0


def main(program, seconds, *chosen):
    if seconds == "again":
        sys.exit(again(program, *chosen))
    names = subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    wanted = chosen or names
    stood = [fuzz(program, reader, max(1, int(seconds) // len(wanted))) for reader in wanted]
    sys.exit(0 if all(stood) else 1)


if __name__ == "__main__":
    main(*sys.argv[1:])
