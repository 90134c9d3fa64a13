"""Makes files of results that another program has changed and given valid checksums."""

import contextlib
import sqlite3


@contextlib.contextmanager
def opened(path):
    """Opens a database, and closes it at the end."""
    with contextlib.closing(sqlite3.connect(path)) as database:
        database.text_factory = lambda text: text.decode("utf-8", "surrogateescape")  # names of files are bytes
        with database:
            yield database


def checksum(*texts):
    """Returns the checksum of text/checksum.hpp: CRC-64 of ECMA-182, each text after its length; signed, as in
    SQLite."""
    crc = 2 ** 64 - 1
    for text in map(lambda each: each.encode("utf-8", "surrogateescape"), texts):
        for byte in len(text).to_bytes(8, "little") + text:
            crc ^= byte
            for _ in range(8):
                crc = crc >> 1 ^ (0xC96C5795D7870F42 if crc & 1 else 0)
    crc ^= 2 ** 64 - 1
    return crc - 2 ** 64 if crc >> 63 else crc


def renew_checksums(database):
    """Renews all checksums, as if PlacedPar had written the content."""
    total = count = 0
    texts = "".join(f"{checksum(path, text) % 2 ** 64:016x}"
                    for path, text in database.execute("SELECT path, text FROM texts ORDER BY place"))
    for row in list(database.execute("SELECT * FROM runs")):
        found = checksum("run", *map(str, row[:-1]))
        database.execute("UPDATE runs SET checksum = ? WHERE settings = ? AND seed = ?", (found, *row[:2]))
        total, count = total ^ found, count + 1
    head = list(database.execute("SELECT netlist, options, version, measures FROM study"))[0]
    database.execute("UPDATE study SET runs = ?, sum = ?, checksum = ?",
                     (count, total, checksum(*head, str(count), str(total), texts)))
