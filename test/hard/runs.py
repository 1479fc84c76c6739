"""For tests of many runs each:  <test>.py EPAFI WORK."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cases import Case  # noqa: E402
from run_cases import run as run_case  # noqa: E402

EPAFI, WORK = sys.argv[1:3]
failures = []


def claim(true, sentence):
    """Notes a claim that does not hold; finish() reports all of them."""
    print(("ok      " if true else "FAILED  ") + sentence)
    if not true:
        failures.append(sentence)


def finish():
    sys.exit(1 if failures else 0)


def run(scene, settings=(), code=0):
    result = run_case(Case("run", "", scene, settings), EPAFI, WORK)
    if result.code != code:
        sys.exit("%s %s: exit code %s, expected %d\n%s" % (scene, list(settings), result.code,
                                                          code, result.text))
    return result
