"""Runs the hard cases of cases.py and says what became of each.

    run_cases.py EPAFI WORK [--group GROUP]... [--case NAME]... [--markdown FILE]
    run_cases.py --page FILE

GROUP is quick (default), long or all.  With --markdown the table of doc/benchmarks is written too,
below the text of hard-cases.md here; --page claims that it has this text, every case in its order
and no other, and what is checked today:  python3 test/hard/run_cases.py build/bin/epafi
build/hard --group all --markdown doc/benchmarks/hard-cases.md
"""
import argparse
import os
import resource
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from cases import CASES  # noqa: E402
from claims import absent, claim, finish, options, read, table  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
HEAD = os.path.join(HERE, "hard-cases.md")
FOLDERS = [os.path.join(HERE, "scenes"), os.path.join(HERE, "..", "..", "drivers", "scenes")]


class Result:
    """What a run left behind: exit code, text, rows of its tables, CPU seconds."""

    def __init__(self, code, text, folder, seconds):
        self.code, self.text, self.seconds = code, text, seconds
        self.history, self.contact, self.interior = (
            table(file) if os.path.exists(file) else []
            for file in (os.path.join(folder, name + ".csv")
                         for name in ("history", "contact", "interior")))

    def last(self, column):
        return self.history[-1][column]


def scene(name):
    for folder in FOLDERS:
        file = os.path.join(folder, name + ".xml")
        if os.path.exists(file):
            return file
    raise SystemExit("no scene " + name)


def run(case, epafi, work):
    folder = absent(os.path.join(work, case.name))
    command = [epafi, "run", scene(case.scene), "--quiet", "--output", folder,
               *options(case.settings)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=case.patience)
        code, text = done.returncode, done.stdout
    except subprocess.TimeoutExpired as error:
        code, text = "no end within %d s" % case.patience, str(error.stdout or "")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Result(code, text.strip(), folder, seconds)


def faults(case, result, results):
    """Measures of the claims, and sentences about what is not as the table says."""
    if result.code != case.code:
        return [], ["exit code %s instead of %d: %s" % (result.code, case.code, result.text)]
    found = ["the message does not say '%s': %s" % (word, result.text)
             for word in case.words if word not in result.text]
    if case.code != 0:
        return [], found
    measures = [claim.measure(result, results) for claim in case.claims]
    found += ["%s: %.2e" % (claim.sentence, measure)
              for claim, measure in zip(case.claims, measures) if not measure <= claim.most]
    return measures, found


def outcome(case, result):
    if case.code != 0:
        return result.text.split("\n")[-1].replace(HERE + os.sep, "").replace("|", "/")
    return "solved; " + "; ".join(claim.sentence.replace("|", "\\|") for claim in case.claims)


def error(case, measures):
    """Largest difference to a known value, or the exit code."""
    if case.code != 0:
        return "exit %d" % case.code
    return "%.0e" % max(measure for claim, measure in zip(case.claims, measures)
                        if claim.is_error)


def markdown(file, rows):
    with open(file, "w") as out:
        out.write(read(HEAD))
        for case, result, measures in rows:
            last = result.history[-1] if result.history else {}
            out.write("| %s | %s | %s | %s | %s | %s | %.1f |\n" % (
                "`%s`" % case.name, case.meaning.replace("|", "\\|"), outcome(case, result),
                error(case, measures),
                "%d" % last["dof"] if last else "",
                "%d" % last["newton_iterations"] if last else "", result.seconds))


def check_page(file):
    text = read(file)
    claim(text.startswith(read(HEAD)), "the text is that of test/hard/hard-cases.md")
    rows = [line.split(" | ") for line in text[len(read(HEAD)):].splitlines()]
    claim([row[0].strip("|` ") for row in rows] == [case.name for case in CASES],
          "%d rows for %d cases, in their order" % (len(rows), len(CASES)))
    for case, row in zip(CASES, rows):
        claim(case.code != 0 or row[2] == outcome(case, None), case.name + " is checked as it says")
    finish()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("epafi", nargs="?")
    parser.add_argument("work", nargs="?")
    parser.add_argument("--page")
    parser.add_argument("--group", default="quick", choices=("quick", "long", "all"))
    parser.add_argument("--case", action="append", default=[])
    parser.add_argument("--markdown")
    chosen = parser.parse_args()
    if chosen.page:
        check_page(chosen.page)
    cases = [case for case in CASES
             if case.name in chosen.case or not chosen.case and (
                 chosen.group == "all" or case.group == chosen.group)]
    results, rows, failed = {}, [], 0
    for case in cases:
        result = results[case.name] = run(case, chosen.epafi, chosen.work)
        measures, wrong = faults(case, result, results)
        rows.append((case, result, measures))
        print("%-6s %-28s %5.1f s" % ("FAILED" if wrong else "ok", case.name, result.seconds))
        for sentence in wrong:
            print("       " + sentence)
        failed += bool(wrong)
    if chosen.markdown and not failed:
        markdown(chosen.markdown, rows)
    print("%d cases, %d failed" % (len(rows), failed))
    sys.exit(1 if failed or not rows else 0)


if __name__ == "__main__":
    main()
