"""A block that slides at the cap of Coulomb's law, and below it: closed forms.

Uniform stress sigma_yy = -p, sigma_xy = s, sigma_xx = 0 in plane strain, u linear and larger
than zero along the base: lambda_n = p and lambda_t = s = min(F p, C), for every basis.
"""
import os

from runs import WORK, claim, finish, run

YOUNG, NU, P = 100.0, 0.3, 1.0

SCENE = """<ParameterList name="Capped">
<ParameterList name="Bodies"><ParameterList name="block">
<ParameterList name="Material">
<Parameter name="Young's Modulus" type="double" value="{young}"/>
<Parameter name="Poisson's Ratio" type="double" value="{nu}"/>
</ParameterList>
<ParameterList name="Geometry">
<Parameter name="Vertices" type="TwoDArray(double)" value="4x2:{{-1,0, 1,0, 1,1, -1,1}}"/>
<Parameter name="Edges" type="Array(string)" value="{{base, right, top, left}}"/>
</ParameterList>
<ParameterList name="Boundary Conditions">
<ParameterList name="base"><Parameter name="Type" type="string" value="Contact"/>
<ParameterList name="Friction">
<Parameter name="Law" type="string" value="Capped Coulomb"/>
<Parameter name="Coefficient" type="string" value="{coefficient}"/>
<Parameter name="Cap" type="string" value="{cap}"/></ParameterList>
</ParameterList>
<ParameterList name="top"><Parameter name="Type" type="string" value="Dirichlet"/>
<Parameter name="Displacement X" type="string" value="{along}"/>
<Parameter name="Displacement Y" type="string" value="{down!r}"/></ParameterList>
<ParameterList name="right"><Parameter name="Type" type="string" value="Neumann"/>
<Parameter name="Traction Y" type="string" value="{shear!r}"/></ParameterList>
<ParameterList name="left"><Parameter name="Type" type="string" value="Neumann"/>
<Parameter name="Traction Y" type="string" value="-{shear!r}"/></ParameterList>
</ParameterList>
</ParameterList></ParameterList>
<ParameterList name="Discretization">
<Parameter name="Elements per Edge" type="Array(int)" value="{{4, 2, 3, 2}}"/>
<Parameter name="Degree" type="int" value="{degree}"/>
<Parameter name="Multiplier" type="string" value="{basis}"/>
</ParameterList>
</ParameterList>
"""

CASES = {  # coefficient, cap, shear
    "cap": ("0.5", "0.2", 0.2),
    "cap_varying": ("0.5 + 0.1*x", "0.2", 0.2),
    "below": ("0.15", "0.2", 0.15),
    "below_varying": ("0.15", "0.3 + 0.05*x", 0.15),
}
os.makedirs(WORK, exist_ok=True)
for name, (coefficient, cap, shear) in CASES.items():
    for basis in ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal"):
        for degree in (1, 3):
            case = "%s.%s.%d" % (name, basis, degree)
            stretch = P * NU * (1 + NU) / YOUNG
            along = "%r*x + %r" % (stretch, shear * 2 * (1 + NU) / YOUNG + 0.05)
            file = os.path.join(WORK, case + ".xml")
            with open(file, "w") as stream:
                stream.write(SCENE.format(
                    young=YOUNG, nu=NU, coefficient=coefficient, cap=cap, shear=shear,
                    along=along, down=-P * (1 - NU ** 2) / YOUNG, degree=degree, basis=basis))
            _, contact = run(file, case)
            claim(max(abs(c["lambda_n"] - P) for c in contact) < 1e-9, case + ": pressure")
            claim(max(abs(c["lambda_t"] - shear) for c in contact) < 1e-9, case + ": shear")
            claim(max(abs(c["bound"] - shear) for c in contact) < 1e-9, case + ": bound")
            claim(all(c["friction"] == 2 for c in contact), case + ": slides")
finish()
