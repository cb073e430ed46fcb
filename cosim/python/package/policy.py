"""The network of [conveyor.policy] for those who train one elsewhere: its file, and its result to the bit."""

import dataclasses

import numpy

from . import _core


@dataclasses.dataclass
class Policy:
    """A file of `armature train`. The observation has a pair of `inputs` for each value, which becomes -127 to 127; `full_mm` is
    the correction of an output of 127. `image`: the network, words as rtl/policy_mlp/README.md defines them."""

    full_mm: float
    inputs: numpy.ndarray
    crc: int
    image: numpy.ndarray


def read(path):
    """Reads such a file. Its checksum is not compared: checksum() is what it should be."""
    inputs, words, values = [], [], {}
    with open(path, encoding="ascii") as file:
        for line in file:
            key, *rest = line.split() or ["#"]
            if key == "input":
                inputs.append([float(value) for value in rest])
            elif key == "image":
                words += [int(word, 16) for word in rest]
            elif key != "#":
                (values[key],) = rest
    image = numpy.array(words, dtype=numpy.uint32)
    return Policy(float(values["full_mm"]), numpy.array(inputs), int(values["crc"], 16), image)


def checksum(image):
    """CRC-32 of the words, as zlib computes it."""
    return _core.network_checksum(numpy.asarray(image, dtype=numpy.uint32))


def evaluate(image, inputs, bound=127):
    """The eight outputs (int8) for each row of inputs (int8), as the logic and the ARM compute them. No output exceeds `bound`.
    Raises ValueError for an image that is no network."""
    return _core.evaluate_network(numpy.asarray(image, numpy.uint32), numpy.asarray(inputs, numpy.int8), bound)
