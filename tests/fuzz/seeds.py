"""Inputs to begin with, made from the repository's own files, beside those that lie in corpus/.

Each function fills a folder for the target of its name.
"""
import base64
import json
import pathlib
import random
import shutil
import struct
import subprocess
import zlib

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
LOOP, WRAP_X, WRAP_Z, FLOATS, ZSTD = 1, 2, 4, 8, 16


# Projects

def small_projects(most=6 << 10):
    """Texts of the sample projects and of the broken ones; of large ones the first records of each list."""
    for file in sorted(REPOSITORY.glob("projects/*/*.wind.json")):
        text = file.read_text()
        while len(text) > most:
            project = json.loads(text)
            halve(project)
            text = json.dumps(project, separators=(",", ":"))
        yield text.encode()
    for file in sorted((REPOSITORY / "tests/data/broken").glob("*.json")):
        if file.stat().st_size <= most:
            yield file.read_bytes()


def halve(value):
    if isinstance(value, list) and len(value) > 4:
        del value[len(value) // 2:]
    for part in value.values() if isinstance(value, dict) else value if isinstance(value, list) else []:
        halve(part)


def project(folder):
    for n, text in enumerate(small_projects()):
        (folder / f"project-{n:03}").write_bytes(text)


clipboard = project


def rescue(folder):
    for n, text in enumerate(small_projects(4 << 10)):
        side = {"format": "windloom-rescue", "original": "", "savedAt": "2026-01-02 03:04", "project": text.decode("utf-8", "replace")}
        (folder / f"rescue-{n:03}").write_text(json.dumps(side))


# glTF

def glb(document, binary=b""):
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def mesh_document(picture=b"", sparse=False):
    """Two triangles that rise, with normals, coordinates, colours, a material and a picture."""
    places = struct.pack("<12f", -1, 0, 0, 1, 0, 0.5, 1, 2, 0.25, -1, 2, 1)
    normals = struct.pack("<12f", *([0, 0, 1] * 4))
    coordinates = struct.pack("<8f", 0, 1, 1, 1, 1, 0, 0, 0)
    colours = bytes([255, 255, 255, 255] * 4)
    indices = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    parts = [places, normals, coordinates, colours, indices, picture]
    binary, views = b"", []
    for part in parts:
        if part:
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
            binary += part + b"\0" * (-len(part) % 4)
    accessor = lambda view, kind, form, count: {"bufferView": view, "componentType": kind, "type": form, "count": count}
    accessors = [accessor(0, 5126, "VEC3", 4), accessor(1, 5126, "VEC3", 4), accessor(2, 5126, "VEC2", 4),
                 accessor(3, 5121, "VEC4", 4), accessor(4, 5123, "SCALAR", 6)]
    accessors[0].update({"min": [-1, 0, 0], "max": [1, 2, 1]})
    accessors[3]["normalized"] = True
    if sparse:
        accessors[0]["sparse"] = {"count": 1, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 0}}
    material = {"alphaMode": "MASK", "alphaCutoff": 0.4, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 0.5, 1]}}
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                "nodes": [{"children": [1], "translation": [0, 0.1, 0], "rotation": [0, 0, 0, 1], "scale": [1, 2, 1]},
                          {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3},
                                            "indices": 4, "material": 0, "mode": 4}]}],
                "materials": [material], "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(binary)}]}
    if picture:
        move = {"KHR_texture_transform": {"offset": [0.1, 0], "rotation": 0.2, "scale": [1, 1]}}
        material["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0, "texCoord": 0, "extensions": move}
        document["textures"] = [{"source": 0, "sampler": 0}]
        document["samplers"] = [{"wrapS": 10497}]
        document["images"] = [{"bufferView": 5, "mimeType": "image/png" if picture[0] == 0x89 else "image/jpeg"}]
        document["extensionsUsed"] = ["KHR_texture_transform"]
    return document, binary


def cube_document():
    """A closed body, so that spheres are packed into it."""
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [i for a, b, c, d in sides for i in (a, b, c, a, c, d)]
    binary = b"".join(struct.pack("<3f", *corner) for corner in corners) + bytes(triangles)
    return {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8},
                          {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 36}],
            "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 36}],
            "buffers": [{"byteLength": len(binary)}]}, binary


def as_text(document, binary):
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return json.dumps(document).encode()


