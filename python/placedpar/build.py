"""Builds networks in Python, without the text of a netlist: each call adds a statement of a netlist."""

import keyword
import re
from typing import Any, Optional, Union

from .errors import Error, NetlistError, caller

_UNQUOTED = re.compile(r"-?\d[\d.]*(e[+-]?\d+)?[kKmM]?|TRUE|FALSE|HIGH|LOW")


def _expression(value: Any) -> str:
    """Returns a value as a netlist writes it: "20M" is a number, any other text gets quotes."""
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, (list, tuple)):
        return "{" + ", ".join(map(_expression, value)) + "}"
    if not isinstance(value, str):
        return str(value)
    if _UNQUOTED.fullmatch(value):
        return value
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def _attributes(values: dict[str, Any]) -> str:
    return "(" + ", ".join(f"{name} = {_expression(value)}" for name, value in values.items()) + ")" if values else ""


class Port:
    """A port of a process, such as `relay.out` or `master.to_slaves[2]`, or a link of a node, such as `root.link[1]`."""

    def __init__(self, owner: "Part", text: str) -> None:
        self.owner = owner
        self.text = text

    def __getitem__(self, index: int) -> "Port":
        return Port(self.owner, f"{self.text}[{index}]")

    def __repr__(self) -> str:
        return f"<placedpar.Port {self.text}>"


class Part:
    """A node or a process of a network built in Python. Its attributes are its ports. Write the port `in` as `in_`."""

    def __init__(self, name: str, on: "Optional[Part]" = None) -> None:
        self._name = name
        self._on = on

    def __getattr__(self, port: str) -> Port:
        if port.startswith("_"):
            raise AttributeError(port)
        is_keyword = port.endswith("_") and keyword.iskeyword(port[:-1])
        return Port(self, f"{self._name}.{port[:-1] if is_keyword else port}")

    def __repr__(self) -> str:
        return f"<placedpar.Part {self._name}>"


class Statements:
    """The statements of a network, each with the line of the program that added it."""

    def __init__(self) -> None:
        self._lines: list[str] = []
        self._places: list[tuple[str, int]] = []
        self._kinds: list[type] = []
        self._names: set[str] = set()
        self._is_loaded = False

    def statement(self, text: str) -> None:
        """Adds a statement of a netlist, such as "fault a.link[0] silent (from = 20ms);"."""
        if self._is_loaded:
            raise Error("a network that was loaded takes no more statements: build one with placedpar.Network()")
        frame = caller()[0]
        self._lines.append(text.replace("\n", " "))
        self._places.append((frame.f_code.co_filename, frame.f_lineno))

    def processor(self, type: str, name: Optional[str] = None, **attributes: Any) -> Part:
        """Adds a node, such as processor("T800", clock="20M"), and returns it. The type may be any node type of
        netlists, such as "T800", "C004" or "workstation"."""
        part = Part(self._new(name or f"{type.lower()}_{len(self._lines)}"))
        self.statement(f"{type} {_attributes(attributes)} {part._name};")
        return part

    def process(self, name: str, kind: Union[str, type], on: Part, priority: Optional[str] = None,
                **parameters: Any) -> Part:
        """Adds a process and returns it.

        kind: a class derived from Process, or the name of a kind, such as "csp.producer".
        on: the processor of the process.
        priority: "HIGH" or "LOW".
        """
        part = Part(self._new(name), on)
        if isinstance(kind, type) and kind not in self._kinds:
            if not hasattr(kind, "_ports"):
                raise TypeError(f"a kind is a class derived from placedpar.Process, or a name, not {kind!r}")
            self._kinds.append(kind)
        named = kind if isinstance(kind, str) else getattr(kind, "kind")
        self.statement(f"process {_attributes({'priority': priority} if priority else {})} {name}; "
                       f"use {_expression(named)} for {name}; place {name} on {on._name};"
                       + (f" {name} {_attributes(parameters)};" if parameters else ""))
        return part

    def connect(self, a: Port, b: Port, link: Optional[Port] = None, **attributes: Any) -> None:
        """Connects two ports by a channel, or two links by a wire.

        link: the link of a processor that carries the channel; by default, the channel takes the shortest route.
        attributes: attributes of the wire, such as length=0.3 or linkspeed="10M".
        """
        name = f"connection_{len(self._lines)}"
        declared = f"connection {_attributes(attributes)} {name}; " if attributes else ""
        placed = ""
        if link is not None:
            ends = [end for end in (a, b) if end.owner._on is link.owner]
            if not ends:
                raise Error(f"{link.text} cannot carry the channel: expected a link of the processor of {a.text} or of {b.text}")
            placed = f" place {ends[0].text} on {link.text};"
        self.statement(f"{declared}connect {a.text} to {b.text}{f' by {name}' if declared else ''};{placed}")

    def _new(self, name: str) -> str:
        if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII):
            raise Error(f"the name {name!r}: expected letters, digits and underscores, not beginning with a digit")
        if name in self._names:
            raise Error(f"the name {name!r} is used twice: choose another name")
        self._names.add(name)
        return name

    def _placed(self, wrong: NetlistError) -> NetlistError:
        """Returns the errors with the lines of the Python program instead of the lines of the netlist."""
        diagnostics = []
        for each in wrong.diagnostics:
            if each["line"] and self._places:
                file, line = self._places[each["line"] - 1]
                hint = f"\nhint: {each['hint']}" if each["hint"] else ""
                text = f"{file}:{line}: {each['severity']}: {each['message']}\n  {self._lines[each['line'] - 1]}{hint}"
                each = {**each, "file": file, "line": line, "column": 0, "text": text}
            diagnostics.append(each)
        return NetlistError("\n".join(each["text"] for each in diagnostics), diagnostics)
