"""A steel block in (Pa, m) and in (MPa, mm): the same digits after conversion."""
from runs import ENERGIES, FORCES, MOMENTS, claim, differ, finish, levels, run, saved


def solve(name, length, stress, law):
    """length, stress: what 1 m and 1 Pa are in the scene's units."""
    strength = {"Coulomb": {"Coefficient": "0.2"},
                "Tresca": {"Threshold": "1.5e6*%r" % stress}}[law]
    block = {
        "Material": {"Young's Modulus": 2.1e11 * stress, "Poisson's Ratio": 0.3},
        "Geometry": {"Vertices": [[0, 0], [2 * length, 0], [2 * length, length], [0, length]],
                     "Edges": ["base", "right", "top", "left"]},
        "Boundary Conditions": {
            "base": {"Type": "Contact", "Gap": "1e-4*(x/%r-0.9)^2*%r" % (length, length),
                     "Friction": {"Law": law, **strength}},
            "left": {"Type": "Dirichlet", "Displacement X": "0"},
            "top": {"Type": "Neumann", "Traction X": "2e6*%r" % stress,
                    "Traction Y": "-9e6*%r*(1 + x/%r)" % (stress, length)}}}
    return run(saved(name, {"Bodies": {"block": block}, "Discretization": {
        "Elements per Edge": [8, 4, 8, 4], "Degree": 2}}), name, levels(2))


for law in ("Coulomb", "Tresca"):
    metre = solve("pa_m", 1.0, 1.0, law)
    milli = solve("mpa_mm", 1000.0, 1e-6, law)
    for a, b in zip(metre[0], milli[0]):
        energy, force = 1e-6 * 1e6, 1e-6 * 1e3
        units = {key: energy for key in ENERGIES}
        units.update({key: force for key in FORCES})
        units.update({key: energy for key in MOMENTS})
        units.update(contact_length=1e3, slip_length=1e3,
                     size_min=1e3, size_max=1e3)
        units.update({key: 1.0 for key in a if key.startswith("eta_") or key == "estimate"})
        size = {1.0: a["energy_load"], force: a["force_normal"], 1e3: 1.0}
        for key, unit in units.items():
            scale = max(abs(a[key]), size.get(unit, 0) if unit != energy else 1e-3)
            error = differ(b[key] / unit, a[key], scale)
            claim(error < 1e-10, "%s, level %d: the same %s (%.1e)" % (
                law, a["level"], key, error))
    units = {"x": 1e3, "y": 1e3, "u_n": 1e3, "u_t": 1e3, "gap": 1e3, "lambda_n": 1e-6,
             "lambda_t": 1e-6, "bound": 1e-6, "pressure": 1e-6, "shear": 1e-6}
    for key, unit in units.items():
        scale = max(abs(point[key]) for point in metre[1]) or 1
        error = max(differ(b[key] / unit, a[key], scale)
                    for a, b in zip(metre[1], milli[1]))
        claim(error < 1e-10, "%s: the same %s along the contact (%.1e)" % (law, key, error))
finish()