def gltf(folder):
    pictures = [b"", picture(4, 4, 8, 6), picture(3, 5, 8, 2)]
    for n, data in enumerate(pictures):
        (folder / f"mesh-{n}.glb").write_bytes(glb(*mesh_document(data)))
    (folder / "sparse.glb").write_bytes(glb(*mesh_document(sparse=True)))
    (folder / "cube.glb").write_bytes(glb(*cube_document()))
    (folder / "mesh.gltf").write_bytes(as_text(*mesh_document(pictures[1])))
    (folder / "cube.gltf").write_bytes(as_text(*cube_document()))


# Pictures

def picture(width, height, bits, kind, interlaced=False, extra=()):
    """A PNG file; kind as in its header: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA."""
    chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    row_bytes = lambda w: (w * {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[kind] * bits + 7) // 8
    numbers = random.Random(width * 1000 + height * 10 + kind)
    row = lambda w, n: bytes([n % 5]) + bytes(numbers.randrange(4 if kind == 3 else 256) for _ in range(row_bytes(w)))
    passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)] if interlaced else [(0, 0, 1, 1)]
    rows = b""
    for x, y, dx, dy in passes:
        wide, high = (width - x + dx - 1) // dx, (height - y + dy - 1) // dy
        if wide > 0 and high > 0:
            rows += b"".join(row(wide, n) for n in range(high))
    head = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, int(interlaced))
    palette = chunk(b"PLTE", bytes(range(12))) if kind == 3 else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + palette + b"".join(chunk(*one) for one in extra)
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def png(folder):
    kinds = [(0, 1), (0, 8), (0, 16), (2, 8), (2, 16), (3, 2), (3, 8), (4, 8), (4, 16), (6, 8), (6, 16)]
    for kind, bits in kinds:
        (folder / f"kind-{kind}-{bits}.png").write_bytes(picture(5, 4, bits, kind))
    extras = [(b"tRNS", b"\0\1"), (b"gAMA", struct.pack(">I", 45455)), (b"tEXt", b"Title\0grass"),
              (b"zTXt", b"Title\0\0" + zlib.compress(b"x" * 999))]
    (folder / "extra.png").write_bytes(picture(4, 4, 8, 0, extra=extras))
    (folder / "interlaced.png").write_bytes(picture(9, 9, 8, 6, interlaced=True))
    (folder / "palette-transparent.png").write_bytes(picture(4, 4, 8, 3, extra=[(b"tRNS", b"\0\x80")]))


def npy(folder):
    def array(shape, version=1, kind="<f4", order="False"):
        count = 1
        for extent in shape:
            count *= extent
        text = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape!r}, }}\n".encode()
        length = struct.pack("<H" if version == 1 else "<I", len(text))
        return b"\x93NUMPY" + bytes([version, 0]) + length + text + struct.pack(f"<{count}f", *range(count))
    for n, data in enumerate([array(()), array((3,)), array((2, 3, 2)), array((4, 4, 2), version=2), array((1, 0, 2), version=3),
                              array((2, 2), kind=">f8"), array((2, 2), order="True"), array((2, 2, 2))[:-3]]):
        (folder / f"{n}.npy").write_bytes(data)


# The editor's and the bakes' own files

def preferences(folder):
    full = {"theme": "light", "interfaceScale": 1.5, "recentFiles": ["/tmp/a.wind.json", "/tmp/b.wind.json"],
            "keymap": {"edit.undo": ["Ctrl+K", "Numpad 7"], "tool.draw": [], "view.top": "Ctrl+Shift+Alt+Page Up"},
            "numbers": {"window.width": 1280, "layout.left": 300.5}, "texts": {"export.preset": "godot"}, "firstRunHintSeen": True}
    (folder / "full.json").write_text(json.dumps(full))
    for n, text in enumerate(["", "{}", "[]", '{"theme": 3}', '{"keymap": {"edit.undo": "Ctrl++", "x": 1}}']):
        (folder / f"{n}.json").write_text(text)


def manifest(folder):
    note = {"first": 0, "last": 5, "fastest": 3.5, "seam": 0.1, "step": 0.2,
            "groups": [[{"path": "f0.bin", "sha256": "00", "role": "field", "encoding": "float16", "frame": 0}]]}
    listed = {"format": "windpack", "plan": "abc", "files": [{"path": "f0.bin", "sha256": "00"}, {"path": "f1.bin"}]}
    (folder / "note.json").write_text(json.dumps(note))
    (folder / "manifest.json").write_text(json.dumps(listed))
    (folder / "both.json").write_text(json.dumps({**note, **listed}))


