"""What clang-tidy is to read of a compile_commands.json: one command a file, without what
clang does not know of GCC's options.  Standard library only.

    tidy_commands.py COMPILE_COMMANDS.json
"""
import json
import sys

with open(sys.argv[1]) as stream:
    commands = {entry["file"]: entry for entry in json.load(stream)}
for entry in commands.values():
    entry["command"] = entry["command"].replace(" -fcx-limited-range", "")
json.dump(list(commands.values()), sys.stdout, indent=1)
