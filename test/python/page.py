"""Runs the code of a page, piece by piece, and compares what it prints with the page.

    page.py EPAFI PAGE.md WORK
"""
import contextlib
import io
import os
import re
import sys

page, work = os.path.abspath(sys.argv[2]), sys.argv[3]
os.environ["PATH"] = os.path.dirname(os.path.abspath(sys.argv[1])) + ":" + os.environ["PATH"]
os.makedirs(work, exist_ok=True)
os.chdir(work)
with open(page, encoding="utf-8") as stream:
    pieces = re.findall(r"```python\n(.*?)```\n(?:```text\n(.*?)```)?", stream.read(), re.S)
names = {}
wrong = 0
for code, expected in pieces:
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(code, page, "exec"), names)
    if said.getvalue() != expected:
        wrong += 1
        print("the code\n%s\nprints\n%s\nbut the page says\n%s" % (code, said.getvalue(), expected))
print("%d pieces of code, %d print something else" % (len(pieces), wrong))
sys.exit(not pieces or wrong > 0)
