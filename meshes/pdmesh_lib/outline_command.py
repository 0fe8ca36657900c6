"""The command `pdmesh outline`."""
import os
import sys

import numpy as np

from .command_options import positive
from .errors import MeshError


def add_outline(commands):
    command = commands.add_parser(
        "outline", help="voids in an image to polygons for a deck",
        description="Outlines of the dark (or bright) parts of an image, of a section or a slice of a tomography, as "
                    "corners of polygons, a line `polygon x y` each: what `Type: Polygon List` of Voids in a deck reads. "
                    "Each is the line half-way between dark and bright, by marching squares; void at the border of the "
                    "image goes on two pixels beyond it. Material that is enclosed by a void is left out.")
    command.add_argument("image", help="PNG, TIFF or any other image that Pillow reads; colours become grey")
    command.add_argument("-o", "--output", required=True, help="list of polygons to write")
    command.add_argument("--pixel", type=float, required=True, metavar="M", help="edge of a pixel (m)")
    command.add_argument("--origin", type=float, nargs=2, default=[0.0, 0.0], metavar=("X", "Y"),
                         help="where the lower left corner of the image is in the body (m); default 0 0")
    command.add_argument("--void", choices=["dark", "bright"], default="dark", help="what is void; default dark")
    command.add_argument("--threshold", type=float, metavar="GREY",
                         help="grey value between void and material; default half-way between darkest and brightest")
    command.add_argument("--smooth", type=float, default=1.0, metavar="PIXELS",
                         help="Gaussian by which the steps of pixels are smoothed first; default 1, 0 for none")
    command.add_argument("--tolerance", type=float, default=0.1, metavar="PIXELS",
                         help="corners that move an outline by less are left out; default 0.1, 0 keeps all")
    command.add_argument("--smallest", type=float, default=0.0, metavar="PIXELS",
                         help="voids with less area are left out; default 0")
    command.add_argument("--frame", type=int, default=1, metavar="N", help="of a file with several images; default 1")
    command.add_argument("--quiet", action="store_true", help="no report; warnings stay")
    command.set_defaults(run=_outline)


def _outline(options):
    from . import outline  # its libraries take a while to load

    positive(options, "pixel")
    for name in ("smooth", "tolerance", "smallest"):
        if not (getattr(options, name) >= 0 and np.isfinite(getattr(options, name))):
            raise MeshError(f"--{name} must not be negative, but is {getattr(options, name):g}")
    if not np.isfinite(options.origin).all():
        raise MeshError(f"--origin must be two finite numbers, but is {options.origin[0]:g} {options.origin[1]:g}")
    if options.pixel > 1e6:
        raise MeshError(f"--pixel {options.pixel:g} is more than 1e6 m: it is the edge of one pixel, in metres")
    if os.path.exists(options.output) and os.path.exists(options.image) and os.path.samefile(options.output, options.image):
        raise MeshError(f"--output {options.output} is the image itself; give the list of polygons another name")
    level = outline.voids_of(_grey(options.image, options.frame), options.void == "bright", options.threshold)
    polygons, islands, n_corners = outline.outlines(level, options.smooth, options.tolerance)
    _require_material(outline, options, level, polygons, islands)
    areas = [outline.area_of(polygon) for polygon in polygons]
    kept = [(polygon, area) for polygon, area in zip(polygons, areas) if area >= options.smallest]
    if not kept:
        raise MeshError(f"{options.image} has no void" + (f" of {options.smallest:g} pixels or more" if areas else "") +
                        f"; its {options.void} parts would be voids, see --void, --threshold and --smallest")
    _write(options, [polygon for polygon, _ in kept], level.shape)
    if not options.quiet:
        inside = outline.share_of([polygon for polygon, _ in kept], level.shape)
        print(f"{options.output}: pdmesh outline of {os.path.basename(options.image)}, {level.shape[1]} x {level.shape[0]} "
              f"pixels, {level.shape[1] * options.pixel:.6g} m x {level.shape[0] * options.pixel:.6g} m")
        print(f"  {len(kept)} polygons with {sum(len(polygon) for polygon, _ in kept)} corners ({n_corners} before "
              f"--tolerance); voids have {inside:.5g} of the image, by pixels {outline.share_by_pixels(level):.5g}")
    if len(kept) < len(polygons):
        print(f"pdmesh: warning: {len(polygons) - len(kept)} voids of less than {options.smallest:g} pixels are left out",
              file=sys.stderr)
    n_islands = sum(len(areas) for areas in islands)
    if n_islands:
        print(f"pdmesh: warning: {n_islands} islands of material within voids are left out: they hang on nothing",
              file=sys.stderr)
    _warn_of_lost_voids(outline, options, level, polygons)


