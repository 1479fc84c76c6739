"""Reactions of rollers, of Fix and of both together, about an origin far from the body."""
import os

from runs import WORK, claim, finish, levels, run

SCENE = """<ParameterList name="Reactions">
<ParameterList name="Bodies"><ParameterList name="plate">
<ParameterList name="Material">
<Parameter name="Young's Modulus" type="double" value="70"/>
<Parameter name="Poisson's Ratio" type="double" value="0.33"/>
<Parameter name="Plane State" type="string" value="Plane Stress"/>
</ParameterList>
<ParameterList name="Geometry">
<Parameter name="Vertices" type="TwoDArray(double)" value="5x2:{10,-4, 12,-4, 12,-3, 11.2,-3, 10,-3}"/>
<Parameter name="Edges" type="Array(string)" value="{base, right, top, cap, left}"/>
</ParameterList>
<ParameterList name="Boundary Conditions">
<ParameterList name="top"><Parameter name="Type" type="string" value="Neumann"/>
<Parameter name="Traction X" type="string" value="0.3"/>
<Parameter name="Traction Y" type="string" value="-0.5"/></ParameterList>
%s</ParameterList>
%s</ParameterList></ParameterList>
<ParameterList name="Discretization">
<Parameter name="Elements per Edge" type="Array(int)" value="{5, 2, 2, 3, 2}"/>
<Parameter name="Degree" type="int" value="%d"/>
</ParameterList>
</ParameterList>
"""
# top: x from 11.2 to 12, y = -3
LOAD = (0.24, -0.4, 11.6 * -0.4 - (-3) * 0.24)


def roller(boundary, component, value):
    return ('<ParameterList name="%s"><Parameter name="Type" type="string" '
            'value="Dirichlet"/><Parameter name="Displacement %s" type="string" '
            'value="%s"/></ParameterList>\n' % (boundary, component, value))


def fix(names):
    return ('<ParameterList name="Rigid Motions"><Parameter name="Fix" '
            'type="Array(string)" value="{%s}"/></ParameterList>\n' % names)


CONTACT = """<ParameterList name="base"><Parameter name="Type" type="string" value="Contact"/>
<ParameterList name="Friction"><Parameter name="Law" type="string" value="Coulomb"/>
<Parameter name="Coefficient" type="string" value="0.4"/></ParameterList></ParameterList>
"""
cases = {
    "fixed": ("", fix("X, Y, Rotation")),
    "roller_and_fix": (roller("left", "X", "0.001*y"), fix("Y")),
    "two_rollers": (roller("left", "X", "0") + roller("base", "Y", "0.001*(x-10)"), ""),
    "contact_and_roller": (CONTACT + roller("left", "X", "0.002"), ""),
    "contact_and_fix": (CONTACT, fix("X, Rotation")),
    "contact_roller_and_fix": (CONTACT + roller("left", "X", "0"), fix("Y")),
}
for name, (conditions, rigid) in cases.items():
    for degree in (1, 3):
        os.makedirs(WORK, exist_ok=True)
        file = os.path.join(WORK, name + ".xml")
        with open(file, "w") as stream:
            stream.write(SCENE % (conditions, rigid, degree))
        history, contact = run(file, "run", levels(2))
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
