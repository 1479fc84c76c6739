"""How far two tables of results are apart, each column relative to its scale.  Standard
library only.

The scale of a column is the largest number among those it is added to: all energies, all
forces, all lengths; in contact.csv all stresses, all displacements.  The eta_* are roots: their
squares add up to the estimate's, so squares are what is compared, and rounding's are no difference.
"""
ASIDE = ("seconds_", "memory_")
FAMILIES = ("energy_", "_length", "eta_")
ROOTS = ("eta_", "estimate", "worst_step_estimate")
FORCES = ("force_", "reaction_", "load_", "contact_x", "contact_y", "contact_moment")
SHARED = (("u_n", "u_t", "gap"), ("x", "y"), ("lambda_n", "lambda_t", "bound"),
          ("pressure", "shear"))


def numbers(rows, name):
    """A column; words (status) as they are."""
    values = [row[name] for row in rows]
    if any(isinstance(value, str) for value in values):
        return [str(value) for value in values]
    return [value ** 2 for value in values] if name.startswith(ROOTS) else values


def family(rows, name):
    """The columns that share a scale."""
    if name.startswith(FORCES):
        return [other for other in rows[0] if other.startswith(FORCES)]
    for group in SHARED:
        if name in group:
            return [other for other in group if other in rows[0]]
    for part in FAMILIES:
        if part in name:
            return [other for other in rows[0] if part in other]
    return [name]


def difference(one, other, name):
    """Largest difference in a column relative to its scale; infinite if rows or words differ."""
    a, b = numbers(one, name), numbers(other, name)
    if len(a) != len(b):
        return float("inf")
    if isinstance(a[0], str):
        return 0 if a == b else float("inf")
    scale = max(abs(x) for column in family(one, name) for x in numbers(one, column))
    if name.startswith(ROOTS):
        scale = max(scale, 1e-16 * max(row["energy_strain"] for row in one))
    return max(abs(x - y) for x, y in zip(a, b)) / scale if scale > 0 else max(map(abs, b))


def worst(one, other, names=None):
    """The largest difference of two tables and its column; times and memory are left aside."""
    return max((difference(one, other, name), name)
               for name in names or one[0] if not name.startswith(ASIDE))
