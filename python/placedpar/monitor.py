"""A client of `placedpar monitor`, the on-line diagnosis (docs/guides/monitor.md)."""

import json
import socket
from typing import Any, Mapping, Optional, Sequence

from .errors import Error


class Monitor:
    """A connection to a monitor, for one machine. Use it in a `with` statement.

    machine: name of the machine.
    port: the TCP port of the monitor at `address`.
    unix: the path of the monitor's socket, in place of `port`.
    timeout_s: longest time to wait for an answer.
    hello: further fields of the first message, such as role="watch" or token="...".

    `welcome` is the monitor's answer to the first message. Raises Error if the monitor refuses a message.
    """

    def __init__(self, machine: str, port: int = 0, address: str = "127.0.0.1", unix: Optional[str] = None,
                 timeout_s: float = 10, **hello: Any) -> None:
        self.alarms: list[dict[str, Any]] = []  #: the alarm messages received so far, oldest first
        if unix is None:
            self._socket = socket.create_connection((address, port), timeout_s)
        else:
            self._socket = socket.socket(socket.AF_UNIX)
            self._socket.settimeout(timeout_s)
            self._socket.connect(unix)
        self._lines = self._socket.makefile("r", encoding="utf-8", newline="\n")
        try:
            self.welcome = self.ask("welcome", type="hello", version=1, machine=machine, **hello)
        except BaseException:
            self.close()
            raise

    def ask(self, answer: str, **message: Any) -> dict[str, Any]:
        """Sends a message and returns the next answer of this type. Appends alarms that arrive before the answer to `alarms`."""
        self._socket.sendall((json.dumps(message) + "\n").encode())
        while True:
            line = self._lines.readline()
            if not line:
                raise Error("the monitor has closed the connection")
            came: dict[str, Any] = json.loads(line)
            if came["type"] == "alarm":
                self.alarms.append(came)
            elif came["type"] == "error":
                field = f"{came['field']}: " if came["field"] else ""
                raise Error(f"the monitor refuses the message: {field}{came['wrong']}, expected {came['right']}")
            elif came["type"] == answer:
                return came

    def configure(self, configuration: str, active: Sequence[str]) -> dict[str, Any]:
        """States the configuration of the main valve, "a" to "e", and the links that move, such as ["BU", "BO"]."""
        return self.ask("configured", type="configuration", configuration=configuration, active=list(active))

    def sample(self, time_s: float, links: Mapping[str, Mapping[str, float]]) -> dict[str, Any]:
        """Sends the readings of all active links at one instant, and returns the estimates.

        links: for each link, inlet_psi and angle_deg, and also spool_in, or servo_V, or inlet_in2 and bypass_in2.
        """
        return self.ask("estimates", type="sample", time_s=time_s, links={name: dict(each) for name, each in links.items()})

    def close(self) -> None:
        """Closes the connection. The monitor keeps the diagnosis."""
        self._lines.close()
        self._socket.close()

    def __enter__(self) -> "Monitor":
        return self

    def __exit__(self, *exception: Any) -> None:
        self.close()
