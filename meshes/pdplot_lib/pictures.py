"""Pictures as files, marked as ours."""
import os
from pathlib import Path

from .results import PlotError


def is_ours(path, program):
    """Whether `program` has written the picture, a PNG file."""
    try:
        with open(path, "rb") as file:
            return f"Software\0{program}".encode() in file.read(4096)
    except OSError:
        return False


def save(figure, output, program, is_named):
    """Writes the figure and closes it. `is_named`: a user has named the file; else the name, which ends in .png, is made
    of others, and what stands there is replaced, as a whole, only where `program` wrote it. Throws PlotError."""
    from .figures import plt
    output = Path(output)
    is_png = output.suffix.lower() in (".png", "")
    if not is_named and os.path.lexists(output) and (output.is_symlink() or not is_ours(output, program)):
        raise PlotError(f"{output}: is there already and is no picture that {program} made; name another file (-o)")
    target = output if is_named else output.with_name(f"{output.name}.{program}-unfinished")
    try:
        figure.savefig(target, dpi=150, format=None if is_named else "png",
                       metadata={"Software": program} if is_png else None)
        if not is_named:
            os.replace(target, output)
    except (OSError, ValueError) as error:
        raise PlotError(f"{output}: cannot be written: {error}") from None
    finally:
        plt.close(figure)
