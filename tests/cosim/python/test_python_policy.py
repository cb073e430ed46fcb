"""The network of a policy: numpy evaluates it as rtl/policy_mlp/README.md says, and gets the bits of the controller."""

import os
import zlib

import numpy
from cli_program import SCENARIOS, Program, main

from armature import policy

FILE = SCENARIOS / "policy_conveyor/belt.policy"
LANES = 8
ROUNDS = int(os.environ.get("ARMATURE_NETWORKS", 40))  # random networks


def layers_of(image):
    """Weights, biases, multipliers, shifts and whether negative values become 0, of each layer."""
    rows = numpy.frombuffer(image.astype("<u4").tobytes(), dtype=numpy.uint8).reshape(-1, LANES)
    at = 0
    while True:
        head = int.from_bytes(rows[at].tobytes(), "little")
        neurons, stride = (head & 63) + 1, (head >> 8 & 7) + 2  # a neuron has a row of parameters and rows of weights
        block = rows[at + 1 : at + 1 + neurons * stride].reshape(neurons, stride * LANES)
        parameters = block[:, :LANES].copy().view("<u8")[:, 0]
        bias = (parameters & 0xFFFFFF).astype(numpy.int64)
        bias -= (bias >> 23) << 24
        yield (
            block[:, LANES:].view(numpy.int8).astype(numpy.int64),
            bias,
            (parameters >> numpy.uint64(32) & numpy.uint64(0xFFFF)).astype(numpy.int64),
            (parameters >> numpy.uint64(24) & numpy.uint64(31)).astype(numpy.int64),
            bool(head >> 16 & 1),
        )
        if head >> 17 & 1:
            return
        at += 1 + neurons * stride


def evaluate(image, inputs, bound):
    values = inputs.astype(numpy.int64)
    for weights, bias, multiplier, shift, relu in layers_of(image):
        wide = numpy.zeros((len(values), max(weights.shape[1], values.shape[1])), dtype=numpy.int64)
        wide[:, : values.shape[1]] = values
        sums = bias + wide[:, : weights.shape[1]] @ weights.T
        values = (sums * multiplier + (1 << (15 + shift))) >> (16 + shift)
        values = values.clip(0 if relu else -128, 127)
    outputs = numpy.zeros((len(inputs), 8), dtype=numpy.int8)
    outputs[:, : values.shape[1]] = values.clip(-bound, bound)[:, :8]
    return outputs


def random_image(random, sizes):
    """Layers of these numbers of neurons, behind the number of inputs."""
    image = b""
    for index, (before, neurons) in enumerate(zip(sizes, sizes[1:])):
        rows = -(-before // LANES)
        last = index == len(sizes) - 2
        relu = int(random.integers(2))
        image += (neurons - 1 | (rows - 1) << 8 | relu << 16 | last << 17).to_bytes(LANES, "little")
        for _ in range(neurons):
            bias = int(random.integers(-(2**23), 2**23)) >> int(random.integers(24))
            shift = int(random.integers(12))
            multiplier = int(
                random.choice([2**15, random.integers(2**16)])
            )  # half of them: sums that end in a half
            image += (bias & 0xFFFFFF | shift << 24 | multiplier << 32).to_bytes(LANES, "little")
            image += random.integers(-128, 128, before, dtype=numpy.int8).tobytes().ljust(rows * LANES, b"\0")
    return numpy.frombuffer(image, dtype="<u4")


class Policy(Program):
    def test_numpy_gets_the_bits_of_the_network_of_the_scenario(self):
        network = policy.read(FILE)
        self.assertEqual(network.inputs.shape, (10, 2))
        random = numpy.random.default_rng(1)
        inputs = random.integers(-128, 128, (20_000, 10), dtype=numpy.int8)
        inputs[:1024] = numpy.where(numpy.arange(1024)[:, None] >> numpy.arange(10) & 1, 127, -127)  # the corners
        for bound in (127, 50, 0):
            got = policy.evaluate(network.image, inputs, bound)
            numpy.testing.assert_array_equal(got, evaluate(network.image, inputs, bound))
        outputs = policy.evaluate(network.image, inputs)[:, 0]
        self.assertGreater(len(numpy.unique(outputs)), 100)

    def test_its_checksum_is_that_of_zlib(self):
        network = policy.read(FILE)
        self.assertEqual(network.crc, zlib.crc32(network.image.astype("<u4").tobytes()))
        self.assertEqual(network.crc, policy.checksum(network.image))
        wrong = policy.read(SCENARIOS / "policy_corrupt_weights/belt.policy")
        self.assertEqual(wrong.crc, network.crc)
        self.assertNotEqual(wrong.crc, policy.checksum(wrong.image))
        flipped = wrong.image ^ network.image
        self.assertEqual(sum(int(word).bit_count() for word in flipped), 1)

    def test_numpy_gets_the_bits_of_random_networks(self):
        """Seed 2; ARMATURE_NETWORKS=n: n of them."""
        random = numpy.random.default_rng(2)
        values = set()
        for number in range(ROUNDS):
            sizes = [
                int(random.integers(1, 33)),
                *random.integers(1, 65, int(random.integers(0, 4))),
                random.integers(1, 9),
            ]
            sizes = [int(size) for size in sizes]
            image = random_image(random, sizes)
            inputs = random.integers(-128, 128, (50, sizes[0]), dtype=numpy.int8)
            bound = int(random.integers(128))
            with self.subTest(number=number, sizes=sizes, bound=bound):
                got = policy.evaluate(image, inputs, bound)
                numpy.testing.assert_array_equal(got, evaluate(image, inputs, bound))
            values |= set(got.ravel().tolist())
        self.assertGreater(len(values), 50)

    def test_an_image_that_is_no_network_is_refused(self):
        image = policy.read(FILE).image
        with self.assertRaisesRegex(ValueError, "no end"):
            policy.evaluate(image[:-2], numpy.zeros((1, 10)))
        with self.assertRaisesRegex(ValueError, "at most 32 inputs"):
            policy.evaluate(image, numpy.zeros((1, 33)))


if __name__ == "__main__":
    main()
