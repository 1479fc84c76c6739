"""The hard cases: scene, settings, and what each must give.

Every case that is solved must also be in balance, on every level: loads, contact forces and
reactions add up to nothing in x, y and moment.
"""
import collections
import math

BASE = "Bodies->block->Boundary Conditions->base->"
TOP = "Bodies->block->Boundary Conditions->top->"
ONCE = ["Adaptivity->Strategy=None"]
NO_BALANCE = ["rigid motion"]
CASES = []


# A sentence that holds where what is measured is at most `most`.
# measure(result, results): a number, of this case's run and of all before it.
# An error is the difference to a known value; other measures are no errors.
Claim = collections.namedtuple("Claim", "sentence measure most is_error", defaults=[True])


class Case:
    """`size`: of the forces, where a case has none but rounding's."""

    def __init__(self, name, meaning, scene, settings=(), code=0, words=(), claims=(),
                 group="quick", patience=600, size=0):
        self.name, self.meaning, self.scene = name, meaning, scene
        self.settings, self.code, self.words = list(settings), code, list(words)
        self.claims = list(claims) if code else [balanced(size), *claims]
        self.group, self.patience = group, patience


def case(*arguments, **options):
    CASES.append(Case(*arguments, **options))


def balanced(size):
    """load + contact + reaction = 0, moments over the largest coordinate of the contact."""
    def measure(result, results):
        length = max([abs(point[key]) for point in result.contact for key in "xy"] + [0]) or 1
        worst = 0
        for row in result.history:
            forces = [row[of + along] for of in ("load", "contact", "reaction")
                      for along in ("_x", "_y")]
            scale = max([abs(force) for force in forces] + [size]) or 1
            for along, unit in (("_x", scale), ("_y", scale), ("_moment", scale * length)):
                rest = row["load" + along] + row["contact" + along] + row["reaction" + along]
                worst = max(worst, abs(rest) / unit)
        return worst
    return Claim("forces and moments balance to 1e-10", measure, 1e-10)


def value(column, wanted, tolerance):
    """The last row's column is `wanted`."""
    how = "to %.0e" % tolerance if tolerance > 0 else "exactly"
    return Claim("%s = %.6g %s" % (column, wanted, how),
                 lambda result, results: abs(result.last(column) - wanted), tolerance)


def load(x, y):
    """What is known of the loads; balance says the rest."""
    scale = max(abs(x), abs(y))
    return Claim("the load is (%.6g, %.6g)" % (x, y),
                 lambda result, results: max(abs(result.last("load_x") - x),
                                             abs(result.last("load_y") - y)) / scale, 1e-10)


def between(column, low, high):
    return Claim("%s from %g to %g" % (column, low, high),
                 lambda result, results: max(low - result.last(column),
                                             result.last(column) - high), 0, is_error=False)


def like(other, columns, tolerance, text=None):
    """The same numbers as another case."""
    def measure(result, results):
        worst = 0
        for column in columns if other in results else ():
            theirs = results[other].last(column)
            worst = max(worst, abs(result.last(column) - theirs) / (abs(theirs) or 1))
        return worst
    return Claim(text or "the same as '%s' to %.0e" % (other.replace("_", " "), tolerance),
                 measure, tolerance)


def steps(most):
    return Claim("at most %d Newton steps" % most,
                 lambda result, results: result.last("newton_iterations"), most,
                 is_error=False)


def fed(result, results):
    """Energy that friction feeds in, over the largest stress times displacement."""
    largest = {key: max(abs(point[key]) for point in result.contact)
               for key in ("lambda_t", "u_t", "u_n")}
    # The conditions hold for coefficients: not for the polynomial where the state changes.
    works, states = {}, {}
    for point in result.contact:
        works.setdefault(point["element"], []).append(point["lambda_t"] * point["u_t"])
        states.setdefault(point["element"], set()).add(point["friction"])
    least = min([sum(works[e]) / len(works[e]) for e in works if states[e] == {2}] + [0])
    scale = largest["lambda_t"] * max(largest["u_t"], largest["u_n"])
    return -least / scale if scale > 0 else 0


dissipates = Claim("friction feeds no energy in", fed, 1e-3, is_error=False)


def coulombs(f):
    def measure(result, results):
        most = max(point["lambda_n"] for point in result.contact)
        return max((abs(point["lambda_t"]) / f - max(point["lambda_n"], 0)) / most
                   for point in result.contact)
    return Claim("|lambda_t| below the bound", measure, 0.05, is_error=False)


# ---- contact or not
zero = [value("force_normal", 0, 0), value("energy_strain", 0, 0), value("contact_length", 0, 0)]
case("grazing", "grazing: gap 0, no load", "clamped_block", claims=zero)
case("grazing_friction", "grazing, Coulomb friction", "clamped_block",
     [BASE + "Friction->Law=Coulomb", BASE + "Friction->Coefficient=0.3"], claims=zero)
