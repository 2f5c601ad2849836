"""What the scripts that make glTF objects share."""
import json
import struct

import numpy


def smooth_normals(positions, triangles):
    """Of vertices that triangles share, weighted by area."""
    positions = numpy.asarray(positions, float)
    normals = numpy.zeros_like(positions)
    corners = positions[triangles]
    faces = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for corner in range(3):
        numpy.add.at(normals, triangles[:, corner], faces)
    return normals / numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def tube(centres, radii, sectors, bump=None):
    """A closed tube along `centres`, its ends closed with a point each: positions and triangles. `radii`: one number or a pair
    (sideways, upwards) for each centre. `bump(ring, angle)` multiplies the radius."""
    centres = numpy.asarray(centres, float)
    radii = numpy.array([(r, r) if numpy.isscalar(r) else r for r in radii], float)
    ways = numpy.gradient(centres, axis=0)
    ways /= numpy.linalg.norm(ways, axis=1, keepdims=True)
    side = numpy.cross(ways[0], (0.0, 1.0, 0.0) if abs(ways[0][1]) < 0.9 else (1.0, 0.0, 0.0))
    positions = []
    for ring, (centre, way) in enumerate(zip(centres, ways)):
        side = side - way * side.dot(way)
        side /= numpy.linalg.norm(side)
        up = numpy.cross(side, way)
        for k in range(sectors):
            angle = 2 * numpy.pi * k / sectors
            part = bump(ring, angle) if bump else 1.0
            positions.append(centre + part * (side * radii[ring][0] * numpy.cos(angle) + up * radii[ring][1] * numpy.sin(angle)))
    rings, triangles = len(centres), []
    for i in range(rings - 1):
        for k in range(sectors):
            a, b = i * sectors + k, i * sectors + (k + 1) % sectors
            triangles += [(a, b, a + sectors), (b, b + sectors, a + sectors)]
    for ring, outwards in ((0, False), (rings - 1, True)):
        positions.append(centres[ring])
        middle = len(positions) - 1
        for k in range(sectors):
            a, b = ring * sectors + k, ring * sectors + (k + 1) % sectors
            triangles.append((a, b, middle) if outwards else (b, a, middle))
    return numpy.array(positions), numpy.array(triangles)


def joined(parts):
    """Parts (positions, triangles, colours) as one."""
    positions, triangles, colours, first = [], [], [], 0
    for p, t, c in parts:
        positions.append(p)
        triangles.append(numpy.asarray(t) + first)
        colours.append(numpy.broadcast_to(c, (len(p), 3)))
        first += len(p)
    return numpy.concatenate(positions), numpy.concatenate(triangles), numpy.concatenate(colours)


def glb(name, maker, positions, triangles, colours):
    """The bytes of a glTF file with one mesh; colours are linear RGB for each vertex."""
    positions = numpy.asarray(positions, "<f4")
    triangles = numpy.asarray(triangles)
    normals = smooth_normals(positions, triangles).astype("<f4")
    rgba = numpy.concatenate([numpy.asarray(colours, float), numpy.ones((len(positions), 1))], axis=1)
    parts = [positions.tobytes(), normals.tobytes(), (numpy.clip(rgba, 0, 1) * 65535 + 0.5).astype("<u2").tobytes(),
             triangles.astype("<u4").tobytes()]
    views, data = [], b""
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part + b"\0" * (-len(part) % 4)
    count = len(positions)
    document = {
        "asset": {"version": "2.0", "generator": maker},
        "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "COLOR_0": 2}, "indices": 3, "material": 0}]}],
        "materials": [{"name": name, "doubleSided": True, "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 1}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
             "min": [float(v) for v in positions.min(axis=0)], "max": [float(v) for v in positions.max(axis=0)]},
            {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5123, "normalized": True, "count": count, "type": "VEC4"},
            {"bufferView": 3, "componentType": 5125, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(data)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 12 + 8 + len(text) + 8 + len(data))
            + struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(data)) + b"BIN\0" + data)
