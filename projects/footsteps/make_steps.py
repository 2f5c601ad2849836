"""Writes the keys of both feet into footsteps.wind.json: a walk around a circle. A foot stands still for its whole
stance, so neither heel nor toe slides; in the swing it lifts, passes the other and comes down.

usage: make_steps.py [FILE.wind.json]
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from collider_keys import put  # noqa: E402

RADIUS = 3.0      # m, of the circle
ASIDE = 0.10      # m from the circle to each foot
STRIDES = 14      # of each foot in a round: 1.35 m each
STRIDE_S = 1.2    # s from one landing of a foot to its next
STANCE = 0.62     # part of the stride on the ground; over a half: walking, not running
# In the swing: part of its time, part of its way, height over the ground, m.
SWING = [(0.30, 0.17, 0.10), (0.62, 0.62, 0.085), (0.86, 0.95, 0.05)]


def place(stride, aside):
    """Where a foot stands, in strides from the start of the round."""
    turn = 2 * math.pi * stride / STRIDES
    return (RADIUS + aside) * math.cos(turn), (RADIUS + aside) * math.sin(turn)


def keys(aside, phase):
    """`phase`: part of a stride that the foot has behind it at the start, less than STANCE."""
    made = []
    for stride in range(STRIDES):
        landed = stride - phase  # in strides, of time and of way
        here, lifts = place(landed, aside), landed + STANCE
        if landed > 0:
            made.append((landed, *here, 0.0))
        made.append((lifts, *here, 0.0))
        for time, way, height in SWING:
            made.append((lifts + time * (1 - STANCE), *place(landed + way, aside), height))
    made.insert(0, (0.0, *place(-phase, aside), 0.0))
    made.append((STRIDES - phase, *place(-phase, aside), 0.0))
    if phase > 0:  # the round ends within a stance
        made.append((float(STRIDES), *place(-phase, aside), 0.0))
    return [(time * STRIDE_S, x, height, z) for time, x, z, height in made]


def main():
    here = pathlib.Path(__file__).parent / "footsteps.wind.json"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here
    text = target.read_text()
    for name, aside, phase in (("left foot", -ASIDE, 0.0), ("right foot", ASIDE, 0.5)):
        text = put(text, name, keys(aside, phase))
    target.write_text(text)
    print(f"{target}: {STRIDES} strides of each foot in {STRIDES * STRIDE_S:.1f} s")


if __name__ == "__main__":
    main()
