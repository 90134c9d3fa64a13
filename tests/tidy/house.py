"""Rules of the house as a whole: the size of rooms, the length of their functions, what each must have."""

import collections
import math

import functions
import tree
import walls

ROOM_PERCENT = 17
SHARES = ((50, 7), (90, 17))  # so many percent of a room's functions have at most so many lines
HOUSE_SHARES = ((50, 6), (90, 14))  # and of all rooms together


def nearest_rank(values, percent):
    """The least of the values that so many percent of them do not exceed."""
    return sorted(values)[math.ceil(len(values) * percent / 100) - 1]


def too_long(place, lengths, shares):
    """A sentence for each share of a place's functions that are longer than they may be."""
    for percent, most in shares:
        lines = nearest_rank(lengths or [0], percent)
        if lines > most:
            yield f"{place}: {percent} % of the functions have up to {lines} lines, more than {most}"


class House:
    """What of {name: text of each C++ file} lies in which room."""

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
        """For people: how large the room is, and its functions."""
        lengths = self.functions[room] or [0]
        shares = ", ".join(f"p{percent} {nearest_rank(lengths, percent):2}" for percent, _ in SHARES)
        return (f"{room:15}{self.lines[room]:6} lines {self.percent(room):5.1f} %   "
                f"functions: {shares}, longest {max(lengths):2}")

    def chain_faults(self):
        """That a row of headers is too long, each of which includes the next."""
        chain = walls.longest_chain({name: included for name, included in self.includes.items() if name.endswith(".hpp")})
        if len(chain) > walls.LONGEST_CHAIN:
            yield f"{len(chain)} headers in a chain, more than {walls.LONGEST_CHAIN}: " + " > ".join(chain)

    def faults(self, names):
        """What is wrong, a sentence each. `names` are all files of the tree."""
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
            yield from too_long(room, self.functions[room], SHARES)
        yield from too_long("all rooms", [lines for room in self.functions.values() for lines in room], HOUSE_SHARES)


def read(texts):
    """The house of the C++ files among {name: text}."""
    return House({name: text for name, text in texts.items() if tree.is_cpp(name)})
