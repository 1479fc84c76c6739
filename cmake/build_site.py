"""The documentation as a site:  build_site.py ROOT FOLDER EPAFI [--headers]

Puts the pages where doc/site/mkdocs.yml looks, with the list of all parameters that EPAFI prints and
the interface of the Python package, builds FOLDER/html by mkdocs, with --headers the headers by Doxygen below it, and follows every
link and picture of the pages to where it leads.
"""
import functools
import glob
import html.parser
import inspect
import os
import re
import shutil
import subprocess
import sys
import textwrap
import urllib.parse

from formulas import with_formulas

# Where pages are; what they link to beyond comes along.
SHOWN = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "doc"]
PARAMETERS = "parameters" + ".md"  # made here
PYTHON = "python-api" + ".md"
# Debian's mkdocs names two scripts that it does not have.
JQUERY = "/usr/share/javascript/jquery/jquery.min.js"
# Chapters that are whole folders.
CHAPTERS = [("Benchmarks", "benchmarks"), ("Decisions", "decisions")]


def stage(root, pages, epafi):
    for path in SHOWN:
        source, target = os.path.join(root, path), os.path.join(pages, path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if os.path.isdir(source):  # the paper is not a page: its journal sets it
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("paper"))
        else:
            shutil.copy(source, target)
    with open(os.path.join(pages, PARAMETERS), "w", encoding="utf-8") as stream:
        stream.write("# Every parameter\n\n" + subprocess.run(
            [epafi, "parameters", "--format", "markdown"], check=True, text=True,
            stdout=subprocess.PIPE).stdout)
    with open(os.path.join(pages, PYTHON), "w", encoding="utf-8") as stream:
        stream.write(python_page(root))
    for file in glob.glob(os.path.join(pages, "**", "*.md"), recursive=True):
        for_mkdocs(file, root, pages)
    os.makedirs(os.path.join(pages, "js"))
    shutil.copy(JQUERY, os.path.join(pages, "js/jquery-3.6.0.min.js"))
    with open(os.path.join(pages, "js/theme_extra.js"), "w", encoding="utf-8"):
        pass


def python_page(root):
    """What `import epafi` offers, by its docstrings."""
    sys.path.insert(0, os.path.join(root, "python"))
    import epafi

    def told(name, thing, level):
        try:
            signature = str(inspect.signature(thing)).replace("self, ", "").replace("(self)", "()").replace("'", "")
        except (TypeError, ValueError):
            signature = ""
        title = "%s %s" % ("#" * level, name)
        return "%s\n\n    %s%s\n\n%s\n" % (title, name, signature, textwrap.indent(
            inspect.getdoc(thing) or "", "    "))

    lines = ["# Python: every class and function\n", inspect.getdoc(epafi).replace("\n    ", "\n\n    ", 1) + "\n"]
    for name in sorted(epafi.__all__):
        thing = getattr(epafi, name)
        lines.append(told(name, thing, 2))
        if inspect.isclass(thing):
            for own, member in vars(thing).items():
                member = member.__func__ if isinstance(member, (classmethod, staticmethod)) else member
                member = member.fget if isinstance(member, property) else member
                member = member.func if isinstance(member, functools.cached_property) else member
                if not own.startswith("_") and callable(member) and inspect.getdoc(member):
                    lines.append(told("%s.%s" % (name, own), member, 3))
    return "\n".join(lines)


def for_mkdocs(file, root, pages):
    """A folder is linked by its first page or file, and what is linked comes along."""
    with open(file, encoding="utf-8") as stream:
        text = stream.read()
    here = os.path.dirname(file)

    def link(match):
        path = os.path.relpath(os.path.join(here, match.group(1)), pages)
        inside = os.path.join(root, path)
        if os.path.isdir(inside):
            names = sorted(os.listdir(inside), key=lambda name: (not name.endswith(".md"), name))
            path = os.path.join(path, names[0])
        if os.path.isfile(os.path.join(root, path)):
            target = os.path.join(pages, path)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            if not os.path.exists(target):
                shutil.copy(os.path.join(root, path), target)
        return "](%s)" % os.path.relpath(os.path.join(pages, path), here)
    text = re.sub(r"\]\(([^)#:]+)\)", link, text)
    if os.path.relpath(file, pages).startswith("doc/theory/"):
        text = with_formulas(text)
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(spaced(text))


def spaced(text):
    """Lists and tables begin behind an empty line, which forges do not ask for."""
    lines, code = [], False
    for line in text.split("\n"):
        code ^= line.startswith("```")
        before = lines[-1] if lines else ""
        for begin in (r"[*-] ", r"\d+\. ", r"\|"):
            if not code and re.match(begin, line) and before and not re.match(begin + r"| ", before):
                lines.append("")
        lines.append(line)
    return "\n".join(lines)


def title_of(file):
    with open(file, encoding="utf-8") as stream:
        return re.sub(r"\s+accepted,.*", "", stream.readline().lstrip("# ").strip())


