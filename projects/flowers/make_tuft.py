"""Makes assets/oat-grass.glb: a tuft of leaves and seed heads as cards with a picture that has alpha.

usage: make_tuft.py [FILE.glb]
"""
import json
import math
import pathlib
import struct
import sys
import zlib

import numpy

SIDE = 512   # pixels of the picture
FINE = 2     # drawn so many times larger, then averaged
CARDS = 6
ROWS = 5     # of quads up a card
HEIGHT, WIDTH = 1.0, 0.86  # m


class Canvas:
    """Premultiplied colour and alpha, 0..1; strokes go over what is there."""

    def __init__(self, side):
        self.side = side
        self.rgb = numpy.zeros((side, side, 3))
        self.alpha = numpy.zeros((side, side))

    def blob(self, x, y, radius, stretch, angle, colour):
        """An ellipse; x, y in 0..1 with y up, radius across, `stretch` times as long along `angle`."""
        s = self.side
        reach = radius * max(stretch, 1.0) + 1.5 / s
        x0, x1 = max(0, int((x - reach) * s)), min(s, int((x + reach) * s) + 2)
        y0, y1 = max(0, int((1 - y - reach) * s)), min(s, int((1 - y + reach) * s) + 2)
        if x0 >= x1 or y0 >= y1:
            return
        v, u = numpy.mgrid[y0:y1, x0:x1]
        dx, dy = (u + 0.5) / s - x, 1 - (v + 0.5) / s - y
        along = dx * math.cos(angle) + dy * math.sin(angle)
        across = -dx * math.sin(angle) + dy * math.cos(angle)
        far = numpy.hypot(across, along / stretch)
        cover = numpy.clip((radius - far) * s + 0.5, 0, 1)
        light = 1.0 - 0.25 * numpy.clip(across / max(radius, 1e-6), -1, 1)
        self.rgb[y0:y1, x0:x1] = (self.rgb[y0:y1, x0:x1] * (1 - cover[..., None])
                                  + cover[..., None] * light[..., None] * numpy.array(colour))
        self.alpha[y0:y1, x0:x1] = self.alpha[y0:y1, x0:x1] * (1 - cover) + cover

    def stroke(self, points, widths, colours):
        """A line of blobs along points."""
        for (x, y), (x2, y2), width, colour in zip(points, points[1:], widths, colours):
            angle = math.atan2(y2 - y, x2 - x)
            length = math.hypot(x2 - x, y2 - y)
            self.blob((x + x2) / 2, (y + y2) / 2, width, max(1.0, 0.75 * length / width), angle, colour)

    def picture(self):
        """8-bit RGBA sRGB; where nothing is drawn the mean colour lies under alpha 0, so that edges stay clean."""
        rgb, alpha = self.rgb, self.alpha
        n = self.side // FINE
        shape = (n, FINE, n, FINE)
        rgb = rgb.reshape(*shape, 3).mean(axis=(1, 3))
        alpha = alpha.reshape(shape).mean(axis=(1, 3))
        mean = rgb.sum(axis=(0, 1)) / alpha.sum()
        plain = numpy.where(alpha[..., None] > 0.02, rgb / numpy.maximum(alpha[..., None], 1e-3), mean)
        encoded = numpy.where(plain <= 0.0031308, 12.92 * plain, 1.055 * numpy.maximum(plain, 1e-6) ** (1 / 2.4) - 0.055)
        out = numpy.concatenate([encoded, alpha[..., None]], axis=2)
        return (numpy.clip(out, 0, 1) * 255 + 0.5).astype(numpy.uint8)


def mix(a, b, t):
    return [p + (q - p) * t for p, q in zip(a, b)]


GREEN_LOW, GREEN_HIGH = (0.035, 0.085, 0.016), (0.15, 0.235, 0.05)
STRAW, HEAD = (0.27, 0.23, 0.085), (0.27, 0.20, 0.095)


def curve(x, lean, height, droop, steps):
    points = []
    for i in range(steps + 1):
        t = i / steps
        points.append((x + lean * t ** 1.6, height * (t - droop * t ** 3)))
    return points


def draw_leaf(canvas, random, x):
    lean = random.uniform(-0.36, 0.36)
    height = random.uniform(0.34, 0.66)
    points = curve(x, lean, height, random.uniform(0.05, 0.3), 26)
    dry = random.uniform(0, 1) ** 3
    widths = [0.0085 * (1 - (i / 26) ** 2.5) * (0.55 + 0.45 * min(1, i / 6)) + 0.0012 for i in range(26)]
    colours = [mix(mix(GREEN_LOW, GREEN_HIGH, (i / 26) ** 0.8), STRAW, dry * i / 26) for i in range(26)]
    canvas.stroke(points, widths, colours)


