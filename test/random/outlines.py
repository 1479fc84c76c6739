"""Random outlines, of segments and arcs."""
import math


def polygon(draw):
    """Around the origin, which sees every corner; counter-clockwise."""
    count = draw.randint(4, 9)
    while True:
        shares = [draw.uniform(0.3, 1) for _ in range(count)]
        if max(shares) < 0.45 * sum(shares):
            break
    angles = [2 * math.pi * sum(shares[:k]) / sum(shares) for k in range(count)]
    radii = [draw.uniform(1, 6) for _ in range(count)]
    return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles)]


def bulges(draw, corners):
    """Arcs for about half of the sides, up to 90 degrees, flattened until they keep clear of each
    other and meet at 10 degrees and more."""
    values = [draw.choice((0, draw.uniform(-0.4, 0.4))) for _ in corners]
    while not is_simple(corners, values):
        values = [value / 2 if abs(value) > 1e-3 else 0 for value in values]
        if not any(values):
            return []
    return values


def arc(start, end, bulge, pieces):
    """Points along an arc, its ends included."""
    (x, y), (a, b) = start, end
    angle = 4 * math.atan(bulge)
    points = []
    for k in range(pieces + 1):
        t = 2 * k / pieces - 1  # a chord has the direction of the tangent half way
        if bulge == 0:
            along, across = (1 + t) / 2, 0
        else:
            length = math.sin((1 + t) * angle / 4) / math.sin(angle / 2)
            along = length * math.cos((t - 1) * angle / 4)
            across = length * math.sin((t - 1) * angle / 4)
        points.append((x + along * (a - x) - across * (b - y), y + along * (b - y) + across * (a - x)))
    return points


def is_simple(corners, values):
    """By polygons of the arcs: no two lines that are not neighbours are near each other."""
    pieces = 12
    sides = [arc(corners[k], corners[(k + 1) % len(corners)], values[k], pieces)
             for k in range(len(corners))]
    for k, side in enumerate(sides):
        (x, y), (a, b), (c, d) = side[-2], side[-1], sides[(k + 1) % len(sides)][1]
        turn = math.atan2((a - x) * (d - b) - (b - y) * (c - a), (a - x) * (c - a) + (b - y) * (d - b))
        if abs(turn) > math.radians(170):
            return False
    points = [point for side in sides for point in side[:-1]]
    size = max(math.dist(p, q) for p in corners for q in corners)
    count = len(points)
    for i in range(count):
        for j in range(i + 2, count):
            if (j + 1) % count == i:
                continue
            a, b, c, d = points[i], points[i + 1], points[j], points[(j + 1) % count]
            if opposite(a, b, c, d) and opposite(c, d, a, b):
                return False
            if j - i > 2 * pieces and count - (j - i) > 2 * pieces and math.dist(a, c) < 0.02 * size:
                return False
    return True


def opposite(a, b, c, d):
    """Does the line through a and b part c from d?"""
    def side(p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return side(c) * side(d) <= 0


def circle(middle, radius, start=-0.5 * math.pi):
    """Four arcs."""
    corners = [(middle[0] + radius * math.cos(start + 0.5 * math.pi * k),
                middle[1] + radius * math.sin(start + 0.5 * math.pi * k)) for k in range(4)]
    return corners, [math.tan(math.pi / 8)] * 4


def turned(point, angle, scale=1):
    c, s = scale * math.cos(angle), scale * math.sin(angle)
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


def rounded(corners, radii, names):
    """A polygon with arcs of these radii in place of corners, 0: sharp; an arc has the name of the side
    before it.  Returns outline, a pair of corners and bulges, and names."""
    points, values, all_names = [], [], []
    for k, (x, y) in enumerate(corners):
        before, (a, b) = corners[k - 1], corners[(k + 1) % len(corners)]
        inwards, outwards = math.atan2(y - before[1], x - before[0]), math.atan2(b - y, a - x)
        angle = (outwards - inwards + math.pi) % (2 * math.pi) - math.pi
        if radii[k]:
            off = radii[k] * abs(math.tan(angle / 2))
            points.append((x - off * math.cos(inwards), y - off * math.sin(inwards)))
            values.append(math.tan(angle / 4))
            all_names.append(names[k - 1])
            x, y = x + off * math.cos(outwards), y + off * math.sin(outwards)
        points.append((x, y))
        values.append(0)
        all_names.append(names[k])
    return (points, values), all_names


def sampled(outline, pieces=64):
    corners, values = outline
    return [point for k, start in enumerate(corners)
            for point in arc(start, corners[(k + 1) % len(corners)], values[k], pieces if values[k] else 8)[:-1]]
