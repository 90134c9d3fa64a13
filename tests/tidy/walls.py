"""The walls of the house: which folder may include which.

A folder may include itself, the folders that the table lists below it, and what those may include. A new folder of
sources needs an entry here first: where it stands is decided before it is built.
"""

import functools
import posixpath
import re

BELOW = {
    "text": [],
    "store": ["text"],
    "ranks": ["text"],
    "web": ["text"],
    "runtime": [],
    "runtime/hardware": ["runtime"],
    "runtime/transputer": ["runtime/hardware"],
    "iserver": ["text"],
    "netlist/network": ["text"],
    "netlist/kinds": ["netlist/network", "runtime/transputer", "iserver"],
    "netlist/language": ["netlist/network"],
    "netlist/elaborate": ["netlist/kinds", "netlist/language"],
    "netlist/complete": ["netlist/elaborate"],
    "netlist/print": ["netlist/kinds"],
    "netlist": ["netlist/complete", "netlist/print"],
    "native": ["netlist", "ranks"],
    "occam/language": ["text"],
    "occam/check": ["occam/language"],
    "occam/code": ["occam/check", "runtime/transputer"],
    "occam/library": ["text"],
    "occam/network": ["netlist", "occam/code", "occam/library"],
    "occam/configuration": ["occam/network"],
    "occam": ["occam/configuration"],
    "classics": ["netlist"],
    "gaprocs/representation": ["runtime", "text"],
    "gaprocs/policies": ["gaprocs/representation"],
    "gaprocs": ["gaprocs/policies"],
    "gaprocs/processes": ["gaprocs", "netlist"],
    "hydraulics/data": ["text"],
    "hydraulics/circuit": ["hydraulics/data"],
    "hydraulics/plant": ["hydraulics/circuit"],
    "problems/plant": ["gaprocs"],
    "problems/benchmark": ["gaprocs"],
    "problems": ["problems/benchmark", "problems/plant"],
    "identification/verdict": ["hydraulics/circuit"],
    "identification": ["gaprocs", "hydraulics/plant", "identification/verdict"],
    "identification/on_line": ["identification"],
    "identification/report": ["identification/on_line"],
    "monitor/protocol": ["identification/on_line"],
    "monitor/memory": ["monitor/protocol", "store"],
    "monitor/service": ["monitor/memory", "web"],
    "picture": ["netlist"],
    "report": ["gaprocs/processes", "picture"],
    "observe/trace": ["netlist", "picture"],
    "observe/critical_path": ["observe/trace"],
    "observe/page": ["observe/trace", "report"],
    "explore/generate": ["gaprocs", "netlist"],
    "explore": ["classics", "identification", "occam", "problems", "report"],
    "explore/prediction": ["explore", "native"],
    "explore/exercise": ["explore"],
    "explore/identify": ["explore", "identification/report"],
    "explore/explain": ["explore", "observe/critical_path"],
    "explore/study": ["explore", "ranks", "store"],
    "explore/check": ["explore/study"],
    "explore/compare": ["explore/study"],
    "explore/optimise": ["explore/explain", "explore/study"],
    "editor/protocol": ["text"],
    "editor/language": ["explore/check"],
    "editor": ["editor/language", "editor/protocol"],
    "experiments/kit": ["explore/study"],
    "experiments/chapter_2": ["experiments/kit"],
    "experiments/chapter_3/kit": ["experiments/kit", "identification/on_line"],
    "experiments/chapter_3": ["experiments/chapter_3/kit"],
    "experiments/chapter_4/kit": ["experiments/chapter_3/kit"],
    "experiments/chapter_4": ["experiments/chapter_4/kit"],
    "experiments/chapter_5/kit": ["experiments/kit"],
    "experiments/chapter_5": ["experiments/chapter_5/kit"],
    "experiments/chapter_6/kit": ["experiments/kit"],
    "experiments/chapter_6": ["experiments/chapter_6/kit"],
    "experiments/appendix_e": ["experiments/kit"],
    "experiments/machine": ["experiments/kit"],
    "python/module": ["explore/explain", "explore/identify", "explore/study", "observe/page"],
    "serve": ["explore/check", "explore/exercise", "explore/explain", "observe/page", "web"],
    "app": ["explore", "observe/page"],
    "app/generation": ["gaprocs", "picture"],
    "app/record": ["explore/study", "hydraulics/plant"],
    "app/options": ["app", "explore/check", "explore/identify", "explore/prediction"],
    "app/identify": ["app/options"],
    "app/mpi": ["ranks"],
    "app/commands": ["app/generation", "app/identify", "app/record", "editor", "experiments/kit", "explore/compare", "explore/exercise", "explore/generate", "explore/optimise", "explore/prediction", "monitor/service", "serve"],
}
ROOMS = sorted({folder.split("/")[0] for folder in BELOW})

# These folders may include everything; no room includes them. Tests mirror the rooms.
OUTSIDE = ("bench", "examples", "tests", "tools/webassembly")
TEST_PROJECTS = ("tests/consumer", "tests/fuzz", "tests/own_kinds") # programs of their own

# A header and its source are one piece. Pieces must not include each other in a circle, except these knots: each is one
# idea in several files.
KNOTS = (
    # A process waits through its executive. The executive asks the kernel, which resumes the process on a worker. The
    # trace is notified of what each process does.
    {"runtime/executive", "runtime/kernel", "runtime/process", "runtime/trace", "runtime/worker"},
)