case("no_contact", "no contact at all", "pressed_block", [BASE + "Gap=1"],
     claims=[value("force_normal", 0, 0), value("contact_length", 0, 0),
             value("reaction_y", 0, 1e-12)], size=100 * 0.02)  # E u
case("full_contact", "full contact: the patch test", "patch",
     claims=[value("force_normal", 2, 1e-12), value("contact_length", 2, 1e-12),
             load(0, -2)])
case("point_contact", "contact on a part of one element", "point_contact",
     claims=[between("contact_length", 1e-3, 2 / 17)])
case("hanging", "no load, nothing near, vertical motion free", "hanging_block", claims=zero)
case("load_removed", "load removed from a block that only stands", "standing_block",
     [TOP + "Traction Y=0"], claims=zero)
case("lifted", "load away from the only support", "standing_block", [TOP + "Traction Y=1"],
     code=2, words=NO_BALANCE)

case("too_few_steps", "one Newton step allowed", "pressed_block",
     ["Solver->Maximum Iterations=1"], code=3,
     words=["Solver->Maximum Iterations", "(", "base"])

# ---- friction holds the body
case("standing", "held by friction only", "standing_block",
     claims=[load(0, -2), value("force_normal", 2, 1e-10), steps(12)])
for share in ("0.3", "0.49", "0.4999999", "0.5"):
    case("slide_" + share, "onset of global sliding, f = 0.5, T = %s N" % share,
         "standing_block", [TOP + "Traction X=" + share],
         claims=[load(2 * float(share), -2), value("force_normal", 2, 1e-10), steps(20),
                 dissipates])
for share in ("0.5000001", "0.6"):
    case("slide_" + share, "beyond global sliding, f = 0.5, T = %s N" % share,
         "standing_block", [TOP + "Traction X=" + share], code=2, words=NO_BALANCE)
case("push_stick", "shear on all sides, f just above its ratio", "pushed_block",
     [BASE + "Friction->Coefficient=0.300001"], claims=[load(0.6, -2), steps(30)])
case("push_slip", "shear on all sides, f just below its ratio", "pushed_block",
     [BASE + "Friction->Coefficient=0.299999"], code=2, words=NO_BALANCE)
case("one_element", "one element of contact, pulled along it", "one_element",
     claims=[load(-10, 5), dissipates, steps(60)])
case("thin_layer", "layer of 1:100 pressed in the middle: 50 full steps do not suffice", "thin_layer",
     claims=[load(0, -5.604991216397929), dissipates, steps(100)])
case("thin_layer_same", "the same, density of degree p", "thin_layer",
     ["Discretization->Stabilization->Density Degree=Same"],
     claims=[load(0, -5.604991216397929), dissipates, steps(100)])
case("opposite_slip", "all slips, to both sides", "opposite_slip",
     claims=[value("slip_length", 2, 1e-12), value("force_tangential", 0, 1e-12),
             load(0, -2), dissipates])
case("tiny_friction", "f = 1e-6", "opposite_slip", [BASE + "Friction->Coefficient=1e-6"],
     claims=[value("slip_length", 2, 1e-12), load(0, -2)])
case("jumping_bound", "bound zero on a part, jumping elsewhere", "jumping_bound",
     claims=[dissipates,
             # what slips carries its bound: 0.2 and 0.01 on a third of the side each
             value("force_tangential", (0.2 + 0.01) * 2 / 3, 1e-10)])
for f in ("0.3", "1", "3", "10", "100"):
    case("shear_f" + f, "f = %s, pressed and sheared; several solutions may exist" % f,
         "pressed_block",
         [BASE + "Friction->Coefficient=" + f, TOP + "Displacement X=0.05"],
         claims=[steps(40), dissipates, coulombs(float(f))])
for f in ("1", "3", "10"):
    case("l_shape_f" + f, "L-shape in a corner, no clamp, f = " + f, "l_shape",
         [BASE + "Friction->Coefficient=" + f,
          "Bodies->block->Boundary Conditions->back->Friction->Coefficient=" + f],
         claims=[dissipates, steps(200)])

# ---- material
# Rounding of u comes back as a force times 1 / (1 - 2 nu), here 5e6: contact/body/DenseBody.
for nu in ("0.49", "0.4999", "0.4999999"):
    case("nu_" + nu, "nu = " + nu, "pressed_block",
         ["Bodies->block->Material->Poisson's Ratio=" + nu],
         claims=[between("force_normal", 5, 6.5), steps(40)])
