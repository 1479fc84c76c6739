"""Load paths against closed forms, beyond paths.py and path_bodies.py: blocks of three widths,
other amplitudes of the loop, bulk stress, dissimilar bodies, errors in time.

Fourth argument: the page that the tables are written to, doc/benchmarks/paths.md."""
import math
import sys

from halves import (F, P, P0, PRESS, SIDES, TO_AND_FRO, contact_side, cycles, error, fretting, half,
                    half_cycle, loads, loop, path, pressing, rms, stick)
from runs import claim, finish, never_falls, points, solved, write
from written import contact, friction, history, keys, written

PARABOLA = keys(Interference="-x^2/200")
page = []


def side(width):
    """Edges of the contact's side of a block, small elements where contact and slip end."""
    inner = [-1.25, -0.95, -0.6, 0.6, 0.95, 1.25]
    outer = [x for x in (2.5, 6, 16) if x < 0.4 * width] + [width / 2]
    counts = [6] + [4] * (len(outer) - 1)
    return ([-x for x in reversed(outer)] + inner + outer,
            counts[::-1] + [30, 88, 30, 88, 30] + counts)


def pair(name, width, moduli, ratios, first="upper", second="lower", uniform=False):
    push = TO_AND_FRO % 0.5
    bodies = [half(what, up, modulus, push, ratio=ratio, side=side(width), uniform=uniform)
              for what, up, modulus, ratio in zip(("upper", "lower"), (1, -1), moduli, ratios)]
    file = written(name, bodies, contact("fret", first + ":contact", second + ":contact",
                                         friction("0.5") + PARABOLA), "Density",
                   more=history([1, 2, 3, 4], [1, 1, 1, 1]))
    return solved(name, file, "Adaptivity->Maximum Degrees of Freedom=20000")[0]


def measured(folder):
    """Largest errors of the stick width and of the shear at the three pushes, and in the mean."""
    widths, worst, mean = [], [], []
    for step, _, exact, c in SIDES:
        here = points(folder, step)
        left, right = stick(here)
        widths.append(abs((right - left) / 2 - c))
        worst.append(error(here, exact))
        mean.append(rms(here, exact))
    return max(widths), max(worst), max(mean)


# two equal bodies on blocks of three widths
rows = []
for width in (20, 40, 80):
    errors = []
    for uniform in (False, True):
        folder = pair("equal %d wide, %d" % (width, uniform), width, [2 * (1 - 0.3**2)] * 2,
                      [0.3] * 2, uniform=uniform)
        errors += measured(folder)
        never_falls(folder)
    rows.append((width, errors))
    claim(errors[0] < 1e-2 and errors[1] < 0.02,
          "%d a wide: stick widths within %.1e of a, shear within %.1e of f p0" % (width, *errors[:2]))
for a, b in zip(rows, rows[1:]):
    claim(b[1][5] < a[1][5] / 1.5, "uniform tractions: shear %.1e of f p0 on %d a, %.1e on %d a" % (
        a[1][5], a[0], b[1][5], b[0]))
page += ["## Two equal bodies", "",
         "Blocks as high as wide, ν = 0.3, degree 2, elements of 0.004 a where slip ends. The load is P, then Q = Qm = 0.5 f P, 0 and", "-Qm, one step each. The largest errors of the three last steps: half the stick width (a = 1), the shear relative to f p0 at its", "worst point in contact, and its mean. With the half-plane's tractions on the outer sides the error does not depend on the width: it comes", "from the elements where slip ends. With uniform tractions on the far sides it falls with the width.", "", "| width | stick | shear | mean | uniform: stick | shear | mean |", "|---:|---:|---:|---:|---:|---:|---:|"]
page += ["| %d a | %s |" % (width, " | ".join("%.1e" % e for e in errors)) for width, errors in rows]

