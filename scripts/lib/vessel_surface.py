"""Reads the surface of a vessel (STL), finds its two ends, and cuts it by planes."""

import numpy

SHARP = numpy.cos(numpy.radians(35))  # of the angle between two triangles at the edge of a cap
FLAT = numpy.cos(numpy.radians(3))  # of the angle between a triangle of a cap and the cap


class SurfaceError(Exception):
    """The surface is not that of one vessel; the text names the remedy."""


def read_stl(path):
    """The corners of the triangles, (n, 3, 3), in the unit of the file, and the number of bytes behind those of a binary file."""
    with open(path, "rb") as stream:
        content = stream.read()
    n_triangles = int(numpy.frombuffer(content[80:84], "<u4")[0]) if len(content) >= 84 else 0
    n_bytes = 84 + 50 * n_triangles
    n_left_out = 0
    # The letters of a text in the place of the number make it more than any file holds.
    if 0 < n_triangles and n_bytes <= len(content):
        record = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        corners = numpy.frombuffer(content, record, n_triangles, 84)["corners"].astype(float)
        n_left_out = len(content) - n_bytes
    elif b"vertex" not in content.lower() and b"endsolid" not in content.lower():
        raise SurfaceError(f"{path} is no STL file, neither binary nor text, or it is cut off: write it again")
    else:
        # Names in the file may have any letters; what counts is the same in all of them.
        lines = [line.split() for line in content.decode("latin-1").splitlines()]
        try:
            corners = numpy.array([line[1:] for line in lines if line and line[0].lower() == "vertex"], float).reshape(-1, 3, 3)
        except ValueError as error:
            raise SurfaceError(f"{path} has a corner without three numbers, or a triangle without three corners, or it is cut off: "
                               "write it again") from error
    if len(corners) == 0:
        raise SurfaceError(f"{path} has no triangles: write the surface of the vessel as STL")
    if not numpy.isfinite(corners).all():
        raise SurfaceError(f"{path} has a corner that is no finite number: write it again")
    return corners, n_left_out


class Section:
    """A closed cut of the surface by a plane: its corners in their order, its centre and its area."""

    def __init__(self, corners, normal):
        self.corners = corners
        middle = corners.mean(axis=0)
        a, b = corners - middle, numpy.roll(corners, -1, axis=0) - middle
        areas = 0.5 * numpy.cross(a, b) @ normal
        total = areas.sum()
        self.area = abs(total)
        self.centre = middle + (areas[:, None] * (a + b)).sum(axis=0) / (3 * total) if total != 0 else middle
        self.radius = numpy.sqrt(self.area / numpy.pi)

    def diameters(self, normal):
        """The largest and the least width of the section."""
        first = numpy.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.7 else [0, 1, 0])
        first /= numpy.linalg.norm(first)
        second = numpy.cross(normal, first)
        angles = numpy.linspace(0, numpy.pi, 72, endpoint=False)
        along = self.corners @ (numpy.outer(first, numpy.cos(angles)) + numpy.outer(second, numpy.sin(angles)))
        widths = along.max(axis=0) - along.min(axis=0)
        return widths.max(), widths.min()

    def largest_difference(self):
        """The largest distance of a corner from the circle of the section's centre and area."""
        return numpy.abs(numpy.linalg.norm(self.corners - self.centre, axis=1) - self.radius).max()


class End:
    """A loop of edges where the surface is open: its centre, and its area as a vector out of the vessel."""

    def __init__(self, corners, inside):
        middle = corners.mean(axis=0)
        self.area = 0.5 * numpy.cross(corners - middle, numpy.roll(corners, -1, axis=0) - middle).sum(axis=0)
        size = numpy.linalg.norm(self.area)
        if size == 0:
            raise SurfaceError(f"the end at {text(middle)} has no area: cut the vessel open there by a plane")
        self.centre = Section(corners, self.area / size).centre
        if self.area @ (inside - self.centre) > 0:
            self.area = -self.area
        self.radius = numpy.sqrt(size / numpy.pi)


def text(point):
    return "(" + ", ".join(f"{value:.4g}" for value in point) + ")"