NU = "Bodies->block->Material->Poisson's Ratio="
DENSITY = "Discretization->Stabilization->Form=Density"
PROJECTED = "Discretization->Stabilization->Form=Projected"
case("nu_0.5", "nu = 1/2 with a stabilisation by V^-1", "pressed_block", [NU + "0.5", PROJECTED], code=1,
     words=["Poisson's Ratio", "Density"])
case("rubber_0.5", "nu = 1/2, stabilised by the density", "pressed_block", [NU + "0.5", DENSITY],
     claims=[between("force_normal", 5, 6.5), steps(40), dissipates])
for nu, near in (("0.4999999", 1e-6), ("0.4999", 1e-3), ("0.49", 0.1)):
    case("rubber_" + nu, "nu = %s, stabilised by the density" % nu, "pressed_block",
         [NU + nu, DENSITY],
         claims=[like("rubber_0.5", ["force_normal", "energy_strain"], near), steps(40)])
# A closed line without contact: psi is pinned on an edge without load.
HOLE = ["Bodies->block->Geometry->Hole 1 Vertices=4x2:{-0.3,0.4, 0.2,0.3, 0.4,0.7, -0.1,0.8}",
        "Bodies->block->Geometry->Hole 1 Edges={hole, hole, hole, hole}",
        "Discretization->Hole 1 Elements per Edge={4, 4, 4, 4}", DENSITY]
same = ["force_normal", "energy_strain", "estimate"]
case("rubber_hole_0.5", "nu = 1/2, a hole without load", "pressed_block", [NU + "0.5", *HOLE],
     claims=[between("force_normal", 2.5, 3.5), steps(40), dissipates])
for nu, near in (("0.4999999", 1e-6), ("0.4999", 1e-3)):
    case("rubber_hole_" + nu, "nu = %s, a hole without load" % nu, "pressed_block", [NU + nu, *HOLE],
         claims=[like("rubber_hole_0.5", same, near), steps(40)])
case("rubber_hole_compressed", "nu = 1/2, a hole without load, compressed", "pressed_block",
     [NU + "0.5", *HOLE, "Solver->Linear->Method=Compressed"],
     claims=[like("rubber_hole_0.5", same, 1e-10), steps(40)])
case("rubber_hole_fixed", "nu = 1/2, a hole that is clamped", "pressed_block",
     [NU + "0.5", *HOLE, "Bodies->block->Boundary Conditions->hole->Type=Dirichlet",
      "Bodies->block->Boundary Conditions->hole->Displacement X=0"], code=1,
     words=["Poisson's Ratio", "'hole'", "without a given displacement"])
LOADED = [*HOLE, "Bodies->block->Boundary Conditions->hole->Type=Neumann",
          "Bodies->block->Boundary Conditions->hole->Pressure=0.3+0.1*x"]
case("rubber_hole_loaded_0.5", "nu = 1/2, a hole under pressure", "pressed_block",
     [NU + "0.5", *LOADED], claims=[steps(40), dissipates])
case("rubber_hole_loaded_0.4999999", "nu = 0.4999999, a hole under pressure", "pressed_block",
     [NU + "0.4999999", *LOADED], claims=[like("rubber_hole_loaded_0.5", same, 1e-6), steps(40)])
case("rubber_hole_loaded_compressed", "nu = 1/2, a hole under pressure, compressed",
     "pressed_block", [NU + "0.5", *LOADED, "Solver->Linear->Method=Compressed"],
     claims=[like("rubber_hole_loaded_0.5", same, 1e-10), steps(40)])
PLATE = "Bodies->plate->Material->Poisson's Ratio="
case("rubber_plate_0.5", "nu = 1/2 of the body that is met", "two-blocks", [PLATE + "0.5"],
     claims=[value("force_normal", 0.02, 1e-12)])
case("rubber_plate_0.4999999", "nu = 0.4999999 of the body that is met", "two-blocks",
     [PLATE + "0.4999999"], claims=[like("rubber_plate_0.5", same, 1e-6)])
case("pressed", "pressed onto a parabola: the reference of the following", "pressed_block",
     claims=[steps(10), dissipates])

# ---- shapes and meshes
# E u / L of the beam is 5000 times its load per area, and rounding of S u as much of the balance.
case("thin_beam", "beam of 1:100 laid down on a plane by its load, p = 3", "thin_beam",
     claims=[load(0, -0.1), between("contact_length", 40, 70), steps(120)], group="long")
# Interior points' predictor reaches a hundredth of its way here; all of its second order leads in circles.
case("thin_beam_path", "the same beam, its load growing in three steps", "thin_beam",
     [TOP + "Traction Y=-0.001*(0.55 + 0.45*sin(pi/2*t))", "History->Times={0.25, 0.5, 0.75}",
      "Adaptivity->Maximum Levels=1"],
     claims=[load(0, -0.1 * (0.55 + 0.45 * math.sin(3 * math.pi / 8))), dissipates], group="long")
