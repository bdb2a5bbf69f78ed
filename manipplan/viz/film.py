"""An animated figure, written as the frames of a GIF or an MP4 file."""

import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import numpy as np

from manipplan.support.checks import Array
from manipplan.support.progress import Progress

#: Time for which a GIF shows its last frame before it repeats [s].
HOLD = 1.0


@dataclass(frozen=True, kw_only=True)
class Film:
    """An animated figure and its frames.

    Attributes:
        figure: a Matplotlib figure.
        show: updates the figure to a time [s].
        times: (k,) times of the frames [s].
        fps: frames per second.
        colours: number of colours of a GIF.
        tell: progress callback.
    """

    figure: Any
    show: Callable[[float], None]
    times: Array
    fps: float
    colours: int
    tell: Progress

    def write_gif(self, stream: IO[bytes]) -> None:
        """Write the frames as a GIF, with durations in hundredths of a second and `HOLD` for the last frame."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from PIL import Image

        canvas: Any = FigureCanvasAgg(self.figure)

        def picture(time: float) -> Any:
            self.show(time)
            canvas.draw()
            return Image.fromarray(np.asarray(canvas.buffer_rgba())[:, :, :3].copy())

        palette = _palette([picture(time) for time in self.times[[0, len(self.times) // 2, -1]]], self.colours)
        frames = [picture(time).quantize(palette=palette, dither=Image.Dither.NONE) for time in self._told()]
        ends = np.round(100 * np.arange(len(frames)) / self.fps).astype(int)
        shown = [*(10 * np.diff(ends)).tolist(), int(1000 * HOLD)]
        frames[0].save(stream, format="GIF", save_all=True, append_images=frames[1:], duration=shown, loop=0)

    def write_mp4(self, stream: IO[bytes]) -> None:
        """Write the frames as an MP4 with ffmpeg."""
        from matplotlib.animation import FFMpegWriter
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        FigureCanvasAgg(self.figure)
        writer: Any = FFMpegWriter(fps=self.fps)  # type: ignore[arg-type]  # ffmpeg takes any rate
        with tempfile.TemporaryDirectory() as folder:  # ffmpeg seeks to the start of its file, which a stream may not allow
            file = Path(folder) / "film.mp4"
            with writer.saving(self.figure, str(file), self.figure.dpi):
                for time in self._told():
                    self.show(time)
                    writer.grab_frame()
            stream.write(file.read_bytes())

    def _told(self) -> Iterator[float]:
        for k, time in enumerate(self.times.tolist()):
            self.tell(k / len(self.times), f"frame {k + 1} of {len(self.times)}")
            yield time


def _palette(frames: list[Any], colours: int) -> Any:
    """One palette for all frames, so that static parts look the same in each.

    Half of it holds the most frequent colours, such as background and lines; the other half approximates the rest.
    """
    from PIL import Image

    width, height = frames[0].size
    some = Image.new("RGB", (width, len(frames) * height))
    for k, frame in enumerate(frames):
        some.paste(frame, (0, k * height))
    counted: Any = sorted(some.getcolors(width * height * len(frames)) or (), reverse=True)
    entries = [value for _, colour in counted[: colours // 2] for value in colour]
    others = some.quantize(colours - len(entries) // 3, method=Image.Quantize.MAXCOVERAGE, kmeans=1, dither=Image.Dither.NONE)
    palette = Image.new("P", (1, 1))
    palette.putpalette((entries + (others.getpalette() or []))[: 3 * colours])
    return palette
