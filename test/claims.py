"""What the tests in Python share: claims, and the tables that epafi writes.  Standard library
only."""
import contextlib
import csv
import os
import shutil
import sys

failures = []


def claim(true, sentence):
    """Notes a claim that does not hold; finish() reports all of them."""
    print(("ok      " if true else "FAILED  ") + sentence)
    if not true:
        failures.append(sentence)


@contextlib.contextmanager
def raises(kind, sentence, *words, absent=()):
    """Claims that what stands below raises an error whose message has these words; it is in the
    list behind `as`."""
    caught = []
    try:
        yield caught
        claim(False, sentence)
    except kind as error:
        caught.append(error)
        claim(all(word in str(error) for word in words) and
              not any(word in str(error) for word in absent), "%s: %s" % (sentence, error))


def finish():
    sys.exit(1 if failures else 0)


def absent(folder):
    """A folder that does not exist any more, in one that does."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(os.path.dirname(folder), exist_ok=True)
    return folder


def options(settings):
    """--set of each."""
    return [word for setting in settings for word in ("--set", setting)]


def read(file):
    with open(file, encoding="utf-8") as stream:
        return stream.read()


def write(file, text):
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(text)
    return file


def table(file):
    """Rows as dictionaries, numbers as floats."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(file, newline="") as stream:
        return [{key: value(cell) for key, cell in row.items()}
                for row in csv.DictReader(stream)]
