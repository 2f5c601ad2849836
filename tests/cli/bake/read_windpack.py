"""A reader of wind packs written from docs/windpack.md alone."""
import struct
import subprocess
import zlib

import numpy

LOOP, WRAP_X, WRAP_Z, FLOATS, ZSTD = 1, 2, 4, 8, 16


def read_windpack(path):
    """Header and frames [frames, height, width, 2], both versions."""
    raw = path.read_bytes()
    assert raw[:8] == b"WINDPACK" and zlib.crc32(raw[:-4]) == struct.unpack("<I", raw[-4:])[0]
    version, mark, flags, width, height, frames = struct.unpack_from("<6I", raw, 8)
    corners = struct.unpack_from("<4f", raw, 32)
    fps, fastest, start = struct.unpack_from("<2fd", raw, 48)
    size, reserved = struct.unpack_from("<2Q", raw, 64)
    assert version in (1, 2) and (mark, reserved) == (0x01020304, 0)
    header = {"version": version, "flags": flags, "corners": corners, "fps": fps, "fastest": fastest, "start": start}
    begin = 80
    if version == 2:
        quantity, reference, roughness, reserved = struct.unpack_from("<I2fI", raw, 80)
        assert reserved == 0 and flags < 32
        header.update(quantity=quantity, reference=reference, roughness=roughness)
        begin = 96
    else:
        assert flags < 8
    cells = raw[begin:-4]
    if flags & ZSTD:
        cells = subprocess.run(["zstd", "-q", "-d", "-c"], input=cells, capture_output=True, check=True).stdout
    kind = numpy.dtype("<f4" if flags & FLOATS else "<f2")
    assert len(cells) == size == width * height * frames * 2 * kind.itemsize
    return header, numpy.frombuffer(cells, kind).reshape(frames, height, width, 2)
