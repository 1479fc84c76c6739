"""Images of scenes: mirrored, turned by a right angle or shifted they give the image of the
solution, on the same meshes, after all levels of refinement.

With a fourth argument, all: every shipped scene."""
import re
import sys

from runs import claim, finish, keys_of, rows, run, saved, scene

# the rows of an orthogonal matrix with one entry in each
IDENTITY = ((1, 0), (0, 1))
MIRROR_X = ((-1, 0), (0, 1))
MIRROR_Y = ((1, 0), (0, -1))
QUARTER = ((0, -1), (1, 0))
DIAGONAL = ((0, 1), (1, 0))


class Image:
    """x' = Q x + shift; expressions of the scene then speak of x = Q' (x' - shift)."""

    def __init__(self, matrix=IDENTITY, shift=(0, 0)):
        self.matrix, self.shift = matrix, shift
        (a, b), (c, d) = matrix
        self.reflects = a * d - b * c < 0

    def point(self, x, y):
        return tuple(row[0] * x + row[1] * y + s for row, s in zip(self.matrix, self.shift))

    def vector(self, x, y):
        return tuple(row[0] * x + row[1] * y for row in self.matrix)

    def source(self, axis):
        """Of the image's axis: the scene's axis, and its sign."""
        row = self.matrix[axis]
        return (0, row[0]) if row[0] else (1, row[1])

    def expression(self, text):
        for old, new in (("x", "y"), ("nx", "ny")):
            back = {}
            for axis, name in enumerate((old, new)):
                origin, sign = self.source(axis)
                shift = self.shift[axis] if old == "x" else 0
                back[(old, new)[origin]] = "(%d*(%s-(%r)))" % (sign, name, shift)
            text = re.sub(r"\b(%s|%s)\b" % (old, new), lambda m: back[m.group(1)], text)
        return text

    def scene(self, keys):
        """A scene of the package, changed in place."""
        meshes = [keys.get("Discretization", {})]
        for body in keys["Bodies"].values():
            self.body(body)
            meshes.append(body.get("Mesh", {}))
        for mesh in meshes:
            for name in mesh:
                if name.endswith("Elements per Edge"):
                    mesh[name] = self.order(mesh[name])
        output = keys.get("Output", {})
        if "Interior Points" in output:
            output["Interior Points"] = self.points(output["Interior Points"], False)
        if "Contacts" in keys:
            keys["Contacts"] = self.functions(keys["Contacts"])
        return keys

    def body(self, body):
        geometry = body["Geometry"]
        for name, value in geometry.items():
            if name.endswith("Vertices"):
                geometry[name] = self.points(value, self.reflects)
            elif name.endswith(("Edges", "Bulges")):
                geometry[name] = self.order(value)
        for name in {"Boundary Conditions", "Motion"} & body.keys():
            body[name] = self.functions(body[name])
        if "Reference Point" in body.get("Motion", {}):
            body["Motion"]["Reference Point"] = self.point(*body["Motion"]["Reference Point"])
        if "Fix" in body.get("Rigid Motions", {}):
            body["Rigid Motions"]["Fix"] = self.axes(body["Rigid Motions"]["Fix"])

    def functions(self, keys):
        """Displacement X and the like become those of the image, absent ones stay absent."""
        image = {}
        for name, value in keys.items():
            if isinstance(value, dict):
                value = self.functions(value)
            elif isinstance(value, str) and name not in ("Type", "Law"):
                value, sign = self.expression(value), 1
                if name.endswith((" X", " Y")):
                    origin = "XY".index(name[-1])
                    axis = next(k for k in (0, 1) if self.source(k)[0] == origin)
                    sign = self.source(axis)[1]
                    name = name[:-1] + "XY"[axis]
                elif name in ("Rotation", "Moment") and self.reflects:
                    sign = -1
                value = value if sign > 0 else "-(%s)" % value
            image[name] = value
        return image

    def points(self, pairs, turned):
        points = [self.point(*pair) for pair in pairs]
        return points[:1] + points[:0:-1] if turned else points

    def order(self, values):
        return values[::-1] if self.reflects else values

    def axes(self, names):
        turned = abs(self.matrix[0][0]) == 0
        return [{"X": "Y", "Y": "X"}.get(name, name) if turned else name for name in names]


EVERY = sys.argv[4:] == ["all"]
# name: levels (None: as shipped)
SCENES = {"rounded-punch": None, "two-blocks": 8, "dovetail": 10, "incline": None, "coulomb": 14,
          "cylinder-on-block": 4}
