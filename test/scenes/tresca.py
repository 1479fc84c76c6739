"""The clamped block under Tresca friction: balance, dissipation, complementarity."""
from runs import claim, finish, levels, run, scene, whole

history, contact = run(scene("tresca.xml"), "tresca", levels(6))

# Loads of the scene: (1/4 - y^2) on the left, 20 (x + 1/2)(x + 1/4) on x = -1/2 ... -1/4.
load_x = 1 / 6
load_y = -20 * 0.25**3 / 6
load_moment = -0.375 * load_y  # its resultant acts at x = -3/8

claim(len(history) == 6 and [row["level"] for row in history] == list(range(6)),
      "six levels, counted from 0")
for row in history:
    name = "level %d: " % row["level"]
    claim(row["status"] == "converged", name + "converged")
    claim(row["dof"] == row["dof_displacement"] + row["dof_multiplier"],
          name + "dof is the sum of its parts")
    # n = (0, -1), t = (1, 0), lambda = -sigma n: the body feels (-lambda_t, +lambda_n)
    claim(abs(load_x - row["force_tangential"] + row["reaction_x"]) < 1e-10 * load_x,
          name + "forces along x are in balance")
    claim(abs(load_y + row["force_normal"] + row["reaction_y"]) < 1e-10 * load_x,
          name + "forces along y are in balance")
    claim(row["newton_iterations"] <= 15, name + "at most 15 Newton steps from zero")
    claim(0 < row["contact_length"] < 1 and 0 < row["slip_length"] <= 1,
          name + "contact and slip on a part of the foundation")

# Moment of the contact forces about the origin, lambda linear on each element (p = 1).
elements = {}
for point in contact:
    elements.setdefault(point["element"], []).append(point)
moment = 0
for points in elements.values():
    first, last = points[0], points[-1]
    n = len(points)
    half = (last["x"] - first["x"]) / 2 * n / (n - 1)
    for t in (-(1 / 3)**0.5, (1 / 3)**0.5):  # two-point Gauss rule
        at = (t * n / (n - 1) + 1) / 2  # from first to last
        x = (first["x"] + last["x"]) / 2 + t * half
        normal = first["lambda_n"] + at * (last["lambda_n"] - first["lambda_n"])
        tangential = first["lambda_t"] + at * (last["lambda_t"] - first["lambda_t"])
        moment += half * (x * normal - 0.5 * tangential)
claim(abs(load_moment + moment + history[-1]["reaction_moment"]) < 1e-10 * load_x,
      "moments are in balance")

largest = {key: max(abs(point[key]) for point in contact)
           for key in ("lambda_n", "lambda_t", "u_n", "u_t", "bound")}
dissipation = [point["lambda_t"] * point["u_t"] for point in whole(contact)]
claim(min(dissipation) >= -1e-3 * max(dissipation), "friction never feeds energy in")
for point in whole(contact):
    slides = point["friction"] == 2
    if slides and abs(abs(point["lambda_t"]) - point["bound"]) > 1e-6 * largest["bound"]:
        claim(False, "sliding points carry the bound, x = %g" % point["x"])
    if abs(point["lambda_t"]) > point["bound"] + 1e-2 * largest["bound"]:
        claim(False, "no shear beyond the bound, x = %g" % point["x"])
    if point["contact"] == 0 and point["u_n"] - point["gap"] > 1e-3 * largest["u_n"]:
        claim(False, "open points do not penetrate, x = %g" % point["x"])
pressure = sum(point["lambda_n"] for point in contact)
work = sum(abs(point["lambda_n"] * (point["u_n"] - point["gap"])) for point in contact)
claim(work < 1e-2 * pressure * largest["u_n"], "pressure acts where the gap is closed")
claim({point["friction"] for point in contact} == {1, 2}, "some points stick, some slide")
claim({point["contact"] for point in contact} == {0, 1}, "some are open, some closed")
finish()
