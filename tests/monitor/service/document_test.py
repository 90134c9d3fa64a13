"""Tests that the messages shown in docs/guides/monitor.md are accepted and answered as shown."""

import json
import os
import pathlib
import re
import unittest

from service import ServiceTest

DOCUMENT = pathlib.Path(os.environ["PLACEDPAR_DOCUMENT"])


def contains(actual, documented):
    """Returns whether an answer has all documented fields."""
    if isinstance(documented, dict):
        return isinstance(actual, dict) and all(
            key in actual and contains(actual[key], value) for key, value in documented.items())
    return actual == documented


class Document(ServiceTest):
    def test_every_message_of_the_page(self):
        service = self.service()
        client, count = None, 0
        for block in re.findall(r"^```monitor\n(.*?)^```", DOCUMENT.read_text(encoding="utf-8"), re.S | re.M):
            for line in block.splitlines():
                if line.startswith("> "):
                    if '"hello"' in line:
                        client = self.client(service)
                    client.send_bytes(line[2:].encode() + b"\n")
                else:
                    answer = client.receive()
                    self.assertTrue(contains(answer, json.loads(line[2:])), f"{line[2:]}\nis answered\n{answer}")
                    count += 1
        self.assertGreater(count, 10)


if __name__ == "__main__":
    unittest.main()