if EVERY:
    SCENES = dict.fromkeys(
        ("rounded-punch", "two-blocks", "dovetail", "incline", "coulomb", "tresca", "press-fit",
         "ring-on-disc", "bonded-inclusion", "two-cylinders", "disc", "punch", "fretting",
         "tilting-punch", "cylinder-on-block"))
IMAGES = {"mirrored at x = 0": Image(MIRROR_X), "turned": Image(QUARTER),
          "shifted": Image(IDENTITY, (1000, -300))}
if EVERY:
    IMAGES.update({"mirrored at y = 0": Image(MIRROR_Y), "mirrored at x = y": Image(DIAGONAL)})
# A shift by 1000 leaves their gaps of 1e-5 eight digits.
FINE = ("two-cylinders",)
# Of the size of all.  Beside the corner of coulomb's clamp the shear is as good as that.
STRESS = {"coulomb": 1e-6}


def along(rows, image):
    """The points of each side in the scene's order; a closed one may start at another."""
    sides = {}
    for row in rows:
        sides.setdefault((row["boundary"], row.get("contact_name")), []).append(row)
    if image.reflects:
        sides = {key: side[::-1] for key, side in sides.items()}
    return sides


def started(side, first, second):
    """A side from the two points on."""
    def off(k):
        return sum(abs(side[(k + i) % len(side)][c] - place[j])
                   for i, place in enumerate((first, second)) for j, c in enumerate("xy"))
    k = min(range(len(side)), key=off)
    return side[k:] + side[:k]


def pairs(rows, others, image):
    """Points of the scene and of its image that belong together."""
    sides = along(rows, Image())
    images = along(others, image)
    for key, side in sides.items():
        ends = [image.point(row["x"], row["y"]) for row in (side + side)[:2]]
        yield from zip(side, started(images[key], *ends))


def size(rows, *columns):
    return max(abs(row[column]) for row in rows for column in columns)


def compare(name, what, image, here, there, shift):
    (history, contact, boundary), (other, contacts, boundaries) = here, there
    claim([row["dof"] for row in history] == [row["dof"] for row in other],
          "%s, %s: the same unknowns on %d levels" % (name, what, len(history)))
    claim(len(boundary) == len(boundaries) and len(contact) == len(contacts), "as many points")
    length, way, stress = (size(boundary, "x", "y"), size(boundary, "ux", "uy"),
                           size(contact, "lambda_n", "lambda_t"))
    off = degrees = displacement = 0
    for p, q in pairs(boundary, boundaries, image):
        degrees += p["degree"] != q["degree"]
        off = max(off, *(abs(a - q[c]) for a, c in zip(image.point(p["x"], p["y"]), "xy")))
        displacement = max(displacement, *(abs(a - q["u" + c]) for a, c in
                                           zip(image.vector(p["ux"], p["uy"]), "xy")))
    sign = -1 if image.reflects else 1
    shear = max(max(abs(p["lambda_n"] - q["lambda_n"]), abs(p["lambda_t"] - sign * q["lambda_t"]))
                for p, q in pairs(contact, contacts, image))
    claim(degrees == 0 and off < 1e-12 * (length + shift), "the same mesh, off by %.0e" % (
        off / length))
    claim(displacement < 1e-10 * (1 + shift) * way, "displacements differ by %.0e" % (
        displacement / way))
    claim(shear < STRESS.get(name, 1e-8) * (1 + shift) * stress, "stresses by %.0e" % (
        shear / stress))


for name, levels in SCENES.items():
    results = {}
    for what, image in {"": Image(), **IMAGES}.items():
        if name in FINE and what == "shifted":
            continue
        file = saved(name, image.scene(keys_of(scene(name + ".xml"))))
        history, contact = run(file, name, ["Adaptivity->Maximum Levels=%d" % levels]
                               if levels else [])
        results[what] = history, contact, rows(name, "boundary.csv")
        if what:
            compare(name, what, image, results[""], results[what],
                    max(map(abs, image.shift)) / size(results[""][2], "x", "y"))

# its own image; the last step of its path has no loads, so that its states are rounding
run(scene("blade-root.xml"), "blade-root", ["Adaptivity->Maximum Levels=5"])
sides = ({(row["body"], row["degree"], round(sign * row["x"], 9), round(row["y"], 9))
          for row in rows("blade-root", "boundary.csv")} for sign in (1, -1))
unlike = next(sides) ^ next(sides)
claim(not unlike, "blade-root: both halves have the same mesh but for %d points" % len(unlike))
finish()
