"""A strict reader of .gltf files with embedded buffers, after the glTF 2.0 specification: refuses what a validator would."""
import base64
import json

import numpy

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
ALLOWED = {
    "": {"asset", "scene", "scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers", "extras"},
    "asset": {"version", "generator", "copyright", "minVersion", "extras"},
    "scenes": {"name", "nodes", "extras"},
    "nodes": {"name", "translation", "rotation", "scale", "matrix", "mesh", "children", "extras"},
    "meshes": {"name", "primitives", "weights", "extras"},
    "materials": {"name", "pbrMetallicRoughness", "emissiveFactor", "alphaMode", "doubleSided", "extras"},
    "accessors": {"name", "bufferView", "byteOffset", "componentType", "count", "type", "min", "max", "normalized"},
    "bufferViews": {"name", "buffer", "byteOffset", "byteLength", "byteStride", "target"},
    "buffers": {"name", "byteLength", "uri"},
}


def strict(text):
    def pairs(items):
        keys = [key for key, _ in items]
        assert len(keys) == len(set(keys)), f"a key twice: {keys}"
        return dict(items)

    def refuse(word):
        raise AssertionError(f"{word} is no JSON")

    return json.loads(text, object_pairs_hook=pairs, parse_constant=refuse)


class Gltf:
    def __init__(self, path):
        self.json = strict(path.read_text("utf-8"))
        self.check_keys()
        assert self.json["asset"]["version"] == "2.0"
        self.buffers = [self.bytes_of(buffer) for buffer in self.json.get("buffers", [])]
        self.check_tree()
        self.positions = [self.read(i) for i in range(len(self.json.get("accessors", [])))]
        for mesh in self.json.get("meshes", []):
            assert mesh["primitives"]
            for primitive in mesh["primitives"]:
                assert set(primitive) <= {"attributes", "mode", "material", "indices"}
                assert 0 <= primitive.get("mode", 4) <= 6
                assert primitive["material"] < len(self.json["materials"])

    def check_keys(self):
        assert set(self.json) <= ALLOWED[""], set(self.json) - ALLOWED[""]
        for name, allowed in ALLOWED.items():
            if name in ("", "asset"):
                continue
            if name in self.json:
                assert self.json[name], f"{name} may not be an empty list"
                for entry in self.json[name]:
                    assert set(entry) <= allowed, set(entry) - allowed

    @staticmethod
    def bytes_of(buffer):
        head, data = buffer["uri"].split(",", 1)
        assert head == "data:application/octet-stream;base64"
        raw = base64.b64decode(data, validate=True)
        assert len(raw) == buffer["byteLength"] >= 1
        return raw

    def read(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        at, kind = accessor.get("byteOffset", 0), numpy.dtype(COMPONENTS[accessor["componentType"]])
        width = WIDTHS[accessor["type"]]
        assert accessor["count"] >= 1 and (view.get("byteOffset", 0) + at) % kind.itemsize == 0
        assert at + accessor["count"] * width * kind.itemsize <= view["byteLength"]
        raw = self.buffers[view["buffer"]]
        assert view.get("byteOffset", 0) + view["byteLength"] <= len(raw)
        values = numpy.frombuffer(raw, kind, accessor["count"] * width, view.get("byteOffset", 0) + at)
        values = values.reshape(-1, width)
        assert numpy.isfinite(values).all()
        numpy.testing.assert_array_equal(numpy.array(accessor["min"], "f4"), values.min(0))
        numpy.testing.assert_array_equal(numpy.array(accessor["max"], "f4"), values.max(0))
        return values

    def check_tree(self):
        """Every node has one parent at most, and scenes name roots."""
        nodes = self.json.get("nodes", [])
        children = [child for node in nodes for child in node.get("children", [])]
        assert len(children) == len(set(children)) and all(0 <= child < len(nodes) for child in children)
        for node in nodes:
            assert node.get("children", [0]), "no empty list of children"
            if "rotation" in node:
                assert abs(numpy.linalg.norm(node["rotation"]) - 1) < 1e-6
            assert node.get("mesh", 0) < len(self.json.get("meshes", [0]))
        for scene in self.json["scenes"]:
            for root in scene.get("nodes", []):
                assert root not in children
        assert self.json["scene"] < len(self.json["scenes"])

    def forward(self, node):
        """Where +Z of a node points in its parent."""
        x, y, z, w = node.get("rotation", [0, 0, 0, 1])
        return numpy.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