# dissimilar bodies whose pressure and shear do not mix: (1 - 2 nu)(1 + nu)/E is equal
for first, second in (("upper", "lower"), ("lower", "upper")):
    folder = pair("1 to 6, %s first" % first, 80, [5.8301, 0.9606415], [0.1, 0.45], first, second)
    errors = measured(folder)
    claim(errors[0] < 1e-2 and errors[1] < 0.02,
          "moduli 1 to 6, %s side first: stick within %.1e, shear within %.1e" % (first, *errors[:2]))
    never_falls(folder)

# loops of other amplitudes, counted from +Qm
page += ["", "## Loops", "",
         "fretting.xml, 40 steps per cycle: friction's work per cycle, counted from +Qm, in units of (f P)²/(π E*).", "", "| Qm/(f P) | exact | first cycle | second less first, relative |", "|---:|---:|---:|---:|"]

for q in (0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9):
    first, second, folder = cycles(q)
    claim(abs(first / loop(q) - 1) < 5e-4,
          "loop of q = %g: work per cycle %.5e, exact %.5e" % (q, first, loop(q)))
    claim(abs(second / first - 1) < 1e-6,
          "loop of q = %g: the second cycle differs by %.1e" % (q, second / first - 1))
    unit = (F * P)**2 / math.pi
    page.append("| %g | %.6f | %.6f | %.1e |" % (q, loop(q) / unit, first / unit, second / first - 1))
    never_falls(folder)

# with a bulk stress that grows along with Q the stick zone moves: [Nowell and Hills 1987]
shift = 0.2
CUTS = [-40, -16, -6, -2.5, -1.25, -0.95, -0.86, 0.46, 0.56, 1.25, 2.5, 6, 16, 40]
BULK = "%r*%r*(t < 1 ? 0 : t - 1)" % (2 * shift, F * P0)
c = math.sqrt(0.5)
for count in (1, 8):
    folder = fretting("bulk stress, %d steps" % count,
                      path([1, 2], [1, count]) + loads("0.25*pi/400*max(0, t - 1)", PRESS, BULK) +
                      contact_side(CUTS, [4, 4, 4, 6, 30, 40, 60, 40, 60, 6, 4, 4, 4]))
    here = points(folder, 1 + count)
    left, right = stick(here)
    side_ = 1 if right > -left else -1
    off = max(abs(left - (side_ * shift - c)), abs(right - (side_ * shift + c)))
    claim(off < 1e-2, "bulk stress: stick from %.4f to %.4f, exact %.4f to %.4f" % (
        left, right, side_ * shift - c, side_ * shift + c))
    worst = error(here, lambda x: F * P0 * (math.sqrt(max(0, 1 - x * x)) - math.sqrt(
        max(0, c * c - (x - side_ * shift)**2))))
    claim(worst < 0.02, "bulk stress: shear within %.1e of f p0" % worst)

# errors in time
page += ["", "## Errors in time", "",
         "fretting.xml. Relative error of friction's work by the trapezoidal rule (`energy_dissipated_trapezoidal`) from Qm to -Qm, against", "160 steps; and the error of the energy balance while P grows, relative to the work from outside.", "", "| steps | trapezoidal work | balance |", "|---:|---:|---:|"]

counts = (5, 10, 20, 40)
exact = half_cycle(160)[0]
inTime = [(abs(half_cycle(count)[1] / exact - 1), pressing(count)) for count in counts]
page += ["| %d | %.1e | %.1e |" % (count, *errors) for count, errors in zip(counts, inTime)]
for (a, b), (c, d), count in zip(inTime, inTime[1:], counts[1:]):
    claim(c < a / 3.3 and d < b / 3,
          "%d steps: trapezoidal work %.1e after %.1e, balance %.1e after %.1e" %
          (count, c, a, d, b))

if len(sys.argv) > 4:
    write(sys.argv[4],
          "# Load paths\n\n**Claim.** Load paths converge to Cattaneo's and Mindlin's closed forms ([theory](../theory/paths.md)). This page was made by\n\n"
          "    python3 test/scenes/path_claims.py build/bin/epafi drivers/scenes build/path_claims "
          "doc/benchmarks/paths.md\n\n" + "\n".join(page) + "\n")
finish()
