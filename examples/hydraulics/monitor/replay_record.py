#!/usr/bin/env python3
"""Replays records of measurement to `placedpar monitor`, as a control system would send them.

Each record is a CSV file: lines starting with '#' describe it, then a row such as

    time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [in]

and a row for each sample. Of a link it takes inlet_pressure and angle with spool, servo, or inlet_area and
bypass_area. The first record begins at its own time, each further one a second after the one before.
"""

import argparse
import csv
import json
import math
import pathlib
import re
import signal
import socket
import subprocess
import sys
import time

SYMBOLS = {"bucket": "BU", "boom": "BO", "stick": "ST", "swing": "SW"}
SYMBOLS |= {symbol: symbol for symbol in SYMBOLS.values()}

# Field of the message, and factors into its unit.
PRESSURE = {"psi": 1, "Pa": 1 / 6894.757, "kPa": 1 / 6.894757, "MPa": 1000 / 6.894757, "bar": 100 / 6.894757}
LENGTH = {"in": 1, "mm": 1 / 25.4, "cm": 1 / 2.54, "m": 1 / 0.0254}
AREA = {"in^2": 1, "cm^2": 1 / 6.4516, "mm^2": 1 / 645.16, "m^2": 1 / 0.00064516}
SENSORS = {
    "inlet_pressure": ("inlet_psi", PRESSURE),
    "angle": ("angle_deg", {"deg": 1, "rad": 180 / math.pi}),
    "spool": ("spool_in", LENGTH),
    "servo": ("servo_V", {"V": 1, "mV": 1e-3}),
    "inlet_area": ("inlet_in2", AREA),
    "bypass_area": ("bypass_in2", AREA),
}
TIMES = {"s": 1, "ms": 1e-3}


class Refused(Exception):
    """What is wrong, for the user."""


def factor(path, column, unit, factors):
    """From the unit of a column to that of the message."""
    if unit not in factors:
        raise Refused(f"{path}: {column}: the unit is [{unit}], expected one of {', '.join(factors)}")
    return factors[unit]


def read_header(path, cells):
    """For each column what to do with it: None, "time" or (link, field), and the factor."""
    columns = []
    for cell in cells:
        if cell.strip() == "configuration":  # the true one, which the monitor is not told
            columns.append((None, 1))
            continue
        found = re.fullmatch(r"\s*(\S+)\s*\[(.*)\]\s*", cell)
        if not found:
            raise Refused(f"{path}: {cell!r}: expected a name and a unit, such as boom.angle [deg]")
        name, unit = found.groups()
        link, _, sensor = name.partition(".")
        if name == "time":
            columns.append(("time", factor(path, name, unit, TIMES)))
        elif link in SYMBOLS and sensor in SENSORS:
            field, factors = SENSORS[sensor]
            columns.append(((SYMBOLS[link], field), factor(path, name, unit, factors)))
        else:
            columns.append((None, 1))  # outlet pressures and the like
    if "time" not in [what for what, _ in columns]:
        raise Refused(f"{path}: there is no column time [s]")
    return columns


def valve_of(fields):
    """The fields that describe the valve; the first that is complete of areas, spool and voltage."""
    for choice in (("inlet_in2", "bypass_in2"), ("spool_in",), ("servo_V",)):
        if all(field in fields for field in choice):
            return choice
    return ()


def usable(path, columns):
    """The columns that a message takes: a link's field and the factor, None for those that it does not."""
    links = {}
    for what, _ in columns:
        if what and what != "time":
            links.setdefault(what[0], []).append(what[1])
    taken = {"time"}
    for symbol, fields in links.items():
        if valve_of(fields) and "inlet_psi" in fields and "angle_deg" in fields:
            taken |= {(symbol, field) for field in ("inlet_psi", "angle_deg", *valve_of(fields))}
    if taken == {"time"}:
        raise Refused(f"{path}: no link has all readings that identification needs: inlet_pressure, angle, "
                      "and spool or servo or (inlet_area and bypass_area)")
    return [(what, scale) if what in taken else (None, 1) for what, scale in columns]


def read_sample(columns, row):
    """A row as a message. Raises ValueError for a cell that is needed and no number."""
    time_s, links = 0, {}
    for (what, scale), cell in zip(columns, row):
        if what is None:
            continue
        value = float(cell) * scale
        if what == "time":
            time_s = value
        else:
            symbol, field = what
            links.setdefault(symbol, {})[field] = max(value, 0.0) if field == "spool_in" else value  # noise about 0
    return {"type": "sample", "time_s": time_s, "links": links}


