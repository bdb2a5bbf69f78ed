"""Pictures of triangles in space with hidden surfaces removed, for the pictures of the pages."""

import numpy as np

#: Direction towards the light, in the frame of the camera: right, up, towards the viewer.
LIGHT = np.array([-0.4, 0.65, 0.65])
LIGHT /= np.linalg.norm(LIGHT)
#: Halfway between the light and the viewer, where a shiny face reflects it.
HALFWAY = np.add(LIGHT, np.eye(3)[2])
HALFWAY /= np.linalg.norm(HALFWAY)
#: A weaker light from the other side.
FILL = np.array([0.8, 0.1, 0.6])
#: Pixels are drawn in this many rows and columns each, and averaged.
FINE = 3
#: Depth difference to the neighbouring pixel from which an outline is drawn [m], and its brightness.
STEP, OUTLINE = 0.012, 0.45


class Raster:
    """A picture of what is around `points` (k, 3) [m], without perspective; bodies are drawn one after the other.

    Args:
        azimuth, elevation: of the viewer [degrees].
        points: that have to be in the picture, which is at least `least` (2,) wide and high [m].
        pixels: per metre.
    """

    def __init__(self, *, azimuth, elevation, points, pixels, least=(0.0, 0.0)):
        a, e = np.deg2rad([azimuth, elevation])
        towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        self.view = np.array([right, np.cross(towards, right), towards])
        self.scale = FINE * pixels
        seen = points @ self.view.T
        self.centre = (seen.min(axis=0) + seen.max(axis=0)) / 2
        width, height = np.maximum(1.04 * np.ptp(seen, axis=0)[:2], least)
        self.shape = (FINE * round(height * pixels), FINE * round(width * pixels))
        self.image = np.ones((*self.shape, 3))

    def draw(self, triangles, colour, *, opacity=1.0, smooth=True):
        """Draw bodies: triangles (t, 3, 3) [m] in a colour (3,), one per triangle (t, 3) or one per corner (t, 3, 3).

        What is translucent is laid over what was drawn before; its own hidden parts are not seen.
        """
        corners = (triangles @ self.view.T - self.centre) * [self.scale, -self.scale, 1.0]
        corners[:, :, 0] += self.shape[1] / 2
        corners[:, :, 1] += self.shape[0] / 2
        normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) @ self.view.T
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-15)
        normal *= np.where(normal[:, 2:] < 0, -1.0, 1.0)
        colours = np.broadcast_to(colour if np.ndim(colour) == 3 else np.reshape(colour, (-1, 1, 3)), (len(triangles), 3, 3))
        normals = np.repeat(normal[:, None], 3, axis=1)
        if smooth:
            normals = smoothed(triangles, normals)
        depth = np.full(self.shape, -np.inf)
        shade = np.zeros((*self.shape, 3))
        for tri, own, around in zip(corners, colours, normals, strict=True):
            low = np.maximum(np.ceil(tri[:, :2].min(axis=0) - 0.5).astype(int), 0)
            high = np.minimum(np.floor(tri[:, :2].max(axis=0) - 0.5).astype(int) + 1, self.shape[::-1])
            if (low >= high).any():
                continue
            x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
            (ax, ay), (bx, by), (cx, cy) = tri[:, :2]
            area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            if abs(area) < 1e-12:
                continue
            v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
            w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
            u = 1 - v - w
            share = np.stack([u, v, w], axis=-1)
            z = share @ tri[:, 2]
            part = (slice(low[1], high[1]), slice(low[0], high[0]))
            seen = (u >= -1e-9) & (v >= -1e-9) & (w >= -1e-9) & (z > depth[part])
            depth[part][seen] = z[seen]
            facing = share[seen] @ around
            facing /= np.maximum(np.linalg.norm(facing, axis=1, keepdims=True), 1e-12)
            light = 0.58 + 0.34 * np.clip(facing @ LIGHT, 0, 1) + 0.14 * np.clip(facing @ FILL, 0, 1)
            shine = np.clip(facing @ HALFWAY, 0, 1) ** 40
            lit = light[:, None] * (share[seen] @ own) + 0.08 * shine[:, None]
            shade[part][seen] = np.clip(lit, 0, 1)
        covered = np.isfinite(depth)
        line = np.zeros(self.shape, dtype=bool)
        for axis in (0, 1):
            for shift in (1, -1):
                other = np.roll(depth, shift, axis=axis)
                with np.errstate(invalid="ignore"):
                    line |= covered & (depth - other > STEP)
        shade[line] *= OUTLINE
        strength = np.where(line, min(1.0, 2 * opacity), opacity)[covered][:, None]
        self.image[covered] = (1 - strength) * self.image[covered] + strength * shade[covered]

    def pixels(self):
        """The picture (h, w, 3) in [0, 1]."""
        h, w = self.shape
        return self.image.reshape(h // FINE, FINE, w // FINE, FINE, 3).mean(axis=(1, 3))


def smoothed(triangles, normals, angle=0.6):
    """Normals of corners, averaged over the triangles around that bend by less than `angle` [rad]."""
    keys = np.unique(np.rint(triangles.reshape(-1, 3) / 1e-6).astype(np.int64), axis=0, return_inverse=True)[1].ravel()
    flat = normals.reshape(-1, 3)
    area = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1).repeat(3)
    order = np.argsort(keys, kind="stable")
    found = flat.copy()
    for group in np.split(order, np.flatnonzero(np.diff(keys[order])) + 1):
        near = flat[group] @ flat[group].T > np.cos(angle)
        found[group] = near @ (flat[group] * area[group, None])
    found /= np.maximum(np.linalg.norm(found, axis=1, keepdims=True), 1e-15)
    return found.reshape(-1, 3, 3)
