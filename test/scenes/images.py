"""Images of scenes under motions of the plane: rotations by quarter turns, reflections, shifts.
Standard library only."""
import re
import xml.etree.ElementTree as tree

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

    # -- a scene's tree ----------------------------------------------------------------------

    def scene(self, text):
        root = tree.fromstring(text)
        for body in child(root, "Bodies"):
            self.body(body)
        for parameter in root.iter("Parameter"):
            if parameter.get("name").endswith("Elements per Edge"):
                parameter.set("value", self.order(parameter.get("value")))
            if parameter.get("name") == "Interior Points":
                parameter.set("value", self.points(parameter.get("value"), False))
        contacts = child(root, "Contacts")
        for parameter in contacts.iter("Parameter") if contacts is not None else ():
            if parameter.get("type") == "string":
                parameter.set("value", self.expression(parameter.get("value")))
        return tree.tostring(root, encoding="unicode")

    def body(self, body):
        geometry = child(body, "Geometry")
        for parameter in geometry:
            name = parameter.get("name")
            if name.endswith("Vertices"):
                parameter.set("value", self.points(parameter.get("value"), self.reflects))
            elif name.endswith(("Edges", "Bulges")):
                parameter.set("value", self.order(parameter.get("value")))
        for conditions in child(body, "Boundary Conditions") or ():
            self.vectors(conditions)
        for motion in body.iter("ParameterList"):
            if motion.get("name") == "Motion":
                self.vectors(motion)
        for fix in body.iter("Parameter"):
            if fix.get("name") == "Fix":
                fix.set("value", self.axes(fix.get("value")))
            if fix.get("name") == "Reference Point":
                numbers = [float(w) for w in fix.get("value").strip("{} ").split(",")]
                fix.set("value", "{%r, %r}" % self.point(*numbers))

    def vectors(self, functions):
        """Displacement X and the like become those of the image, absent ones stay absent."""
        for parameter in functions.iter("Parameter"):
            name, value = parameter.get("name"), parameter.get("value")
            if name == "Type" or name == "Law" or parameter.get("type") != "string":
                continue
            value = self.expression(value)
            sign = 1
            if name.endswith((" X", " Y")):
                origin = "XY".index(name[-1])
                axis = next(k for k in (0, 1) if self.source(k)[0] == origin)
                sign = self.source(axis)[1]
                parameter.set("name", name[:-1] + "XY"[axis])
            elif name in ("Rotation", "Moment") and self.reflects:
                sign = -1
            parameter.set("value", value if sign > 0 else "-(%s)" % value)

    def points(self, value, turned):
        numbers = [float(w) for w in value[value.index("{"):].strip("{} ").split(",")]
        points = [self.point(*pair) for pair in zip(numbers[::2], numbers[1::2])]
        if turned:
            points[1:] = points[:0:-1]
        return "%dx2:{%s}" % (len(points), ", ".join("%r" % c for p in points for c in p))

    def order(self, value):
        words = [word.strip() for word in value.strip("{} ").split(",")]
        return "{%s}" % ", ".join(reversed(words) if self.reflects else words)

    def axes(self, value):
        words = [word.strip() for word in value.strip("{} ").split(",")]
        turned = abs(self.matrix[0][0]) == 0
        return "{%s}" % ", ".join({"X": "Y", "Y": "X"}.get(w, w) if turned else w for w in words)


def child(node, name):
    return next((c for c in node if c.get("name") == name), None)