def read_record(path):
    """The samples as messages."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = [row for row in csv.reader(line for line in file if not line.startswith("#")) if row]
    if not rows:
        raise Refused(f"{path}: there is no header")
    columns, samples = usable(path, read_header(path, rows[0])), []
    for number, row in enumerate(rows[1:], 1):
        if len(row) != len(columns):
            raise Refused(f"{path}: sample {number} has {len(row)} values, expected {len(columns)}")
        try:
            samples.append(read_sample(columns, row))
        except ValueError as error:
            raise Refused(f"{path}: sample {number}: {error}") from None
    if not samples:
        raise Refused(f"{path}: there are no samples")
    return samples


class Monitor:
    """A connection to the service."""

    def __init__(self, address, port, token):
        self.socket = socket.create_connection((address, port), timeout=30)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.lines = self.socket.makefile("r", encoding="utf-8")
        if token:
            self.ask({"type": "token", "token": token}, "accepted")

    def send(self, message):
        self.socket.sendall(json.dumps(message).encode() + b"\n")

    def receive(self):
        line = self.lines.readline()
        if not line:
            raise Refused("the monitor has closed the connection")
        message = json.loads(line)
        if message["type"] == "error":
            raise Refused(f"the monitor refuses {message['field']}: {message['wrong']}; right is {message['right']}")
        if message["type"] == "closing":
            raise Refused(f"the monitor has closed the connection: {message['text']}")
        return message

    def ask(self, message, answer):
        """Sends it and gives its answer; alarms on the way are printed."""
        self.send(message)
        while True:
            received = self.receive()
            if received["type"] == answer:
                return received
            if received["type"] == "alarm":
                print(f"{received['time_s']:7.2f} s  alarm {received['state']}: {received['alarm']}: {received['text']}")


def start_service():
    """A service of our own on any free port."""
    service = subprocess.Popen(["placedpar", "monitor"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return service, int(service.stdout.readline().split()[-1])


def print_estimates(answer):
    for name, state in answer["sets"].items():
        for symbol, link in state["links"].items():
            if link["compliance_in3_per_psi"] is not None:
                flags = "".join(f", {flag}" for flag in link["flags"])
                error = link["standard_error_in3_per_psi"]
                how = (f"{link['excitation_psi_per_s']:.0f} psi/s" if "excitation_psi_per_s" in link
                       else f"standard error {error:.5f}" if error else "standard error unknown")
                print(f"{answer['time_s']:7.2f} s  {name} {symbol}: {link['compliance_in3_per_psi']:.5f} in^3/psi, "
                      f"{how}{flags}")


def replay(monitor, samples, offset_s, options):
    """One record; gives the time of its last sample."""
    configuration = {"type": "configuration", "configuration": options.configuration}
    if options.configuration != "auto":
        configuration["active"] = sorted(samples[0]["links"])
    monitor.ask(configuration, "configured")
    began = time.monotonic()
    for number, sample in enumerate(samples):
        if options.speed > 0:
            due = began + (sample["time_s"] - samples[0]["time_s"]) / options.speed
            time.sleep(max(0.0, due - time.monotonic()))
        moved = dict(sample, time_s=round(sample["time_s"] + offset_s, 9))
        answer = monitor.ask(moved, "estimates")
        if number % options.every == options.every - 1:
            print_estimates(answer)
    monitor.ask({"type": "ping"}, "pong")  # alarms of the last sample come before this
    return samples[-1]["time_s"] + offset_s


def print_status(status):
    for symbol, link in status["links"].items():
        if symbol not in status["active"] and not link["off"]["movements"]:
            continue
        off = link["off"]
        sure = f", {min(100 * off['probability'], 99):.0f} % sure" if off["probability"] else ""
        print(f"{symbol}: {off['verdict']}{sure}; compliance in health {link['baseline_in3_per_psi']:.5f} in^3/psi")
    print("alarms:", ", ".join(f"{each['alarm']} {'+'.join(each['links'])}" for each in status["alarms"]) or "none")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("records", nargs="+", metavar="RECORD.csv")
    parser.add_argument("--speed", type=float, default=1, help="times real time; 0: as fast as it is answered")
    parser.add_argument("--address", default="127.0.0.1")
    parser.add_argument("--port", type=int, help="where the monitor listens")
    parser.add_argument("--token-file", type=pathlib.Path, metavar="FILE", help="what the monitor wants to be told")
    parser.add_argument("--start", action="store_true", help="starts a monitor for this replay")
    parser.add_argument("--machine", default="digger")
    parser.add_argument("--configuration", default="a", choices=[*"abcde", "auto"],
                        help="of the main valve; auto: the monitor recognises it")
    parser.add_argument("--every", type=int, default=10, metavar="N", help="prints the estimates of every Nth sample")
    options = parser.parse_args()
    if options.start == (options.port is not None):
        parser.error("say --port of a running monitor, or --start")
    if options.every < 1:
        parser.error("--every: expected 1 or more")
    return options


def main():
    options = arguments()
    service = None
    try:
        records = [read_record(path) for path in options.records]
        if options.start:
            service, options.port = start_service()
        token = options.token_file.read_text(encoding="utf-8").strip() if options.token_file else None
        monitor = Monitor(options.address, options.port, token)
        period_s = round(records[0][1]["time_s"] - records[0][0]["time_s"], 9) if len(records[0]) > 1 else 0.02
        monitor.ask({"type": "hello", "version": 1, "machine": options.machine, "period_s": period_s}, "welcome")
        end_s = None
        for path, samples in zip(options.records, records):
            print(path)
            offset_s = 0 if end_s is None else end_s + 1 - samples[0]["time_s"]
            end_s = replay(monitor, samples, offset_s, options)
        print_status(monitor.ask({"type": "status"}, "status"))
    except (Refused, OSError) as error:
        print(f"replay_record: {error}", file=sys.stderr)
        return 1
    finally:
        if service:
            service.send_signal(signal.SIGTERM)
            service.communicate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
