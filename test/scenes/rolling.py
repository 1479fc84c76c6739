"""Rolling under a given force against Carter's closed form, and the motion found replayed as
Sliding over an obstacle.  Fourth argument: elements in the contact's half-width."""
import sys

from runs import claim, finish, keys_of, saved, scene, solved, steps

FINE = int(sys.argv[4])
LENGTH, R, F, P = 3.25, 1000.0, 0.3, 3.141592653589793 / 3000
EXACT = FINE >= 50
STEPS = int(LENGTH * FINE) * (2 if EXACT else 1)


def path(name, file):
    return steps(solved(name, file, "Discretization->Degree=%d" % (2 if EXACT else 1),
                        "Adaptivity->Maximum Degrees of Freedom=100000",
                        "Bodies->rail->Mesh->Elements per Edge={4, 3, 4, 10, %d, 10, 4, 3}" %
                        (6.5 * FINE), "History->Steps={1, 4, %d}" % STEPS)[0])


rolled = path("rolled", scene("rolling.xml"))
found = {round(row["t"] - 2, 9): row["slab.motion_x"] for row in rolled}


def creep(s):
    """The rate about a place, a tenth of the half-width long."""
    there = sorted(found, key=lambda x: abs(x - s - 0.05))[0]
    before = sorted(found, key=lambda x: abs(x - s + 0.05))[0]
    return (found[there] - found[before]) / (there - before) * R / F


for s, exact in ((1, 0.470), (2, 0.397), (3, 0.3991)):
    off = creep(s) / exact - 1
    claim(abs(off) < (1e-2 if EXACT else 5e-2),
          "creep behind %d half-widths: %.4f, off by %.1e" % (s, creep(s), off))
off = creep(LENGTH - 0.05) / 0.4 - 1
claim(abs(off) < (5e-2 if not EXACT else 4e-3 if FINE < 100 else 2e-3),
      "steady creep is Carter's but for %.1e" % off)
claim(all(abs(row["roller.force_tangential"] / (0.64 * F * P) - 1) < 1e-9 for row in rolled[5:]),
      "the force is the given one")

# the same rail under an obstacle that slides as the slab did
def motion(key):
    return {"Points": [(0, 0)] + [(row["t"], row[key]) for row in rolled]}


replayed = path("replayed", saved("replayed", keys_of(scene("rolling.xml")).changed({
    "Bodies->slab": None, "Contacts": None,
    "Tables": {"motionx": motion("slab.motion_x"), "motiony": motion("slab.motion_y")},
    "Bodies->rail->Boundary Conditions->face": {
        "Type": "Contact", "Gap": "(x - max(0, t - 2))^2/(2*R) + motiony(t)",
        "Sliding": "-motionx(t)", "Friction": {"Law": "Coulomb", "Coefficient": "f"}}})))
off = max(abs(a["roller.force_tangential"] - b["face.force_tangential"])
          for a, b in zip(rolled, replayed)) / (0.64 * F * P)
claim(off < 1e-9, "replayed as Sliding: the same force to %.1e" % off)
finish()
