"""What the user of pictures chooses: sizes, formats, units."""
from __future__ import annotations

import dataclasses
import math
import re
from typing import Any, Optional

import numpy as np
from cycler import cycler

from epafi.program import InputError
from epafi.tables import used_of

# Okabe and Ito's, which readers without red or green tell apart.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
STYLE = {"axes.grid": True, "grid.alpha": 0.3, "axes.prop_cycle": cycler(color=COLOURS),
         "legend.fontsize": "small", "axes.titlesize": "medium", "figure.titlesize": "medium",
         "text.usetex": False,  # LaTeX would run what a scene's texts say
         "lines.markersize": 4, "svg.hashsalt": "epafi", "figure.constrained_layout.use": True}
POWERS = {"length": (1, 0), "stress": (0, 1), "force": (1, 1), "energy": (2, 1)}
# The unit of force of some units of length and stress: stress times length squared.
FORCES = {("mm", "MPa"): "N", ("m", "Pa"): "N", ("m", "kPa"): "kN", ("m", "MPa"): "MN",
          ("mm", "GPa"): "kN", ("m", "GPa"): "GN", ("in", "psi"): "lbf"}


@dataclasses.dataclass(frozen=True)
class Looks:
    """What the user of pictures chooses."""

    size: Optional[tuple[float, float]] = None  # of a picture, inches; by its content without
    dpi: float = 110  # of its pixels
    font: float = 10  # points
    title: bool = True
    endings: tuple[str, ...] = ("png", "svg")
    units: Any = None  # "mm,MPa", or a pair: those of length and stress, for labels

    def __post_init__(self) -> None:
        if isinstance(self.units, str):
            object.__setattr__(self, "units", self.units.split(","))
        if self.units is not None:
            object.__setattr__(self, "units", tuple(self.units))
        if self.units is not None and len(self.units) != 2:
            raise InputError("units: %r is not 'LENGTH,STRESS', as 'mm,MPa'" % (
                ",".join(self.units),))
        if self.size is not None and np.shape(self.size) != (2,):
            raise InputError("size: %r is not (width, height) in inches" % (self.size,))
        for name in ("size", "dpi", "font"):
            value = getattr(self, name)
            if value is not None and not all(isinstance(number, (int, float, np.number)) and
                                             0 < number < math.inf for number in np.ravel(value)):
                raise InputError("%s: %r is not above 0" % (name, value))

    def style(self) -> dict[str, Any]:
        return {**STYLE, "figure.dpi": self.dpi, "font.size": self.font}

    def unit(self, quantity: str, revolution: bool = False) -> str:
        """Of one of POWERS, per unit of thickness or of a whole revolution, as "N/mm" or
        "cm^2 bar"; empty without units."""
        if self.units is None or quantity not in POWERS:
            return ""
        length, stress = POWERS[quantity]
        force, unit = FORCES.get(self.units), self.units[0]
        if force and length and stress:
            moment = force if length == 1 else "%s %s" % (force, unit)
            return moment if revolution else "%s/%s" % (moment, unit)
        powers = (unit, length + (revolution and bool(length and stress))), (self.units[1], stress)
        return " ".join(name + ("^%d" % power if power > 1 else "")
                        for name, power in powers if power and name)

    def label(self, text: str, quantity: str) -> str:
        """'pressure [MPa]': a label with the unit of one of POWERS."""
        unit = re.sub(r"\^(\d)", r"$^\1$", self.unit(quantity))
        return "%s [%s]" % (text, unit) if unit else text

    def field_label(self, text: str, field: str) -> str:
        kind = {"u": "length", "t": ""}.get(field[0], "stress")
        return self.label(text, kind).strip() if kind else text


def units_of(folder: str) -> Optional[tuple[str, str]]:
    """The names of length and stress that a run's scene gives under Output->Units; "" of one that it
    does not give."""
    root = used_of(folder)
    names = {} if root is None else {entry.get("name"): entry.get("value", "") for entry in root.findall(
        "ParameterList[@name='Output']/ParameterList[@name='Units']/Parameter")}
    return (plain(names.get("Length", "")), plain(names.get("Stress", ""))) if names else None


def plain(text: str) -> str:
    """A text of the scene, in which $ is no mathematics and which a legend shows even if it begins
    with _."""
    return (" " if text.startswith("_") else "") + text.replace("$", r"\$")