case("thin_beam_frictionless", "the same beam without friction, p = 2", "thin_beam",
     [BASE + "Friction->Coefficient=0", "Discretization->Degree=2"],
     claims=[load(0, -0.1), between("contact_length", 40, 70)])
case("wedge", "acute corner of 5 degrees, contact ends in it", "wedge",
     claims=[dissipates, steps(10)])
case("wedge_refused", "the same with gamma0 = 0.1, too large here", "wedge",
     [PROJECTED, "Discretization->Stabilization->Gamma0=0.1"], code=2,
     words=["Gamma0"])
case("wedge_projected", "projected with the default gamma0, which gives way", "wedge",
     [PROJECTED], claims=[dissipates, steps(10), between("gamma0", 0.001, 0.03),
             like("wedge", ["energy_load", "force_normal"], 1e-2)])
case("l_shape", "L-shape, two contact sides, friction alone holds it", "l_shape",
     claims=[dissipates, steps(20)])
case("mesh_ratio", "mesh ratio 1e-10 on the contact side", "graded_mesh",
     claims=[between("size_min", 0, 0.45e-10), like("pressed", ["force_normal"], 0.05),
             steps(20)])
case("degree_20", "p = 20", "high_degree",
     claims=[value("degree_min", 20, 0), like("pressed", ["force_normal"], 0.01), steps(20)])
case("many_sides", "several contact sides and clamps, Dirichlet beside Neumann, contact to "
     "the corners, a hole", "many_sides", claims=[dissipates, steps(20)])
case("holes_refined", "the same on 4 times the elements", "many_sides",
     ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=3"],
     claims=[like("many_sides", ["force_normal"], 0.05), steps(50)])

# ---- gamma0, [P] sec. 8.3: 256 elements, p = 1
MESH = ONCE + ["Discretization->Elements per Edge={64, 64, 64, 64}"]
GAMMA = "Discretization->Stabilization->Gamma0="
FORM = "Discretization->Stabilization->Form="
for gamma in ("1e-3", "1e-13", "1e-12", "1e-10", "1e-8", "1e-6", "1e-4", "1e-2", "6.6e-2"):
    plateau = [] if gamma in ("1e-13", "1e-3") else [
        like("gamma_1e-3", ["energy_strain", "energy_load"], 2e-3,
             text="on the plateau (2e-3)")]
    case("gamma_" + gamma, "gamma0 = %s, 256 elements" % gamma, "coulomb",
         MESH + [GAMMA + gamma],
         claims=plateau + [value("force_normal", 0.125, 1e-10), steps(50)])
for form in ("Projected", "Exact"):
    case("gamma_0.11_" + form, "gamma0 = 0.11, " + form.lower(), "coulomb",
         MESH + [GAMMA + "0.11", FORM + form],
         claims=[like("gamma_1e-3", ["energy_load"], 2e-2, text="near the plateau (2e-2)")])
for gamma in ("0.5", "1e-3", "10", "1e4"):
    case("gamma_%s_Density" % gamma, "gamma0 = %s, by the density" % gamma, "coulomb",
         MESH + [GAMMA + gamma, DENSITY, "Discretization->Stabilization->Scaling=Stiffness"],
         claims=([] if gamma == "0.5" else
                 [like("gamma_0.5_Density", ["energy_strain", "energy_load"], 2e-5)]) +
         [value("force_normal", 0.125, 1e-10), steps(50)])
for gamma in ("5e-4", "1e-3", "0.1"):
    case("stiffness_" + gamma, "gamma0 = %s scaled by stiffness, 256 elements" % gamma,
         "coulomb", MESH + [GAMMA + gamma, "Discretization->Stabilization->Scaling=Stiffness"],
         claims=[value("force_normal", 0.125, 1e-10), steps(50)])

# ---- size
case("elements_4096", "4096 elements", "coulomb",
     ONCE + ["Discretization->Elements per Edge={1024, 1024, 1024, 1024}",
             "Adaptivity->Maximum Degrees of Freedom=100000", "Output->Fields=false"],
     claims=[value("elements", 4096, 0), value("force_normal", 0.125, 1e-9)], group="long",
     patience=3600)

# ---- what is shipped (patch: see above)
for name, x, y in (("tresca", None, None), ("coulomb", 0, -0.125),
                   ("hertz", 0, -3.141592653589793 / 4 * 1000 / (1 - 0.3**2) / 100),
                   ("punch", 0, -1)):
    case("shipped_" + name, "shipped scene, all its levels: " + name, name,
         claims=[] if x is None else [load(x, y)])
