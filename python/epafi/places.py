"""Where stresses may be singular: nodes of outlines at corners and where conditions change, with the
wedges that meet there."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Optional

import numpy as np
from numpy.polynomial.legendre import leggauss, legfit, legval

from epafi.tables import Table
from epafi.wedges import CLAMPED, FREE, Corner, Rows, Wedge, held, sliding

if TYPE_CHECKING:
    from epafi.runs import Run

SMOOTH = math.radians(1)  # less is no corner
NEAR = 1e-12  # of all outlines' size: the same node; bodies may be drawn APART
APART = 1e-6
SYMMETRY = "symmetry"  # the boundary on the line of Geometry->Symmetry, which rolls
BOUNDED = ("None", "Tresca", "Capped Coulomb")  # shear that singular pressure leaves behind


class Element:
    """Of boundary.csv, complex points and traction at equal distances of the parameter; the body is on
    the left of the way from start to end."""

    before: Element
    after: Element

    def __init__(self, table: Table, rows: slice) -> None:
        self.x, self.traction = (table[a][rows] + 1j * table[b][rows]
                                 for a, b in (("x", "y"), ("tx", "ty")))
        self.body = str(table["body"][rows][0])
        self.name = str(table["boundary"][rows][0]).removeprefix(self.body + ":")
        self.number, self.degree = int(table["element"][rows][0]), int(table["degree"][rows][0])
        middle = self.x[len(self.x) // 2]
        self.angle = 2 * np.angle((self.x[-1] - middle) / (middle - self.x[0]))  # of an arc
        self.chord = self.x[-1] - self.x[0]

    def node(self, at_end: bool) -> complex:
        return complex(self.x[-1 if at_end else 0])

    def direction(self, at_end: bool) -> complex:
        turned = self.chord * np.exp(0.5j * self.angle * (1 if at_end else -1))
        return complex(turned / abs(turned))

    def polar(self, at_end: bool, origin: complex) -> tuple[np.ndarray, ...]:
        """At Gauss points: distances from the origin, weights, sigma_theta_theta and sigma_r_theta."""
        t, weights = leggauss(self.degree + 2)
        nodes = np.linspace(-1, 1, len(self.x))
        parts = [legval(t, legfit(nodes, part, self.degree + 1))  # the density's degree, or less
                 for part in (self.traction.real, self.traction.imag)]
        share = (t + 1) / 2
        if abs(self.angle) > 1e-9:
            share = (np.sin(self.angle * share / 2) / np.sin(self.angle / 2)
                     * np.exp(0.5j * self.angle * (share - 1)))
        normal = -1j * self.chord / abs(self.chord) * np.exp(0.5j * self.angle * t)
        ray = self.x[0] + self.chord * share - origin
        traction, along = parts[0] + 1j * parts[1], ray / abs(ray) * (1 if at_end else -1)
        return (abs(ray), weights * abs(self.chord) / 2, np.real(traction * np.conj(normal)),
                np.real(traction * np.conj(along)))


@dataclass
class Face:
    """How a side of a body is held close to one of its nodes."""

    kind: str  # free, symmetry, clamp, contact, bond
    rows: Rows = FREE  # what vanishes, if nothing elastic is opposite
    joint: Optional[float] = None  # if something elastic is: as in Corner
    opposite: str = ""  # that body


@dataclass
class Place:
    """A point between the faces before and after it; inside of `before` or at its end."""

    x: complex
    before: Element
    faces: tuple[Face, Face]  # after, before: anticlockwise
    angle: float

    def outward(self, at_end: bool) -> Iterator[Element]:
        """The elements of one of its sides, to the next corner."""
        element = self.before if at_end else self.before.after
        while True:
            yield element
            following = element.before if at_end else element.after
            turn = np.angle(element.direction(not at_end) / following.direction(at_end))
            if (following.name != element.name or abs(turn) > SMOOTH
                    or following is (self.before.after if at_end else self.before)):
                return
            element = following


class Outlines:
    """Of a run's elastic bodies, with their conditions."""

    def __init__(self, run: Run) -> None:
        self.scene, table = run.numbers, run.boundary
        self.line = self.scene.get("Geometry", {}).get("Symmetry")
        bodies = self.scene["Bodies"]
        touch = self.scene.get("Contacts") or any(
            rules.get("Type") == "Contact" for body in bodies.values()
            for rules in body.get("Boundary Conditions", {}).values())
        self.samples = run.contact if touch else None
        starts = np.flatnonzero(np.append(True, (np.diff(table["element"]) != 0)
                                          | (table["body"][1:] != table["body"][:-1])))
        self.elements = [Element(table, slice(a, b)) for a, b in zip(
            starts, [*starts[1:], table.size])]
        self.size = np.ptp(table["x"]) + np.ptp(table["y"])
        first = self.elements[0]
        for element, following in zip(self.elements, [*self.elements[1:], first]):
            closes = self.near(element.node(True), first.node(False))
            element.after = first if closes else following
            element.after.before = element
            first = following if closes else first
        self.vertices = [complex(*vertex)
                         for body in bodies.values() if body["Material"].get("Rigid")
                         for name, vertices in body["Geometry"].items()
                         if name.endswith("Vertices") for vertex in vertices]

    def near(self, a: complex, b: complex) -> bool:
        return abs(a - b) < NEAR * self.size

    def conditions(self, element: Element) -> dict[str, Any]:
        return self.scene["Bodies"][element.body].get("Boundary Conditions", {}).get(
            element.name, {})

    def contacts(self, element: Element) -> Iterator[tuple[str, dict[str, Any], str]]:
        """Of a side: name, rules, and the opposite body ("": an obstacle, or a rigid one)."""
        rules = self.conditions(element)
        if rules.get("Type") == "Contact":
            yield element.name, rules, ""
        for name, rules in self.scene.get("Contacts", {}).items():
            sides = list(rules["Between"])
            for side, other in (sides, sides[::-1]):
                if side == element.body + ":" + element.name:
                    body = other.partition(":")[0]
                    rigid = self.scene["Bodies"][body]["Material"].get("Rigid")
                    yield name, rules, "" if rigid else body

    def touching(self, element: Element, name: str) -> np.ndarray:
        """The samples of a contact on an element, or opposite to it."""
        if self.samples is None:
            return np.empty(0, int)
        here = self.samples["contact_name"] == name
        own = here & (self.samples["body"] == element.body)
        if own.any():
            return np.flatnonzero(own & (self.samples["element"] == element.number))
        x = self.samples["x"] + 1j * self.samples["y"]
        distance = np.where(here, abs(x - element.x[len(element.x) // 2]), math.inf)
        rows, nearest = np.flatnonzero(distance < abs(element.chord) / 2), int(np.argmin(distance))
        spacing = abs(np.diff(x[max(nearest - 1, 0):nearest + 2])).min(initial=math.inf)
        return rows if len(rows) or not distance[nearest] < spacing else np.array([nearest])

    def halved(self, element: Element) -> bool:
        """Does the body go on beyond it as its mirror image?"""
        return element.name == SYMMETRY and self.line in ("X", "Y")

    def face(self, element: Element, at_end: bool) -> Face:
        """Of an element at one of its ends.  Surfaces that yield bound what they transmit: to a
        singular stress they are free."""
        rules = self.conditions(element)
        axes = [axis for axis in "XY" if "Displacement " + axis in rules]
        halved = self.halved(element)
        if rules.get("Type") == "Dirichlet" or halved:
            ray = element.direction(at_end) * (-1 if at_end else 1)
            return Face(SYMMETRY if halved else "clamp", CLAMPED if len(axes) == 2 else held(
                float((math.pi / 2 if (axes or [self.line]) == ["Y"] else 0) - np.angle(ray))))
        for name, rules, opposite in self.contacts(element):
            rows, friction = self.touching(element, name), rules.get("Friction", {})
            law = friction.get("Law", "None")
            if (len(rows) == 0 or rules.get("Normal", {}).get("Law", "Rigid") != "Rigid"
                    or law != "Tied" and self.samples["contact"][rows].mean() < 0.5):
                continue
            shears = friction.get("Compliance", 0) == 0
            if shears and (law == "Tied" or np.mean(self.samples["friction"][rows] == 1) > 0.5):
                return Face("bond" if law == "Tied" else "contact", CLAMPED, None, opposite)
            ratio = 0.0
            if shears and law not in BOUNDED:
                _, _, normal, shear = element.polar(at_end, element.node(at_end))
                pressure, bound = self.samples["lambda_n"][rows], self.samples["bound"][rows]
                ratio = round(float(np.median((bound / pressure)[pressure > 0])), 9) * float(
                    np.sign(normal @ shear))
            return Face("contact", sliding(ratio), ratio, opposite)
        return Face("free")

    def angle(self, before: Element) -> float:
        """Inside the body at an element's end; 2 pi between the faces of a crack."""
        turn = np.angle(before.after.direction(False) / before.direction(True))
        return float(math.pi - turn) if turn < math.pi - SMOOTH else 2 * math.pi

    def places(self) -> list[Place]:
        def kind(element: Element) -> tuple[Any, bool]:
            return self.conditions(element), self.halved(element) or any(
                len(self.touching(element, name)) for name, *_ in self.contacts(element))

        kinds = {id(element): kind(element) for element in self.elements}
        found = []
        for before in self.elements:
            angle = self.angle(before)
            if (abs(angle - math.pi) > SMOOTH or kinds[id(before)] != kinds[id(before.after)]
                    or any(self.near(before.node(True), vertex) for vertex in self.vertices)):
                found.append(Place(before.node(True), before, (
                    self.face(before.after, False), self.face(before, True)), angle))
        return found

    def corner(self, place: Place) -> tuple[Corner, int]:
        """The wedges around a place, and which of them is its own; angles count from that one's
        face after the node."""
        body = place.before.body
        wedges, joints = [self.wedge(body, place.angle, 0.0)], []

        def beyond(face: Face, anticlockwise: bool) -> Face:
            """Adds the wedge behind a face; what that one has on its other side."""
            other = self.ending(face.opposite, place.x)
            angle = self.angle(other) if other else math.pi
            wedges.insert(len(wedges) * anticlockwise, self.wedge(
                face.opposite, angle,
                wedges[-1].end if anticlockwise else wedges[0].start - angle))
            joints.insert(len(joints) * anticlockwise, face.joint)
            if other is None:
                return Face("free")
            face = self.face(other, True) if anticlockwise else self.face(other.after, False)
            around = abs(wedges[-1].end - wedges[0].start - 2 * math.pi) < SMOOTH
            return face if face.opposite != body or around else Face("free")

        first, last = place.faces
        while last.opposite:
            last = beyond(last, True)
            if last.opposite == body:
                return Corner(tuple(wedges), (*joints, last.joint)), 0
        own = len(wedges)
        while first.opposite:
            first = beyond(first, False)
        return Corner(tuple(wedges), tuple(joints), (first.rows, last.rows)), len(wedges) - own

    def open_ends(self) -> Iterator[Place]:
        """Where contact ends within a side, between two samples: closed on one face, free on the
        other."""
        for k in self._changes("contact"):
            at_end = self.samples["contact"][k] == 1  # contact is before the end
            row = k if at_end else k + 1
            element = next(e for e in self.elements if e.body == self.samples["body"][row]
                           and e.number == self.samples["element"][row])
            face = self.face(element, at_end)
            if face.kind == "free":  # most of that element is
                element = element.before if at_end else element.after
                face = self.face(element, at_end)
            faces = (Face("free"), face)
            yield Place(self.between(k), element, faces if at_end else faces[::-1], math.pi)

    def between(self, k: int) -> complex:
        """Two neighbouring samples."""
        return complex(*(self.samples[axis][k:k + 2].mean() for axis in "xy"))

    def ending(self, body: str, x: complex) -> Optional[Element]:
        """The body's element with this end; None: the body is smooth there."""
        distance, element = min(((abs(element.node(True) - x), element) for element in self.elements
                                 if element.body == body), key=lambda pair: pair[0])
        return element if distance < APART * self.size else None

    def wedge(self, body: str, angle: float, start: float) -> Wedge:
        material = self.scene["Bodies"][body]["Material"]
        e, nu = material["Young's Modulus"], material["Poisson's Ratio"]
        angle = round(angle, 11)  # alike at corners that are
        return Wedge(start, start + angle, e / (2 * (1 + nu)), (3 - nu) / (1 + nu)
                     if material["Plane State"] == "Plane Stress" else 3 - 4 * nu)

    def _changes(self, column: str) -> np.ndarray:
        """Of a state: samples after which it is another one on the same side."""
        if self.samples is None:
            return np.empty(0, int)
        follow = (self.samples["body"][1:] == self.samples["body"][:-1]) & (
            np.diff(self.samples["s"]) > 0)
        return np.flatnonzero(follow & (np.diff(self.samples[column]) != 0))

    def reach(self, place: Place, points: np.ndarray, least: float) -> float:
        """How far the next of the points is, the next change of contact or friction further off than
        `least`, or another side of the body."""
        fronts = abs(np.array([self.between(k) for column in ("contact", "friction")
                               for k in self._changes(column)], complex) - place.x)
        near = {id(element) for at_end in (False, True) for element in place.outward(at_end)}
        others = [abs(element.x - place.x).min() for element in self.elements
                  if element.body == place.before.body and id(element) not in near]
        distances = np.concatenate([abs(points - place.x), fronts[fronts > least], others])
        return float(distances[distances > NEAR * self.size].min(initial=self.size))
