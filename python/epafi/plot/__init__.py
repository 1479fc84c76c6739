"""Pictures of runs and studies, one kind in each module; `epafi plot` and the Python front draw
by the same code.  Needs matplotlib."""
from epafi.plot.figures import Looks, Pictures
from epafi.plot.folder import draw_folder

__all__ = ["Looks", "Pictures", "draw_folder"]
