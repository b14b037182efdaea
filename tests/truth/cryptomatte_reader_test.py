# SPDX-License-Identifier: GPL-3.0-or-later
"""The Cryptomattes of keikan-verify truth, opened by a reader that shares nothing with the writer: OpenEXR's file
layout and Cryptomatte 1.2.0 read here from their specifications, with Python's own zlib alone. What it decodes must be,
bit for bit, the coverage channels that the same command writes of the same picture. Argument: the build's folder."""
import array
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
SCENES = pathlib.Path(__file__).resolve().parents[2] / "data" / "scenes"
ZIP, FLOAT32 = 3, 2


class Picture:
    """A single-part scanline OpenEXR file with ZIP compression: header and channels by name."""

    def __init__(self, contents):
        magic, version = struct.unpack_from("<II", contents)
        assert magic == 20000630 and version & 0xFF == 2, "an OpenEXR file"
        assert version & 0x1A00 == 0, "not tiled, not deep, one part"
        self.header, at = {}, 8
        while contents[at] != 0:
            name, at = self.text(contents, at)
            kind, at = self.text(contents, at)
            size, = struct.unpack_from("<i", contents, at)
            self.header[name] = (kind, contents[at + 4:at + 4 + size])
            at += 4 + size
        x0, y0, x1, y1 = struct.unpack("<4i", self.header["dataWindow"][1])
        self.width, self.height = x1 - x0 + 1, y1 - y0 + 1
        assert self.header["compression"][1][0] == ZIP
        self.types = self.channel_types(self.header["channels"][1])
        self.channels = {name: array.array("I") for name in self.types}  # bits, not numbers
        at += 1
        offsets = struct.unpack_from(f"<{(self.height + 15) // 16}Q", contents, at)
        for block, offset in enumerate(offsets):
            y, size = struct.unpack_from("<ii", contents, offset)
            assert y == y0 + 16 * block
            self.read_block(contents[offset + 8:offset + 8 + size], min(16, self.height - 16 * block))

    @staticmethod
    def text(contents, at):
        end = contents.index(0, at)
        return contents[at:end].decode("utf-8"), end + 1

    def channel_types(self, data):
        types, at = {}, 0
        while data[at] != 0:
            name, at = self.text(data, at)
            kind, _, x_sampling, y_sampling = struct.unpack_from("<iiii", data, at)
            assert (x_sampling, y_sampling) == (1, 1)
            types[name], at = kind, at + 16
        return types

    def read_block(self, data, rows):
        size = rows * self.width * 4 * len(self.types)
        if len(data) < size:
            predicted = bytearray(zlib.decompress(data))
            for i in range(1, len(predicted)):
                predicted[i] = predicted[i - 1] + predicted[i] - 128 & 0xFF
            half = (len(predicted) + 1) // 2
            data = bytearray(len(predicted))
            data[0::2], data[1::2] = predicted[:half], predicted[half:]
        assert len(data) == size
        at = 0
        for _ in range(rows):
            for name in sorted(self.types, key=str.encode):  # in a file channels stand by name
                self.channels[name].frombytes(bytes(data[at:at + 4 * self.width]))
                at += 4 * self.width

    def string(self, name):
        kind, value = self.header[name]
        assert kind == "string"
        return value.decode("utf-8")


def murmur3_32(text):
    """MurmurHash3_x86_32 with seed 0, of the name in UTF-8."""
    data, mask, value = text.encode("utf-8"), 0xFFFFFFFF, 0

    def turned(word, by):
        return (word << by | word >> 32 - by) & mask

    whole = len(data) // 4 * 4
    for at in range(0, whole, 4):
        word = int.from_bytes(data[at:at + 4], "little")
        value ^= turned(word * 0xCC9E2D51 & mask, 15) * 0x1B873593 & mask
        value = turned(value, 13) * 5 + 0xE6546B64 & mask
    tail = int.from_bytes(data[whole:], "little")
    if len(data) > whole:
        value ^= turned(tail * 0xCC9E2D51 & mask, 15) * 0x1B873593 & mask
    value ^= len(data)
    for by, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35)):
        value = (value ^ value >> by) * factor & mask
    return value ^ value >> 16


def id_of(name):
    """As the specification has it: no exponent of all zeros or all ones, lest the float be denormal or not a number."""
    value = murmur3_32(name)
    exponent = value >> 23 & 255
    return value ^ 1 << 23 if exponent in (0, 255) else value


def as_float(bits):
    return struct.unpack("<f", struct.pack("<I", bits))[0]


