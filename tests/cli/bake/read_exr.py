"""Reads OpenEXR pictures of one part and scanlines, not packed or with ZIP; after "OpenEXR File Layout"."""
import struct
import zlib

import numpy

SAMPLES = {0: "<u4", 1: "<f2", 2: "<f4"}


def text_at(raw, at):
    end = raw.index(b"\0", at)
    return raw[at:end].decode("ascii"), end + 1


def channels_of(value):
    found, at = {}, 0
    while value[at]:
        name, at = text_at(value, at)
        kind, linear, x_step, y_step = struct.unpack_from("<iB3xii", value, at)
        assert linear in (0, 1) and (x_step, y_step) == (1, 1)
        found[name] = SAMPLES[kind]
        at += 16
    assert at == len(value) - 1
    return found


def parse(kind, value):
    if kind == "string":
        return value.decode("utf-8")
    if kind == "chlist":
        return channels_of(value)
    layout = {"box2i": "<4i", "float": "<f", "v2f": "<2f", "int": "<i", "compression": "<B", "lineOrder": "<B"}[kind]
    assert struct.calcsize(layout) == len(value), kind
    found = struct.unpack(layout, value)
    return found if len(found) > 1 else found[0]


def unpack(packed, size):
    """The bytes of a block: zlib, sums of differences, then both halves of the bytes in turn."""
    if len(packed) == size:
        return packed
    assert len(packed) < size
    bytes_ = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(int)
    assert len(bytes_) == size
    bytes_[1:] -= 128
    bytes_ = (numpy.cumsum(bytes_) % 256).astype(numpy.uint8)
    out = numpy.empty(size, numpy.uint8)
    half = (size + 1) // 2
    out[0::2], out[1::2] = bytes_[:half], bytes_[half:]
    return out.tobytes()


def read_exr(path):
    """Attributes by name, and channels by name as [height, width]; every byte of the file is accounted for."""
    raw = path.read_bytes()
    assert struct.unpack_from("<II", raw, 0) == (20000630, 2), "no plain scanline picture"
    attributes, at = {}, 8
    while raw[at]:
        name, at = text_at(raw, at)
        kind, at = text_at(raw, at)
        assert 1 <= len(name) <= 31 and name not in attributes
        size, = struct.unpack_from("<i", raw, at)
        attributes[name] = parse(kind, raw[at + 4:at + 4 + size])
        at += 4 + size
    at += 1
    for name in ("channels", "compression", "dataWindow", "displayWindow", "lineOrder", "pixelAspectRatio",
                 "screenWindowCenter", "screenWindowWidth"):
        assert name in attributes, f"{name} is required"
    low_x, low_y, high_x, high_y = attributes["dataWindow"]
    width, height = high_x - low_x + 1, high_y - low_y + 1
    block_rows = {0: 1, 2: 1, 3: 16}[attributes["compression"]]
    blocks = -(-height // block_rows)
    offsets = struct.unpack_from(f"<{blocks}Q", raw, at)
    at += 8 * blocks
    names = sorted(attributes["channels"])
    assert list(attributes["channels"]) == names
    types = [numpy.dtype(attributes["channels"][name]) for name in names]
    row_bytes = width * sum(kind.itemsize for kind in types)
    picture = {name: numpy.empty((height, width), kind) for name, kind in zip(names, types)}
    for block, offset in enumerate(offsets):
        assert offset == at
        row, size = struct.unpack_from("<ii", raw, at)
        assert row == low_y + block * block_rows
        rows = min(block_rows, height - block * block_rows)
        data, from_ = unpack(raw[at + 8:at + 8 + size], rows * row_bytes), 0
        for line in range(row - low_y, row - low_y + rows):
            for name, kind in zip(names, types):
                picture[name][line] = numpy.frombuffer(data, kind, width, from_)
                from_ += width * kind.itemsize
        at += 8 + size
    assert at == len(raw)
    return attributes, picture
