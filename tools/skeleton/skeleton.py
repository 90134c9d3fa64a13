"""Writes a new kind, device, problem or experiment from the templates in the folders beside this file.

The path of a template below its folder, without the last .in, is the path of the new file. In paths and texts, @snake@
and the other placeholders of `words_for` are replaced. Each `Insertion` adds the new piece to a list or a table. All
texts are made in memory first, so either all files are written, or none.
"""

import dataclasses
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[1]
sys.path.append(str(TOP / "tests" / "tidy"))
import format as formatting  # noqa: E402
import tree  # noqa: E402

LONGEST = 24
# C++ keywords, and macros in lower case that GCC and Clang predefine.
RESERVED = set("""
    alignas alignof and and-eq asm auto bitand bitor bool break case catch char class compl concept const consteval constexpr
    constinit const-cast continue co-await co-return co-yield decltype default delete do double dynamic-cast else enum
    explicit export extern false float for friend goto if inline int linux long mutable namespace new noexcept not not-eq
    nullptr operator or or-eq private protected public register reinterpret-cast requires return short signed sizeof
    static static-assert static-cast struct switch template this thread-local throw true try typedef typeid typename
    union unix unsigned using virtual void volatile wchar-t while xor xor-eq char8-t char16-t char32-t main std
""".split())
NETLIST_WORDS = set("val define connection input output process connect use place rep if else node fault".split())
NAMES_IN_NETLISTS = set("a b c d p count clock producer consumer".split())  # used in the templates of a device


class Refusal(Exception):
    """An error message: what is wrong, where, and what would be right."""


@dataclasses.dataclass
class Insertion:
    """A text that is inserted in front of the text `before` of a file. `before` must occur exactly once in the file."""

    file: str
    before: str
    text: str

    def into(self, text, words):
        added = filled(self.text, words)
        if text.count(self.before) != 1:
            raise Refusal(f"{self.file}: expected the line {self.before.strip().splitlines()[0]!r} once, found it "
                          f"{text.count(self.before)} times: insert {added.strip()!r} by hand, or repair the file")
        return text.replace(self.before, added + self.before)


@dataclasses.dataclass
class Piece:
    """The lists that one of the tools changes besides writing its templates, and the rules for names that are taken."""

    topic: str    # the folder of examples/ for the piece's example
    example: str  # the example's description in the README of this folder
    insertions: list
    taken: list  # (files, pattern): the name is taken if the pattern is found in one of the files
    reserved: set = dataclasses.field(default_factory=set)  # names that are refused in addition to C++ keywords
    next: str = ""  # a command that shows the new piece; it is printed at the end


END_OF_NAMESPACE = "\n} // namespace placedpar\n"
# The name is taken if a source declares a type or a namespace with this name, or a header declares such a function.
TYPE = (r"[a-z].*\.[ch]pp", r"\b(?:class|struct|enum|namespace|concept|using) (?:placedpar::)?(?:@Pascal@|@snake@)\b")
FUNCTION = (r"[a-z].*\.hpp", r"(?m)^(?:[\w:<>,]+[ &*]+)+@snake@\(")
PIECES = {
    "kind": Piece(
        "csp",
        "csp.@snake@: packets that are counted on their way",
        [Insertion("classics/kinds.hpp", END_OF_NAMESPACE, "std::vector<ProcessKind> @snake@_kinds(); ///< csp.@snake@\n"),
         Insertion("classics/kinds.cpp", "})\n        for (auto& kind : kinds)", ", @snake@_kinds()")],
        [(r"[a-z].*\.cpp", r'"csp\.@snake@"'), (r"classics/.*", r"\b@snake@_kinds\b")],
        next="placedpar kinds csp.@snake@"),
    "device": Piece(
        "machine",
        "@article@ @words@, which executes a process at a time, beside a transputer",
        [Insertion("netlist/kinds/devices.hpp", "\n/// Lists all devices above.\n",
                   "/// Executes one process at a time: runtime/hardware/@snake@.hpp.\nDeviceKind @snake@();\n"),
         Insertion("netlist/kinds/devices.hpp", "};\n\n} // namespace placedpar", ", @snake@"),
         Insertion("docs/reference/netlist-language.md", "\n| module or board | transputer | memory |",
                   "| `@snake@` | @article@ @words@: four links, executes one process at a time |\n"),
         Insertion("runtime/README.md", "| the host computer |",
                   "| @article@ @words@: executes one process at a time | `hardware/@snake@` |\n")],
        [TYPE, FUNCTION, (r"netlist/kinds/.*\.cpp", r'"(?:@snake@|@words@)"')],
        NETLIST_WORDS | NAMES_IN_NETLISTS,
        next="placedpar kinds @snake@"),
    "problem": Piece(
        "genetic",
        "@kebab@: a valley of several numbers, and a genetic algorithm that searches for its bottom",
        [Insertion("explore/problems.cpp", '#include "problems/plant/plant_family.hpp"\n', '#include "problems/@snake@.hpp"\n'),
         Insertion("explore/problems.cpp", "    for (const ProblemFamily& family : own_problems())\n",
                   "    problems.add(minimised<@Pascal@>());\n"),
         Insertion("problems/README.md", "| benchmarks for optimisers |",
                   "| a sum of squares, each with a weight | `@snake@` |\n")],
        [TYPE, (r"(?:problems|explore)/.*\.[ch]pp", r'"@kebab@"')],
        next="placedpar kinds @kebab@"),
    "experiment": Piece(
        "thesis",
        "the experiment @kebab@: what a link carries one way, beside the databook",
        [],
        [(r"experiments/.*\.cpp", r'\b@snake@_experiment\b|\.name = "@kebab@"')],
        next="placedpar replay @kebab@"),
}


