"""Readers of volume files, after the formats' own rules: they know nothing of our writers. Each gives vectors as an
array [z, y, x, 3] of the file's own axes."""
import re
import struct

import numpy


def read_fga(path):
    """(low corner, high corner, vectors), as Unreal's importer reads it."""
    text = path.read_text("ascii")
    assert not text.rstrip().endswith(","), "no comma behind the last value"
    tokens = [token.strip() for token in text.split(",")]
    assert all(re.fullmatch(r"-?\d+(\.\d+)?", token) for token in tokens), "plain decimal numbers"
    numbers = numpy.array([float(token) for token in tokens])
    nx, ny, nz = (int(n) for n in numbers[:3])
    assert min(nx, ny, nz) >= 1 and max(nx, ny, nz) <= 128, "or the import fails"
    assert len(numbers) == 9 + 3 * nx * ny * nz
    vectors = numbers[9:]
    assert numpy.abs(vectors).max() <= 65504, "stored as halves"
    # Index x + NX * (y + NY * z).
    return numbers[3:6], numbers[6:9], vectors.reshape(nz, ny, nx, 3)


def read_vf(path):
    """(place, vectors): place is the 4 x 4 matrix of version 2, None in version 1."""
    raw = path.read_bytes()
    place = None
    if raw[:4] == b"VF_V":
        at, size = 10, struct.unpack_from("<3H", raw, 4)
    else:
        assert raw[:4] == b"VF2X"
        minor, kind, usage, *size = struct.unpack_from("<3B3H", raw, 4)
        assert (minor, kind, usage) == (0, 2, 2), "three floats a cell, used as vectors"
        place = numpy.array(struct.unpack_from("<16f", raw, 13)).reshape(4, 4)
        at = 77
    width, height, depth = size
    assert len(raw) == at + 12 * width * height * depth, "exactly so many bytes"
    return place, numpy.frombuffer(raw, "<f4", offset=at).reshape(depth, height, width, 3)


def read_slab(image, slices):
    """Vectors over the strength, as Godot imports and decodes a picture of slices [across, down]."""
    across, down = slices
    height, width = image.shape[0] // down, image.shape[1] // across
    assert image.shape == (height * down, width * across, 3)
    cut = [image[n // across * height:][:height, n % across * width:][:, :width] for n in range(across * down)]
    return numpy.stack(cut) / 255.0 * 2 - 1


def vdb_header(path):
    """The fixed beginning of an OpenVDB file: (version, has offsets, id)."""
    raw = path.read_bytes()
    assert raw[:8] == b" BDV\0\0\0\0"
    version, _, _, offsets = struct.unpack_from("<3IB", raw, 8)
    return version, offsets, raw[21:57].decode("ascii")


def read_vdb(path, openvdb):
    """(side of a voxel, place of the centre of voxel (0, 0, 0), vectors) of the one grid."""
    grids, metadata = openvdb.readAll(str(path))
    (grid,) = grids
    assert grid.name == "velocity" and isinstance(grid, openvdb.Vec3SGrid)
    assert grid.vectorType == "contravariant relative" and grid.gridClass == "unknown"
    assert grid.saveFloatAsHalf
    assert grid.transform.isLinear and len(set(grid.transform.voxelSize())) == 1, "cubic voxels"
    low, high = grid.evalActiveVoxelBoundingBox()
    assert low == (0, 0, 0)
    size = [n + 1 for n in high]
    assert grid.activeVoxelCount() == size[0] * size[1] * size[2], "every voxel is active"
    vectors = numpy.zeros((*size, 3), "f4")
    grid.copyToArray(vectors)
    return grid.transform.voxelSize()[0], grid.transform.indexToWorld((0, 0, 0)), vectors.transpose(2, 1, 0, 3)
