"""A steel block in (Pa, m) and in (MPa, mm): the same digits after conversion."""
import os

from runs import ENERGIES, FORCES, MOMENTS, WORK, claim, differ, finish, levels, run

SCENE = """<ParameterList name="Steel">
<ParameterList name="Bodies"><ParameterList name="block">
<ParameterList name="Material">
<Parameter name="Young's Modulus" type="double" value="{E!r}"/>
<Parameter name="Poisson's Ratio" type="double" value="0.3"/>
</ParameterList>
<ParameterList name="Geometry">
<Parameter name="Vertices" type="TwoDArray(double)" value="4x2:{{0,0, {a},0, {a},{b}, 0,{b}}}"/>
<Parameter name="Edges" type="Array(string)" value="{{base, right, top, left}}"/>
</ParameterList>
<ParameterList name="Boundary Conditions">
<ParameterList name="base"><Parameter name="Type" type="string" value="Contact"/>
<Parameter name="Gap" type="string" value="1e-4*(x/{L}-0.9)^2*{L}"/>
<ParameterList name="Friction"><Parameter name="Law" type="string" value="{law}"/>
<Parameter name="{key}" type="string" value="{strength}"/></ParameterList>
</ParameterList>
<ParameterList name="left"><Parameter name="Type" type="string" value="Dirichlet"/>
<Parameter name="Displacement X" type="string" value="0"/></ParameterList>
<ParameterList name="top"><Parameter name="Type" type="string" value="Neumann"/>
<Parameter name="Traction X" type="string" value="2e6*{S}"/>
<Parameter name="Traction Y" type="string" value="-9e6*{S}*(1 + x/{L})"/></ParameterList>
</ParameterList>
</ParameterList></ParameterList>
<ParameterList name="Discretization">
<Parameter name="Elements per Edge" type="Array(int)" value="{{8, 4, 8, 4}}"/>
<Parameter name="Degree" type="int" value="2"/>
</ParameterList>
</ParameterList>
"""


def solve(name, length, stress, law):
    """length, stress: what 1 m and 1 Pa are in the scene's units."""
    strength = {"Coulomb": ("Coefficient", "0.2"),
                "Tresca": ("Threshold", "1.5e6*%r" % stress)}[law]
    os.makedirs(WORK, exist_ok=True)
    file = os.path.join(WORK, name + ".xml")
    with open(file, "w") as stream:
        stream.write(SCENE.format(E=2.1e11 * stress, a=2.0 * length, b=1.0 * length,
                                  L=length, S=stress, law=law, key=strength[0],
                                  strength=strength[1]))
    return run(file, name, levels(2))


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
