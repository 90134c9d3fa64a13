"""Process kinds in Python.

    class Relay(pp.Process):
        inp = pp.Input(int)
        out = pp.Output(int)
        cycles = 100

        def body(self):
            while True:
                x = yield self.inp.input()
                yield pp.compute(self.cycles)
                yield self.out.output(x + 1)

A body is a generator that yields operations, which the process performs in virtual time. Python code itself takes no
virtual time.
"""

import inspect
from typing import Any, Generator, Optional, Union

from . import _core
from ._core import ChannelEnd, Operation, Packet, RandomStream, after, alt, never, par, skip, stop
from .errors import Error
from .network import Time, picoseconds

__all__ = ["BYTE", "INT16", "INT64", "REAL32", "Input", "Inputs", "Output", "Outputs", "Packet", "Parameter", "Process",
           "RandomStream", "after", "alt", "clock", "compute", "never", "now", "par", "skip", "stop", "until", "wait",
           "when"]

INT16, INT64, BYTE, REAL32 = "INT16", "INT64", "BYTE", "REAL32"
_PROTOCOLS = {int: "INT32", float: "REAL64", bool: "BOOL", bytes: "[]BYTE", Packet: "packet", object: "object"}


def _protocol(kind: Any) -> str:
    """Returns the protocol for the type of a port's messages, which may be a list type such as list[float]."""
    arguments = getattr(kind, "__args__", None)
    if getattr(kind, "__origin__", None) is list and arguments:
        return "[]" + _protocol(arguments[0])
    if kind in _PROTOCOLS:
        return _PROTOCOLS[kind]
    if isinstance(kind, str):
        return kind
    raise TypeError(f"a port can carry int, float, bool, bytes, list[int], list[float], pp.Packet, object, pp.INT16, "
                    f"pp.INT64, pp.BYTE or pp.REAL32, not {kind!r}")


class _Port:
    is_output = False
    is_array = False

    def __init__(self, kind: Any, about: str = "", optional: bool = False) -> None:
        self.protocol = _protocol(kind)
        self.about = about
        self.optional = optional
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name


class Input(_Port):
    """An input end. `yield self.NAME.input()` returns the message."""


class Inputs(_Port):
    """An array of input ends, connected as NAME[0], NAME[1] and so on. In the body, self.NAME is a list of input ends."""
    is_array = True


class Output(_Port):
    """An output end. `yield self.NAME.output(message)` returns when the receiver has taken the message."""
    is_output = True


class Outputs(_Port):
    """An array of output ends. In the body, self.NAME is a list of output ends."""
    is_output = True
    is_array = True


class Parameter:
    """A parameter with a unit and a range. A plain attribute, such as `cycles = 100`, is a parameter, too.

    default: the default value, an int, a float or a str; or the type int, float or str if the netlist must give a value.
    """

    def __init__(self, default: Any, unit: str = "", least: Optional[float] = None, most: Optional[float] = None,
                 about: str = "") -> None:
        is_type = isinstance(default, type)
        types = {int: "integer", float: "real", str: "text"}
        kind = default if is_type else type(default)
        if kind not in types:
            raise TypeError(f"a parameter must be an int, a float or a str, not {default!r}")
        if kind is int and not is_type and not -2**63 <= default < 2**63:
            raise Error(f"a parameter of {default}, expected a whole number of 64 bits")
        self.type = types[kind]
        self.default = None if is_type else default
        self.unit, self.least, self.most, self.about = unit, least, most, about
        self.name = ""


class Process:
    """A process kind. Attributes that are ports or parameters describe its interface; `body` is its program.

    In the body, `self.name` is the name of the process in the netlist, such as "relay[2]", and `self.seed` is the
    seed of the run. `kind` is the name of the kind in netlists; by default it is the name of the class.
    """

    kind: str = ""
    name: str
    seed: int
    _measure: Any

    def __init_subclass__(cls, **arguments: Any) -> None:
        super().__init_subclass__(**arguments)
        if "kind" not in cls.__dict__:
            cls.kind = cls.__name__

    def body(self) -> Optional[Generator[Operation, Any, Any]]:
        """The program of the process: a generator of operations."""
        raise NotImplementedError(f"{type(self).__name__} has no body")

    def measure(self, name: str, value: Union[float, str], unit: str = "") -> None:
        """Reports a number, with its unit, or a text at the end of the run."""
        self._measure(name, value if isinstance(value, str) else float(value), unit)

    def random(self, name: Optional[str] = None) -> RandomStream:
        """Returns the random stream of this name, by default the process's name. It has uniform(), normal(), below(n)
        and chance(p). The numbers depend only on the run's seed and the name."""
        return RandomStream(self.seed, self.name if name is None else name)

    @classmethod
    def _attributes(cls) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for base in reversed(cls.__mro__[:cls.__mro__.index(Process)]):
            found.update(base.__dict__)
        return {name: value for name, value in found.items() if not name.startswith("_") and name != "kind"}

    @classmethod
    def _ports(cls) -> list[_Port]:
        return [value for value in cls._attributes().values() if isinstance(value, _Port)]

    @classmethod
    def _parameters(cls) -> list[Parameter]:
        parameters = []
        for name, value in cls._attributes().items():
            if isinstance(value, (int, float, str)) and not isinstance(value, bool):
                try:
                    value = Parameter(value)
                except (Error, TypeError) as wrong:
                    raise Error(f"{cls.__name__}.{name}: {wrong}") from None
            if isinstance(value, (Parameter, _Port)) and name in ("name", "seed"):
                raise Error(f"{cls.__name__}.{name}: each process has this attribute already: choose another name")
            if isinstance(value, Parameter):
                value.name = name
                parameters.append(value)
        return parameters

    @classmethod
    def _about(cls) -> str:
        return cls.__doc__ and inspect.getdoc(cls) or f"The class {cls.__name__} of a program in Python."


def compute(cycles: int, words_outside: int = 0) -> Operation:
    """Computes for this number of processor cycles. words_outside: number of accesses to memory outside the chip."""
    return _core.compute(cycles, words_outside)


def wait(time: Time) -> Operation:
    """Waits for a time, in seconds or as "20us". As a guard of `alt`, it is ready after this time."""
    return _core.wait(picoseconds(time))


def until(time: Time) -> Operation:
    """Waits until a virtual time, in seconds from the start of the run or as "20ms". It can also be a guard of `alt`."""
    return _core.until(picoseconds(time))


def when(condition: bool, guard: Union[ChannelEnd, Operation]) -> Union[ChannelEnd, Operation]:
    """Returns the guard if the condition is true, otherwise a guard that is never ready."""
    return guard if condition else never()


def now() -> float:
    """Returns the virtual time in seconds. Call it only in a body."""
    return _core.now_ps() / 1e12


def clock() -> int:
    """Returns the reading of the processor's clock in ticks, as occam's `timer ? t` does. Call it only in a body."""
    return _core.clock()
