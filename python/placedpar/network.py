"""Networks and their runs."""

import copy
import html
import json
import numbers
import os
import warnings
from datetime import timedelta
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence, Union

from . import _core
from .build import Statements
from .errors import Deadlock, Error, NetlistError, NetlistWarning, ProgramError, caller
from .progress import ProgressOption, progress_of, watched
from .tables import table, table_of_columns, table_of_csv


Time = Union[float, str, timedelta]
FilePath = Union[str, "os.PathLike[str]"]


def picoseconds(time: Time) -> int:
    """Returns a time in picoseconds: a number is in seconds; a text has a unit as in a netlist ("20us")."""
    if isinstance(time, str):
        return _core.parse_time(time)
    if isinstance(time, timedelta):
        time = time.total_seconds()
    if not 0 <= time <= 9.2e6:
        raise Error(f"a time of {time} s, expected 0 to 9.2e6 s (virtual time lasts for 106 days)")
    return round(time * 1e12)


def limit(time: Optional[Time]) -> Optional[int]:
    """Returns the time limit of a run in picoseconds; None means no limit."""
    return None if time is None else picoseconds(time)


def seed_of(seed: int, what: str = "seed") -> int:
    """Returns the seed. Raises Error if it is not a valid seed."""
    if not isinstance(seed, numbers.Integral) or not 0 <= seed < 2**64:
        raise Error(f"{what} {seed!r}, expected a whole number from 0 to {2**64 - 1}")
    return int(seed)


def require_network(value: Any) -> None:
    """Raises TypeError if the value is not a Network."""
    if not isinstance(value, Network):
        raise TypeError(f"expected a network, such as pp.load(\"ring.cfs\"), not {value!r}")


def setting(value: Any) -> str:
    """Returns the value of a setting as `placedpar run --set` takes it."""
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    return value if isinstance(value, str) else str(value)


class _Shown:
    """Base class of objects that a notebook shows. `text` is the object's text."""

    def __init__(self, text: str) -> None:
        self.text = text

    def save(self, path: FilePath) -> None:
        """Writes the text to a file, which a browser can show without access to the internet."""
        Path(path).write_text(self.text, encoding="utf-8")


class Drawing(_Shown):
    """A drawing in SVG, which a notebook shows. `text` is the SVG."""

    def _repr_svg_(self) -> str:
        return self.text


class Page(_Shown):
    """The page of a run in HTML, which a notebook shows in a frame. `text` is the HTML."""

    def __init__(self, text: str, height: int) -> None:
        super().__init__(text)
        self.height = height

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="{self.height}" '
                'style="border: 1px solid #ccc"></iframe>')


class Run:
    """A finished run of a network, as Network.run() returns it."""

    def __init__(self, network: _core.Network, core: _core.Run) -> None:
        self._network = network
        self._core = core
        self._report: Optional[dict[str, Any]] = None

    @property
    def fingerprint(self) -> str:
        """The fingerprint as 16 hexadecimal digits. It covers the order and the times of all events."""
        return f"{self._core.fingerprint:016x}"

    @property
    def outcome(self) -> str:
        """How the run ended: "completed", "stopped at the time limit", "deadlock", "program failed", or "halted by an error"."""
        return self._core.outcome

    @property
    def time(self) -> float:
        """The virtual time of the run's work, in seconds."""
        return self._core.time_ps / 1e12

    @property
    def events(self) -> int:
        """The number of events of the machine."""
        return self._core.events

    @property
    def output(self) -> str:
        """The text that programs in occam wrote to the screen of their host; "" if there was none."""
        return self._core.output

    @property
    def report(self) -> dict[str, Any]:
        """The whole report as a dictionary, as `placedpar run --json` writes it. Times are in picoseconds."""
        if self._report is None:
            self._report = json.loads(self._network.report_json(self._core))
        return self._report

    @property
    def measures(self) -> Any:
        """A table of what the processes measured: process, name, value, unit."""
        return table(self.report["measurements"], ["process", "name", "value", "unit"])

    @property
    def processors(self) -> Any:
        """A table of the processors: name, type, busy (a fraction of the run's time), busy_ps."""
        return table(self.report["processors"], ["name", "type", "busy", "busy_ps"])

    @property
    def links(self) -> Any:
        """A table of the directions of links: from, to, bytes, occupied (a fraction of the run's time), occupied_ps."""
        return table(self.report["links"], ["from", "to", "bytes", "occupied", "occupied_ps"])

    @property
    def processes(self) -> Any:
        """A table of the processes: name, on (its processor), waiting (a fraction of the run's time), waiting_ps."""
        return table(self.report["processes"], ["name", "on", "waiting", "waiting_ps"])

    @property
    def log(self) -> Any:
        """A table of every generation of every search, in long form: seed, generation, time_ms, process, from,
        quantity, value. The quantities are best, best_so_far, mean, diversity, immigrants and so on."""
        return table_of_csv(self._core.log_csv())

    @property
    def timeline(self) -> Any:
        """A table of intervals: track (a process, processor or link), activity, begin and end in seconds, subject (the
        process that a processor executes, or the channel that a link carries), bytes, partner (of a wait). The run is
        repeated to record the intervals."""
        names = ("track", "activity", "begin", "end", "subject", "bytes", "partner")
        return table_of_columns(**dict(zip(names, self._network.timeline(self._core))))

    def page(self, height: int = 700) -> Page:
        """Returns the page of the run: machine, timelines, convergence. The run is repeated to record the page.

        height: height of the frame in a notebook, in pixels.
        """
        return Page(self._network.page(self._core), height)

    def __str__(self) -> str:
        return self._network.report_text(self._core)

    def __repr__(self) -> str:
        return f"<placedpar.Run {self.outcome} at {self.time:.9g} s, fingerprint {self.fingerprint}>"


