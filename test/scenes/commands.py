"""Commands, options and schemas: one table says what the parser, the help, the man page, the
completion and editors know."""
import json
import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as xml

from runs import (SCENES, WORK, claim, epafi, fails, finish, fresh, keys_of, raises, read, rows,
                  scene, write)

code, usage = epafi("--help")
names = re.findall(r"^  epafi ([a-z]+)", usage, re.M)
claim(code == 0 and {"run", "study", "check", "parameters", "plot", "schema", "version",
                     "help"} <= set(names), "the commands: " + " ".join(names))
code, man = epafi("help", "--format", "man")
code, completion = epafi("help", "--format", "bash")
for name in names:
    code, text = epafi(name, "--help")
    claim(code == 0 and text.startswith("usage: epafi " + name), name + " --help")
    code, other = epafi("help", name)
    claim(code == 0 and other == text, "epafi help " + name)
    options = re.findall(r"^  (--[a-z]+)", text, re.M)
    claim(all(option in usage for option in options) and
          all(option.replace("-", r"\-") in man for option in options) and
          all(option in completion for option in options),
          "%s's options stand in all pages: %s" % (name, " ".join(options)))
    fails("%s: an unknown option" % name, ["'--help'"], name, "--hepl")
# the Python that draws
os.environ["EPAFI_PYTHON"] = os.path.join(WORK, "nopython")
if os.path.exists(os.environ["EPAFI_PYTHON"]):
    os.remove(os.environ["EPAFI_PYTHON"])
fails("a Python that is none", ["nopython' cannot be started", "EPAFI_PYTHON"], "plot", WORK)
with open(os.environ["EPAFI_PYTHON"], "w") as stream:
    stream.write('#!/bin/sh\necho "another one: $(basename "$1")"\n')
os.chmod(os.environ["EPAFI_PYTHON"], 0o755)
claim(epafi("plot", WORK) == (0, "another one: __main__.py\n"), "the Python that EPAFI_PYTHON names draws")
del os.environ["EPAFI_PYTHON"]
fails("a wrong command is answered by the list of commands", ["  " + name for name in names], "solve")
fails("a scene without a command: how to run it", ["epafi run "], scene("tresca.xml"))
study = os.path.join(SCENES, "..", "studies", "ablation.xml")
for arguments, words in [(("run", study), "epafi study " + study),
                         (("study", scene("tresca.xml")), "epafi run " + scene("tresca.xml"))]:
    fails("a study is no scene, nor the other way", [words], *arguments)
for arguments, words in [
        (["--output", "a", "--output", "b"], "2 times"), (["--output="], "needs a value"),
        (["--force=yes"], "takes no value"), (["--output", ""], "empty")]:
    fails(" ".join(arguments), [words], "run", scene("tresca.xml"), *arguments)

# the completion completes
script = os.path.join(WORK, "completion.bash")
write(script, completion)


def completed(*words):
    line = "source %s; COMP_WORDS=(%s); COMP_CWORD=%d; _epafi; printf '%%s\\n' \"${COMPREPLY[@]}\"" % (
        script, " ".join("'%s'" % word for word in words), len(words) - 1)
    done = subprocess.run(["bash", "-c", line], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, cwd=SCENES)
    return sorted(done.stdout.split()) if not done.stderr else [done.stderr]


claim(completed("epafi", "s") == ["schema", "study"], "commands are completed")
claim(completed("epafi", "run", "--q") == ["--quiet"], "options are completed")
claim(completed("epafi", "run", "tr") == ["tresca.xml"], "scenes are completed")
claim(completed("epafi", "schema", "--format", "j") == ["json"], "words are completed")

# what --set can do to a list
BOUNDARY = "Bodies->block->Boundary Conditions->foundation"
for sentence, settings, ok, words in [
        ("a law is replaced", [BOUNDARY + "->Friction={Law=Tresca, Threshold=max(x, 0.1)}"],
         True, ""),
        ("a list with a list in it",
         ["Adaptivity={Strategy=Graded hp, Grading={Ratio=0.2}}"], True, "Graded hp"),
        ("a list is removed", ["Adaptivity="], True, "None"),
        ("blanks around =", ["Adaptivity->Strategy = Graded hp"], True, "Graded hp"),
        ("an array needs braces", ["Discretization->Elements per Edge=8, 4"], False, "{8, 4}"),
        ("a key is removed, another one set",
         ["Discretization->Elements per Edge=", "Discretization->Mesh Size=0.5"], True, ""),
        ("a key within a replaced list is checked", ["Adaptivity={Strateg=None}"], False,
         "'Strategy'"),
        ("what a law needs is still wanted", [BOUNDARY + "->Friction={Law=Tresca}"], False,
         "Threshold"),
        ("what is not there cannot be removed", ["Output->Fields="], False, "not in the scene"),
        ("a key for NOX", ["Solver->NOX->Line Search->Method=Backtrack"], True, ""),
        ("a list for NOX is no value", ["Solver->NOX=Backtrack"], False, "{Key=value"),
        ("a list is no value", ["Adaptivity=None"], False, "{Key=value")]:
    code, text = epafi("check", scene("coulomb.xml"), settings=settings)
    claim((code == 0) == ok and words in text, "--set: %s (%s)" %
          (sentence, "accepted" if code == 0 else text.strip()[:120]))

