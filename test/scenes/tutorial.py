"""The tutorial as a reader follows it: its scene, what it says the screen shows, its commands one
after the other, its study."""
import math
import os
import re
import shlex
import subprocess

from runs import EPAFI, SCENES, claim, finish, fresh, read, table, write

PAGE = os.path.join(SCENES, "..", "..", "doc", "tutorial.md")
HERE = fresh("reader")
os.makedirs(HERE)
page = read(PAGE)


def follow(words):
    done = subprocess.run([EPAFI, *words], cwd=HERE, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    return done.returncode, done.stdout


def put(name, text):
    write(os.path.join(HERE, name), text)


def numbers(line):
    return [float(word) for word in re.split(r"[ /]+|(?<=\d)-(?=\d)", line.strip())
            if re.fullmatch(r"[-+.\de]+", word)]


def alike(said, shown):
    """Are a page's lines those of the screen, numbers to 1e-3, columns on the right left out?"""
    rows = [numbers(line) for line in said]
    return len(said) == len(shown) and all(
        len(row) <= len(numbers(line)) and all(math.isclose(a, b, rel_tol=1e-3)
                                               for a, b in zip(row, numbers(line)))
        for row, line in zip(rows, shown))


def same_rows(*folders):
    first, second = (table(os.path.join(HERE, folder, "history.csv")) for folder in folders)
    return len(first) == len(second) and all(
        a[key] == b[key] or math.isclose(a[key], b[key], rel_tol=1e-9)
        for a, b in zip(first, second) for key in ("dof", "energy_strain", "force_normal"))


put("block.yaml", "".join(re.findall(r"```yaml\n(.*?)```", page, re.S)))
put("mine.csv", "0,0.5\n0.5,0.25\n")
answers = re.findall(r"```text\n(.*?)```", page, re.S)
commands = re.findall(r"^    (?:build/bin/epafi|\./run) ([^\n]*?\S)(?:  .*)?$", page, re.M)
for line in commands:
    words = shlex.split(line)
    if words[0].endswith(".yaml"):
        words.insert(0, "run")
    code, text = follow(words)
    claim(code == 0, "epafi %s: exit %d %s" % (line, code, text.strip()[-100:]))
    if words[0] == "check" and "--plot" not in words:
        claim(text == answers[0], "check prints what the page says:\n" + text)
    if words == ["run", "block.yaml"]:
        said = [row for row in answers[1].splitlines() if re.match(r" +\d+ ", row)]
        shown = [row for row in text.splitlines() if re.match(r" +\d+ ", row)]
        claim(len(said) > 4 and alike(said, shown), "and run:\n" + text)
claim(len(commands) >= 9, "%d commands" % len(commands))

put("block.xml", "".join(re.findall(r"```xml\n(.*?)```", page, re.S)))
code, text = follow(["run", "block.xml", "--output", "xml.out"])
claim(code == 0 and same_rows("block.out", "xml.out"), "XML says the same: " + text[-80:])
for first, second in (("yaml", "xml"), ("xml", "yaml")):
    code, text = follow(["check", "block." + first, "--format", second])
    put("printed." + second, text)
    code, again = follow(["check", "printed." + second, "--format", "yaml"])
    claim(code == 0 and again == follow(["check", "block." + first, "--format", "yaml"])[1],
          "printed as %s and read again: %s" % (second, again[:80]))
study = re.search(r"^    Friction of the block:\n(?:     .*\n)*", page, re.M)[0]
put("friction.yaml", re.sub("^    ", "", study, flags=re.M))
code, text = follow(["study", "friction.yaml"])
claim(code == 0 and "pictures ./friction.out: sweep sweep_forces sweep_contact" in text,
      "the study: " + text[-80:])

# the scene of the first page, and what is said of it
front = read(os.path.join(SCENES, "..", "..", "README.md"))
put("lug.yaml", re.search(r"```yaml\n(.*?)```", front, re.S)[1])
code, text = follow(["run", "lug.yaml"])
last = table(os.path.join(HERE, "lug.out", "history.csv"))[-1]
rim = [point["von_mises"] for point in table(os.path.join(HERE, "lug.out", "boundary.csv"))
       if point["boundary"] == "lug:bore"]
claim(code == 0 and math.isclose(last["bearing.pressure_max"], 63.5, rel_tol=2e-3) and
      math.isclose(max(rim), 157, rel_tol=5e-3), "README: the pin presses by %.4g, the bore bears %.4g" % (
          last["bearing.pressure_max"], max(rim)))
finish()