def typed(folder):
    for n, text in enumerate(["2*3+1", "-(4 - 1)/2", "12 m/s", "sqrt(min(4, 9))^2", "36 km/h", "50 %", "1e-5", "pi*cos(60)",
                              "Ctrl+Shift+Z", "Numpad Plus", "+3.25", "0x1p4", "1/0", "((((1))))"]):
        (folder / f"{n}.txt").write_text(text)


def command_line(folder):
    lines = ["--help", "--version", "new a.wind.json --template meadow --solver cwd-sim", "validate a b --json", "info a --json",
             "sample a --at 1,2 --at -3,4.5 --time 3 --backend cpu --threads 2",
             "bake a --out d --format exr,atlas,npy --preset godot --from 1 --seconds 2 --fps 15 --resolution 256x128 --loop",
             "bake a --out d --format vdb --frames 3-17 --steps 20 --warm-up 2 --space uv --vmax 30 --response --layers 4",
             "render a --out x.png --time 6 --frames 3 --size 320x200 --overlay arrows,grid --no-culling all --samples 4",
             "bench solver --cells 512,1000 --json -", "edit a.wind.json", "docs docs", "a.wind.json --size 1280x720 --scale 1.5 --select 1,4",
             "--screenshot x.png --frames 60", "godot 256x256 3-17 4"]
    for n, line in enumerate(lines):
        (folder / f"{n:02}.txt").write_text(line.replace(" ", "\n"))


# Wind packs and the live link

def pack(version=2, flags=0, width=4, height=3, frames=2, quantity=0, roughness=0.03, seed=1):
    """A pack after docs/windpack.md."""
    numbers = random.Random(seed)
    cell = "2f" if flags & FLOATS else "2e"
    cells = b"".join(struct.pack("<" + cell, numbers.uniform(-9, 9), numbers.uniform(-9, 9))
                     for _ in range(width * height * frames))
    head = struct.pack("<8s6I4f2fd2Q", b"WINDPACK", version, 0x01020304, flags, width, height, frames, -2, -1, 6, 5, 10, 20, 1.5,
                       len(cells), 0)
    if version >= 2:
        head += struct.pack("<I2fI", quantity, 2, roughness, 0)
    if flags & ZSTD:
        cells = subprocess.run(["zstd", "-q", "-c", "--no-check"], input=cells, capture_output=True, check=True).stdout
    body = head + cells
    return body + struct.pack("<I", zlib.crc32(body))


def windpack(folder):
    packs = [pack(version=1), pack(version=1, flags=LOOP | WRAP_X, width=1, frames=3), pack(), pack(flags=FLOATS),
             pack(flags=LOOP | WRAP_X | WRAP_Z, width=17, height=9), pack(flags=FLOATS | LOOP, width=2, height=1, frames=5),
             pack(quantity=1, roughness=0), pack(width=1, height=1, frames=1)]
    if shutil.which("zstd"):
        packs += [pack(flags=ZSTD), pack(flags=ZSTD | FLOATS | LOOP, width=16, height=16)]
    packs += [packs[2][:95], packs[2][:8], packs[3] + b"x"]
    for n, data in enumerate(packs):
        (folder / f"{n:02}.windpack").write_bytes(data)


def windpack_damage(folder):
    """Packs cut at every byte, and with every bit of the header turned: tried once, not mutated."""
    for kind, good in enumerate([pack(version=1), pack(), pack(flags=FLOATS | LOOP)]):
        header = 80 if kind == 0 else 96
        for length in range(len(good)):
            (folder / f"{kind}-cut-{length:04}").write_bytes(good[:length])
        for bit in range(8 * header):
            bad = bytearray(good)
            bad[bit // 8] ^= 1 << bit % 8
            (folder / f"{kind}-bit-{bit:04}").write_bytes(bad)


def live(folder):
    slot_bytes = 64 + 512 * 512 * 4
    for n, (width, height, newest) in enumerate([(4, 3, 1), (512, 512, 2), (1, 1, 7), (513, 1, 3)]):
        header = struct.pack("<8s4IQI", b"WINDLIVE", 1, 4, slot_bytes, 0, newest, 1).ljust(64, b"\0")
        slot = struct.pack("<QII5fId", 2 * newest, width, height, -2, -1, 6, 5, 9, 2 * (n % 4), 1.5).ljust(64, b"\0")
        (folder / f"{n}.live").write_bytes(header + slot + struct.pack("<32e", *range(32)))
