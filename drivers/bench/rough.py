#!/usr/bin/python3
"""How much of a rough surface touches?

    drivers/bench/rough.py EPAFI FOLDER [--elements N] [--surfaces COUNT] [--threads N]
                           [--picture FILE.png]

Self-affine profiles with Hurst's exponent 0.8, wavelengths from 1/4 to 1/64 of a block's width 2,
random phases and a root mean square slope of 0.1 are pressed without friction onto a rigid plane,
in ten steps of the load, on compressed operators.  Prints the part in contact against the
mean pressure over (plane strain modulus times slope) as rows of doc/benchmarks/roughness.md's
table, and draws them, with the pressure on a quarter of the block, beside Persson's formula for line
contact, erf(sqrt(2) p).  Then the law "Exponential" takes a surface's place: its Length and Pressure
fit how far the block comes down, and on a bottom with a long wave its pressure is compared with that
of the surface.  Runs that are in FOLDER already are not made again.
"""
import argparse
import math
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))
import epafi  # noqa: E402

SLOPE, HURST, SHORTEST = 0.1, 0.8, 64
WAVE = "0.005*(1-cos(pi*x))"  # of the bottom, beside the roughness
LOADS = np.geomspace(0.01, 0.5, 10)


def profile(seed):
    """Points (x, height) of one surface on [-1, 1], sixteen for every shortest wave."""
    x = np.linspace(-1, 1, 32 * SHORTEST + 1)
    waves = np.arange(8, 2 * SHORTEST + 1)[:, None]
    phases = np.random.default_rng(seed).uniform(0, 2 * np.pi, waves.shape)
    heights = waves ** -(0.5 + HURST)
    heights *= SLOPE / np.sqrt(((np.pi * waves * heights) ** 2).sum() / 2)
    y = (heights * np.cos(np.pi * waves * x + phases)).sum(axis=0)
    return np.column_stack([x, y - y.min()])


def scene(bottom, elements, tables):
    """The block on its plane; t is the mean pressure over (plane strain modulus times slope)."""
    return epafi.Scene({
        "Tables": tables,
        "Constants": {"slope": SLOPE},
        "Bodies": {"block": {
            "Material": {"Young's Modulus": 0.91, "Poisson's Ratio": 0.3},
            "Geometry": {"Vertices": [[-1, 0], [1, 0], [1, 2], [-1, 2]],
                         "Edges": ["bottom", "side", "top", "side"]},
            "Boundary Conditions": {"bottom": {"Type": "Contact", **bottom},
                                    "top": {"Type": "Neumann", "Traction Y": "-slope*t"}},
            "Rigid Motions": {"Fix": ["X", "Rotation"]}}},
        "History": {"Times": list(LOADS), "Steps": [1] * len(LOADS)},
        "Adaptivity": {"Strategy": "None", "Maximum Degrees of Freedom": 10 ** 7},
        "Discretization": {"Elements per Edge": [elements, 64, 64, 64]},
        "Solver": {"Linear": {"Method": "Compressed"}},
    }, title="Rough block")


def solved(output, threads, *described):
    """A run, made if it is not there."""
    if os.path.exists(os.path.join(output, "timings.txt")):
        return epafi.Run(output)
    return epafi.run(scene(*described), output=output, force=True, threads=threads)


def resolved(options, seed, gap="profile(x)", kind="rough"):
    return solved(os.path.join(options.folder, "%s_%d_%d" % (kind, options.elements, seed)),
                  options.threads, {"Gap": gap}, options.elements,
                  {"profile": {"Points": profile(seed), "Interpolation": "Spline"}})


def fitted(run):
    """Length and Pressure of the law whose closing is nearest to the mean of u_n, and the largest
    difference in parts of the largest closing."""
    closing = run.profiles("u_n").mean(axis=1)
    best = (np.inf,)
    for pressure in np.geomspace(1e-6, 1e-1, 2000):
        law = np.log1p(SLOPE * LOADS / pressure)
        length = (law * closing).sum() / (law * law).sum()
        best = min(best, (abs(length * law - closing).max() / closing.max(), length, pressure))
    return best


def compare(options, seed, run):
    """A row: a surface's law; by both the pressure's part that follows the bottom's wave, 2 <p cos(pi x)>/<p>;
    CPU seconds."""
    off, length, pressure = fitted(run)
    rough = resolved(options, seed, "profile(x)+" + WAVE, "curved")
    smooth = solved(os.path.join(options.folder, "law_%d" % seed), options.threads, {
        "Gap": WAVE, "Normal": {"Law": "Exponential", "Length": "%.17g" % length,
                                "Pressure": "%.17g" % pressure}}, 64, {})
    waves = [2 * (each.profiles("lambda_n") * np.cos(np.pi * each.contact["x"])).mean(axis=1) /
             each.profiles("lambda_n").mean(axis=1) for each in (rough, smooth)]
    seconds = [each.history["seconds_total"][-1] for each in (rough, smooth)]
    print("| %d | %.3g | %.3g | %.1f %% | %s | %.1f, %.2f |" % (
        seed, length, pressure, 100 * off,
        " | ".join("%.3f, %.3f" % (waves[0][k], waves[1][k]) for k in (0, 3, 6, 9)), *seconds))


def draw(file, parts, contact):
    """Part in contact against pressure, each surface a line; below, pressure along the block."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (above, below) = plt.subplots(2, 1, figsize=(7, 7), layout="constrained")
    for number, part in enumerate(parts):
        above.loglog(LOADS, part, "o-", color="C0", markersize=3, linewidth=1, alpha=0.7,
                     label=None if number else "%d surfaces" % len(parts))
    fine = np.geomspace(LOADS[0], LOADS[-1], 200)
    above.loglog(fine, [math.erf(math.sqrt(2) * p) for p in fine], "k--", linewidth=1,
                 label="Persson: erf(√2 p / (E* h'))")
    above.set_xlabel("mean pressure p / (E* h')")
    above.set_ylabel("part in contact")
    above.legend(frameon=False)
    middle = abs(contact["x"]) <= 0.25  # corners of the block are far away
    below.plot(contact["x"][middle], contact["lambda_n"][middle] / SLOPE, linewidth=0.8)
    below.set_xlim(-0.25, 0.25)
    below.set_ylim(0, None)
    below.set_xlabel("x")
    below.set_ylabel("pressure / (E* h'),  p = %.2g E* h'" % LOADS[-1])
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("folder")
    parser.add_argument("--elements", type=int, default=4096)
    parser.add_argument("--surfaces", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--picture")
    options = parser.parse_args()
    os.environ["EPAFI"] = os.path.abspath(options.epafi)
    runs = [resolved(options, seed) for seed in range(1, options.surfaces + 1)]
    parts = [run.steps["bottom.contact_length"] / 2 for run in runs]
    print("| p / (E* h') | part in contact | part / p | Persson |\n|---|---|---|---|")
    for load, *part in zip(LOADS, *parts):
        mean = sum(part) / len(part)
        print("| %.3f | %s | %.2f | %.4f |" % (load, ", ".join("%.4f" % p for p in part),
                                               mean / load, math.erf(math.sqrt(2) * load)))
    print("\n| surface | `Length` | `Pressure` | closing off by | p / (E* h') = 0.010 | 0.037 | 0.136 | 0.500 | "
          "CPU s |\n|---|---|---|---|---|---|---|---|---|")
    for seed, run in enumerate(runs, 1):
        compare(options, seed, run)
    if options.picture:
        draw(options.picture, parts, runs[0].contact)


if __name__ == "__main__":
    main()