# The longest allowed chain of headers, each including the next.
LONGEST_CHAIN = 12

# Only sources include these libraries, which take long to compile. Headers declare the names they need
# (boost/json/fwd.hpp).
LARGE_LIBRARY = re.compile(r"""^\s*#\s*include\s*[<"](CLI|Eigen|fmt|boost/json)(?!/fwd\.hpp)[/.]""")
# Exceptions: headers that hold a library's values, or that only one source includes.
HEADERS_WITH_LIBRARIES = {
    "experiments/chapter_5/kit/covariance_adaptation.hpp": "Eigen",
    "experiments/chapter_5/kit/differential_evolution.hpp": "Eigen",
    "experiments/chapter_5/kit/least_squares.hpp": "Eigen",
    "explore/study/toml_reader.hpp": "fmt",
    "identification/verdict/noisy_rows.hpp": "Eigen",
    "identification/verdict/way_matrices.hpp": "Eigen",
    "monitor/memory/kept_json.hpp": "boost/json",
    "report/field.hpp": "boost/json",
}
# CLI11 takes longest to compile: only two sources include it.
SOURCES_WITH_CLI = {"app/command_line.cpp", "app/options.cpp"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)', re.MULTILINE)


@functools.lru_cache(maxsize=None)
def reach(folder):
    """Returns the folders that a folder may include."""
    return {folder}.union(*(reach(below) for below in BELOW[folder]))


def room_of(name):
    """Returns the room of a file; None outside the rooms."""
    top = name.split("/")[0]
    return top if "/" in name and top in ROOMS else None


def folder_fault(name):
    """Returns a fault if a C++ file lies in a wrong folder."""
    folder = posixpath.dirname(name)
    if room_of(name):
        return None if folder in BELOW else f"{name}: no wall is known of {folder}: see tests/tidy/walls.py"
    if not folder.startswith(OUTSIDE):
        return f"{name}: {folder or 'the top'} is no room: see tests/tidy/walls.py"
    if folder.startswith("tests/") and not folder.startswith(TEST_PROJECTS):
        mirrored = folder.removeprefix("tests/")
        if mirrored not in BELOW and mirrored not in ROOMS:
            return f"{name}: tests mirror the rooms, and there is no {mirrored}"
    return None


def includes(text):
    """Returns the names of our headers that a C++ file includes, as written there."""
    return [name for mark, name in INCLUDE.findall(text) if mark == '"' or room_of(name)]


def include_fault(name, included):
    """Returns the fault in one C++ file's include of another, which should be written "room/folder/header.hpp"."""
    folder, other = posixpath.dirname(name), posixpath.dirname(included)
    if not room_of(name) or folder not in BELOW or other in reach(folder):
        return None
    return f"{folder} may not include {included}"


def library_fault(name, line):
    """Returns the fault in a line of a C++ file that includes a library."""
    large = LARGE_LIBRARY.match(line)
    if not large or not room_of(name):
        return None
    if name.endswith(".hpp") and HEADERS_WITH_LIBRARIES.get(name) != large[1]:
        return f"a header includes {large[1]}: include it in sources, and declare in headers what they name of it"
    if name.endswith(".cpp") and large[1] == "CLI" and name not in SOURCES_WITH_CLI:
        return "options are declared by app/options.hpp; CLI11 itself is included by " + " and ".join(sorted(SOURCES_WITH_CLI))
    return None


def longest_chain(graph):
    """Returns the longest path through the graph {node: successors}. REQUIRES: the graph has no circle."""
    @functools.lru_cache(maxsize=None)
    def begun_by(node):
        return (node, *max(map(begun_by, sorted(graph.get(node, ()))), key=len, default=()))

    return max(map(begun_by, sorted(graph)), key=len, default=())


def stem_of(name):
    """Returns the common name of a header and its source."""
    return posixpath.splitext(name)[0]


def piece_of(name):
    """Returns the common name of a header and its source; for a knot, the first of its names."""
    stem = stem_of(name)
    return min(next((knot for knot in KNOTS if stem in knot), {stem}))


def pieces(graph):
    """Returns {piece: pieces that it includes}, from {file: files that it includes}."""
    found = {}
    for name, included in graph.items():
        others = {piece_of(other) for other in included} - {piece_of(name)}
        found.setdefault(piece_of(name), set()).update(others)
    return found


def loose_ends(graph, knots=KNOTS):
    """Returns the names in knots that no circle of {file: files that it includes} ties to the others any more. Knots of
    a tree without any of their files do not count."""
    stems = {}
    for name, included in graph.items():
        stems.setdefault(stem_of(name), set()).update(stem_of(other) for other in included)

    def reached(stem):
        found, new = set(), {stem}
        while new:
            found |= new
            new = set().union(*(stems.get(each, set()) for each in new)) - found
        return found

    return sorted(stem for knot in knots for stem in knot if knot & stems.keys() and not knot <= reached(stem))


def circle(graph):
    """Returns the nodes of one circle of {node: successors}, in order, with the first repeated at the end; empty if
    there is none."""
    done, path = set(), []

    def follow(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for other in sorted(graph.get(node, ())):
            found = follow(other)
            if found:
                return found
        path.pop()
        done.add(node)
        return []

    for node in sorted(graph):
        found = follow(node)
        if found:
            return found
    return []
