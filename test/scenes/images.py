"""Images of scenes under motions of the plane: rotations by quarter turns, reflections, shifts.
Standard library only."""
import re

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

    # -- a scene's keys ----------------------------------------------------------------------

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
        if "Interior Points" in keys.get("Output", {}):
            keys["Output"]["Interior Points"] = self.points(keys["Output"]["Interior Points"], False)
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
