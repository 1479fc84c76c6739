"""Data that do not vanish close to a place, and the powers of r that they bring along."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from epafi.outlines import Edge
from epafi.program import InputError

if TYPE_CHECKING:
    from epafi.runs import Run

LINEAR = frozenset((1.0, 2.0))  # powers of r in a displacement that follows what is given
TRACTIONS = ("Traction X", "Traction Y", "Force X", "Force Y", "Moment")


def zero(value: Any) -> bool:
    """Is a value of a scene, a number or a text, the number 0?"""
    try:
        return float(value) == 0
    except (TypeError, ValueError):
        return False


def numbers_at(run: Run, step: Optional[int]) -> dict[str, Any]:
    """A run's scene with numbers at the end of the path; at a step the conditions of boundaries that
    are zero at the end keep the texts that are not zero throughout."""
    numbers = run.numbers
    if step is None:
        return numbers

    def mended(tree: dict[str, Any], texts: dict[str, Any]) -> dict[str, Any]:
        return {key: mended(value, texts[key]) if isinstance(value, dict)
                else texts[key] if zero(value) and not zero(texts[key]) else value
                for key, value in tree.items()}

    kinds = ("Boundary Conditions", "Thermal Conditions")
    return {**numbers, "Bodies": {name: {
        key: mended(value, run.scene["Bodies"][name][key]) if key in kinds else value
        for key, value in body.items()} for name, body in numbers["Bodies"].items()}}


def loaded(run: Run, step: Optional[int]) -> set[str]:
    """Bodies with loads inside."""
    scene = run.numbers
    return {name for name, body in scene["Bodies"].items()
            if body.get("Body Loads") or scene.get("Body Loads")} | reacting(run, step)


def reacting(run: Run, step: Optional[int]) -> set[str]:
    """Bodies on which Rigid Motions->Fix acts by a uniform traction."""
    fixed = {name for name, body in run.numbers["Bodies"].items()
             if body.get("Rigid Motions", {}).get("Fix")}
    if not fixed:
        return fixed
    try:
        table = run.bodies
    except InputError:  # one body: its resultants stand in history.csv, at the end of the path
        if step is not None:
            return fixed
        table = run.history
    found = set()
    for name in fixed:
        rows = table["body"] == name if "body" in table else np.full(table.size, True)
        row = np.flatnonzero(rows if step is None else rows & (table["step"] == step))[-1]
        here = run.boundary["body"] == name
        x, tractions = ((run.boundary[a] + 1j * run.boundary[b])[here]
                        for a, b in (("x", "y"), ("tx", "ty")))
        size = abs(np.diff(x)) @ abs(tractions[1:])
        moment = abs(table["reaction_moment"][row]) / (np.ptp(x.real) + np.ptp(x.imag))
        if math.hypot(table["reaction_x"][row], table["reaction_y"][row]) + moment > 1e-6 * size:
            found.add(name)
    return found


def heat(rules: list[dict[str, Any]], angle: float) -> frozenset[float]:
    """Powers of r in the displacement that steady heat conduction brings along in a wedge whose faces
    have these `Thermal Conditions`: one more than those of temperatures r^p, harmonic between faces
    that are cold or insulated, p = 0 where it may be warm, p = 1 where data vary."""
    given = [rule["Temperature"] for rule in rules if "Temperature" in rule]
    first = math.pi / angle / (2 if len(given) == 1 else 1)
    found = {1 + first, 1 + first * (3 if len(given) == 1 else 2)}
    if not given or not all(map(zero, given)):
        found.add(1.0)
    if any(isinstance(value, str) for value in given) or not all(
            zero(rule.get("Heat Flux", 0)) for rule in rules):
        found.add(2.0)
    return frozenset(found)


def turns(edge: Edge) -> bool:
    """Is an edge displaced as a rigid one?"""
    turn = ((edge.u[-1] - edge.u[0]) / (edge.end - edge.start)).imag
    rest = edge.u - edge.u[0] - 1j * turn * (edge.x - edge.start)
    return bool(abs(rest).max() < 1e-9 * abs(edge.u).max())
