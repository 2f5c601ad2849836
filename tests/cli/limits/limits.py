"""Files and options just above a limit, files that are none, and files outside a project's folder: each is refused with
its place, at once, and without taking memory. docs/limits.md is what the code says."""
import argparse
import json
import os
import pathlib
import re
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

DONE, BAD_INPUT, USAGE, MACHINE = 0, 1, 2, 3
MIB = 1 << 20
# A refusal needs a small part of a second and 60 MiB; sanitizers need several times that.
PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))
MOST_CPU_S = 5.0 * PATIENCE
# Sanitizers keep what was freed for a while.
MOST_MEMORY = (700 if PATIENCE == 1 else 1400) * MIB


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, body=b""):
    """A grey 8-bit picture; without a body only its header is true."""
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b"")


def grey(width, height):
    return png(width, height, bytes((width + 1) * height))


def glb(document, data=b""):
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], **document}
    if data:
        document["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    parts = struct.pack("<I4s", len(text), b"JSON") + text
    if data:
        parts += struct.pack("<I4s", len(data), b"BIN\0") + data
    return b"glTF" + struct.pack("<II", 2, 12 + len(parts)) + parts


def triangles(count, **more):
    """A mesh without indices. `count` may lie: the buffer holds one triangle where it does."""
    held = min(count, 100_000)
    data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 1) * held
    return {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3 * count, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": len(data)}], **more}, data


def points(count):
    return [{"id": n + 1, "position": [n * 0.01, 0]} for n in range(count)]


def records(count, **values):
    return [{"id": n + 1, **values} for n in range(count)]


class Case(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.top = pathlib.Path(holder.name)
        self.folder = self.top / "project"
        self.folder.mkdir()
        self.project = self.folder / "a.wind.json"

    def write(self, **parts):
        self.project.write_text(json.dumps({"format": "windloom-project", "version": 1, **parts}), encoding="utf-8")

    def run_windloom(self, *arguments, memory=None):
        def limit():
            if memory:
                resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

        process = subprocess.Popen([OPTIONS.windloom, *map(str, arguments)], stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, preexec_fn=limit)
        text = process.stdout.read().decode("utf-8", "replace")
        process.stdout.close()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, text, used

    def answered(self, status, message, *arguments):
        found, text, used = self.run_windloom(*arguments)
        self.assertEqual(found, status, f"{arguments}: {text[:2000]}")
        self.assertIn(message, text)
        self.assertLess(used.ru_utime + used.ru_stime, MOST_CPU_S, message)
        self.assertLess(used.ru_maxrss * 1024, MOST_MEMORY, message)
        return text

    def refused(self, status, message, *arguments):
        self.assertNotEqual(status, DONE)
        return self.answered(status, message, *arguments)

    def sparse(self, path, size):
        with open(path, "wb") as file:
            file.truncate(size)


class Projects(Case):
    def test_a_file_that_is_too_large_is_not_read(self):
        self.sparse(self.project, 64 * MIB + 1)
        for verb in ("validate", "info"):
            self.refused(BAD_INPUT, "is larger than the limit of 67108864 bytes", verb, self.project)

    def test_counts_just_above_the_limits(self):
        keys = [[n, 1] for n in range(10_001)]
        path = [[n * 0.1, 0, 0, 0] for n in range(10_001)]
        corner = [[n, n * n] for n in range(257)]
        for place, found, parts in (
                ("/graph/points", "holds 100001", {"graph": {"points": points(100_001)}}),
                ("/graph/arrows", "holds 100001", {"graph": {"arrows": [{"id": n + 1, "from": 1, "to": 2}
                                                                        for n in range(100_001)]}}),
                ("/graph/signals/0/keys", "10001", {"graph": {"points": points(1), "signals": [
                    {"root": 1, "kind": "curve", "keys": keys}]}}),
                ("/obstacles", "holds 10001", {"obstacles": records(10_001)}),
                ("/obstacles/0/points", "an array of 3 to 256 corners",
                 {"obstacles": [{"id": 1, "centre": [0, 0], "shape": "polygon", "points": corner}]}),
                ("/probes", "holds 1001", {"probes": records(1001)}),
                ("/cameras", "holds 1001", {"cameras": records(1001)}),
                ("/species", "holds 17", {"species": records(17)}),
                ("/colliders", "holds 65", {"colliders": records(65)}),
                ("/colliders/0/keys", "10001", {"colliders": [{"id": 1, "keys": path}]}),
                ("/surfaces", "holds 65", {"surfaces": records(65)}),
                ("/rotors", "holds 17", {"rotors": records(17)}),
                ("/name", "256", {"name": "n" * 257}),
                ("/field/resolution", "from 8 to 4096", {"field": {"resolution": [4097, 8]}}),
                ("/grass/density", "million blades", {"field": {"size": [2000, 2000]}, "grass": {"density": 51}}),
                ("/field", "has more than 256 keys", {"field": {f"k{n}": 0 for n in range(257)}})):
            with self.subTest(place):
                self.write(**parts)
                text = self.refused(BAD_INPUT, place, "validate", self.project)
                self.assertIn(found, text)

    def test_nesting_and_values_of_json(self):
        for text, message in (("[" * 65 + "]" * 65, "nested deeper than 64 levels"),
                              ("[" * 2_000_000, "nested deeper than 64 levels"),
                              ('{"later": [' + "0," * 8_000_000 + "0]}", "holds more than 8000000 values")):
            self.project.write_text(text)
            self.refused(BAD_INPUT, message, "validate", self.project)


class Assets(Case):
    def check(self, name, bytes_or_size, message, **parts):
        if isinstance(bytes_or_size, int):
            self.sparse(self.folder / name, bytes_or_size)
        else:
            (self.folder / name).write_bytes(bytes_or_size)
        self.write(**parts)
        text = self.refused(BAD_INPUT, message, "validate", self.project)
        self.assertIn(name, text)
        return text

    def test_pictures(self):
        ground = {"terrain": {"kind": "heightmap", "file": "h.png"}}
        map_ = {"grass": {"maps": {"density": "h.png"}}}
        for parts in (ground, map_):
            self.check("h.png", 256 * MIB + 1, "is larger than the limit of 268435456 bytes", **parts)
            self.check("h.png", png(32769, 1), "damaged PNG file", **parts)
            self.check("h.png", png(32768, 4097), "pixels, at most 134217728 can be read", **parts)
            self.check("h.png", png(32768, 4096), "cut short", **parts)
        # Texts, each of which would be unpacked to 8 MB and kept.
        texts = chunk(b"zTXt", b"k\0\0" + zlib.compress(bytes(7_900_000), 9)) * 200
        header, rest = grey(16, 16)[:33], grey(16, 16)[33:]
        (self.folder / "h.png").write_bytes(header + texts + rest)
        self.write(**ground)
        self.answered(DONE, "valid", "validate", self.project)
        self.check("h.png", grey(16385, 2), "has 16385 pixels a side, expected at most 16384", **ground)

    def test_meshes(self):
        plant = {"species": [{"id": 1, "shape": "mesh", "file": "m.glb"}]}
        solid = {"colliders": [{"id": 1, "shape": "mesh", "file": "m.glb"}]}
        surface = {"surfaces": [{"id": 1, "shape": "mesh", "file": "m.glb"}]}
        ground = {"terrain": {"kind": "mesh", "file": "m.glb"}}
        for parts in (plant, solid, surface, ground):
            self.check("m.glb", (1 << 30) + 1, "is larger than the limit of 1073741824 bytes", **parts)
            self.check("m.glb", glb(*triangles(3_000_000_000)), "m.glb: has 9000000000 elements", **parts)
            self.check("m.glb", glb(*triangles(300_000)), "reaches beyond its buffer", **parts)
            deep = []
            for _ in range(70):
                deep = [deep]
            self.check("m.glb", glb(*triangles(1, extras=deep)), "nested deeper than 64 levels", **parts)
            self.check("m.glb", glb(*triangles(1, extras=[0] * 1_000_001)), "holds more than 1000000 values", **parts)
        self.check("m.glb", glb(*triangles(20_001)), "has more than", **plant)
        placed, data = triangles(1)
        placed["meshes"][0]["primitives"] *= 1000
        placed["nodes"] = [{"children": list(range(1, 202))}] + [{"mesh": 0}] * 201
        self.check("m.glb", glb(placed, data), "places more than 200000 pieces", **ground)

    def test_triangles_in_a_pile(self):
        document, data = triangles(1)
        per, pieces, nodes = 1000, 20, 25  # half a million, in a few kilobytes
        document["accessors"].append({"bufferView": 1, "componentType": 5121, "count": 3 * per, "type": "SCALAR"})
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": 3 * per})
        document["meshes"][0]["primitives"][0]["indices"] = 1
        document["meshes"][0]["primitives"] *= pieces
        document["nodes"] = [{"children": list(range(1, nodes + 1))}] + [{"mesh": 0}] * nodes
        pile = glb(document, data + bytes((0, 1, 2)) * per)
        self.assertLess(len(pile), 10_000)
        self.check("m.glb", pile, "triangles that lie over each other", terrain={"kind": "mesh", "file": "m.glb"})
        self.write(colliders=[{"id": 1, "shape": "mesh", "file": "m.glb", "spheres": 1024}])
        self.answered(DONE, "valid", "validate", self.project)

    def test_all_meshes_of_a_project_together(self):
        document, data = triangles(1)
        count = 6_000_000  # two million triangles of three vertices, a byte for each corner
        document["accessors"].append({"bufferView": 1, "componentType": 5121, "count": count, "type": "SCALAR"})
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": count})
        document["meshes"][0]["primitives"][0]["indices"] = 1
        (self.folder / "m0.glb").write_bytes(glb(document, data + bytes((0, 1, 2)) * (count // 3)))
        for n in range(1, 11):
            os.link(self.folder / "m0.glb", self.folder / f"m{n}.glb")
        self.write(surfaces=[{"id": n + 1, "shape": "mesh", "file": f"m{n}.glb"} for n in range(11)])
        status, text, _ = self.run_windloom("validate", self.project)
        self.assertEqual(status, BAD_INPUT, text)
        self.assertIn("/surfaces/10/file: m10.glb: makes more than 20 million triangles", text)
        self.assertNotIn("/surfaces/9/file", text)

    def test_materials_and_their_pictures(self):
        plant = {"species": [{"id": 1, "shape": "mesh", "file": "m.glb"}]}
        many, data = triangles(1)
        many["materials"] = [{}] * 17
        many["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}, "material": n} for n in range(17)]}]
        self.check("m.glb", glb(many, data), "uses more than 16 materials", **plant)
        for sizes, message in (([(8193, 1)], "more than 8192 pixels a side"),
                               ([(8192, 8192)] * 3, "makes more than 128 million pixels")):
            several, data = triangles(1)
            several["images"], several["textures"], several["materials"] = [], [], []
            for n, size in enumerate(sizes):
                # The first two are true, so that only their sum is too much.
                picture = grey(*size) if len(sizes) > 1 and n < 1 else png(*size)
                (self.folder / f"p{n}.png").write_bytes(picture)
                several["images"].append({"uri": f"p{n}.png"})
                several["textures"].append({"source": n})
                several["materials"].append({"pbrMetallicRoughness": {"baseColorTexture": {"index": n}}})
            several["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}, "material": n}
                                                 for n in range(len(sizes))]}]
            if len(sizes) == 1:
                self.check("m.glb", glb(several, data), message, **plant)

    def test_initial_winds(self):
        self.write()
        wind = self.folder / "wind.npy"
        sample = ("sample", self.project, "--at", "0,0", "--time", "0", "--backend", "cpu", "--initial", wind)
        self.sparse(wind, (1 << 30) + 1)
        self.refused(BAD_INPUT, "is larger than the limit of 1073741824 bytes", *sample)
        for shape in ("(4294967296, 4294967296, 2)", "(1000000, 1000000, 2)", "(" + "1, " * 33 + ")"):
            header = ("{'descr': '<f4', 'fortran_order': False, 'shape': " + shape + ", }\n").encode()
            wind.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + bytes(64))
            self.refused(BAD_INPUT, "wind.npy", *sample)


class NoFiles(Case):
    def test_pipes_devices_and_folders_are_not_read(self):
        pipe = self.folder / "pipe.wind.json"
        os.mkfifo(pipe)
        for path, message in ((pipe, "is a pipe or a device"), ("/dev/zero", "is a pipe or a device"),
                              (self.folder, "is a folder")):
            self.refused(BAD_INPUT, message, "validate", path)
            self.refused(BAD_INPUT, message, "info", path)

    def test_nor_where_a_project_names_them(self):
        for name, parts in (("x.png", {"terrain": {"kind": "heightmap", "file": "x.png"}}),
                            ("x.png", {"grass": {"maps": {"height": "x.png"}}}),
                            ("x.png", {"shell": {"texture": {"file": "x.png"}}}),
                            ("x.glb", {"species": [{"id": 1, "shape": "mesh", "file": "x.glb"}]}),
                            ("x.glb", {"terrain": {"kind": "mesh", "file": "x.glb"}})):
            path = self.folder / name
            self.write(**parts)
            os.mkfifo(path)
            self.refused(BAD_INPUT, "is a pipe or a device", "validate", self.project)
            path.unlink()
            path.symlink_to("/dev/zero")
            self.refused(BAD_INPUT, "a link that leads out of the project's folder", "validate", self.project)
            self.refused(BAD_INPUT, "is a pipe or a device", "validate", "--allow-outside", self.project)
            path.unlink()

    def test_a_pipe_as_an_initial_wind_or_a_manifest(self):
        self.write()
        os.mkfifo(self.folder / "wind.npy")
        self.refused(BAD_INPUT, "is a pipe or a device", "sample", self.project, "--at", "0,0", "--time", "0",
                     "--backend", "cpu", "--initial", self.folder / "wind.npy")
        out = self.top / "out"
        out.mkdir()
        bake = ("bake", self.project, "--out", out, "--format", "npy", "--seconds", "0.1", "--backend", "cpu")
        os.mkfifo(out / "manifest.json")
        self.refused(BAD_INPUT, "is a pipe or a device", *bake)
        (out / "manifest.json").unlink()
        self.sparse(out / "manifest.json", 256 * MIB + 1)
        self.refused(BAD_INPUT, "is larger than the limit of 268435456 bytes", *bake)


class Outside(Case):
    def setUp(self):
        super().setUp()
        (self.top / "library").mkdir()
        (self.top / "library" / "hills.png").write_bytes(grey(16, 16))

    def test_files_outside_are_read_only_where_it_is_allowed(self):
        (self.folder / "link.png").symlink_to("../library/hills.png")
        for file in ("../library/hills.png", str(self.top / "library" / "hills.png"), "link.png"):
            self.write(terrain={"kind": "heightmap", "file": file})
            for verb in (["validate"], ["info"], ["sample", "--at", "0,0", "--time", "0.1", "--backend", "cpu"],
                         ["bake", "--out", self.top / "out", "--format", "npy", "--seconds", "0.1", "--backend", "cpu"]):
                text = self.refused(BAD_INPUT, "/terrain/file: found '" + file, verb[0], self.project, *verb[1:])
                self.assertIn("--allow-outside", text)
                self.assertFalse((self.top / "out").exists())
            status, text, _ = self.run_windloom("validate", "--allow-outside", self.project)
            self.assertEqual(status, DONE, text)
            status, text, _ = self.run_windloom("info", self.project, "--allow-outside")
            self.assertEqual(status, DONE, text)

    def test_addresses_are_never_fetched(self):
        for uri in ("http://localhost:1/a.bin", "https://example.org/a.bin", "file:///etc/passwd", "/etc/passwd"):
            mesh, data = triangles(1)
            mesh["buffers"] = [{"uri": uri, "byteLength": len(data)}]
            (self.folder / "m.gltf").write_text(json.dumps({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
                                                            "nodes": [{"mesh": 0}], **mesh}))
            self.write(terrain={"kind": "mesh", "file": "m.gltf"})
            for option in ([], ["--allow-outside"]):
                self.refused(BAD_INPUT, "m.gltf", "validate", self.project, *option)


class Options(Case):
    def test_options_just_above_their_limits(self):
        self.write()
        bake = ("bake", self.project, "--out", self.top / "out", "--format", "npy", "--backend", "cpu")
        render = ("render", self.project, "--out", self.top / "a.png")
        for message, command in (
                ("1 to 8192 a side", [*bake, "--resolution", "8193x8"]),
                ("at most 100000 can be baked", [*bake, "--seconds", "1000.01", "--fps", "100"]),
                ("at most 274877906944 cells can be baked",
                 [*bake, "--resolution", "8192x8192", "--seconds", "100", "--fps", "41"]),
                ("--seconds", [*bake, "--seconds", "1000001"]),
                ("--layers", [*bake, "--layers", "129"]),
                ("--frames", [*bake, "--frames", "0-100000"]),
                ("8 to 16384 pixels", [*render, "--size", "16385x8"]),
                ("8 to 4096 cells", [*render, "--resolution", "4097x8"]),
                ("--frames", [*render, "--frames", "100001"]),
                ("--time", [*render, "--time", "1000001"])):
            with self.subTest(message):
                self.refused(USAGE, message, *command)
                self.assertEqual(sorted(p.name for p in self.top.iterdir()), ["project"])


class Memory(Case):
    def test_where_memory_ends_the_command_line_says_so(self):
        if self.run_windloom("--version", memory=1024 * MIB)[0] != DONE:
            self.skipTest("this build needs more address space than that for itself")
        self.write(field={"resolution": [4096, 4096]})
        out = self.top / "out"
        status, text, _ = self.run_windloom("bake", self.project, "--out", out, "--format", "npy", "--seconds", "0.1",
                                            "--backend", "cpu", "--threads", "1", memory=700 * MIB)
        self.assertEqual(status, MACHINE, text)
        self.assertIn("not enough memory", text)
        self.assertFalse(out.exists() and any(out.iterdir()), "nothing is left")


class Documents(Case):
    def test_the_page_of_limits_is_what_the_code_says(self):
        status, text, _ = self.run_windloom("docs", self.top)
        self.assertEqual(status, DONE, text)
        page = (OPTIONS.repository / "docs" / "limits.md").read_text(encoding="utf-8")
        self.assertEqual(page, (self.top / "limits.md").read_text(encoding="utf-8"), "run: windloom docs docs")
        rows = re.findall(r"^\| [^|]+ \| [^|]+ \| `([^`]+)` \|", page, re.M)
        self.assertGreater(len(rows), 60)
        for row in rows:
            self.assertTrue((OPTIONS.repository / row).is_file(), row)

    def test_only_three_files_start_programs_and_none_opens_connections(self):
        starts = re.compile(r"(?<![\w.])(?:std::|::)?(system|popen|fork|vfork|exec[lv]p?e?|posix_spawnp?|connect|"
                            r"getaddrinfo|dlopen)\s*\(")
        allowed = {("engine/cli/verb_edit.cpp", "execv"), ("engine/cli/bench_startup.cpp", "posix_spawn"),
                   ("editor/core/folder_opener.cpp", "posix_spawnp")}
        found = set()
        for room in ("engine", "editor"):
            for path in sorted((OPTIONS.repository / room).rglob("*.[ch]*")):
                text = re.sub(r"//[^\n]*|\"(?:\\.|[^\"\\\n])*\"", "", path.read_text(encoding="utf-8"))
                for match in starts.finditer(text):
                    if re.search(r"void App::\s*$", text[:match.start(0)]) or match.group(0) == "connect(":
                        continue  # a function of ours
                    found.add((path.relative_to(OPTIONS.repository).as_posix(), match.group(1)))
        self.assertEqual(found, allowed)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--windloom", required=True)
    parser.add_argument("--repository", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
