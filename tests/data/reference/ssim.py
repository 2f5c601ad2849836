"""Mean structural similarity of two made-up pictures, straight from Wang et al. 2004, equations 13 to 16: the numbers
that tests/unit/io/picture_compare_test.cpp expects. No library, no trick: every window is summed up for itself.

usage: ssim.py
"""
from math import exp

WIDTH, HEIGHT, WINDOW, SIGMA = 23, 17, 11, 1.5
C1, C2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2


def noise(seed):
    state, rows = seed, []
    for _ in range(HEIGHT):
        row = []
        for _ in range(WIDTH):
            state = (state * 1664525 + 1013904223) % 2**32
            row.append(state >> 24)
        rows.append(row)
    return rows


def ramp():
    return [[(9 * x + 5 * y) % 256 for x in range(WIDTH)] for y in range(HEIGHT)]


def shifted(picture):
    return [[row[max(x - 1, 0)] for x in range(WIDTH)] for row in picture]


def mean_ssim(a, b):
    weights = {(x, y): exp(-((x - 5) ** 2 + (y - 5) ** 2) / (2 * SIGMA**2)) for x in range(WINDOW) for y in range(WINDOW)}
    total = sum(weights.values())
    values = []
    for top in range(HEIGHT - WINDOW + 1):
        for left in range(WIDTH - WINDOW + 1):
            def mean(f):
                return sum(w * f(a[top + y][left + x], b[top + y][left + x]) for (x, y), w in weights.items()) / total
            ma, mb = mean(lambda p, q: p), mean(lambda p, q: q)
            va, vb = mean(lambda p, q: (p - ma) ** 2), mean(lambda p, q: (q - mb) ** 2)
            cov = mean(lambda p, q: (p - ma) * (q - mb))
            values.append((2 * ma * mb + C1) * (2 * cov + C2) / ((ma**2 + mb**2 + C1) * (va + vb + C2)))
    return sum(values) / len(values)


for name, a, b in [("noise and other noise", noise(1), noise(2)),
                   ("noise moved by a pixel", noise(1), shifted(noise(1))),
                   ("ramp and noise", ramp(), noise(1)),
                   ("ramp moved by a pixel", ramp(), shifted(ramp())),
                   ("ramp and its half", ramp(), [[p // 2 for p in row] for row in ramp()])]:
    print(f"{name}: {mean_ssim(a, b):.9f}")