def _require_material(outline, options, level, polygons, islands):
    """Refuses images in which void is all around the material: that would be left out as an island."""
    loose = sum(sum(areas) for polygon, areas in zip(polygons, islands) if outline.reaches_border(polygon, level.shape))
    if loose > 0.05 * np.sum(level <= 0):
        raise MeshError(f"{options.image}: void that reaches the border of the image is all around material of "
                        f"{loose:.4g} pixels, which would be left out as an island; cut the image to the specimen, paint "
                        "what is outside of it as material, or see whether --void is right")


def _warn_of_lost_voids(outline, options, level, polygons):
    lost = outline.lost_voids(level, options.smooth)
    if len(lost):
        print(f"pdmesh: warning: {len(lost)} voids of pixels have no polygon, the largest of {lost.max()} pixels: they are "
              f"smoothed away; give less to --smooth than {options.smooth:g}", file=sys.stderr)
    found, pixels = outline.share_of(polygons, level.shape), outline.share_by_pixels(level)
    if abs(found - pixels) > 0.05 * pixels:
        print(f"pdmesh: warning: polygons have {found:.4g} of the image, their pixels {pixels:.4g}: voids are small for "
              f"--smooth {options.smooth:g} and --tolerance {options.tolerance:g}; give less, or an image with more "
              "pixels", file=sys.stderr)


def _grey(file_name, frame):
    """[rows, columns] grey values."""
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(file_name) as image:
            frames = getattr(image, "n_frames", 1)
            if not 1 <= frame <= frames:
                raise MeshError(f"--frame {frame}: {file_name} has {frames} image{'s' if frames > 1 else ''}")
            image.seek(frame - 1)
            # Modes whose pixels are one number each are taken as they are: 16 bits too.
            is_grey = image.mode in ("1", "L", "I", "F") or image.mode.startswith("I;16")
            values = np.asarray(image if is_grey else image.convert("RGB").convert("L"), dtype=float)
    except Image.DecompressionBombError:
        raise MeshError(f"{file_name}: has more than {2 * Image.MAX_IMAGE_PIXELS} pixels; cut it into parts, or make it "
                        "smaller") from None
    except UnidentifiedImageError:
        raise MeshError(f"{file_name}: no image that Pillow can read; save it as PNG or TIFF") from None
    except (OSError, SyntaxError) as error:
        raise MeshError(f"{file_name}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if min(values.shape) < 2 or not np.isfinite(values).all():
        raise MeshError(f"{file_name}: needs two pixels or more each way, with finite values")
    return values


def _write(options, polygons, shape):
    origin = np.array(options.origin)
    try:
        with open(options.output, "w") as file:
            file.write(f"# pdmesh outline of {os.path.basename(options.image)}: {shape[1]} x {shape[0]} pixels of "
                       f"{options.pixel!r} m, lower left corner at {origin[0]!r} {origin[1]!r}\n# polygon x y\n")
            for number, polygon in enumerate(polygons, 1):
                for x, y in (origin + options.pixel * polygon).tolist():
                    file.write(f"{number} {x!r} {y!r}\n")
    except OSError as error:
        raise MeshError(f"--output {options.output} cannot be written: {error.strerror}") from None
