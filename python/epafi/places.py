"""Where stresses may be singular: corners of outlines, ends of conditions and what lies opposite to
them, with the wedges that meet there."""
from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterator, Optional

import numpy as np

from epafi.given import LINEAR, TRACTIONS, heat, loaded, numbers_at, turns
from epafi.outlines import SMOOTH, Edge, Samples, distance, edges_of, rigid_corners
from epafi.wedges import CLAMPED, FREE, Corner, Rows, Wedge, held, modes, sliding

if TYPE_CHECKING:
    from epafi.runs import Run

APART = 1e-6  # of all outlines' size: bodies that touch may be drawn so far apart
BENT = 0.05  # of the radius of an arc: as far as it is nearly straight
SHARE = 1e-3  # of a contact beside a place: what is smaller there does not count as its state
SLID = 1e-4  # of the largest displacement: less is no slip of what sticks
SYMMETRY = "symmetry"  # the boundary on the line of Geometry->Symmetry, which rolls
BOUNDED = ("None", "Tresca", "Capped Coulomb")  # shear that singular pressure leaves behind


@dataclass(frozen=True)
class Face:
    """How a side of a body is held close to a place."""

    kind: str  # free, symmetry, clamp, contact, bond
    name: str = ""  # of the contact
    rows: Rows = FREE  # what vanishes, if nothing elastic is opposite
    joint: Optional[float] = None  # if something elastic is: as in Corner
    opposite: str = ""  # that body
    front: float = math.inf  # distance at which its state changes
    given: frozenset[float] = frozenset()  # powers of r in the displacement that data bring along


@dataclass(eq=False)
class Place:
    """A point between two edges of a body, or within one; angle inside the body, 2 pi between the
    faces of a crack."""

    x: complex
    edges: tuple[Edge, Edge]  # after, before: anticlockwise
    angle: float = field(init=False)
    faces: tuple[Face, Face] = field(init=False)

    def __post_init__(self) -> None:
        after, before = (edge.tangent(self.x) for edge in self.edges)
        turn = 0.0 if self.edges[0] is self.edges[1] else float(np.angle(after / before))
        self.angle = math.pi - turn if turn < math.pi - SMOOTH else 2 * math.pi

    @property
    def ends(self) -> bool:
        """Does a side of the body end here, at a corner or where another one begins?"""
        return abs(self.angle - math.pi) > SMOOTH or self.edges[0].name != self.edges[1].name

    @property
    def body(self) -> str:
        return self.edges[0].body

    @property
    def motion(self) -> tuple[complex, float]:
        """Displacement at the end of the path, and the rotation of a clamp."""
        here = self.edges[0].moved(self.x)
        for k, (edge, face) in enumerate(zip(self.edges, self.faces)):
            if face.rows == CLAMPED and face.kind == "clamp":
                far = (edge.end, edge.start)[k]
                return here, float(((edge.moved(far) - here) / (far - self.x)).imag)
        return here, 0.0

    def ray(self, k: int) -> complex:
        """Direction of a face, away from the place."""
        return self.edges[k].tangent(self.x) * (1, -1)[k]


@dataclass(eq=False)
class Meeting:
    """The places of all bodies that meet in a point, anticlockwise, and their wedges."""

    places: list[Place]
    corner: Corner
    reach: float = math.inf

    @property
    def bent(self) -> bool:
        return any(edge.curvature for place in self.places for edge in place.edges)

    @property
    def given(self) -> frozenset[float]:
        """Powers of r in the displacement that data bring along."""
        return frozenset().union(*(face.given for place in self.places for face in place.faces))


