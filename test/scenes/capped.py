"""A block that slides at the cap of Coulomb's law, and below it: closed forms.

Uniform stress sigma_yy = -p, sigma_xy = s, sigma_xx = 0 in plane strain, u linear and larger
than zero along the base: lambda_n = p and lambda_t = s = min(F p, C), for every basis.
"""
from runs import claim, finish, run, saved

YOUNG, NU, P = 100.0, 0.3, 1.0


def scene(law, along, shear, discretization):
    return {"Bodies": {"block": {
        "Material": {"Young's Modulus": YOUNG, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": [[-1, 0], [1, 0], [1, 1], [-1, 1]],
                     "Edges": ["base", "right", "top", "left"]},
        "Boundary Conditions": {
            "base": {"Type": "Contact", "Friction": {"Law": "Capped Coulomb", **law}},
            "top": {"Type": "Dirichlet", "Displacement X": along,
                    "Displacement Y": "%r" % (-P * (1 - NU ** 2) / YOUNG)},
            "right": {"Type": "Neumann", "Traction Y": "%r" % shear},
            "left": {"Type": "Neumann", "Traction Y": "-%r" % shear}}}},
        "Discretization": {"Elements per Edge": [4, 2, 3, 2], **discretization}}


CASES = {  # coefficient, cap, shear
    "cap": ("0.5", "0.2", 0.2),
    "cap_varying": ("0.5 + 0.1*x", "0.2", 0.2),
    "below": ("0.15", "0.2", 0.15),
    "below_varying": ("0.15", "0.3 + 0.05*x", 0.15),
}
for name, (coefficient, cap, shear) in CASES.items():
    for basis in ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal"):
        for degree in (1, 3):
            case = "%s.%s.%d" % (name, basis, degree)
            stretch = P * NU * (1 + NU) / YOUNG
            along = "%r*x + %r" % (stretch, shear * 2 * (1 + NU) / YOUNG + 0.05)
            file = saved(case, scene({"Coefficient": coefficient, "Cap": cap}, along, shear,
                                     {"Degree": degree, "Multiplier": basis}))
            _, contact = run(file, case)
            claim(max(abs(c["lambda_n"] - P) for c in contact) < 1e-9, case + ": pressure")
            claim(max(abs(c["lambda_t"] - shear) for c in contact) < 1e-9, case + ": shear")
            claim(max(abs(c["bound"] - shear) for c in contact) < 1e-9, case + ": bound")
            claim(all(c["friction"] == 2 for c in contact), case + ": slides")
finish()
