"""The arrow graph as glTF: legal, and the same trees as in the project."""
import json

import numpy

import harness
from read_gltf import Gltf

# Two roots that merge in 5, nearer to root 1; a ring behind it; an arrow with a name.
GRAPH = {
    "points": [{"id": 1, "name": "gate", "position": [-8, -4]}, {"id": 2, "position": [14, -4]},
               {"id": 5, "position": [0, -4]}, {"id": 6, "position": [0, 2]}, {"id": 7, "position": [4, 5]}],
    "arrows": [{"id": 20, "from": 1, "to": 5, "strength": 9, "radius": 3, "travelSpeed": 4},
               {"id": 21, "from": 2, "to": 5, "strength": 7, "drive": "force", "where": "end", "travelSpeed": 4},
               {"id": 22, "name": "rise", "from": 5, "to": 6, "strength": 5, "swirl": -2, "travelSpeed": 2},
               {"id": 23, "from": 6, "to": 7, "travelSpeed": 10, "muted": True},
               {"id": 24, "from": 7, "to": 5, "travelSpeed": 10}],
    "signals": [{"root": 1, "kind": "curve", "period": 4, "keys": [[0, 0], [1, 1, "smooth"], [2, 0.25, "hold"]]}],
}


class Graph(harness.Case):
    def baked(self, graph=None, **changes):
        project = dict(harness.PROJECT, name="Gräser \"im\" Wind", graph=graph or GRAPH, probes=[], **changes)
        self.project.write_text(json.dumps(project))
        out = self.bake("--seconds", 0.1, "--fps", 20, "--graph", formats="npy,vf")
        entries = {entry["path"]: entry for entry in json.loads((out / "manifest.json").read_text())["files"]}
        self.assertEqual(entries["graph.gltf"]["role"], "graph")
        self.assertEqual(entries["graph.gltf"]["sha256"], harness.sha256(out / "graph.gltf"))
        return out, Gltf(out / "graph.gltf")

    def test_trees_and_arrows_are_nodes(self):
        _, gltf = self.baked()
        nodes = gltf.json["nodes"]
        trees = {nodes[n]["name"]: nodes[n] for n in gltf.json["scenes"][0]["nodes"]}
        self.assertEqual(list(trees), ["AGC_gate", "AGC_2"])
        arrows = {name: [nodes[child]["extras"]["id"] for child in tree["children"]] for name, tree in trees.items()}
        # Point 5 is reached from root 1 after 2 s, from root 2 after 3.5 s.
        self.assertEqual(arrows, {"AGC_gate": [20, 22, 23, 24], "AGC_2": [21]})
        self.assertEqual(trees["AGC_gate"]["translation"], [-8, 0, -4])
        self.assertEqual(trees["AGC_gate"]["extras"]["kind"], "tree")
        signal = trees["AGC_gate"]["extras"]["signal"]
        self.assertEqual((signal["kind"], signal["period"]), ("curve", 4))
        self.assertEqual(signal["keys"], [[0, 0, "linear"], [1, 1, "smooth"], [2, 0.25, "hold"]])

    def test_arrows_lie_and_point_as_drawn(self):
        _, gltf = self.baked()
        places = {point["id"]: numpy.array(point["position"]) for point in GRAPH["points"]}
        drawn = {arrow["id"]: arrow for arrow in GRAPH["arrows"]}
        reached = {20: 0, 21: 0, 22: 2, 23: 5, 24: 5.5}
        kinds = {20: "root", 21: "root", 22: "branch", 23: "branch", 24: "branch"}
        nodes = gltf.json["nodes"]
        seen = []
        for tree in (nodes[n] for n in gltf.json["scenes"][0]["nodes"]):
            for node in (nodes[n] for n in tree["children"]):
                extras = node["extras"]
                arrow = drawn[extras["id"]]
                start, end = places[arrow["from"]], places[arrow["to"]]
                at = numpy.array(tree["translation"]) + node["translation"]
                numpy.testing.assert_allclose(at, [start[0], 0, start[1]], atol=1e-6)
                way = (end - start) / numpy.linalg.norm(end - start)
                numpy.testing.assert_allclose(gltf.forward(node), [way[0], 0, way[1]], atol=1e-6)
                self.assertAlmostEqual(extras["length"], numpy.linalg.norm(end - start), places=5)
                self.assertAlmostEqual(extras["reached"], reached[extras["id"]], places=5)
                self.assertEqual(extras["kind"], kinds[extras["id"]])
                for key, value in arrow.items():
                    self.assertEqual(extras[key], value, key)
                self.assertEqual(extras["drive"], arrow.get("drive", "speed"))
                self.assertEqual(node["name"], arrow.get("name", f"arrow {arrow['id']}"))
                seen.append(extras["id"])
        self.assertEqual(sorted(seen), [20, 21, 22, 23, 24])

    def test_lines_show_every_arrow(self):
        _, gltf = self.baked()
        places = {point["id"]: point["position"] for point in GRAPH["points"]}
        wanted = sorted((*places[arrow["from"]], *places[arrow["to"]]) for arrow in GRAPH["arrows"])
        found = []
        for tree in (gltf.json["nodes"][n] for n in gltf.json["scenes"][0]["nodes"]):
            (primitive,) = gltf.json["meshes"][tree["mesh"]]["primitives"]
            self.assertEqual(primitive["mode"], 1)
            lines = gltf.positions[primitive["attributes"]["POSITION"]] + tree["translation"]
            self.assertEqual(len(lines), 6 * len(tree["children"]))  # a shaft and two barbs
            for start, end in zip(lines[0::6], lines[1::6]):
                found.append((start[0], start[2], end[0], end[2]))
        numpy.testing.assert_allclose(sorted(found), wanted, atol=1e-5)

    def test_the_scene_names_the_files(self):
        out, gltf = self.baked()
        wind = gltf.json["scenes"][0]["extras"]["wind"]
        self.assertEqual((wind["version"], wind["project"]), (1, "Gräser \"im\" Wind"))
        self.assertEqual([entry["path"] for entry in wind["maps"]], ["wind.npy", "wind.0000.vf", "wind.0001.vf"])
        for entry in wind["maps"]:
            self.assertTrue((out / entry["path"]).is_file())

    def test_without_arrows_it_is_legal_as_well(self):
        _, gltf = self.baked({"points": [{"id": 3, "position": [1, 1]}], "arrows": []})
        self.assertEqual(set(gltf.json), {"asset", "scene", "scenes"})

    def test_many_trees_share_one_buffer(self):
        points = [{"id": 1 + n, "position": [n % 25 - 8, n // 25 - 8]} for n in range(250)]
        arrows = [{"id": 1000 + n, "from": 1 + n, "to": 2 + n} for n in range(0, 250, 2)]
        _, gltf = self.baked({"points": points, "arrows": arrows})
        self.assertEqual(len(gltf.json["scenes"][0]["nodes"]), 125)
        self.assertEqual(len(gltf.json["buffers"]), 1)

    def test_it_is_the_same_file_every_time(self):
        first = (self.baked()[0] / "graph.gltf").read_bytes()
        self.assertEqual(first, (self.baked()[0] / "graph.gltf").read_bytes())


harness.main()
