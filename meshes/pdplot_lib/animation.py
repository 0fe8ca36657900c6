"""All steps of a run as a moving picture."""
import shutil
import subprocess
from io import BytesIO
from pathlib import Path

from . import figures
from .results import PlotError


def animation(results, view, file_name, steps, frames_per_second):
    """GIF, or MP4 by the program ffmpeg; the limits of the colours do not change."""
    kind = Path(file_name).suffix.lower()
    if kind not in (".gif", ".mp4"):
        raise PlotError(f"--animate {file_name}: expected a name that ends in .gif or .mp4")
    if kind == ".mp4" and shutil.which("ffmpeg") is None:
        raise PlotError(f"--animate {file_name}: MP4 needs ffmpeg (Debian: apt install ffmpeg); .gif does not")
    if not frames_per_second > 0:
        raise PlotError(f"--speed {frames_per_second:g}: expected frames a second, above zero")
    panels = [(results, step, "") for step in steps]
    view.limits = view.limits or figures.common_limits(panels, view)
    if view.scale:
        view.window = figures.common_window(panels, view)
    try:
        (_write_gif if kind == ".gif" else _write_mp4)(_frames(results, view, steps), file_name, frames_per_second)
    except OSError as error:
        raise PlotError(f"{file_name}: cannot be written: {error.strerror or error}") from None


def _frames(results, view, steps):
    for step in steps:
        figure = figures.map_panels([(results, step, figures.step_title(results, step, view))], view)
        buffer = BytesIO()
        # All frames of one size: nothing is cut to what is in it.
        with figures.plt.rc_context({"savefig.bbox": None}):
            figure.savefig(buffer, format="png", dpi=90)
        figures.plt.close(figure)
        yield buffer


def _write_gif(frames, file_name, frames_per_second):
    from PIL import Image
    images = [Image.open(frame).convert("RGB").convert("P", palette=Image.Palette.ADAPTIVE, colors=128)
              for frame in frames]
    images[0].save(file_name, save_all=True, append_images=images[1:], duration=int(1000 / frames_per_second), loop=0)


def _write_mp4(frames, file_name, frames_per_second):
    # yuv420p, which every player knows, takes even numbers of pixels.
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate", str(frames_per_second), "-i",
               "-", "-vf", "scale=trunc(iw/2)*2:trunc(ih/2)*2", "-pix_fmt", "yuv420p", str(file_name)]
    run = subprocess.run(command, input=b"".join(frame.getvalue() for frame in frames), stderr=subprocess.PIPE)
    if run.returncode:
        raise PlotError(f"{file_name}: ffmpeg failed: {run.stderr.decode(errors='replace').strip()}")
