#!/usr/bin/python3
"""Pressure and worn depth beside the edge of a punch, on elements down to 1e-8 of its half-width.

    worn_edge.py FOLDER FILE.png

FOLDER is `graded` among what test/scenes/wear_claims.py leaves.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))
import epafi  # noqa: E402
from epafi.plot.figures import COLOURS, STYLE, plt  # noqa: E402

run = epafi.Run(sys.argv[1])
distance = 1 - run.contact["x"]
order = np.argsort(distance)
with plt.rc_context(STYLE):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4))
    for panel, column, label in zip(axes, ("pressure", "worn_depth"), ("pressure", "worn depth")):
        profiles = run.profiles(column)
        for k in (1, 4, 10):
            panel.semilogx(distance[order], profiles[k][order], color=COLOURS[(1, 4, 10).index(k)],
                           label="step %d" % k, linewidth=1)
        panel.set_xlabel("distance from the edge / half-width")
        panel.set_ylabel(label)
    axes[0].legend()
    figure.savefig(sys.argv[2], dpi=110)
