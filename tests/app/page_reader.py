"""Reads the page of a run: its data, and the slices and messages in its stretches (observe/page/stretch.hpp)."""

import base64
import collections
import json
import re
import zlib

Slice = collections.namedtuple("Slice", "begin end doing open note")
Message = collections.namedtuple("Message", "left arrived source target channel")


def data_of(page):
    return json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', page, re.S).group(1))


class Numbers:
    def __init__(self, packed):
        self.bytes, self.at = packed, 0

    def next(self):
        number, shift, byte = 0, 0, 128
        while byte >= 128:
            byte = self.bytes[self.at]
            number += (byte & 127) << shift
            self.at, shift = self.at + 1, shift + 7
        return number

    def column(self, length):
        return [self.next() for _ in range(length)]

    def texts(self):
        length = self.next()
        self.at += length
        return json.loads(self.bytes[self.at - length:self.at])


class Page:
    """A page's slices, by number of track, and its messages, in the order of time."""

    def __init__(self, text):
        self.data = data_of(text)
        self.run = self.data["timeline"]
        self.slices, self.messages = collections.defaultdict(list), []
        packed = [base64.b64decode(each) for each in re.findall(r'<script class="stretch" type="text/plain">(.*?)</script>', text)]
        for (begin, end, entries), each in zip(zip(*[iter(self.run["stretches"])] * 3), packed, strict=True):
            self.read(begin, end, entries, Numbers(zlib.decompress(each) if self.run["deflated"] else each))
        self.messages.sort()
        for slices in self.slices.values():
            slices.sort()

    def read(self, begin, end, entries, numbers):
        texts = numbers.texts()
        counts = [numbers.column(2) for _ in range(numbers.next())]
        columns = zip(*[numbers.column(sum(count for _, count in counts)) for _ in range(4)])
        all_of_it = []
        for track, count in counts:
            at = begin
            for gap, length, doing, note in (next(columns) for _ in range(count)):
                at += gap + length
                all_of_it.append((at - length, at))
                self.slices[track].append(Slice(at - length, at, self.run["doing"][doing % 16], doing >= 16, texts[note]))
        count, left = numbers.next(), begin
        for source, target, gap, length, channel in zip(*[numbers.column(count) for _ in range(5)]):
            left += gap
            all_of_it.append((left, left + length))
            self.messages.append(Message(left, left + length, source, target, texts[channel]))
        assert numbers.at == len(numbers.bytes) and len(all_of_it) == entries
        assert min(all_of_it)[0] >= begin and max(last for _, last in all_of_it) == end

    def slices_of(self, name):
        """Returns the slices of a process's track."""
        return self.slices[next(number for number, track in enumerate(self.run["tracks"])
                                if track["name"] == name and track["kind"] == "process")]