class Outlines:
    """Of a run's elastic bodies, with their conditions at the end, or at a step of the path."""

    def __init__(self, run: Run, step: Optional[int] = None) -> None:
        self.scene, table = numbers_at(run, step), run.boundary
        self.line = self.scene.get("Geometry", {}).get("Symmetry")
        self.revolve = self.scene.get("Geometry", {}).get("Type") == "Axisymmetric"
        bodies = self.scene["Bodies"]
        touch = self.scene.get("Contacts") or any(
            rules.get("Type") == "Contact" for body in bodies.values()
            for rules in body.get("Boundary Conditions", {}).values())
        if touch:  # else nothing asks for them
            self.samples = Samples(run.contact if step is None else run.step(step))
        self.edges = edges_of(table)
        self.sides: dict[str, list[Edge]] = {}
        for edge in self.edges:
            self.sides.setdefault(edge.body + ":" + edge.name, []).append(edge)
        self.size = float(np.ptp(table["x"]) + np.ptp(table["y"]))
        self.most = np.hypot(table["ux"], table["uy"]).max()  # displacement
        self.rigid = {name: rigid_corners(body["Geometry"]) for name, body in bodies.items()
                      if body["Material"].get("Rigid")}
        self.loaded = loaded(run, step)
        ends = [Place(edge.end, (edge.after, edge)) for edge in self.edges]
        self.places = [self.completed(place) for place in ends
                       if place.ends and not self.on_axis(place.x)]
        for x, edge in self.opposite_ends():
            if not self.on_axis(x) and all(abs(place.x - x) > APART * self.size for place in self.places
                   if place.body == edge.body):
                self.add(x, edge)

    def on_axis(self, x: complex) -> bool:
        """On that of Geometry->Type = Axisymmetric, where no wedge ends."""
        return self.revolve and abs(x.real) < APART * self.size

    def conditions(self, edge: Edge) -> dict[str, Any]:
        return self.scene["Bodies"][edge.body].get("Boundary Conditions", {}).get(edge.name, {})

    def contacts(self, edge: Edge) -> Iterator[tuple[str, dict[str, Any], str]]:
        """Of a side: name, rules, and the opposite side ("": an obstacle)."""
        rules = self.conditions(edge)
        if rules.get("Type") == "Contact":
            yield edge.name, rules, ""
        for name, rules in self.scene.get("Contacts", {}).items():
            sides = list(rules["Between"])
            for side, other in (sides, sides[::-1]):
                if side == edge.body + ":" + edge.name:
                    yield name, rules, other

    def side(self, name: str) -> list[Edge]:
        """The edges of "body:boundary"."""
        return self.sides.get(name, [])

    def ends(self, name: str) -> np.ndarray:
        """Where "body:boundary" begins, ends or has a corner."""
        return np.array(self.rigid.get(name.partition(":")[0], [
            place.x for edge in self.side(name) for place in (
                Place(edge.start, (edge, edge.before)), Place(edge.end, (edge.after, edge)))
            if place.ends]), complex)

    def opposite_ends(self) -> Iterator[tuple[complex, Edge]]:
        """Where a side of a contact ends opposite to an edge of another body."""
        known: dict[str, np.ndarray] = {}
        for edge in self.edges:
            for name, _, other in self.contacts(edge):
                if other not in known:
                    known[other] = self.ends(other)
                ends = known[other]
                if len(ends):
                    found, before = edge.nearest(ends)
                    for x, end in zip(found[before], ends[before]):
                        if abs(x - end) < self.apart(name, x):
                            yield complex(x), edge

    def apart(self, name: str, x: complex) -> float:
        """How far apart sides may be drawn that touch."""
        here = np.flatnonzero((self.samples.name == name) & self.samples.closed)
        gap = self.samples.gap[here[abs(self.samples.x[here] - x).argmin()]] if len(here) else 0
        return float(APART * self.size + 1.1 * abs(gap))

    def add(self, x: complex, edge: Edge) -> Place:
        """A place on an edge, at one of its ends or within it."""
        after = edge.after if abs(x - edge.end) < APART * self.size else edge
        before = edge.before if abs(x - edge.start) < APART * self.size else edge
        self.places.append(self.completed(Place(x, (after, before))))
        return self.places[-1]

    def completed(self, place: Place) -> Place:
        place.faces = self.face(place, 0), self.face(place, 1)
        return place

    def face(self, place: Place, k: int) -> Face:
        """Surfaces that yield bound what they transmit: to a singular stress they are free."""
        edge = place.edges[k]
        given: frozenset[float] = frozenset()
        rules = self.conditions(edge)
        if place.body in self.loaded or any(rules.get(key, 0) != 0 for key in TRACTIONS):
            given = LINEAR
        warmed = self.scene["Bodies"][place.body].get("Thermal Conditions")
        if warmed:
            given |= heat([warmed.get(edge.name, {}) for edge in place.edges], place.angle)
        axes = [axis for axis in "XY" if "Displacement " + axis in rules]
        halved = edge.name == SYMMETRY and self.line in ("X", "Y")
        if rules.get("Type") == "Dirichlet" or halved:
            for axis in axes:
                value = rules["Displacement " + axis]
                given |= LINEAR | {0} if isinstance(value, str) else {0} if value else frozenset()
            if len(axes) == 2 and 0 in given and given <= LINEAR | {0} and place.body not in (
                    self.loaded) and turns(edge):
                given = frozenset((0,))
            return Face("symmetry" if halved else "clamp", "", CLAMPED if len(axes) == 2 else held(
                float((math.pi / 2 if (axes or [self.line]) == ["Y"] else 0)
                      - np.angle(place.ray(k)))), given=given)
        faces = [self.touched(place, k, name, rules, other, given)
                 for name, rules, other in self.contacts(edge)]
        return next((face for face in faces if face.kind != "free"), Face(
            "free", front=min((face.front for face in faces), default=math.inf),
            given=given.union(*(face.given for face in faces))))

    def touched(self, place: Place, k: int, name: str, rules: dict[str, Any], other: str,
                given: frozenset[float]) -> Face:
        """A face that is in contact or may be."""
        rows = self.samples.on_edge(place.edges[k], name, other)
        ray = place.ray(k)
        rows = rows[((self.samples.x[rows] - place.x) / ray).real > 0]
        distances = abs(self.samples.x[rows] - place.x)
        if not self.samples.closed[rows].any():
            return Face("free", given=given)
        rows, distances = rows[np.argsort(distances)], np.sort(distances)
        next_ = self.samples.element[rows[np.searchsorted(distances, SHARE * distances[-1])]]
        beyond = rows[self.samples.element[rows] == next_]
        tip = distances[self.samples.element[rows] == next_].max()
        law = rules.get("Friction", {}).get("Law", "None")
        closed, stuck = self.samples.closed[rows], self.samples.stuck[rows]
        beside, facing = place.x + SHARE * distances[-1] * ray, self.side(other)
        if facing:  # else an obstacle, or rigid
            covered = np.any([edge.nearest(np.append(self.samples.x[rows], beside))[1]
                              for edge in facing], axis=0)
            closed &= covered[:-1]
        if facing and not covered[-1] or self.samples.closed[beyond].mean() < 0.5:
            return Face("free", front=float(distances[closed & (
                distances > (tip if closed[0] else 0))].min(initial=math.inf)), given=given)
        shears = rules.get("Friction", {}).get("Compliance", 0) == 0
        if rules.get("Normal", {}).get("Law", "Rigid") != "Rigid":
            return Face("free", given=given | LINEAR)
        sticks = shears and (law == "Tied" or bool(self.samples.stuck[beyond].mean() > 0.5))
        changes = ~closed if law in ("None", "Tied") else ~closed | (stuck != sticks)
        changes &= distances > tip
        front = float(distances[changes].min(initial=math.inf))
        body = other.partition(":")[0]
        gaps = self.samples.gap[rows][distances < front]
        if abs(gaps).max() > 1e-10 * self.size:
            given |= {0} if np.ptp(gaps) < 1e-10 * self.size else LINEAR | {0}
        if body in self.rigid:
            given |= {0, 1}
        if sticks and law != "Tied" and abs(
                self.samples.sliding[rows][distances < front]).max() > SLID * self.most:
            given |= LINEAR | {0}  # it has slid before
        opposite = "" if body in self.rigid else body
        if sticks:
            return Face("bond" if law == "Tied" else "contact", name, CLAMPED, None, opposite, front,
                        given)
        ratio = 0.0
        if shears and law not in BOUNDED:
            pressed = beyond[self.samples.pressure[beyond] > 0]
            ratio = 0.0 if not len(pressed) else -round(float(np.median(
                self.samples.bound[pressed] / self.samples.pressure[pressed])), 9) * float(
                    np.sign(self.samples.shear[pressed].sum()))
        elif law != "None" or not shears:
            given |= LINEAR
        return Face("contact", name, sliding(ratio), ratio, opposite, front, given)

    def place_of(self, face: Face, place: Place, k: int) -> Place:
        """Of the body opposite to a face."""
        other = next(other for name, _, other in self.contacts(place.edges[k]) if name == face.name)
        near = [candidate for candidate in self.places if candidate.body == face.opposite]
        if near:
            best = min(near, key=lambda candidate: abs(candidate.x - place.x))
            if abs(best.x - place.x) < self.apart(face.name, place.x):
                return best
        found = [(abs(x[0] - place.x), complex(x[0]), edge) for edge in self.side(other)
                 for x in [edge.nearest(np.array([place.x]))[0]]]
        _, x, edge = min(found, key=lambda entry: entry[0])
        return self.add(x, edge)

    def meetings(self) -> list[Meeting]:
        """Those at which stresses are singular."""
        done: set[int] = set()
        result = []
        for place in list(self.places):
            if id(place) in done:
                continue
            meeting = self.meeting(place)
            done |= set(map(id, meeting.places))
            if modes(meeting.corner):
                meeting.reach = self.reach(meeting.places)
                result.append(meeting)
        return result

    def meeting(self, place: Place) -> Meeting:
        chain, closed = [place], False
        joints: list[Any] = []
        for k in (1, 0):  # anticlockwise, then clockwise
            while not closed:
                end = chain[-k]
                if not end.faces[k].opposite:
                    break
                beyond = self.place_of(end.faces[k], end, k)
                closed = beyond in chain
                if not closed and sum(p.angle for p in chain) + beyond.angle > 2 * math.pi + SMOOTH:
                    break
                joints.insert(len(joints) * k, end.faces[k].joint)
                if not closed:
                    chain.insert(len(chain) * k, beyond)
        wedges, start = [], 0.0
        for member in chain:
            wedges.append(self.wedge(member.body, member.angle, start))
            start = wedges[-1].end
        faces = None if closed else (chain[0].faces[0].rows, chain[-1].faces[1].rows)
        return Meeting(chain, Corner(tuple(wedges), tuple(joints), faces))

    def wedge(self, body: str, angle: float, start: float) -> Wedge:
        material = self.scene["Bodies"][body]["Material"]
        e, nu = material["Young's Modulus"], material["Poisson's Ratio"]
        return Wedge(start, start + round(angle, 11), e / (2 * (1 + nu)), (3 - nu) / (1 + nu)
                     if material["Plane State"] == "Plane Stress" else 3 - 4 * nu)

    def reach(self, places: list[Place]) -> float:
        """How far the bodies are wedges: to the next end of an edge, change of contact or friction,
        or other side, a part of an arc's radius."""
        found = [self.size]
        for place in places:
            found += [face.front for face in place.faces]
            found += [BENT / abs(edge.curvature) for edge in place.edges if edge.curvature]
            found += [abs(end - place.x) for edge in place.edges for end in (edge.start, edge.end)]
            found.append(distance(place.x, [edge for edge in self.edges if edge.body == place.body
                                            and edge not in place.edges]))
            found += [abs(vertex - place.x) for vertices in self.rigid.values()
                      for vertex in vertices if any(face.kind == "contact" for face in place.faces)]
        return float(min(far for far in found if far > APART * self.size))
