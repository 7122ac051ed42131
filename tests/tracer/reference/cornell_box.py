"""Renders data/gallery/cornell_box.nff with Mitsuba 3, as the image that our path tracer must agree with.

    python cornell_box.py SCENE.nff OUT [--size 64] [--passes 16] [--spp 2048]

Of NFF and our extension it reads what that scene has: v, b 0 0 0, `surface lambert colour`, p, and
`light rectangle ... visible`. OUT.exr gets the mean of the passes, linear RGB, 32-bit float;
OUT_error.exr the standard error of that mean, of each pixel, from the passes' scatter, 16-bit float.
"""
import argparse
import dataclasses

import numpy
import mitsuba

VIEW_FIELDS = {"from": 3, "at": 3, "up": 3, "angle": 1, "hither": 1, "resolution": 2}
BLOCK = 8  # pixels along the blocks whose noise is printed, as tests/tracer/cornell_test.cpp has them


@dataclasses.dataclass
class Box:
    view: dict = dataclasses.field(default_factory=dict)
    surfaces: list = dataclasses.field(default_factory=list)  # (colour, [polygon])
    lamp: dict = dataclasses.field(default_factory=dict)


class Words:
    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            lines = (line.split("#")[0] for line in file)
            self._words = " ".join(lines).split()[::-1]

    def __bool__(self):
        return bool(self._words)

    def word(self, *expected):
        word = self._words.pop()
        if expected and word not in expected:
            raise ValueError(f"{word!r}: this script reads {', '.join(expected)} here")
        return word

    def numbers(self, count):
        return [float(self._words.pop()) for _ in range(count)]


def read_view(words, box):
    for _ in VIEW_FIELDS:
        field = words.word(*VIEW_FIELDS)
        box.view[field] = words.numbers(VIEW_FIELDS[field])


def read_background(words, _):
    if any(words.numbers(3)):
        raise ValueError("the background is taken to be black")


def read_surface(words, box):
    words.word("lambert")
    words.word("colour")
    box.surfaces.append((words.numbers(3), []))


def read_polygon(words, box):
    corners = int(words.word())
    box.surfaces[-1][1].append([words.numbers(3) for _ in range(corners)])


def read_light(words, box):
    words.word("rectangle")
    for field in ("corner", "u", "v", "radiance"):
        box.lamp[field] = numpy.array(words.numbers(3))
    words.word("visible")


ENTITIES = {"v": read_view, "b": read_background, "surface": read_surface, "p": read_polygon, "light": read_light}


def read_nff(path):
    words, box = Words(path), Box()
    while words:
        ENTITIES[words.word(*ENTITIES)](words, box)
    return box


def reflecting(colour, polygons):
    """One mesh of all polygons of a colour, each the fan round its first corner, matt on both sides."""
    points, faces = [], []
    for polygon in polygons:
        first = len(points)
        points += polygon
        faces += [(first, first + i, first + i + 1) for i in range(1, len(polygon) - 1)]
    properties = mitsuba.Properties()
    properties["surface"] = mitsuba.load_dict(
        {"type": "twosided", "matt": {"type": "diffuse", "reflectance": {"type": "rgb", "value": colour}}}
    )
    mesh = mitsuba.Mesh("surface", len(points), len(faces), props=properties)
    parameters = mitsuba.traverse(mesh)
    parameters["vertex_positions"] = numpy.ravel(points).astype(numpy.float32)
    parameters["faces"] = numpy.ravel(faces).astype(numpy.uint32)
    parameters.update()
    return mesh


def shining(lamp):
    """A square of edge 2 on its sides; it shines to the side of u x v, as ours does."""
    normal = numpy.cross(lamp["u"], lamp["v"])
    place = numpy.identity(4)
    place[:3, 0] = lamp["u"] / 2
    place[:3, 1] = lamp["v"] / 2
    place[:3, 2] = normal / numpy.linalg.norm(normal)
    place[:3, 3] = lamp["corner"] + (lamp["u"] + lamp["v"]) / 2
    return {
        "type": "rectangle",
        "to_world": mitsuba.ScalarTransform4f(place),
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}},
        "emitter": {"type": "area", "radiance": {"type": "rgb", "value": list(lamp["radiance"])}},
    }


def camera(view, size):
    """NFF's angle is that of the image's whole height."""
    to_world = mitsuba.ScalarTransform4f().look_at(origin=view["from"], target=view["at"], up=view["up"])
    return {
        "type": "perspective",
        "fov": view["angle"][0],
        "fov_axis": "y",
        "to_world": to_world,
        "film": {
            "type": "hdrfilm",
            "width": size,
            "height": size,
            "pixel_format": "rgb",
            "component_format": "float32",
            "rfilter": {"type": "box"},
        },
        "sampler": {"type": "independent"},
    }


def scene_of(box, size):
    scene = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": -1},
        "camera": camera(box.view, size),
        "lamp": shining(box.lamp),
    }
    for number, (colour, polygons) in enumerate(box.surfaces):
        scene[f"surface{number}"] = reflecting(colour, polygons)
    return mitsuba.load_dict(scene)


def blocks(images):
    """Means of blocks: passes x rows x columns x channels."""
    passes, rows, columns, channels = images.shape
    return images.reshape(passes, rows // BLOCK, BLOCK, columns // BLOCK, BLOCK, channels).mean(axis=(2, 4))


def standard_error(passes):
    """Of the mean over passes."""
    return passes.std(axis=0, ddof=1) / numpy.sqrt(len(passes))


def largest_share(passes):
    return (standard_error(passes) / passes.mean(axis=0)).max()


def write(image, component, path):
    mitsuba.Bitmap(image.astype(component)).write(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene")
    parser.add_argument("out")
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--passes", type=int, default=16)
    parser.add_argument("--spp", type=int, default=2048)
    parser.add_argument("--variant", default="scalar_rgb")
    arguments = parser.parse_args()

    mitsuba.set_variant(arguments.variant)
    scene = scene_of(read_nff(arguments.scene), arguments.size)
    passes = numpy.stack(
        [numpy.array(mitsuba.render(scene, spp=arguments.spp, seed=seed)) for seed in range(arguments.passes)]
    )
    write(passes.mean(axis=0), numpy.float32, arguments.out + ".exr")
    write(standard_error(passes), numpy.float16, arguments.out + "_error.exr")
    print(f"Mitsuba {mitsuba.__version__}, {arguments.variant}, {arguments.passes} x {arguments.spp} samples per pixel")
    print(f"mean {passes.mean(axis=(0, 1, 2))}, largest relative standard error:")
    print(f"  of the image's mean  {largest_share(passes.mean(axis=(1, 2))):.2e}")
    print(f"  of a block of {BLOCK} x {BLOCK}  {largest_share(blocks(passes)):.2e}")


if __name__ == "__main__":
    main()
