"""Reads KTX2 textures of one level, after "KTX File Format Specification 2.0" and the Khronos Data Format rules."""
import struct
import subprocess

import numpy

from read_bc5 import block_counts, decode_bc5

# vkFormat: components of halves, bytes of a texel block, type size
FORMATS = {83: (2, 4, 2), 97: (4, 8, 2), 141: (0, 16, 1)}
FLOAT_ONE, FLOAT_MINUS_ONE = 0x3F800000, 0xBF800000


def check_descriptor(raw, vk_format):
    """The data format descriptor must say exactly what the Vulkan format says."""
    components, block_bytes, _ = FORMATS[vk_format]
    total, kind, version, block_size, model, primaries, transfer, flags = struct.unpack_from("<IIHHBBBB", raw, 0)
    assert total == len(raw) == block_size + 4 and kind == 0 and version == 2
    assert model == (1 if components else 132) and (primaries, transfer, flags) == (1, 1, 0)
    last = 0 if components else 3
    assert tuple(raw[16:20]) == (last, last, 0, 0), "the size of a texel block, less one"
    assert tuple(raw[20:28]) == (block_bytes, 0, 0, 0, 0, 0, 0, 0), "bytes of each plane"
    samples = [struct.unpack_from("<HBBIII", raw, at) for at in range(28, len(raw), 16)]
    if components:
        channels = [0, 1, 2, 15][:components]
        expected = [(16 * i, 15, 0xC0 | channel, 0, FLOAT_MINUS_ONE, FLOAT_ONE) for i, channel in enumerate(channels)]
    else:
        expected = [(0, 63, 0, 0, 0, 0xFFFFFFFF), (64, 63, 1, 0, 0, 0xFFFFFFFF)]
    assert samples == expected, samples


def key_values(raw):
    found, at = {}, 0
    while at < len(raw):
        length, = struct.unpack_from("<I", raw, at)
        key, value = raw[at + 4:at + 4 + length].split(b"\0", 1)
        assert value.endswith(b"\0") and key.decode() not in found
        found[key.decode()] = value[:-1].decode()
        padded = -(-length // 4) * 4
        assert not any(raw[at + 4 + length:at + 4 + padded])
        at += 4 + padded
    assert list(found) == sorted(found)
    return found


def unpack_zstd(packed):
    return subprocess.run(["zstd", "-dc"], input=packed, capture_output=True, check=True).stdout


def read_ktx2(path):
    """What the header says, the texts by key, and texels [layers, height, width, channels] as read_dds gives them."""
    raw = path.read_bytes()
    assert raw[:12] == bytes.fromhex("AB4B5458203230BB0D0A1A0A")
    vk_format, type_size, width, height, depth, layers, faces, levels, scheme = struct.unpack_from("<9I", raw, 12)
    assert (depth, faces, levels) == (0, 1, 1) and scheme in (0, 2) and layers != 1
    components, block_bytes, expected_type = FORMATS[vk_format]
    assert type_size == expected_type
    dfd_at, dfd_size, keys_at, keys_size, global_at, global_size = struct.unpack_from("<4I2Q", raw, 48)
    assert dfd_at == 80 + 24 and keys_at == dfd_at + dfd_size and (global_at, global_size) == (0, 0)
    check_descriptor(raw[dfd_at:dfd_at + dfd_size], vk_format)
    texts = key_values(raw[keys_at:keys_at + keys_size])
    at, stored, size = struct.unpack_from("<3Q", raw, 80)
    alignment = 1 if scheme else max(block_bytes, 4)
    assert at == -(-(keys_at + keys_size) // alignment) * alignment and not any(raw[keys_at + keys_size:at])
    assert len(raw) == at + stored and (scheme or stored == size)
    data = unpack_zstd(raw[at:]) if scheme else raw[at:]
    count = max(layers, 1)
    across, down = (width, height) if components else block_counts(width, height)
    layer_bytes = across * down * block_bytes
    assert len(data) == size == count * layer_bytes
    if components:
        texels = numpy.frombuffer(data, "<f2").reshape(count, height, width, components)
    else:
        texels = numpy.stack([decode_bc5(data[i * layer_bytes:(i + 1) * layer_bytes], width, height)
                              for i in range(count)])
    return {"format": vk_format, "layers": layers, "size": (width, height), "scheme": scheme}, texts, texels