def configure(root, folder, headers):
    with open(os.path.join(root, "doc/site/mkdocs.yml"), encoding="utf-8") as stream:
        lines = [stream.read().rstrip()]
    for chapter, name in CHAPTERS:
        lines.append("  - %s:" % chapter)
        for file in sorted(glob.glob(os.path.join(folder, "pages/doc", name, "*.md"))):
            lines.append("      - '%s': doc/%s/%s" % (
                title_of(file).replace("'", "''"), name, os.path.basename(file)))
    lines += ["  - Project:", "      - Overview: doc/index.md", "      - Changes: CHANGELOG.md",
              "      - Contributing: CONTRIBUTING.md"]
    if headers:
        lines.append("      - Headers: headers/index.html")
    with open(os.path.join(folder, "mkdocs.yml"), "w", encoding="utf-8") as stream:
        stream.write("\n".join(lines) + "\n")
    named = set(re.findall(r": (\S+\.md)", "\n".join(lines)))
    pages = os.path.join(folder, "pages")
    return sorted("%s is in no chapter of doc/site/mkdocs.yml" % os.path.relpath(file, pages)
                  for file in glob.glob(os.path.join(pages, "doc/**/*.md"), recursive=True)
                  if os.path.relpath(file, pages) not in named)


def document_headers(root, folder):
    with open(os.path.join(root, "doc/site/Doxyfile"), encoding="utf-8") as stream:
        options = stream.read()
    options += "INPUT = %s %s\nSTRIP_FROM_PATH = %s\nSTRIP_FROM_INC_PATH = %s\n" % (
        os.path.join(root, "packages"), os.path.join(root, "drivers"),
        root, os.path.join(root, "packages"))
    options += "OUTPUT_DIRECTORY = %s\nHTML_OUTPUT = headers\n" % os.path.join(folder, "html")
    subprocess.run(["doxygen", "-"], input=options, text=True, check=True)


# Elements that mkdocs and its theme write; others are a < of a formula that swallowed text.
ELEMENTS = set("""html head meta link title script style body div nav form input button ul ol li a p
    br hr span section footer i b em strong code pre img table thead tbody tr th td blockquote kbd
    h1 h2 h3 h4 h5 h6 small sup sub
    math mtable mtr mtd mrow mi mn mo mtext msub msup msubsup""".split())


class Page(html.parser.HTMLParser):
    """Where a page leads, the places on it that can be led to, and elements that are none."""

    def __init__(self, file):
        super().__init__()
        self.links, self.places, self.strange = [], set(), set()
        with open(file, encoding="utf-8") as stream:
            self.feed(stream.read())

    def handle_starttag(self, tag, attrs):
        if tag not in ELEMENTS or tag == "a" and not attrs_of_link(attrs):
            self.strange.add("<%s %s>" % (tag, " ".join(name for name, _ in attrs)))
        for name, value in attrs:
            if name in ("id", "name") and value:
                self.places.add(value)
            elif value and (name == "src" or name == "href"):
                self.links.append(value)


def attrs_of_link(attrs):
    return {"href", "id", "name", "class"} & {name for name, _ in attrs}


def dangling(site):
    """Sentences about links that lead nowhere, and how many there are in all."""
    files = [file for file in glob.glob(os.path.join(site, "**", "*.html"), recursive=True)
             if os.sep + "headers" + os.sep not in file]
    pages = {file: Page(file) for file in files}
    found, count = [], 0
    for file, page in pages.items():
        found += ["%s: %s is no element of HTML" % (os.path.relpath(file, site), element)
                  for element in sorted(page.strange)]
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or os.path.basename(file) == "404.html":
                continue
            count += 1
            path = urllib.parse.unquote(parts.path)
            target = os.path.normpath(os.path.join(os.path.dirname(file), path)) if path else file
            if os.path.isdir(target):
                target = os.path.join(target, "index.html")
            where = os.path.relpath(file, site)
            if not os.path.exists(target):
                found.append("%s links to %s, which is not there" % (where, link))
            elif parts.fragment and target in pages and \
                    urllib.parse.unquote(parts.fragment) not in pages[target].places:
                found.append("%s links to %s, which has no such place" % (where, link))
    return found, count


def main():
    root, folder, epafi = (os.path.abspath(argument) for argument in sys.argv[1:4])
    headers = "--headers" in sys.argv[4:]
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    stage(root, os.path.join(folder, "pages"), epafi)
    lost = configure(root, folder, headers)
    subprocess.run(["mkdocs", "build", "--quiet", "--config-file",
                    os.path.join(folder, "mkdocs.yml")], check=True)
    if headers:
        document_headers(root, folder)
    found, count = dangling(os.path.join(folder, "html"))
    found += lost
    print("\n".join(found))
    print("%s: %d links, %d lead nowhere" % (os.path.join(folder, "html/index.html"), count,
                                             len(found)))
    sys.exit(len(found) > 0 or count < 100)


if __name__ == "__main__":
    main()
