"""slip: how the sides of contacts slide along a load path, over place and time, with the borders of
stick and of contact."""
import numpy as np

from epafi.plot.figures import plain, short
from epafi.plot.layout import laid_out, middles, window
from epafi.tables import Table

SHOWN = 3  # contacts


def maps(files):
    """Per contact that can stick or slip at some step: its name and its tables of all steps."""
    names = dict.fromkeys(zip(files[0]["body"].astype(str), files[0]["contact_name"].astype(str)))
    for body, name in names:
        own = [Table.of({column: values[(file["body"] == body) & (file["contact_name"] == name)]
                         for column, values in file.columns.items()}) for file in files]
        if any((file["friction"] > 0).any() and file["slip"].any() for file in own):
            yield name, own


def draw(files, t, title, pictures):
    """Of contact.csv of all steps, at the times t."""
    found = sorted(maps(files), key=lambda one: -max(np.abs(file["slip"]).max()
                                                     for file in one[1]))[:SHOWN]
    if not found or len(files) < 2:
        return
    figure, axes = pictures.subplots(1, len(found), figsize=(3 + 4.4 * len(found), 4.6))
    for panel, (name, own) in zip(np.atleast_1d(axes), found):
        shown = [laid_out(file, turns=False) for file in own]
        one_panel(panel, shown, t, pictures)
        if len(found) > 1:
            panel.set_title(short(name))
    pictures.title(figure, "%s: slip of %s since the first step" % (
        title, ", ".join(plain(name) for name, _ in found)))
    pictures.save(figure, "slip")


def one_panel(axes, shown, t, pictures):
    _, s, label, parts = shown[0]
    columns = {name: np.array([columns[name] for columns, *_ in shown])
               for name in ("slip", "contact", "friction")}
    slip = np.where(columns["contact"] > 0, columns["slip"], np.nan)
    size = np.nanmax(np.abs(slip), initial=1e-300)
    rows = middles(np.asarray(t, float))
    for a, b in parts:
        drawn = axes.pcolormesh(middles(s[a:b]), rows, slip[:, a:b], cmap="RdBu_r", vmin=-size,
                                vmax=size, rasterized=True)
        stick = ((columns["friction"] == 1) & (columns["contact"] > 0))[:, a:b].astype(float)
        if b - a > 1 and 0 < stick.mean() < 1:
            axes.contour(s[a:b], t, stick, [0.5], colors="black", linewidths=0.8)
    axes.set_xlim(*window(shown))
    axes.set_facecolor("0.9")
    axes.grid(False)
    axes.set_xlabel(pictures.looks.label(label, "length"))
    axes.set_ylabel("t")
    bar = axes.figure.colorbar(drawn, ax=axes)
    bar.set_label(pictures.looks.label("slip; black: border of stick, grey: open", "length"))
