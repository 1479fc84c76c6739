"""No dangling citation:  python3 check_citations.py ROOT

  1. A page that a source, script, scene or page names (some-page.md) is in the repository, by its
     name alone or by the end of its path; names in capitals are placeholders of a usage.
  2. A relative link of a page leads to a file, and its #part to a heading.
  3. A decision cited by its number exists: a page of its own, a section "## 12. ..." of a page of
     several, or a row <a id="d12"></a> of doc/decisions/history.md; once.
  4. What pages say of today (decisions, the changelog and benchmarks tell of their day): `a/path` in
     it, from the root, from a layer or its end, leads to a file or a folder; `Type::member` are words
     of a header; what a table of types by task lists is declared as a type in a source.
"""
import os
import re
import sys

SOURCES = (".cpp", ".hpp", ".inc", ".py", ".cmake", ".sh", ".xml", ".txt", ".awk", ".in", ".md")
PAGE = re.compile(r"(?<![\w/<>*.-])[\w./-]*[\w-]\.md\b")
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"`(?:\./)?((?:[\w.-]{2,}/)+[\w.-]*)`")
MEMBER = re.compile(r"`(\w+)::(\w+)`")
TYPES = re.compile(r"^\| task \| types \|\n.*\n((?:\|.*\n?)+)", re.M)
TYPE = re.compile(r"`(?:\w+::)*(\w+)`")
DECLARED = re.compile(r"\b(?:class|struct|enum class|using) (\w+)")
OF_THEIR_DAY = ("doc/decisions/", "doc/benchmarks/", "CHANGELOG.md")
DECISION = re.compile(r"\b[Dd]ecisions? (\d+)")


# What a build, an installation or a run makes.
MADE = re.compile(r"build|share/|lib/|include/|/|steps/|sweep/|\w+\.out/")


def of_today(path):
    return path.endswith(".md") and not path.startswith(OF_THEIR_DAY)


def anchors(text):
    """GitHub's: lower case, without signs, spaces as dashes; and places that are named."""
    heads = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", re.sub(r"\]\([^)]*\)", "]", head)).lower().replace(" ", "-")
            for head in heads} | set(re.findall(r'<a id="([\w-]+)">', text))


def decided(path, text):
    """Numbers of the decisions that a page holds."""
    if os.path.basename(path) == "history.md":
        return [int(number) for number in re.findall(r'^\| <a id="d(\d+)"></a>\1 \|', text, re.M)]
    sections = [int(number) for number in re.findall(r"^## (\d+)\. ", text, re.M)]
    return sections or [int(re.match(r"\d+", os.path.basename(path)).group())]


def problems(files):
    """`files`: path -> text, or None where only the name matters; sentences about the rest."""
    ends = {path[at:] for path in files for at in
            [0] + [k + 1 for k, c in enumerate(path) if c == "/"]}
    numbers = [number for path, text in sorted(files.items())
               if re.search(r"decisions/(\d+-[^/]*|history)\.md$", path)
               for number in decided(path, text or "")]
    decisions = set(numbers)
    folders = {os.path.dirname(path) for path in files}
    # From the root or from a folder on the way, without an ending, too.
    known = ends | {end.rsplit(".", 1)[0] for end in ends} | {
        folder[at:] for folder in folders for at in
        [0] + [k + 1 for k, c in enumerate(folder) if c == "/"]}
    words = set(re.findall(r"\w+", " ".join(
        text or "" for path, text in files.items() if path.endswith((".hpp", "CMakeLists.txt")))))
    types = {name for path, text in files.items() if path.endswith((".hpp", ".cpp"))
             for name in DECLARED.findall(text or "")}
    found = ["decision %d stands twice" % number for number in decisions
             if numbers.count(number) > 1]
    for path, text in sorted(files.items()):
        if text is None:
            continue
        here = os.path.dirname(path)
        if path.endswith(".md"):
            text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
        links = LINK.findall(text) if path.endswith(".md") else []
        for link in links:
            target, _, part = link.partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            whole = os.path.normpath(os.path.join(here, target)) if target else path
            if whole not in files and whole not in folders:
                found.append("%s links to %s, which is not there" % (path, link))
            elif part and part not in anchors(files.get(whole) or ""):
                found.append("%s links to %s, which has no such heading" % (path, link))
        for page in PAGE.findall(LINK.sub("]", text) if links else text):
            name = os.path.basename(page)[:-3]
            if name.upper() != name and re.sub(r"^(\.*/)+", "", page) not in ends:
                found.append("%s cites %s, which is not in the repository" % (path, page))
        for place in PATH.findall(text) if of_today(path) else ():
            if place.strip("/") not in known and not MADE.match(place):
                found.append("%s names %s, which is not in the repository" % (path, place))
        for member in MEMBER.findall(text) if of_today(path) else ():
            if not words.issuperset(member):
                found.append("%s names %s, which no header has" % (path, "::".join(member)))
        for table in TYPES.findall(text) if of_today(path) else ():
            for name in TYPE.findall(table):
                if name not in types:
                    found.append("%s lists %s, which is no type" % (path, name))
        for number in DECISION.findall(text):
            if int(number) not in decisions:
                found.append("%s cites decision %s, which does not exist" % (path, number))
    return found


def tree(root):
    files = {}
    for folder, inner, names in os.walk(root):
        inner[:] = [name for name in inner if not name.startswith((".", "build"))]
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), root)
            text = None
            if name.endswith(SOURCES) and "fuzz/corpus" not in path and \
                    name != os.path.basename(__file__):
                with open(os.path.join(root, path), encoding="utf-8", errors="replace") as stream:
                    text = stream.read()
            files[path] = text
    return files


def check_itself():
    """Each kind is found, and what is sound is not."""
    sound = {"doc/a.md": "# A b\n[x](sub/b.md#c-d) [y](#a-b) [z](https://no.where/)",
             "doc/sub/b.md": "## C: d\nsee ../a.md", "doc/decisions/0003-x.md": "",
             "doc/decisions/0005-y.md": "# 5. Y\n## 5. a\n## 6. b",
             "doc/decisions/history.md": '| <a id="d7"></a>7 | x |\n[x](#d7)',
             "doc/d.md": "`src/x` `src/` `T::m` `build/bin/x`\n| task | types |\n|---|---|\n| a | `T` |",
             "src/t.hpp": "struct T { int m; }",
             "src/x.cpp": "// [doc/a.md], [sub/b.md], decision 3; usage: x TABLE.md",
             "src/w.cpp": "// decision 6, decision 7"}
    assert problems(sound) == [], problems(sound)
    for path, text, word in (("src/y.hpp", "/// [b.md], c.md", "c.md"),
                             ("src/y.hpp", "/// theory/a.md", "theory/a.md"),
                             ("doc/c.md", "[x](b.md)", "b.md"),
                             ("doc/c.md", "[x](a.md#b)", "a.md#b"),
                             ("doc/c.md", "`src/z`", "src/z"), ("doc/c.md", "`T::n`", "T::n"),
                             ("doc/c.md", "| task | types |\n|---|---|\n| a | `T`, `m` |", "lists m"),
                             ("src/y.hpp", "/// decision 4", "decision 4"),
                             ("doc/decisions/0007-z.md", "", "decision 7"),
                             ("doc/c.md", "[x](decisions/history.md#d8)", "#d8")):
        found = problems({**sound, path: text})
        assert len(found) == 1 and word in found[0], (text, found)


check_itself()
FOUND = problems(tree(sys.argv[1]))
print("\n".join(FOUND) or "every citation leads somewhere")
sys.exit(1 if FOUND else 0)
