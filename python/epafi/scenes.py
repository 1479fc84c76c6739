"""Scenes as dictionaries, checked against the program's schema; the program reads and writes their
files, which come and go as JSON."""
from __future__ import annotations

import copy
import json
import os
import re
import tempfile
from typing import Any, Mapping, Optional

import numpy as np

from epafi.program import InputError, call, schema
from epafi.tables import nearest


class Scene(dict[str, Any]):
    """A scene as a dictionary: lists are dictionaries, arrays lists or numpy arrays, expressions
    text or numbers; the keys are those of `epafi parameters`.

        Scene({"Bodies": {"block": {...}}, "Discretization": {"Mesh Size": 0.1}}, title="Block")

    `title` is the scene's, `folder` what the `File` of a Geometry or a table is relative to.
    InputError for unknown keys and wrong types, with the path and the nearest known key.
    """

    def __init__(self, tree: Mapping[str, Any], title: str = "scene", folder: str = ".") -> None:
        super().__init__(copy.deepcopy(dict(tree)))
        self.title = title
        self.folder = os.path.abspath(folder)
        _check(self, schema(), "")

    @classmethod
    def read(cls, file: str | os.PathLike[str]) -> Scene:
        """From an XML or a YAML file, as the program reads it."""
        name = os.fspath(file)
        title, tree = printed(name)
        return cls(tree, title, os.path.dirname(name) or ".")

    def changed(self, settings: Mapping[str, Any]) -> Scene:
        """A copy with other values: {"A->B->Key": value}; None removes a key or a list."""
        tree = copy.deepcopy(dict(self))
        for path, value in settings.items():
            *parents, key = path.split("->")
            target = tree
            for parent in parents:
                target = target.setdefault(parent, {})
                if not isinstance(target, dict):
                    raise InputError("%s: %r is a value, no list" % (path, parent))
            if value is None:
                if key not in target:
                    raise InputError("%s: is not in the scene, so it cannot be removed" % path)
                del target[key]
            else:
                target[key] = copy.deepcopy(value)
        return Scene(tree, self.title, self.folder)

    def write(self, file: str | os.PathLike[str]) -> None:
        """Into a file that `epafi run` reads: XML, or JSON if its name ends with .yaml."""
        name = os.fspath(file)
        kind = os.path.splitext(name)[1].lower()
        if kind not in (".xml", ".yaml"):
            raise InputError("'%s': scenes are written as XML or JSON; let the name end with .xml or, "
                             "since JSON is YAML, .yaml" % name)
        _check(self, schema(), "")  # it may have been changed in place
        text = json.dumps({self.title: self._absolute(self)}, indent=1, default=_plain)
        if kind == ".xml":
            with tempfile.TemporaryDirectory() as folder:
                draft = os.path.join(folder, "scene.yaml")
                with open(draft, "w", encoding="utf-8") as stream:
                    stream.write(text)
                text = call(["check", "--format", "xml", draft], scene=draft)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)

    def _absolute(self, tree: Mapping[str, Any], *parents: str) -> dict[str, Any]:
        """With the paths of files from the root."""
        return {key: self._absolute(value, *parents, key) if isinstance(value, Mapping)
                else os.path.join(self.folder, value) if key == "File" and (
                    parents[-1:] == ("Geometry",) or parents[:-1] == ("Tables",))
                else value for key, value in tree.items()}

    def check(self) -> str:
        """What `epafi check` says: every expression is evaluated, nothing is solved."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.yaml")
            self.write(file)
            return call(["check", file], scene=file)


def printed(file: str, *options: str) -> tuple[str, dict[str, Any]]:
    """Title and content of a scene or a study as the program prints it."""
    return next(iter(json.loads(call(["check", *options, "--format", "json", file])).items()))


def _child(rules: Mapping[str, Any], key: str) -> Optional[Mapping[str, Any]]:
    """The schema of a key, by name or by pattern."""
    if key in rules.get("properties", {}):
        return rules["properties"][key]
    for pattern, rule in rules.get("patternProperties", {}).items():
        if re.search(pattern, key):
            return rule
    return None


def _plain(value: Any) -> Any:
    """numpy's values as Python's."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    return [_plain(entry) for entry in value] if isinstance(value, (list, tuple)) else value


def _is(value: Any, kind: str) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return {"object": isinstance(value, Mapping), "array": isinstance(value, list),
            "string": isinstance(value, str), "boolean": isinstance(value, bool),
            "number": number,
            "integer": number and isinstance(value, int)}[kind]


def _check(value: Any, rules: Mapping[str, Any], path: str) -> None:
    kinds = rules["type"] if isinstance(rules["type"], list) else [rules["type"]]
    value = _plain(value)
    if not any(_is(value, kind) for kind in kinds):
        raise InputError("%s: is %r, wanted: %s" % (path, value, " or ".join(kinds)))
    if "enum" in rules and value not in rules["enum"]:
        raise InputError("%s: is %r; allowed: %s" % (
            path, value, ", ".join(map(repr, rules["enum"]))))
    if isinstance(value, list):
        for k, entry in enumerate(value):
            _check(entry, rules["items"], "%s, entry %d" % (path, k))
    if not isinstance(value, Mapping) or not ("properties" in rules or
                                              "patternProperties" in rules):
        return
    for key, entry in value.items():
        here = path + "->" + key if path else key
        rule = _child(rules, key)
        if rule is None:
            known = list(rules.get("properties", {}))
            raise InputError("%s: unknown%s known: %s" % (
                here, nearest(key, known), ", ".join(map(repr, known))))
        _check(entry, rule, here)
