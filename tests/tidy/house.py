"""Checks rules for the whole project: size of rooms, length of functions, and required files."""

import collections
import math

import functions
import tree
import walls

ROOM_PERCENT = 17
SHARES = ((50, 7), (90, 17))  # (percent, lines): this percentage of a room's functions have at most this many lines
HOUSE_SHARES = ((50, 6), (90, 15))  # the limits for all rooms together
# The functions of a compiler list the forms of a construct, so that they are longer.
SHARES_OF = {"occam": ((50, 9), (90, 24))}


def nearest_rank(values, percent):
    """Returns the least value that the given percentage of the values do not exceed."""
    return sorted(values)[math.ceil(len(values) * percent / 100) - 1]


def too_long(place, lengths, shares):
    """Returns a sentence for each percentage of the functions of a place (a room, or all rooms) that exceeds its limit."""
    for percent, most in shares:
        lines = nearest_rank(lengths or [0], percent)
        if lines > most:
            yield f"{place}: {percent} % of the functions have up to {lines} lines, more than {most}"


class House:
    """Groups {name: text of each C++ file} by room."""

    def __init__(self, texts):
        self.lines = collections.Counter()
        self.functions = collections.defaultdict(list)
        self.includes = {name: set(walls.includes(text)) & texts.keys() for name, text in texts.items()}
        for name, text in texts.items():
            room = walls.room_of(name)
            if room:
                self.lines[room] += len(text.splitlines())
                self.functions[room] += [function.lines for function in functions.functions(text)]

    def percent(self, room):
        return 100 * self.lines[room] / sum(self.lines.values())

    def line_of(self, room):
        """Describes the size of the room and of its functions."""
        lengths = self.functions[room] or [0]
        shares = ", ".join(f"p{percent} {nearest_rank(lengths, percent):2}" for percent, _ in SHARES)
        return (f"{room:15}{self.lines[room]:6} lines {self.percent(room):5.1f} %   "
                f"functions: {shares}, longest {max(lengths):2}")

    def chain_faults(self):
        """Returns a fault if the longest chain of headers, each including the next, is too long."""
        chain = walls.longest_chain({name: included for name, included in self.includes.items() if name.endswith(".hpp")})
        if len(chain) > walls.LONGEST_CHAIN:
            yield f"{len(chain)} headers in a chain, more than {walls.LONGEST_CHAIN}: " + " > ".join(chain)

    def faults(self, names):
        """Returns the faults, a sentence each. `names` are all files of the tree."""
        circle = walls.circle(self.includes) or walls.circle(walls.pieces(self.includes))
        if circle:
            yield "files include each other in a circle: " + " -> ".join(circle)
        else:
            yield from self.chain_faults()
        for loose in walls.loose_ends(self.includes):
            yield f"{loose} is in no circle with the others of its knot: see KNOTS in tests/tidy/walls.py"
        for room in sorted(self.lines):
            if f"{room}/README.md" not in names:
                yield f"{room}: there is no README.md that says what it is, where to start, what may be touched"
            if self.percent(room) > ROOM_PERCENT:
                yield f"{room}: {self.percent(room):.1f} % of the code, more than {ROOM_PERCENT} %"
            yield from too_long(room, self.functions[room], SHARES_OF.get(room, SHARES))
        yield from too_long("all rooms", [lines for room in self.functions.values() for lines in room], HOUSE_SHARES)


def read(texts):
    """Returns the house made of the C++ files in {name: text}."""
    return House({name: text for name, text in texts.items() if tree.is_cpp(name)})