def draw_stem(canvas, random, x):
    lean = random.uniform(-0.30, 0.30)
    height = random.uniform(0.80, 1.02)
    points = curve(x, lean, height, 0.05, 44)
    tone = random.uniform(0, 1)
    colours = [mix(mix(GREEN_LOW, GREEN_HIGH, i / 30), STRAW, min(1, max(0, (i - 16) / 24)) * (0.5 + 0.5 * tone)) for i in range(44)]
    canvas.stroke(points, [0.0034 - 0.0018 * i / 44 for i in range(44)], colours)
    head = mix(HEAD, (0.19, 0.115, 0.10), 0.8 * tone)
    # A panicle: spikelets on short branches that hang to both sides.
    for i in range(29, 44):
        t = (i - 29) / 15
        px, py = points[i]
        for side in (-1, 1):
            if random.uniform(0, 1) < 0.2:
                continue
            reach = (0.007 + 0.030 * math.sin(math.pi * (0.15 + 0.8 * t)) * (1 - 0.6 * t)) * random.uniform(0.45, 1.4)
            ex, ey = px + side * reach, py + random.uniform(-0.1, 0.7) * reach - 0.010
            canvas.stroke([(px, py), ((px + ex) / 2, (py + ey) / 2 + 0.007), (ex, ey)], [0.0010, 0.0010], [STRAW, STRAW])
            shade = random.uniform(0.75, 1.2)
            canvas.blob(ex, ey - 0.007, 0.0040, 2.9, math.radians(90 - 28 * side) + random.uniform(-0.5, 0.5),
                        [min(1.0, shade * c) for c in head])


def make_picture():
    random = numpy.random.RandomState(7)
    canvas = Canvas(SIDE * FINE)
    for _ in range(34):
        draw_leaf(canvas, random, 0.5 + random.uniform(-0.07, 0.07))
    for _ in range(5):
        draw_stem(canvas, random, 0.5 + random.uniform(-0.05, 0.05))
    for _ in range(12):
        draw_leaf(canvas, random, 0.5 + random.uniform(-0.07, 0.07))
    return canvas.picture()


def png(pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    high, wide = pixels.shape[:2]
    rows = b"".join(b"\0" + pixels[y].tobytes() for y in range(high))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", wide, high, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def make_cards():
    """Positions, normals, coordinates, indices: cards around the middle, leaning outwards as they rise."""
    positions, normals, uvs, indices = [], [], [], []
    for card in range(CARDS):
        turn = math.pi * card / CARDS + 0.2 * math.sin(5 * card)
        side = (math.cos(turn), math.sin(turn))
        out = (-side[1], side[0])
        lean = 0.16 * (1 if card % 2 else -1)
        size = 0.82 + 0.18 * math.cos(3 * card + 1)
        first = len(positions)
        for row in range(ROWS + 1):
            t = row / ROWS
            for edge in (-0.5, 0.5):
                away = lean * t * t
                x = side[0] * edge * WIDTH * size + out[0] * away
                z = side[1] * edge * WIDTH * size + out[1] * away
                positions.append((x, HEIGHT * size * t, z))
                # Mostly upwards, so that a tuft takes light as the meadow around it.
                n = (0.9 * edge * side[0] + 0.25 * out[0], 0.9, 0.9 * edge * side[1] + 0.25 * out[1])
                length = math.sqrt(sum(c * c for c in n))
                normals.append(tuple(c / length for c in n))
                uvs.append((0.5 + edge if card % 3 else 0.5 - edge, 1 - t))
        for row in range(ROWS):
            a = first + 2 * row
            indices += [a, a + 1, a + 3, a, a + 3, a + 2]
    return positions, normals, uvs, indices


def glb():
    positions, normals, uvs, indices = make_cards()
    parts = [struct.pack(f"<{3 * len(positions)}f", *sum(positions, ())),
             struct.pack(f"<{3 * len(normals)}f", *sum(normals, ())),
             struct.pack(f"<{2 * len(uvs)}f", *sum(uvs, ())),
             struct.pack(f"<{len(indices)}H", *indices), png(make_picture())]
    views, data = [], b""
    for part in parts:
        data += b"\0" * (-len(data) % 4)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part
    data += b"\0" * (-len(data) % 4)
    low = [min(p[i] for p in positions) for i in range(3)]
    high = [max(p[i] for p in positions) for i in range(3)]
    count = len(positions)
    document = {
        "asset": {"version": "2.0", "generator": "make_tuft.py"},
        "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "oat grass"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0}]}],
        "materials": [{"name": "oat grass", "doubleSided": True, "alphaMode": "MASK", "alphaCutoff": 0.4,
                       "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 1}}],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071, "wrapT": 33071}],
        "images": [{"bufferView": 4, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": low, "max": high},
            {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": count, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(data)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return (b"glTF" + struct.pack("<II", 2, 12 + 8 + len(text) + 8 + len(data))
            + struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(data)) + b"BIN\0" + data)


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "assets" / "oat-grass.glb"
    target.write_bytes(glb())
