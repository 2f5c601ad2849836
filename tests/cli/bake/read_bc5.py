"""Decodes BC5 (two channels, unsigned), after the Direct3D documentation of BC4 and BC5."""
import numpy


def decode_channel(blocks):
    """[..., 8] bytes to [..., 16] values, 0 to 255, between the steps as fractions."""
    ends = blocks[..., :2].astype(float)
    first, last = ends[..., :1], ends[..., 1:]
    falling = first > last
    table = numpy.empty(blocks.shape[:-1] + (8,))
    table[..., :2] = ends
    for i in range(2, 8):
        eight = ((8 - i) * first + (i - 1) * last) / 7
        six = ((6 - i) * first + (i - 1) * last) / 5 if i < 6 else numpy.full_like(first, 0 if i == 6 else 255)
        table[..., i:i + 1] = numpy.where(falling, eight, six)
    bits = sum(blocks[..., 2 + i].astype(numpy.uint64) << numpy.uint64(8 * i) for i in range(6))
    indices = numpy.stack([(bits >> numpy.uint64(3 * i)) & numpy.uint64(7) for i in range(16)], axis=-1)
    return numpy.take_along_axis(table, indices.astype(int), axis=-1)


def block_counts(width, height):
    return -(-width // 4), -(-height // 4)


def decode_bc5(data, width, height):
    """[height, width, 2] values of 0 to 255."""
    across, down = block_counts(width, height)
    blocks = numpy.frombuffer(data, numpy.uint8).reshape(down, across, 2, 8)
    values = decode_channel(blocks).reshape(down, across, 2, 4, 4)
    return values.transpose(0, 3, 1, 4, 2).reshape(4 * down, 4 * across, 2)[:height, :width]


def block_ranges(codes):
    """For each pixel of [height, width, 2] the difference of the greatest and the least in its block."""
    height, width = codes.shape[:2]
    across, down = block_counts(width, height)
    padded = numpy.pad(codes, ((0, 4 * down - height), (0, 4 * across - width), (0, 0)), mode="edge")
    blocks = padded.reshape(down, 4, across, 4, 2)
    ranges = blocks.max(axis=(1, 3)) - blocks.min(axis=(1, 3))
    return ranges.repeat(4, axis=0).repeat(4, axis=1)[:height, :width]