class Cryptomatte:
    """The one layer of a picture, decoded: {name: [bits of its coverage, a pixel each]}."""

    def __init__(self, picture):
        keys = [name for name in picture.header if name.startswith("cryptomatte/")]
        numbers = {key.split("/")[1] for key in keys}
        assert len(numbers) == 1, "one layer"
        self.number = numbers.pop()
        values = {key.split("/")[2]: picture.string(key) for key in keys}
        self.layer = values["name"]
        assert self.number == f"{murmur3_32(self.layer):08x}"[:7]
        assert (values["hash"], values["conversion"]) == ("MurmurHash3_32", "uint32_to_float32")
        self.manifest = {name: int(text, 16) for name, text in json.loads(values["manifest"]).items()}
        ranks = len([name for name in picture.channels if name.startswith(self.layer)]) // 2
        self.pairs = []
        for rank in range(ranks):
            first, second = ("R", "G") if rank % 2 == 0 else ("B", "A")
            channels = [f"{self.layer}{rank // 2:02}.{letter}" for letter in (first, second)]
            assert all(picture.types[channel] == FLOAT32 for channel in channels)
            self.pairs.append([picture.channels[channel] for channel in channels])
        assert len(self.pairs) * 2 == len(picture.channels), "nothing but ranks"
        self.pixels = picture.width * picture.height

    def mattes(self):
        names = {number: name for name, number in self.manifest.items()}
        decoded = {name: array.array("I", bytes(4 * self.pixels)) for name in self.manifest}
        for pixel in range(self.pixels):
            last = float("inf")
            for ids, coverages in self.pairs:
                coverage = as_float(coverages[pixel])
                assert 0 <= coverage <= last, "ranks by falling coverage"
                last = coverage
                if ids[pixel] == 0:
                    assert coverage == 0
                    continue
                matte = decoded[names[ids[pixel]]]
                assert matte[pixel] == 0, "an id once a pixel"
                matte[pixel] = coverages[pixel]
        return decoded


class Decoded(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pictures = {}
        with tempfile.TemporaryDirectory() as folder:
            for kind in ("channels", "cryptomatte"):
                file = pathlib.Path(folder, kind + ".exr")
                subprocess.run([str(BUILD / "keikan-verify"), "truth", str(SCENES / "tower_closeup.json"), "--quiet",
                                "--size", "120x90", "--format", kind, "-o", str(file)], check=True, timeout=120,
                               stdout=subprocess.DEVNULL)
                cls.pictures[kind] = Picture(file.read_bytes())

    def test_ids_are_the_hashes_of_the_names(self):
        self.assertEqual(murmur3_32("hello"), 0x248BFA47)  # as published with the hash
        self.assertEqual(id_of("bunny"), 0x13851A76)  # as in the specification's example
        matte = Cryptomatte(self.pictures["cryptomatte"])
        self.assertEqual(matte.layer, "CryptoObject")
        self.assertGreater(len(matte.manifest), 10)
        for name, number in matte.manifest.items():
            self.assertEqual(number, id_of(name), name)

    def test_each_matte_is_the_coverage_channel_of_its_object_bit_for_bit(self):
        channels = self.pictures["channels"].channels
        decoded = Cryptomatte(self.pictures["cryptomatte"]).mattes()
        self.assertEqual({f"coverage.{name}" for name in decoded} | {"background"}, set(channels))
        seen = 0
        for name, matte in decoded.items():
            self.assertEqual(matte, channels[f"coverage.{name}"], name)
            seen += any(matte)
        self.assertGreater(seen, 10)

    def test_what_is_missing_from_1_is_the_background(self):
        background = self.pictures["channels"].channels["background"]
        matte = Cryptomatte(self.pictures["cryptomatte"])
        partly = 0
        for pixel in range(matte.pixels):
            covered = sum(as_float(coverages[pixel]) for _, coverages in matte.pairs)
            self.assertAlmostEqual(covered + as_float(background[pixel]), 1, delta=1e-6)
            partly += 0 < covered < 1
        self.assertGreater(partly, 100)

    def test_a_file_with_one_wrong_bit_is_noticed(self):
        matte = Cryptomatte(self.pictures["cryptomatte"])
        _, coverages = matte.pairs[0]
        at = next(i for i, bits in enumerate(coverages) if 0 < as_float(bits) < 1)
        coverages[at] ^= 1
        try:
            channels = self.pictures["channels"].channels
            self.assertTrue(any(decoded != channels[f"coverage.{name}"] for name, decoded in matte.mattes().items()))
        finally:
            coverages[at] ^= 1


if __name__ == "__main__":
    unittest.main()
