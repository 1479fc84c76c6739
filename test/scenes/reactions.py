"""Reactions of rollers, of Fix and of both together, about an origin far from the body."""
from runs import claim, finish, levels, run, saved


def scene(conditions, fix, degree):
    return {"Bodies": {"plate": {
        "Material": {"Young's Modulus": 70, "Poisson's Ratio": 0.33, "Plane State": "Plane Stress"},
        "Geometry": {"Vertices": [[10, -4], [12, -4], [12, -3], [11.2, -3], [10, -3]],
                     "Edges": ["base", "right", "top", "cap", "left"]},
        "Boundary Conditions": {
            "top": {"Type": "Neumann", "Traction X": "0.3", "Traction Y": "-0.5"}, **conditions},
        **({"Rigid Motions": {"Fix": fix}} if fix else {})}},
        "Discretization": {"Elements per Edge": [5, 2, 2, 3, 2], "Degree": degree}}


# top: x from 11.2 to 12, y = -3
LOAD = (0.24, -0.4, 11.6 * -0.4 - (-3) * 0.24)


def roller(boundary, component, value):
    return {boundary: {"Type": "Dirichlet", "Displacement " + component: value}}


CONTACT = {"base": {"Type": "Contact", "Friction": {"Law": "Coulomb", "Coefficient": "0.4"}}}
cases = {
    "fixed": ({}, ["X", "Y", "Rotation"]),
    "roller_and_fix": (roller("left", "X", "0.001*y"), ["Y"]),
    "two_rollers": ({**roller("left", "X", "0"), **roller("base", "Y", "0.001*(x-10)")}, []),
    "contact_and_roller": ({**CONTACT, **roller("left", "X", "0.002")}, []),
    "contact_and_fix": (CONTACT, ["X", "Rotation"]),
    "contact_roller_and_fix": ({**CONTACT, **roller("left", "X", "0")}, ["Y"]),
}
for name, (conditions, fix) in cases.items():
    for degree in (1, 3):
        history, contact = run(saved(name, scene(conditions, fix, degree)), "run", levels(2))
        for row in history:
            where = "%s, p = %d, level %d: " % (name, degree, row["level"])
            claim(row["status"] == "converged", where + "converged")
            # base: n = (0, -1), t = (1, 0); the body feels (-lambda_t, +lambda_n)
            x = LOAD[0] - row["force_tangential"] + row["reaction_x"]
            y = LOAD[1] + row["force_normal"] + row["reaction_y"]
            claim(abs(x) < 1e-10 * 0.4, where + "forces along x are in balance (%.1e)" % x)
            claim(abs(y) < 1e-10 * 0.4, where + "forces along y are in balance (%.1e)" % y)
            if not contact:
                moment = LOAD[2] + row["reaction_moment"]
                claim(abs(moment) < 1e-9 * 0.4, where + "moments balance (%.1e)" % moment)
finish()
