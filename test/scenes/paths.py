"""Load paths: friction remembers.  Cattaneo's and Mindlin's closed forms on a block that stands
for a half-plane (incompressible, so that pressure and shear do not mix), a = 1.

   loading to Q     q = f p0 [s(x) - c s(x/c)],  s(x) = (1 - x^2)^1/2,  c = (1 - Q/(f P))^1/2
   unloading to Q   q = q(Qm) - 2 f p0 [s(x) - c' s(x/c')],  c' = (1 - (Qm - Q)/(2 f P))^1/2
   a closed loop    work (f P)^2/(pi E*) (4 q h - 8 H), q = Qm/(f P), see loop()
"""
from halves import (F, FINE, P0, contact_side, cycles, half_cycle, loads, loop, path, pressing,
                    remembers)
from halves import fretting as solve
from runs import claim, finish, never_falls, points, rows, saved, solved

# Cattaneo, and the way back to 0 and to -Qm; small elements where slip ends, a node at |x| = a
base = solve("cattaneo", path([1, 2, 3, 4], [1]) + contact_side(*FINE))
remembers(base)
claim(points(base) == points(base, 4), "contact.csv is that of the last step")

# work per cycle, counted from +Qm; other amplitudes in path_tolerance.py
first, second, _ = cycles(0.5)
claim(abs(first / loop(0.5) - 1) < 0.01,
      "work per cycle %.6e, exact %.6e" % (first, loop(0.5)))
claim(abs(second / first - 1) < 1e-6, "the second cycle differs by %.1e" % (second / first - 1))

# a path that no point reverses ends where one step does; P and Q together do not
ROW = ["History->Times={1, 2}"]
few = solve("one step", ROW + ["History->Steps={1, 1}"])
many = solve("fifty steps", ROW + ["History->Steps={1, 50}"])
difference = max(abs(a["lambda_t"] - b["lambda_t"]) + abs(a["lambda_n"] - b["lambda_n"])
                 for a, b in zip(points(few), points(many))) / (F * P0)
claim(difference < 1e-8, "P, then growing Q: 1 and 50 steps differ by %.1e" % difference)
TOGETHER = loads("0.25*pi/400*t/2", "pi/400*t/2") + ["History->Times={2}"]
one = solve("together, one step", TOGETHER + ["History->Steps={1}"])
along = solve("together, forty steps", TOGETHER + ["History->Steps={40}"])
apart = max(abs(a["lambda_t"] - b["lambda_t"])
            for a, b in zip(points(along), points(few))) / (F * P0)
claim(apart > 0.05, "P and Q together is another path: it differs by %.3f f p0" % apart)

# energies
for folder in (base, many, along):
    never_falls(folder)
errors = [pressing(count) for count in (4, 16)]
claim(errors[1] < errors[0] / 10,
      "the balance of energy is of second order: %.1e, %.1e of the work" % tuple(errors))

# a floor that rises against a block held by Fix alone does half its force times its way
RISE = 0.002
BLOCK = saved("held", {
    "Bodies": {"block": {
        "Material": {"Young's Modulus": 1, "Poisson's Ratio": 0.3},
        "Geometry": {"Vertices": [[-0.5, 0], [0.5, 0], [0.5, 0.6], [-0.5, 0.6]],
                     "Edges": ["floor", "right", "top", "left"]},
        "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]},
        "Boundary Conditions": {"floor": {"Type": "Contact", "Gap": "-%g*t" % RISE}}}},
    "History": {"Times": [1.0]},
    "Discretization": {"Elements per Edge": [6, 3, 6, 3]},
    "Adaptivity": {"Maximum Levels": 1}})
for degree in (1, 2, 4):
    for gamma in (0.1, 10):
        name = "held, degree %d, Gamma0 %g" % (degree, gamma)
        folder, _ = solved(name, BLOCK, "Discretization->Degree=%d" % degree,
                           "Discretization->Stabilization->Gamma0=%g" % gamma)
        last = rows(folder, "steps.csv")[-1]
        work = last["floor.force_normal"] * RISE / 2
        off = abs(last["energy_outside"] - work) / work
        claim(work > 0 and off < 1e-9, "%s: the floor's work is off by %.1e" % (name, off))

trapezoidal = [abs(half_cycle(count)[1] / (loop(0.5) / 2) - 1) for count in (5, 20)]
claim(trapezoidal[1] < trapezoidal[0] / 4 or trapezoidal[1] < 2e-3,
      "the trapezoidal work converges: %.1e, %.1e" % tuple(trapezoidal))
finish()
