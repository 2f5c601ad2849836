"""`windloom bake` when things go wrong: no torn files, a message, the right exit status."""
import json
import resource
import signal
import subprocess
import time

import numpy

import harness
from harness import SAMPLE_PACK, WINDLOOM


def disk_holds(kilobytes):
    """For a child: files longer than this can't be written, as on a disk that is full."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (kilobytes * 1024, kilobytes * 1024))
    return limit


class BakeTrouble(harness.Case):
    def test_ctrl_c_leaves_nothing_and_an_older_bake_alone(self):
        out = self.bake("--seconds", 0.2, "--fps", 10, formats="npy,png")
        before = {path.name: harness.sha256(path) for path in out.iterdir()}
        command = [WINDLOOM, "bake", self.project, "--backend", "cpu", "--out", out, "--format", "npy,png"]
        child = subprocess.Popen([*command, "--seconds", "2000", "--fps", "5"], stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.kill)
        give_up = time.monotonic() + 60
        while not any(path.name.startswith(".bake") for path in out.iterdir()):
            self.assertLess(time.monotonic(), give_up, "the bake never began")
            time.sleep(0.05)
        child.send_signal(signal.SIGINT)
        self.assertIn("cancelled", child.communicate(timeout=60 * harness.PATIENCE)[1])
        self.assertEqual(child.returncode, 130)
        self.assertEqual({path.name: harness.sha256(path) for path in out.iterdir()}, before)

    def test_a_full_disk_is_said_and_leaves_nothing(self):
        for formats in ("npy", "windpack", "npy,png"):
            with self.subTest(formats=formats):
                out = self.folder / formats
                done = self.call("bake", self.project, "--backend", "cpu", "--out", out, "--format", formats,
                                 "--seconds", 0.5, "--json", status=3, preexec_fn=disk_holds(16))
                self.assertIn("can't write", done.stderr)
                self.assertFalse(json.loads(done.stdout)["ok"])
                self.assertFalse(out.exists(), "not even the folder that the bake made")

    def test_a_bake_that_is_killed_leaves_a_whole_bake_or_none(self):
        """Whenever it dies: every file that a manifest lists is there with its checksum."""
        out, whole, none = self.folder / "killed", 0, 0
        presets = ("unity", "unreal")
        command = [WINDLOOM, "bake", self.project, "--backend", "cpu", "--out", out, "--format", "png,png16,exr,dds",
                   "--seconds", "3", "--fps", "20", "--resolution", "32x20"]
        started = time.monotonic()
        subprocess.run([*command, "--preset", presets[0]], check=True, capture_output=True)
        length = time.monotonic() - started
        for n in range(24):
            child = subprocess.Popen([*command, "--preset", presets[n % 2]], stdout=subprocess.DEVNULL,
                                     stderr=subprocess.DEVNULL)
            # Most of all near the end, where files are moved to their places.
            time.sleep(length * (0.2 + 0.9 * (n / 23) ** 0.5))
            child.kill()
            child.wait()
            if not (out / "manifest.json").exists():
                none += 1
                continue
            whole += 1
            for entry in json.loads((out / "manifest.json").read_text())["files"]:
                self.assertEqual(harness.sha256(out / entry["path"]), entry["sha256"], f"{n}: {entry['path']}")
        self.assertEqual(whole + none, 24)
        self.assertGreater(whole, 0)
        subprocess.run([*command, "--preset", presets[0]], check=True, capture_output=True)
        self.assertTrue((out / "manifest.json").exists())

    def test_a_folder_that_cannot_be_made_is_said(self):
        below = self.project / "below"
        done = self.call("bake", self.project, "--out", below, "--format", "npy", "--backend", "cpu", status=3)
        self.assertIn("below", done.stderr)

    def test_wrong_usage_names_what_was_expected(self):
        out = ("--out", self.folder / "out")
        for args, expected in (
                (("--format", "gif"), "npy, png, exr"),
                (("--format", "npy", "--preset", "cryengine"), "generic, unreal, unity, unity-negz, godot"),
                (("--format", "npy", "--resolution", "12"), "WxH"),
                (("--format", "npy", "--resolution", "0x5"), "WxH"),
                (("--format", "npy", "--resolution", "9000x5"), "8192"),
                (("--format", "npy", "--seconds", "1e6"), "100000"),
                (("--format", "npy", "--seconds", "-1"), "--seconds"),
                (("--format", "npy", "--fps", "0"), "--fps"),
                (("--format", "npy", "--seconds", "1", "--steps", "3"), "--steps"),
                ((), "--format")):
            with self.subTest(args=args):
                done = self.call("bake", self.project, *out, *args, status=2)
                self.assertIn(expected, done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_broken_project_is_refused_with_its_place(self):
        project = json.loads(self.project.read_text())
        project["graph"]["arrows"][1]["to"] = 99
        self.project.write_text(json.dumps(project))
        done = self.call("bake", self.project, "--out", self.folder / "out", "--format", "npy", status=1)
        self.assertIn("/graph/arrows/1/to", done.stderr)
        self.call("bake", self.folder / "none.wind.json", "--out", self.folder / "out", "--format", "npy", status=1)

    def test_steps_count_the_solvers_steps_and_a_bake_can_be_continued(self):
        whole = numpy.load(self.bake("--from", 0.25, "--seconds", 0.01, out="whole") / "wind.npy")
        steps = numpy.load(self.bake("--steps", 15, out="steps") / "wind.npy")
        self.assertEqual(steps.shape, (1, 30, 48, 2))
        numpy.testing.assert_array_equal(steps, whole)
        self.assertEqual(numpy.load(self.bake("--steps", 12, "--fps", 30, out="many") / "wind.npy").shape[0], 7)
        out = self.bake("--steps", 0, "--initial", self.folder / "steps" / "wind.npy", out="continued")
        continued = numpy.load(out / "wind.npy")
        numpy.testing.assert_allclose(continued, steps, atol=0.2 * numpy.abs(steps).max())

    def test_a_continued_bake_goes_on_in_time(self):
        whole = numpy.load(self.bake("--steps", 60, out="whole") / "wind.npy")[0]
        half = self.bake("--steps", 30, out="half") / "wind.npy"
        words = ("--steps", 30, "--initial", half)
        second = self.bake(*words, "--initial-time", 0.5, out="second")
        manifest = json.loads((second / "manifest.json").read_text())
        self.assertAlmostEqual(manifest["time"]["start"], 1, delta=1e-6)
        again = numpy.load(self.bake(*words, out="again") / "wind.npy")[0]

        def error(wind):
            return numpy.sqrt(((wind - whole) ** 2).mean() / (whole ** 2).mean())

        continued = numpy.load(second / "wind.npy")[0]
        self.assertLess(error(continued), 0.1)
        self.assertGreater(error(again), 2 * error(continued), "without its time the arrows begin from the start")
        sampled = self.call("sample", self.project, "--backend", "cpu", "--json", "--initial", half, "--initial-time", 0.5,
                            "--time", 1, "--at", "{:.9g},{:.9g}".format(*harness.centre_of(24, 15)))
        answer = json.loads(sampled.stdout)
        self.assertEqual(answer["steps"], 60)
        numpy.testing.assert_allclose(answer["samples"][0]["velocity"], continued[15, 24], atol=1e-4)
        self.call("bake", self.project, "--out", self.folder / "no", "--format", "npy", "--initial", half,
                  "--initial-time", 0.5, "--from", 0.2, status=2)
        self.call("sample", self.project, "--at", "1,1", "--time", 1, "--initial-time", 0.5, status=2)

    def test_the_c_library_refuses_a_damaged_pack(self):
        out = self.bake("--seconds", 0.1, formats="windpack")
        pack = out / "wind.windpack"
        raw = pack.read_bytes()
        for damaged, message in ((raw[:200], "another length"), (b"x" + raw[1:], "not a wind pack"),
                                 (raw[:500] + bytes([raw[500] ^ 1]) + raw[501:], "damaged"), (b"", "not a wind pack")):
            pack.write_bytes(damaged)
            done = subprocess.run([SAMPLE_PACK, pack], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn(message, done.stderr)


harness.main()
