"""Reads DDS textures with the DX10 extension, after Microsoft's programming guide for DDS."""
import struct

import numpy

from read_bc5 import block_counts, decode_bc5

HALVES = {34: 2, 10: 4}  # R16G16_FLOAT, R16G16B16A16_FLOAT: components
BC5 = 83


def read_dds(path):
    """What the header says, and the texels as [slices, height, width, channels]: halves, or codes 0 to 255 for BC5."""
    raw = path.read_bytes()
    assert raw[:4] == b"DDS "
    size, flags, height, width, pitch, depth, mipmaps, *reserved = struct.unpack_from("<7I11I", raw, 4)
    assert size == 124 and mipmaps == 1 and not any(reserved)
    format_size, format_flags, four_cc, *rest = struct.unpack_from("<II4s5I", raw, 76)
    assert (format_size, format_flags, four_cc) == (32, 4, b"DX10") and not any(rest)
    caps, caps2, *more = struct.unpack_from("<5I", raw, 108)
    assert not any(more)
    dxgi, dimension, misc, count, misc2 = struct.unpack_from("<5I", raw, 128)
    assert misc == misc2 == 0 and flags & 0x1007 == 0x1007 and caps & 0x1000
    volume = dimension == 4
    assert dimension in (3, 4) and volume == bool(caps2 & 0x200000) == bool(flags & 0x800000) == bool(caps & 8)
    slices = depth if volume else count
    assert slices >= 1 and (count == 1 if volume else depth == 0)
    if dxgi == BC5:
        across, down = block_counts(width, height)
        slice_bytes = 16 * across * down
        assert flags & 0x80000 and not flags & 8 and pitch == slice_bytes
        texels = numpy.stack([decode_bc5(raw[148 + i * slice_bytes:148 + (i + 1) * slice_bytes], width, height)
                              for i in range(slices)])
    else:
        channels = HALVES[dxgi]
        slice_bytes = 2 * channels * width * height
        assert flags & 8 and not flags & 0x80000 and pitch == 2 * channels * width
        texels = numpy.frombuffer(raw, "<f2", slices * height * width * channels, 148)
        texels = texels.reshape(slices, height, width, channels)
    assert len(raw) == 148 + slices * slice_bytes
    return {"dxgi": dxgi, "volume": volume, "slices": slices, "size": (width, height)}, texels
