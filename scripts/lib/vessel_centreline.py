"""The centreline of the surface of a vessel without branches: the line on which the centres of its sections lie."""

import numpy

from vessel_surface import SurfaceError, text

LARGEST_CHANGE = 1e-3  # of the line from one iteration to the next, over the least radius
MOST_ITERATIONS = 40
MOST_SAMPLES = 500
FARTHEST = 2.5  # a point of the surface from the line, over the radius


def normalised(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def march(surface, inlet, outlet):
    """Points near the centreline from the inlet to the outlet, and the radii there: steps along the line of the sections' centres."""
    points, radii = [inlet.centre], [inlet.radius]
    direction = normalised(-inlet.area)
    radius = inlet.radius
    for _ in range(100000):
        step = 0.25 * radius
        if len(points) > 3 and numpy.linalg.norm(outlet.centre - points[-1]) < max(step, 0.5 * outlet.radius):
            return numpy.array(points + [outlet.centre]), numpy.array(radii + [outlet.radius])
        guess = points[-1] + step * direction
        section = surface.section(guess, direction)
        if section is not None and numpy.linalg.norm(section.centre - guess) < radius:
            direction = normalised(direction + normalised(section.centre - points[-1]))
            section = surface.section(section.centre, direction) or section
        if section is None or numpy.linalg.norm(section.centre - guess) > radius:
            # The plane meets the edge of an end that is cut at a slant: go on until the outlet is there.
            if numpy.linalg.norm(outlet.centre - guess) < 4 * outlet.radius and len(points) > 3:
                return numpy.array(points + [outlet.centre]), numpy.array(radii + [outlet.radius])
            if numpy.linalg.norm(inlet.centre - guess) > 4 * inlet.radius:
                raise SurfaceError(f"the vessel has no closed section near {text(guess)}, or jumps there: remove side branches, and close "
                                   "all holes but for inlet and outlet")
            points.append(guess)
            radii.append(radius)
            continue
        if not 0.25 < section.area / (numpy.pi * radius**2) < 4:
            raise SurfaceError(f"the area of the section jumps near {text(section.centre)}, from {numpy.pi * radius**2:.4g} to "
                               f"{section.area:.4g}: remove side branches")
        points.append(section.centre)
        radius = section.radius
        radii.append(radius)
    raise SurfaceError("the line does not come to the outlet: name the ends by --inlet X Y Z --outlet X Y Z")


def refuse_branches(surface, line, radii):
    """Refuses a surface of which a part is far away from the line, such as a blind branch."""
    used = numpy.unique(surface.triangles)
    for begin in range(0, len(used), 4096):
        points = surface.points[used[begin:begin + 4096]]
        distances = numpy.linalg.norm(points[:, None] - line[None], axis=2)
        nearest = distances.argmin(axis=1)
        relative = distances[numpy.arange(len(points)), nearest] / radii[nearest]
        if relative.max() > FARTHEST:
            raise SurfaceError(f"the surface at {text(points[relative.argmax()])} is {relative.max():.3g} radii away from the centreline: "
                               "remove side branches and bulges there, or use a mesh of your own")


def positions(points):
    """The length of the line up to each point."""
    return numpy.concatenate([[0], numpy.cumsum(numpy.linalg.norm(numpy.diff(points, axis=0), axis=1))])


def resampled(points, number):
    """So many points at equal distances on the cubics through the points (Catmull and Rom)."""
    place = positions(points)
    slopes = numpy.gradient(points, place, axis=0, edge_order=2 if len(points) > 2 else 1)
    wanted = numpy.linspace(0, place[-1], number)
    interval = numpy.clip(numpy.searchsorted(place, wanted, side="right") - 1, 0, len(place) - 2)
    length = (place[interval + 1] - place[interval])[:, None]
    u = (wanted - place[interval])[:, None] / length
    return ((1 + 2 * u) * (1 - u) ** 2 * points[interval] + u * (1 - u) ** 2 * length * slopes[interval]
            + u**2 * (3 - 2 * u) * points[interval + 1] - u**2 * (1 - u) * length * slopes[interval + 1])


def smoothed(values, weights, spacing, wave_length):
    """The values at equal distances without what is shorter than the wave length; a weight of zero marks one that is missing. It
    leaves parabolas as they are."""
    thirds = numpy.diff(numpy.eye(len(values)), 3, axis=0)
    strength = (wave_length / (2 * numpy.pi * spacing)) ** 6
    matrix = numpy.diag(weights) + max(strength, 1e-6) * thirds.T @ thirds
    return numpy.linalg.solve(matrix, weights[:, None] * values)


def tangents_of(points):
    return normalised(numpy.gradient(points, positions(points), axis=0, edge_order=2))


class Centreline:
    """Points at equal distances from inlet to outlet, the radius of the section at each, and what to know of the sections."""

    def __init__(self, surface, inlet, outlet, n_points, smoothing):
        """`smoothing`: waves of the line shorter than this are left out [the surface's unit]; None: twice the mean radius."""
        line, radii = march(surface, inlet, outlet)
        refuse_branches(surface, line, radii)
        length = positions(line)[-1]
        least_radius = min(inlet.radius, outlet.radius)
        # Enough sections for the shape of the line, few enough for a large surface.
        number = int(numpy.clip(numpy.ceil(4 * length / least_radius), 12, MOST_SAMPLES)) + 1
        wave_length = inlet.radius + outlet.radius if smoothing is None else smoothing
        line = resampled(line, number)
        self.n_iterations = 0
        change = numpy.inf
        while change > LARGEST_CHANGE * least_radius:
            if self.n_iterations == MOST_ITERATIONS:
                raise SurfaceError(f"the line does not settle: it still moves by {change:.3g}; give a larger --smoothing")
            self.n_iterations += 1
            centres, weights = self.cut(surface, line, inlet, outlet)
            spacing = positions(line)[-1] / (number - 1)
            # Points that stand closer or farther than the spacing after the cut change that by a second order only.
            new = resampled(smoothed(centres, weights, spacing, wave_length), number)
            change = numpy.linalg.norm(new - line, axis=1).max()
            line = new
        self.points = resampled(line, n_points)
        fine = tangents_of(line)
        places, wanted = numpy.arange(number), numpy.linspace(0, number - 1, n_points)
        self.tangents = normalised(numpy.array([numpy.interp(wanted, places, fine[:, d]) for d in range(3)]).T)
        self.sections = self.sections_at(surface, self.points, self.tangents)
        self.radii = self.radii_of(inlet, outlet)
        self.length = positions(line)[-1]
        turns = numpy.linalg.norm(numpy.gradient(fine, positions(line), axis=0), axis=1)
        self.curvatures = numpy.interp(wanted, places, turns)
        self.refuse_jumps()

    @staticmethod
    def sections_at(surface, points, tangents):
        """The section across the line at each point; None next to an end where the plane meets the end's edge."""
        sections = []
        for point, tangent in zip(points, tangents):
            section = surface.section(point, tangent)
            if section is not None and numpy.linalg.norm(section.centre - point) > section.radius:
                section = None
            sections.append(section)
        return sections

    def cut(self, surface, line, inlet, outlet):
        sections = self.sections_at(surface, line, tangents_of(line))
        sections[0] = sections[-1] = None
        centres = numpy.array([point if section is None else section.centre for point, section in zip(line, sections)])
        weights = numpy.array([0. if section is None else 1. for section in sections])
        if weights.sum() < 4:
            raise SurfaceError("hardly any plane across the vessel cuts it in a closed section: it is too short, or its ends are cut at "
                               "too much of a slant; use a longer part of the vessel")
        centres[0], centres[-1] = inlet.centre, outlet.centre
        weights[0] = weights[-1] = 1
        return centres, weights

    def radii_of(self, inlet, outlet):
        known = numpy.array([section is not None for section in self.sections])
        radii = numpy.array([0. if section is None else section.radius for section in self.sections])
        # The area of an end, seen along the line.
        for place, end in ((0, inlet), (-1, outlet)):
            radii[place] = numpy.sqrt(abs(end.area @ self.tangents[place]) / numpy.pi)
            known[place] = True
        places = numpy.arange(len(radii))
        missing = places[~known]
        # Near the ends alone, where the plane meets the edge of an end at a slant.
        inner = [i for i in missing if numpy.linalg.norm(self.points[i] - inlet.centre) > 4 * inlet.radius
                 and numpy.linalg.norm(self.points[i] - outlet.centre) > 4 * outlet.radius]
        if inner:
            raise SurfaceError(f"the section at {text(self.points[inner[0]])} is not closed: close all holes but for inlet and outlet")
        radii[missing] = numpy.interp(missing, places[known], radii[known])
        return radii

    def refuse_jumps(self):
        slopes = numpy.abs(numpy.diff(self.radii)) / numpy.diff(positions(self.points))
        i = int(slopes.argmax())
        if slopes[i] > 1:
            raise SurfaceError(f"the radius jumps from {self.radii[i]:.4g} to {self.radii[i + 1]:.4g} near {text(self.points[i])}: remove "
                               "side branches there, or smooth the surface")