class Network(Statements):
    """A network of processors and processes: load() reads a network from a file, and calls add parts to an empty Network().

        net = pp.Network()
        a = net.processor("T800", clock="20M")
        b = net.processor("T800")
        net.connect(a.link[1], b.link[0])
        ends = net.process("ends", Ends, on=a)
        relay = net.process("relay", Relay, on=b, cycles=1000)
        net.connect(ends.out, relay.inp)
        net.connect(relay.out, ends.inp)
        net.run()

    A network built in Python is checked at its first use. An error raises NetlistError with the line of the program.
    """

    def __init__(self) -> None:
        super().__init__()
        self._file = ""  # "" if the statements are the netlist
        self._settings: dict[str, str] = {}
        self._more: tuple[list[str], list[str], dict[str, str]] = ([], [], {})  # include, faults, use
        self._checked: Optional[tuple[int, _core.Network]] = None  # the checked network, and the number of its statements

    @property
    def _core(self) -> _core.Network:
        if self._checked is None or self._checked[0] != len(self._lines):
            try:
                core = _core.Network(self._file or "netlist", "\n".join(self._lines), bool(self._file), self._settings,
                                     *self._more, self._kinds)
            except NetlistError as wrong:
                raise self._placed(wrong) if self._places else wrong from None
            if core.warnings:
                warnings.warn(str(self._placed(NetlistError("", core.warnings))), NetlistWarning, caller()[1])
            self._checked = (len(self._lines), core)
        return self._checked[1]

    def changed(self, settings: Mapping[str, Any]) -> "Network":
        """Returns the network with changed settings, which are given as in load()."""
        other = Network()
        other.__dict__.update({name: copy.copy(value) for name, value in self.__dict__.items()})
        other._settings = {**self._settings, **{name: setting(value) for name, value in settings.items()}}
        other._checked = None
        return other

    def run(self, seed: int = 1, until: Optional[Time] = None, shuffle: Optional[int] = None,
            progress: ProgressOption = None, keys: str = "") -> Run:
        """Runs the network in virtual time and returns a Run. Other Python threads continue meanwhile; Ctrl-C ends the run.

        seed: seed of all random numbers.
        until: latest end of the run, in seconds or as "20ms".
        shuffle: a seed; ready processes then run in a random order that this seed determines.
        progress: a function that is called, on another thread, with the virtual time and the latest end in seconds
        (None if there is none); False shows no line of progress on a terminal or in a notebook. The virtual time is the
        time of the latest generation of a search, or of the latest step of a process in Python. A run without searches
        and without processes in Python reports only its end.
        keys: the keys that are pressed for a program in occam; "\\r" is the return key.

        Raises Deadlock, ProgramError, ProcessError, and Error for a run that cannot be made.
        """
        order = None if shuffle is None else seed_of(shuffle, "shuffle")
        end_ps, clock = limit(until), _core.Clock()
        end = None if end_ps is None else end_ps / 1e12
        with progress_of(progress, "{} of {} s of virtual time") as tell:
            with watched(tell, lambda: clock.picoseconds / 1e12, end):
                core = self._core.run(seed_of(seed), end_ps, order, clock if tell else None, keys)
            if tell:
                tell(core.time_ps / 1e12, end)
        run = Run(self._core, core)
        if core.failure_text():
            raise ProgramError(core.failure_text(), run)
        if core.outcome == "deadlock":
            raise Deadlock(core.deadlock_text(), run)
        return run

    def svg(self, software: bool = False) -> Drawing:
        """Returns a drawing of the machine, or of the processes and channels alone."""
        return Drawing(self._core.software_svg() if software else self._core.svg())

    @property
    def cfs(self) -> str:
        """Returns the network as a netlist without loops and constants."""
        return self._core.cfs()

    def _repr_svg_(self) -> str:
        return self._core.svg()

    def __repr__(self) -> str:
        nodes, processes, channels = self._core.counts
        return f"<placedpar.Network {self._core.path}: {nodes} nodes, {processes} processes, {channels} channels>"


def load(netlist: FilePath, kinds: Sequence[type] = (), settings: Optional[Mapping[str, Any]] = None,
         include: Sequence[FilePath] = (), faults: Sequence[str] = (), use: Optional[Mapping[str, str]] = None,
         **more_settings: Any) -> Network:
    """Reads a netlist, a configuration (.pgm) or a program in occam (.occ), and returns a Network.

    netlist: the path of a file, or the text of a netlist (a text has a semicolon or several lines). A program runs on
    one T800 with 2 Mbyte, as in `placedpar run`.
    kinds: classes derived from Process, which the netlist names by their `kind`.
    settings, and further keyword arguments: values, attributes and parameters that replace the values in the netlist,
    such as slaves=4, linkspeed="10M", settings={"t[0].clock": "20M"}. For a configuration or a program, they replace the
    values of VALs, too, such as n=7.
    include: folders that are searched for included files.
    faults: faults, written as in a netlist.
    use: process kinds that replace programs, by the programs' names in the netlist, such as {"sim.lku": "ga.master"}.

    Raises NetlistError, with file, line, column and hint of each error.
    """
    for kind in kinds:
        if not hasattr(kind, "_ports"):
            raise TypeError(f"kinds must be classes derived from placedpar.Process, not {kind!r}")
    text = os.fspath(netlist)
    network = Network()
    if ";" in text or "\n" in text:
        network._lines = text.split("\n")
    else:
        network._file = text
    network._kinds = list(kinds)
    network._more = ([os.fspath(folder) for folder in include], list(faults), dict(use or {}))
    network._is_loaded = True
    network = network.changed({**(settings or {}), **more_settings})
    network._core  # raises the errors
    return network
