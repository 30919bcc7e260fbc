"""What printed_models.sh says."""

import ctypes
import pathlib
import re
import subprocess
import sys

carom, out = sys.argv[1], pathlib.Path(sys.argv[2])
try:
    lib3mf = ctypes.CDLL("lib3MF.so.1")
except OSError:
    print("skipped: lib3MF.so.1 is not installed")
    sys.exit(77)


def fail(words):
    print("FAILED:", words)
    sys.exit(1)


def export(game, file):
    """Returns the triangles, the size in millimetres and the volume in cm³ that are told."""
    done = subprocess.run([carom, "export", game, "--spacetime", file, "--until", "5"], capture_output=True,
                          encoding="utf-8")  # fmt: skip
    told = done.stdout + done.stderr
    size = re.search(r"(\d+) × (\d+) × (\d+) mm, (\d+) triangles", told)
    volume = re.search(r"have ([\d.]+) cm³", told)
    if done.returncode or not size or not volume:
        fail(f"{file}: {told}")
    return int(size[4]), [int(size[k]) for k in (1, 2, 3)], float(volume[1])


def check(file, found, told):
    """Of both: triangles, size, volume."""
    if found[0] != told[0]:
        fail(f"{file}: {found[0]} triangles, {told[0]} were told")
    if any(abs(a - b) > 0.6 for a, b in zip(found[1], told[1])):
        fail(f"{file}: {found[1]} mm, {told[1]} were told")
    if abs(found[2] - told[2]) > 0.06:
        fail(f"{file}: {found[2]} cm³, {told[2]} were told")


def by_admesh(file):
    told = subprocess.run(["admesh", file], capture_output=True, encoding="utf-8").stdout

    def number(words):
        return float(re.search(re.escape(words) + r"\s*[:=]\s*(-?[\d.]+)", told)[1])

    for fault in ("Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                  "Facets reversed", "Backwards edges", "Normals fixed"):  # fmt: skip
        if number(fault):
            fail(f"{file}: {fault}: {number(fault):.0f}")
    size = [number(f"Max {axis}") - number(f"Min {axis}") for axis in "XYZ"]
    return int(number("Number of facets")), size, number("Volume") / 1000.0


def ask(name, *arguments):
    if code := getattr(lib3mf, "lib3mf_" + name)(*arguments):
        fail(f"lib3mf_{name}: error {code:#x}")


def pointer(name, *arguments):
    made = ctypes.c_void_p()
    ask(name, *arguments, ctypes.byref(made))
    return made


def number(name, *arguments):
    """Also the truth of something."""
    told = ctypes.c_uint32()
    ask(name, *arguments, ctypes.byref(told))
    return told.value


def by_lib3mf(file):
    model = pointer("createmodel")
    ask("reader_readfromfileutf8", pointer("model_queryreader", model, b"3mf"), str(file).encode())
    meshes = pointer("model_getmeshobjects", model)
    triangles, volume_mm3, corners = 0, 0.0, []
    place, triangle = (ctypes.c_float * 3)(), (ctypes.c_uint32 * 3)()
    while number("resourceiterator_movenext", meshes):
        mesh = pointer("resourceiterator_getcurrent", meshes)
        if not number("meshobject_ismanifoldandoriented", mesh) & 0xFF:
            fail(f"{file}: a part is open or turned inside out")
        points = []
        for i in range(number("meshobject_getvertexcount", mesh)):
            ask("meshobject_getvertex", mesh, i, ctypes.byref(place))
            points.append(tuple(place))
        corners += points
        count = number("meshobject_gettrianglecount", mesh)
        for i in range(count):
            ask("meshobject_gettriangle", mesh, i, ctypes.byref(triangle))
            a, b, c = (points[k] for k in triangle)
            volume_mm3 += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                           + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0  # fmt: skip
        triangles += count
    if not corners:
        fail(f"{file}: no mesh")
    size = [max(corner[k] for corner in corners) - min(corner[k] for corner in corners) for k in range(3)]
    return triangles, size, volume_mm3 / 1000.0


for game in ("two-cushions", "bar-meets-bar", "english"):
    for ending, read in ((".stl", by_admesh), (".3mf", by_lib3mf)):
        file = out / (game + ending)
        told = export(game, file)
        found = read(file)
        check(file.name, found, told)
        size = " x ".join(f"{mm:.1f}" for mm in found[1])
        print(f"{file.name}: {found[0]} triangles, {size} mm, {1000.0 * found[2]:.0f} mm3, closed")
