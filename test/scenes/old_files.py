"""Files that earlier versions have written: gone on from to the same end, or refused by name."""
import os
import xml.etree.ElementTree as xml

import h5py
import numpy

from runs import WORK, claim, epafi, finish, fresh, scene, table

os.makedirs(WORK, exist_ok=True)
ORDER = ("edge", "degree", "position", "indicators", "outline", "multiplier", "rigid",
         "contact_state", "friction_state", "displacement", "density")
OF_PATH = ("path_t", "path_iterations", "path_multiplier", "path_rigid")
OF_STEPS = ("step_t", "step_displacement", "step_density")


def reseal(file):
    """The checksum of what the file holds now."""
    group = file["Epafi"]
    number = lambda name: numpy.ravel(group.attrs[name])[0]
    text = lambda name: group[name][()] if name in group else b""
    array = lambda name: group[name][:].tobytes() if name in group else b""
    parts = [numpy.array([number("level"), number("converged")], "<i4").tobytes(),
             numpy.array([number("seconds_total"), number("seconds_wall")], "<f8").tobytes(),
             text("reason") + text("used") + text("history"), array("bodies"),
             array("rigid_bodies"), text("resultants"), *map(array, ORDER)]
    if "path_t" in group:
        parts += [text("steps"), numpy.array([number("complete")], "<i4").tobytes(),
                  *map(array, OF_PATH + OF_STEPS)]
    value = 14695981039346656037
    for byte in b"".join(parts):
        value = (value ^ byte) * 1099511628211 & (1 << 64) - 1
    kind = group.attrs.get_id("checksum").dtype
    if value == number("checksum"):
        return True
    group.attrs.modify("checksum", numpy.array([value], kind))
    return False


def written(text):
    """used.xml as it was when every body was displaced by 0."""
    root = xml.fromstring(text)
    for body in root.find("ParameterList[@name='Bodies']"):
        motion = body.find("ParameterList[@name='Motion']")
        if motion is None:
            motion = xml.SubElement(body, "ParameterList", name="Motion")
        for key in ("Displacement X", "Displacement Y", "Rotation"):
            if motion.find("Parameter[@name='%s']" % key) is None:
                xml.SubElement(motion, "Parameter", name=key, type="string", value="0",
                               isDefault="true")
    return xml.tostring(root)


def solve(name, file, *arguments):
    folder = fresh(name)
    code, text = epafi("run", file, "--quiet", "--output", folder, *arguments)
    claim(code == 0, name + ": solved" + ("" if code == 0 else text[-300:]))
    return folder


for name in ("rounded-punch", "tresca"):
    base = [scene(name + ".xml"), "--set", "Adaptivity->Strategy=Adaptive h"]
    two = ["--set", "Adaptivity->Maximum Levels=2"]
    whole = solve(name + " two levels", *base, *two)
    old = solve(name + " one level", *base, "--set", "Adaptivity->Maximum Levels=1")
    with h5py.File(os.path.join(old, "solution.hdf"), "r+") as file:
        claim(reseal(file), name + ": the checksum is that of doc/solution-file.md")
        group = file["Epafi"]
        used = written(group["used"][()])
        del group["used"]
        group["used"] = numpy.bytes_(used)
        if "rigid_bodies" in group:
            del group["rigid_bodies"]
            group.attrs.modify("format", numpy.array([2], "<i4"))
        reseal(file)
    code, text = epafi("run", *base, *two, "--quiet", "--restart", old)
    claim(code == 0, name + ": an earlier version's file is gone on from " + text[-300:])
    ends = [table(os.path.join(folder, "history.csv")) for folder in (whole, old)]
    claim(len(ends[1]) == 2 and all(
        ends[0][1][key] == ends[1][1][key] for key in ("dof", "energy_strain", "estimate", "contact_y")),
        name + ": to the same end")

path = solve("path", scene("fretting.xml"), "--set", "History->Times={1, 2}", "--set",
             "History->Steps={1, 1}", "--set",
             "Discretization->Elements per Edge={2, 2, 2, 3, 20, 3, 2, 2, 2, 3, 3, 3}")
with h5py.File(os.path.join(path, "solution.hdf"), "r+") as file:
    claim(reseal(file), "path: the checksum is that of doc/solution-file.md")
    for name in OF_STEPS:
        del file["Epafi"][name]
    reseal(file)
code, text = epafi("fields", path, "--step", "1")
claim(code == 1 and "kept the last step alone" in text, "--step of an older file is refused: " + text.strip())
code, text = epafi("fields", path, "--grid", "4,4")
claim(code == 0, "its last step is not " + text)
finish()