# where the schema declares no types, they are those of a YAML file
code, text = epafi("check", scene("coulomb.xml"), "--used", settings=[
    "Solver->NOX={Line Search={Method=Full Step, Full Step={Full Step=0.5}}}",
    "Solver->NOX->Printing->Output Information=0"])
claim(code == 0 and all(re.search('name="%s" *type="%s"' % key, text) for key in (
    ("Method", "string"), ("Full Step", "double"), ("Output Information", "int"))),
      "--set: a list for NOX has its types (%s)" % text[-200:].strip())

# Set in studies takes arrays and lists, and used.xml repeats them
study = os.path.join(WORK, "arrays.xml")
write(study, """<ParameterList name="Arrays">
  <ParameterList name="Scenes"><ParameterList name="coulomb">
    <Parameter name="File" type="string" value="%s"/>
  </ParameterList></ParameterList>
  <ParameterList name="Variants"><ParameterList name="coarse">
    <Parameter name="Set" type="Array(string)" value="{ Adaptivity={Strategy=None},
      Discretization->Elements per Edge={4, 2, 4, 2}, %s->Friction->Coefficient=max(0.1, 0.2)}"/>
  </ParameterList></ParameterList>
</ParameterList>
""" % (os.path.abspath(scene("coulomb.xml")), BOUNDARY))
folder = fresh("arrays")
code, text = epafi("study", study, "--output", folder, "--quiet", "--no-plot")
row, = rows(os.path.join(folder, "coarse"), "history.csv")
claim(code == 0 and row["elements"] == 12, "12 elements")
again = fresh("again")
code, text = epafi("study", os.path.join(folder, "used.xml"), "--output", again, "--quiet",
                   "--no-plot")
repeated, = rows(os.path.join(again, "coarse"), "history.csv")
claim(code == 0 and all(repeated[key] == value for key, value in row.items()
                        if not key.startswith(("seconds", "memory"))), "used.xml repeats the study")
claim([row["variant"] for row in rows(again, "study.csv")] == ["coarse"],
      "without a reference where there was none")

# schemas: what the program accepts, they accept; and they find slips of the pen
code, text = epafi("parameters")
claim("Variants-><variant>->Set" in text and "Adaptivity->Strategy" in text,
      "parameters covers scenes and studies")
keys = [path.rpartition("->")[2] for path in re.findall(r"^(\S.*)\n    ", text, re.M)]
code, tables = epafi("parameters", "--format", "markdown")
claim(code == 0 and len(keys) > 100 and
      all("\n| %s |" % key.replace("<", "&lt;").replace(">", "&gt;") in tables for key in keys),
      "%d keys stand in its tables" % len(keys))
described = json.loads(epafi("help", "--format", "json")[1])["keys"]["scene"]
code, text = epafi("parameters", "--format", "xml")
claim(code == 0 and sorted(entry.get("name") for entry in xml.fromstring(text).iter()
                           if entry.get("name") and entry.get("name") != "Parameters")
      == sorted(key["path"].rpartition("->")[2] for key in described), "and in a list")
samples = os.path.join(WORK, "samples.xml")
write(samples, text)
fails("which can be read, if not solved", ["Tables-><table>: is not a name"], "check", samples)
rng = os.path.join(WORK, "epafi.rng")
write(rng, epafi("schema")[1])
xmllint = shutil.which("xmllint")
if xmllint:
    def valid(file):
        return subprocess.run([xmllint, "--noout", "--relaxng", rng, file],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    shipped = [os.path.join(where, name)
               for top in (SCENES, os.path.join(SCENES, "..", "studies"))
               for where, _, files in os.walk(top) for name in files if name.endswith(".xml")]
    claim(len(shipped) > 10 and all(valid(file) for file in shipped),
          "RELAX NG: %d shipped scenes and studies are valid" % len(shipped))
    claim(valid(os.path.join(folder, "used.xml")) and
          valid(os.path.join(folder, "coarse", "used.xml")), "and what a run has used")
    text = read(scene("coulomb.xml"))
    for before, after in [('name="Strategy"', 'name="Strateg"'), ("Graded hp", "Gradde hp"),
                          ('Freedom" type="int"', 'Freedom" type="bool"'),
                          ('"Young\'s Modulus" type="double" value="',
                           '"Young\'s Modulus" type="double" value="-')]:
        claim(before in text, "the scene has " + before)
        spoiled = os.path.join(WORK, "spoiled.xml")
        write(spoiled, text.replace(before, after, 1))
        claim(not valid(spoiled), "RELAX NG refuses " + after)
else:
    print("xmllint is not here: RELAX NG not tried")
try:
    import json

    import jsonschema
    schema = json.loads(epafi("schema", "--format", "json", "--of", "scene")[1])
    for name in sorted(os.listdir(SCENES)):
        jsonschema.validate({"A scene": keys_of(scene(name))}, schema)
    claim(True, "the JSON Schema accepts every shipped scene")
    text = json.dumps({"A scene": keys_of(scene("coulomb.xml"))})
    for before, after in [('"Coulomb"', '"Colomb"'), ('"Strategy"', '"Strateg"'),
                          ('"Young\'s Modulus": ', '"Young\'s Modulus": -'),
                          ('"Bodies"', '"Body"')]:
        claim(before in text, "the scene has " + before)
        with raises(jsonschema.ValidationError, "JSON Schema refuses " + after):
            jsonschema.validate(json.loads(text.replace(before, after)), schema)
except ImportError as error:
    print("%s: JSON Schema not tried" % error)
finish()
