"""For tests of many runs each:  <test>.py EPAFI WORK."""
import sys

from cases import Case
from run_cases import run as run_case
from claims import claim, failures, finish, read, table, write  # noqa: F401

EPAFI, WORK = sys.argv[1:3]


def run(scene, settings=(), code=0):
    result = run_case(Case("run", "", scene, settings), EPAFI, WORK)
    if result.code != code:
        sys.exit("%s %s: exit code %s, expected %d\n%s" % (scene, list(settings), result.code,
                                                          code, result.text))
    return result