class Surface:
    """The triangles of one vessel without the caps of its ends, joined at their edges."""

    def __init__(self, corners, ends_near=()):
        """`ends_near`: points that tell which flat parts of a closed surface are its ends, if there are more than two."""
        flat = corners.reshape(-1, 3)
        self.size = numpy.linalg.norm(flat.max(axis=0) - flat.min(axis=0))
        # Corners at the same place but for the digits that a text file leaves out.
        _, places, numbers = numpy.unique(numpy.round(flat / (1e-7 * self.size)), axis=0, return_index=True, return_inverse=True)
        self.points, triangles = flat[places], numbers.reshape(-1, 3)
        different = ((triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2])
                     & (triangles[:, 2] != triangles[:, 0]))
        self.join(triangles[different])
        if self.number_of_parts(self.neighbours) != 1:
            raise SurfaceError("the surface has several parts that are not joined: keep that of the vessel, of a wall its inner side, and "
                               "join its triangles")
        if (self.neighbours >= 0).all():
            # Without a hole through it a closed surface is a sphere to topology: its Euler characteristic is 2.
            if len(numpy.unique(self.triangles)) - len(self.triangles) // 2 < 2:
                raise SurfaceError("the surface is closed and has a hole through it, as a wall has with its inner and its outer side: keep "
                                   "its inner side alone, without the outer side and the rings that join the two. If it is that of a "
                                   "lumen, cut the vessel open at its ends, and remove a branch that divides and joins again")
            self.remove_caps(list(ends_near))
        loops = self.open_loops()
        if len(loops) > 2:
            raise SurfaceError(f"the surface is open at {len(loops)} places, near "
                               + ", ".join(text(self.points[loop].mean(axis=0)) for loop in loops[:6])
                               + ": a vessel with branches needs one table for each; close all holes but for inlet and outlet")
        if len(loops) < 2:
            raise SurfaceError("the surface is open at one end and closed at the other: cut the other one open by a plane, or close "
                               "both by flat caps")
        used = numpy.unique(self.triangles)
        n_edges = ((self.neighbours >= 0).sum() // 2) + (self.neighbours < 0).sum()
        if len(used) - n_edges + len(self.triangles) != 0:
            raise SurfaceError("the vessel divides and joins again, or its surface has a handle: remove the side branch")
        self.ends = []
        for loop in loops:
            end = self.points[loop]
            distances = numpy.linalg.norm(self.points[used] - end.mean(axis=0), axis=1)
            near = distances < 2 * numpy.linalg.norm(end - end.mean(axis=0), axis=1).max()
            self.ends.append(End(end, self.points[used][near].mean(axis=0)))

    def join(self, triangles):
        """Finds the triangle beyond each edge; -1 where there is none."""
        self.triangles = triangles
        edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        _, numbers, counts = numpy.unique(edges, axis=0, return_inverse=True, return_counts=True)
        numbers = numbers.reshape(-1)
        if counts.max() > 2:
            places = self.points[edges[numpy.isin(numbers, numpy.nonzero(counts > 2)[0])].reshape(-1)]
            raise SurfaceError(f"more than two triangles meet at an edge near {text(places[0])}: repair the surface there, for "
                               "example remove doubled triangles and walls inside the vessel")
        order = numpy.argsort(numbers, kind="stable")
        self.neighbours = numpy.full(3 * len(triangles), -1)
        pairs = numpy.nonzero(numbers[order][1:] == numbers[order][:-1])[0]
        first, second = order[pairs], order[pairs + 1]
        self.neighbours[first], self.neighbours[second] = second // 3, first // 3
        self.neighbours = self.neighbours.reshape(-1, 3)

    def parts(self, neighbours):
        """For each triangle the number of the part it belongs to, where only these neighbours are joined."""
        number = numpy.full(len(self.triangles), -1)
        n_parts = 0
        for start in range(len(number)):
            if number[start] >= 0:
                continue
            number[start] = n_parts
            stack = [start]
            while stack:
                for other in neighbours[stack.pop()]:
                    if other >= 0 and number[other] < 0:
                        number[other] = n_parts
                        stack.append(other)
            n_parts += 1
        return number

    def number_of_parts(self, neighbours):
        return self.parts(neighbours).max() + 1

    def remove_caps(self, ends_near):
        """Opens a closed surface at its two flat ends."""
        corners = self.points[self.triangles]
        vectors = 0.5 * numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        areas = numpy.maximum(numpy.linalg.norm(vectors, axis=1), 1e-300)
        normals = vectors / areas[:, None]
        # Which way a normal points is left open: the triangles of a cap lie in one plane either way.
        smooth = numpy.abs((normals[:, None] * normals[self.neighbours]).sum(axis=2)) > SHARP
        number = self.parts(numpy.where(smooth, self.neighbours, -1))
        caps = []
        for part in range(number.max() + 1):
            mine = numpy.nonzero(number == part)[0]
            signs = numpy.sign(normals[mine] @ normals[mine[numpy.argmax(areas[mine])]])
            total = (signs[:, None] * vectors[mine]).sum(axis=0)
            if (numpy.abs(normals[mine] @ total) > FLAT * numpy.linalg.norm(total)).all():
                centre = (corners[mine].mean(axis=1) * areas[mine, None]).sum(axis=0) / areas[mine].sum()
                caps.append((part, centre))
        if len(caps) > 2 and len(ends_near) == 2:
            caps = [min(caps, key=lambda cap, point=point: numpy.linalg.norm(cap[1] - point)) for point in ends_near]
        if len({part for part, _ in caps}) != 2:
            raise SurfaceError(f"the surface is closed and has {len(caps)} flat ends with sharp edges, where a vessel has 2: cut its ends "
                               "open by planes, or, if it has more flat parts, name the ends by --inlet X Y Z --outlet X Y Z")
        self.join(self.triangles[~numpy.isin(number, [part for part, _ in caps])])
        if self.number_of_parts(self.neighbours) != 1:
            raise SurfaceError("the two flat ends divide the surface: cut the vessel's ends open by planes")

    def open_loops(self):
        """The points of each loop of edges with one triangle, in their order."""
        triangle, side = numpy.nonzero(self.neighbours < 0)
        following = {}
        for a, b in zip(self.triangles[triangle, side], self.triangles[triangle, (side + 1) % 3]):
            following.setdefault(a, []).append(b)
            following.setdefault(b, []).append(a)
        loops = []
        while following:
            start = next(iter(following))
            loop, previous = [start], None
            while True:
                others = [other for other in following[loop[-1]] if other != previous]
                if len(following[loop[-1]]) != 2 or not others:
                    raise SurfaceError(f"the edge of an opening meets itself at {text(self.points[loop[-1]])}: repair the surface there")
                previous = loop[-1]
                if others[0] == start:
                    break
                loop.append(others[0])
            for point in loop:
                del following[point]
            loops.append(loop)
        return loops

    def section(self, point, normal):
        """The cut by the plane whose centre is nearest to the point; None where the cut is not closed or there is none."""
        height = (self.points - point) @ normal
        height[height == 0] = 1e-12 * self.size  # no corner lies in the plane
        above = height > 0
        sides = above[self.triangles]
        crossing = numpy.nonzero(sides.any(axis=1) & ~sides.all(axis=1))[0]
        left = set(crossing.tolist())
        nearest = None
        while left:
            start = left.pop()
            corners, closed, came_from, triangle = [], True, -2, start
            for edge in range(3):
                a, b = self.triangles[start, edge], self.triangles[start, (edge + 1) % 3]
                if above[a] != above[b]:
                    first = edge
            edge = first
            while True:
                a, b = self.triangles[triangle, edge], self.triangles[triangle, (edge + 1) % 3]
                share = height[a] / (height[a] - height[b])
                corners.append(self.points[a] + share * (self.points[b] - self.points[a]))
                came_from, triangle = triangle, self.neighbours[triangle, edge]
                if triangle < 0:
                    closed = False
                    break
                left.discard(int(triangle))
                if triangle == start:
                    break
                entered = {a, b}
                for edge in range(3):
                    a, b = self.triangles[triangle, edge], self.triangles[triangle, (edge + 1) % 3]
                    if above[a] != above[b] and {a, b} != entered:
                        break
            corners = numpy.array(corners)
            distance = numpy.linalg.norm(corners - point, axis=1).min()
            if nearest is None or distance < nearest[0]:
                nearest = (distance, corners, closed)
        if nearest is None or not nearest[2] or len(nearest[1]) < 3:
            return None
        return Section(nearest[1], normal)
