"""Frame times of the real window on a graph of 10,000 arrows, at rest and while one point or everything is dragged. Run by hand.

usage: window_bench.py WINDLOOM_EDITOR
"""
import json
import pathlib
import random
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "ui"))
from editor_driver import display, editor  # noqa: E402

SIDE = 100


def project():
    dice = random.Random(1)
    points, arrows = [], []
    for z in range(SIDE):
        for x in range(SIDE):
            number = 1 + z * SIDE + x
            points.append({"id": number, "position": [round(x - 49.5 + dice.uniform(-0.3, 0.3), 3),
                                                      round(z - 49.5 + dice.uniform(-0.3, 0.3), 3)]})
            if x or z:
                arrows.append({"id": SIDE * SIDE + number, "from": number - SIDE if z else number - 1, "to": number, "radius": 1})
    return {"format": "windloom-project", "version": 1, "name": "Ten thousand arrows",
            "field": {"resolution": [64, 64]}, "grass": {"density": 0}, "graph": {"points": points, "arrows": arrows}}


def frame_ms(app, work, seconds=3):
    first, start = int(app.fact("frame")), time.monotonic()
    while time.monotonic() - start < seconds:
        work()
        time.sleep(0.005)
    return (time.monotonic() - start) * 1000 / max(1, int(app.fact("frame")) - first)


def dragged(app):
    """ms a frame while what is under the middle of the picture is dragged."""
    x, y = app.centre("viewport")
    app.point_at((x, y))
    app.xdotool("mousedown", 1)
    steps = iter(range(10**9))

    def work():
        step = next(steps)
        app.move((x + 20 + step % 40, y + step % 30))

    frame_ms(app, work, 1)
    result = frame_ms(app, work)
    app.key("Escape")
    app.xdotool("mouseup", 1)
    return result


def main():
    with tempfile.TemporaryDirectory(prefix="windloom-bench-") as folder, display() as environment:
        file = pathlib.Path(folder) / "many.wind.json"
        file.write_text(json.dumps(project()))
        with editor(sys.argv[1], environment, folder, str(file)) as app:
            app.key("KP_Home")
            app.wait_fact("view", "top")
            time.sleep(2)
            print(f"playing, nothing done: {frame_ms(app, lambda: None):.0f} ms a frame")
            app.key("space", "w", "alt+a")
            print(f"one point dragged: {dragged(app):.0f} ms a frame")
            app.key("a")
            time.sleep(1)
            print(f"all dragged: {dragged(app):.0f} ms a frame")
            app.key("5")
            print(f"all dragged, arrows not drawn: {dragged(app):.0f} ms a frame")


if __name__ == "__main__":
    main()