def filled(text, words):
    """Returns the text with the placeholders replaced."""
    return re.sub(r"@(\w+)@", lambda found: words[found[1]], text)


def check_name(name, piece):
    """Throws Refusal unless the name is possible in C++, in netlists and on the command line."""
    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", name):
        proper = re.sub(r"[^a-z0-9]+", "-", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", name).lower()).strip("-0123456789")
        raise Refusal(f'"{name}" cannot be a name: a name has small letters and digits, and hyphens between words, such as '
                      f'"{proper or "hour-glass"}"')
    if len(name) > LONGEST:
        raise Refusal(f'"{name}" has {len(name)} characters: a name has at most {LONGEST}')
    if name in RESERVED or name in piece.reserved:
        where = "a reserved word of C++" if name in RESERVED else "a word of netlists, or a name in the example's netlist"
        raise Refusal(f'"{name}" is {where}: choose another name, such as "my-{name}"')


def words_for(name, topic):
    """Returns the values of the placeholders."""
    words = name.replace("-", " ")
    article = "an" if name[0] in "aeiou" else "a"
    return {"kebab": name, "snake": name.replace("-", "_"), "Pascal": "".join(word.capitalize() for word in name.split("-")),
            "words": words, "Title": words[0].upper() + words[1:], "article": article, "Article": article.capitalize(),
            "example": f"{topic}/{name}"}


def words_for_experiment(folder, top):
    """Returns the chapter of the folder's experiments, and the next free number below 100. Experiments with numbers from 100 on stay at the end of the list."""
    files = sorted((top / "experiments" / folder).glob("*.cpp"))
    if not re.fullmatch(r"chapter_\w+|appendix_\w+|machine", folder) or not files:
        known = sorted(path.name for path in (top / "experiments").iterdir() if path.is_dir() and path.name != "kit")
        raise Refusal(f'experiments/{folder} has no experiments: expected one of the folders {", ".join(known)}')
    texts = [path.read_text(encoding="utf-8") for path in files]
    numbers = [int(number) for text in texts for number in re.findall(r"\.number = (\d+)", text)]
    chapters = [found for text in texts for found in re.findall(r'\.chapter = "(\w+)"', text)]
    return {"folder": folder, "chapter": chapters[0], "number": str(max(n for n in numbers if n < 100) + 1)}


def check_taken(piece, words, top):
    """Throws Refusal if something in the tree already has the name."""
    if (top / "examples" / words["example"]).exists():
        raise Refusal(f'examples/{words["example"]} already exists: choose another name than "{words["kebab"]}"')
    names = tree.names(top)
    for files, pattern in piece.taken:
        wanted = re.compile(filled(pattern, words))
        for name in names:
            if not re.fullmatch(files, name) or name.startswith("tests/"):
                continue
            text = re.sub(r"//.*", "", (top / name).read_text(encoding="utf-8", errors="replace"))  # without comments
            if found := wanted.search(text):
                line = text[:found.start()].count("\n") + 1
                raise Refusal(f'"{words["kebab"]}" is taken: {name}:{line} has {found[0].strip()}: choose another name')


def new_files(what, words, top):
    """Returns {path: text} of the filled templates. Throws Refusal if one of the files exists."""
    folder = HERE / what
    made = {}
    for template in sorted(path for path in folder.rglob("*.in")):
        path = filled(str(template.relative_to(folder)).removesuffix(".in"), words)
        if (top / path).exists():
            raise Refusal(f'{path} already exists: choose another name than "{words["kebab"]}", or remove the file')
        made[path] = filled(template.read_text(encoding="utf-8"), words)
    return made


def changed_files(piece, words, top):
    """Returns {path: text} of the files in which the new piece must be listed."""
    row = Insertion(f"examples/{piece.topic}/README.md", "\n\nBack to the [README]", f"\n| [@kebab@](@kebab@/README.md) | {piece.example} |")
    changed = {}
    for insertion in [*piece.insertions, row]:
        try:
            text = changed.get(insertion.file) or (top / insertion.file).read_text(encoding="utf-8")
        except OSError as error:
            raise Refusal(f"{insertion.file}: cannot be read, but must list the new piece: {error.strerror}") from error
        changed[insertion.file] = insertion.into(text, words)
    return changed


def formatted(texts, top):
    """Returns the texts, with C++ formatted by clang-format 14; unchanged if it is not installed."""
    program = formatting.clang_format()
    if not program:
        print("clang-format 14 is not installed, so the new files are not formatted: install it, and run python3 tests/tidy/format.py . --mend")
        return texts
    done = {}
    for path, text in texts.items():
        if tree.is_cpp(path):
            command = [program, f"--assume-filename={top / path}"]
            text = subprocess.run(command, cwd=top, input=text, capture_output=True, text=True, check=True).stdout
        done[path] = text
    return done


def write(texts, top):
    """Writes all of {path: text}, or nothing. Throws Refusal."""
    before = {path: (top / path).read_bytes() if (top / path).exists() else None for path in texts}
    folders = []
    try:
        for path, text in texts.items():
            missing = [folder for folder in (top / path).parents if not folder.exists()]
            (top / path).parent.mkdir(parents=True, exist_ok=True)
            folders += missing
            (top / path).write_text(text, encoding="utf-8")
    except OSError as error:
        put_back(before, folders, top)
        raise Refusal(f"{path}: cannot be written: {error.strerror}; nothing was changed") from error


def put_back(before, folders, top):
    for path, content in before.items():
        if content is None and (top / path).exists():
            (top / path).unlink()
        elif content is not None and (top / path).read_bytes() != content:
            (top / path).write_bytes(content)
    for folder in sorted(set(folders), key=lambda each: len(each.parts), reverse=True):
        if folder.exists():
            folder.rmdir()


def make(what, name, folder="machine", top=TOP):
    """Writes the piece. Returns the written texts by path, and the values of the placeholders. Throws Refusal."""
    piece = PIECES[what]
    check_name(name, piece)
    words = words_for(name, piece.topic)
    if what == "experiment":
        words |= words_for_experiment(folder, top)
    check_taken(piece, words, top)
    texts = formatted(new_files(what, words, top) | changed_files(piece, words, top), top)
    write(texts, top)
    return texts, words


def main(what, arguments, about):
    """Runs tools/new-WHAT with these arguments, and returns its exit code."""
    most = 2 if what == "experiment" else 1
    if arguments in (["-h"], ["--help"]):
        print(about.strip())
        return 0
    try:
        if not 1 <= len(arguments) <= most:
            raise Refusal(f"expected a name, got {len(arguments)} arguments\n{about.strip()}")
        texts, words = make(what, *arguments)
    except Refusal as refusal:
        print(f"new-{what}: {refusal}", file=sys.stderr)
        return 1
    print("\n".join(texts))
    print(f"Build and run it: ./demo, then {filled(PIECES[what].next, words)}; test it by ./check")
    return 0
