"""Reads MCAP files as https://mcap.dev/spec describes them, and checks all that a file says twice."""

import json
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, DATA_END = 11, 15


class Fields:
    """The fields of a record, one after the other."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, size):
        self.at += size
        return int.from_bytes(self.data[self.at - size : self.at], "little")

    def bytes(self, count):
        self.at += count
        return self.data[self.at - count : self.at]

    def text(self):
        return self.bytes(self.number(4)).decode()

    def pairs(self, key, value):
        inner = Fields(self.bytes(self.number(4)))
        found = []
        while inner.at < len(inner.data):
            found.append((inner.number(key), inner.number(value)))
        return found

    def rest(self):
        return self.bytes(len(self.data) - self.at)


def records(data, at, end):
    """(offset, kind, content, length) of each record."""
    while at < end:
        kind, length = struct.unpack_from("<BQ", data, at)
        yield at, kind, data[at + 9 : at + 9 + length], 9 + length
        at += 9 + length
    assert at == end


class McapFile:
    """`messages`: (topic, time in ns, value); `schemas`: JSON Schema by topic, `names` of the schemas by topic."""

    def __init__(self, path):
        data = path.read_bytes()
        assert data.startswith(MAGIC) and data.endswith(MAGIC)
        self.schemas, self.names, self.messages = {}, {}, []
        self.known, self.topics, self.chunks, self.indexes = {}, {}, {}, {}
        self.sequence = {}
        for at, kind, content, length in records(data, len(MAGIC), len(data) - len(MAGIC)):
            self.take(at, kind, content, length, data)
        assert kind == FOOTER
        assert [one for _, _, one in self.statistics] == [len(self.messages), len(self.topics), len(self.chunks)]

    def take(self, at, kind, content, length, data):
        fields = Fields(content)
        if kind == SCHEMA:
            number, name, encoding = fields.number(2), fields.text(), fields.text()
            assert number > 0 and encoding == "jsonschema"
            self.known.setdefault(number, (name, json.loads(fields.text())))
        elif kind == CHANNEL:
            number, schema, topic = fields.number(2), fields.number(2), fields.text()
            assert fields.text() == "json"
            self.topics[number] = topic
            self.names[topic], self.schemas[topic] = self.known[schema]
        elif kind == CHUNK:
            self.take_chunk(at, fields, length)
        elif kind == MESSAGE_INDEX:
            channel = fields.number(2)
            self.indexes[at] = (channel, fields.pairs(8, 8))
            assert self.indexes[at][1] == self.chunk_index[channel]
        elif kind == CHUNK_INDEX:
            self.check_chunk_index(fields)
        elif kind == STATISTICS:
            self.statistics = [
                ("messages", 8, fields.number(8)),
                ("schemas", 2, fields.number(2)),
                ("channels", 4, fields.number(4)),
            ]
            assert self.statistics.pop(1)[2] == len(self.known)
            assert (fields.number(4), fields.number(4)) == (0, 0)
            self.statistics.append(("chunks", 4, fields.number(4)))
            times = [time for _, time, _ in self.messages]
            assert (fields.number(8), fields.number(8)) == (times[0], max(times))
            counts = dict(fields.pairs(2, 8))
            for number, topic in self.topics.items():
                assert counts[number] == sum(one == topic for one, _, _ in self.messages)
        elif kind == FOOTER:
            start, offsets = fields.number(8), fields.number(8)
            assert offsets == 0
            assert fields.number(4) == zlib.crc32(data[start : at + 9 + 16])

    def take_chunk(self, at, fields, length):
        first, last, size = fields.number(8), fields.number(8), fields.number(8)
        check_sum = fields.number(4)
        assert fields.text() == ""
        content = fields.bytes(fields.number(8))
        assert len(content) == size and zlib.crc32(content) == check_sum
        self.chunk_index = {}
        times = []
        for offset, kind, message, _ in records(content, 0, size):
            assert kind == MESSAGE
            inner = Fields(message)
            channel, sequence, time, published = (inner.number(size) for size in (2, 4, 8, 8))
            assert time == published and sequence == self.sequence.get(channel, 0)
            self.sequence[channel] = sequence + 1
            self.chunk_index.setdefault(channel, []).append((time, offset))
            self.messages.append((self.topics[channel], time, json.loads(inner.rest())))
            times.append(time)
        assert (first, last) == (min(times), max(times))
        self.chunks[at] = (first, last, length, size)

    def check_chunk_index(self, fields):
        first, last, at, length = (fields.number(8) for _ in range(4))
        assert self.chunks[at] == (first, last, length, self.chunks[at][3])
        for channel, index_at in fields.pairs(2, 8):
            assert self.indexes[index_at][0] == channel
        assert fields.number(8) > 0 and fields.text() == ""
        assert (fields.number(8), fields.number(8)) == (self.chunks[at][3],) * 2

    def of(self, topic):
        return [(time, value) for one, time, value in self.messages if one == topic]
