"""The table in doc/benchmarks has every case of cases.py, in its order, and no other; its text
and what it says was checked are those of today.

    table.py HARD-CASES.md
"""
import os
import sys

from cases import CASES
from run_cases import HERE, outcome
from claims import read  # run_cases knows where that is

text = read(sys.argv[1])
head = read(os.path.join(HERE, "hard-cases.md"))
wrong = [] if text.startswith(head) else ["its text is not that of test/hard/hard-cases.md"]
rows = [line.split(" | ") for line in text[len(head):].splitlines()]
names = [row[0].strip("|` ") for row in rows]
wrong += ["no row for " + case.name for case in CASES if case.name not in names]
wrong += ["no case for the row " + name for name in names
          if name not in [case.name for case in CASES]]
if not wrong and names != [case.name for case in CASES]:
    wrong.append("the rows are in another order than the cases")
wrong += ["%s: not what is checked now" % case.name for case, row in zip(CASES, rows)
          if not wrong and case.code == 0 and row[2] != outcome(case, None)]
print("\n".join(wrong) or "%d cases, %d rows" % (len(CASES), len(rows)))
if wrong:
    print("make it again: python3 test/hard/run_cases.py build/bin/epafi build/hard "
          "--group all --markdown doc/benchmarks/hard-cases.md")
sys.exit(1 if wrong else 0)
