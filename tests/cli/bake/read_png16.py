"""Reads 16-bit PNG files that aren't interlaced, after ISO 15948."""
import struct
import zlib

import numpy

from harness import unfilter


def read_png16(path):
    """Samples [height, width, 4]."""
    raw = path.read_bytes()
    assert raw[:8] == b"\x89PNG\r\n\x1a\n"
    at, data, kinds = 8, b"", []
    while at < len(raw):
        length, kind = struct.unpack_from(">I4s", raw, at)
        body = raw[at + 8:at + 8 + length]
        assert struct.unpack_from(">I", raw, at + 8 + length)[0] == zlib.crc32(kind + body)
        kinds.append(kind)
        if kind == b"IHDR":
            width, height, depth, colour, packing, filters, interlace = struct.unpack(">IIBBBBB", body)
            assert (depth, colour, packing, filters, interlace) == (16, 6, 0, 0, 0)
        elif kind == b"IDAT":
            data += body
        at += 12 + length
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND" and set(kinds) == {b"IHDR", b"IDAT", b"IEND"}
    lines = numpy.frombuffer(zlib.decompress(data), numpy.uint8).reshape(height, 1 + 8 * width)
    image = numpy.zeros((height, 8 * width), int)
    above = numpy.zeros(8 * width, int)
    for row in range(height):
        above = image[row] = unfilter(lines[row, 0], lines[row, 1:].astype(int), above, 8)
    return (image[:, 0::2] * 256 + image[:, 1::2]).reshape(height, width, 4)
