"""Scenes as dictionaries, checked against the program's schema, read from and written as XML."""
from __future__ import annotations

import copy
import os
import re
import tempfile
import xml.etree.ElementTree as xml
from typing import Any, Callable, Mapping, Optional

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
        root = xml.fromstring(call(["check", "--read", name]))
        return cls(tree_of(root), root.get("name", ""), os.path.dirname(name) or ".")

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
        """As XML, which `epafi run` reads, into a file whose name ends so."""
        if not os.fspath(file).lower().endswith(".xml"):
            raise InputError("'%s': scenes are written as XML; let the name end with .xml" %
                             os.fspath(file))
        _check(self, schema(), "")  # it may have been changed in place
        root = _list(self.title, self, schema(), self.folder)
        xml.indent(root)
        xml.ElementTree(root).write(file, encoding="utf-8", xml_declaration=True)

    def check(self) -> str:
        """What `epafi check` says: every expression is evaluated, nothing is solved."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.xml")
            self.write(file)
            return call(["check", file], scene=file)


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


def entry(value: Any, rules: Mapping[str, Any]) -> tuple[str, str]:
    """Teuchos' type and text of a value; without rules by what it is."""
    value = _plain(value)
    kinds = rules.get("type")
    if isinstance(value, list):
        table = bool(value) and isinstance(value[0], list)
        cells = [x for row in value for x in row] if table else value
        if table and len({len(row) for row in value}) != 1:
            raise InputError("a table has rows of one length: %r" % (value,))
        wanted = rules.get("items", {}).get("type", "number")
        if wanted == "string" or any(isinstance(cell, str) for cell in cells):
            type_, words = "string", [str(cell) for cell in cells]
        elif "integer" in wanted or not rules and all(isinstance(cell, int) for cell in cells):
            type_, words = "int", [str(cell) for cell in cells]
        else:
            type_, words = "double", [repr(float(cell)) for cell in cells]
        text = "{%s}" % ", ".join(words)
        if table:
            return "TwoDArray(%s)" % type_, "%dx%d:%s" % (len(value), len(value[0]), text)
        return "Array(%s)" % type_, text
    if isinstance(value, bool):
        return "bool", "true" if value else "false"
    if isinstance(value, str):
        return "string", value
    if isinstance(value, int) and (kinds is None or "integer" in kinds):
        return "int", str(value)
    return "double", repr(float(value))


def _list(name: str, tree: Mapping[str, Any], rules: Mapping[str, Any],
          folder: str, parent: str = "") -> xml.Element:
    element = xml.Element("ParameterList", name=name)
    for key, value in tree.items():
        rule = _child(rules, key) or {}
        if isinstance(value, Mapping):
            element.append(_list(key, value, rule, folder, name))
            continue
        if key == "File" and (name == "Geometry" or parent == "Tables"):
            value = os.path.join(folder, value)
        kind, text = entry(value, rule)
        xml.SubElement(element, "Parameter", name=key, type=kind, value=text)
    return element


def tree_of(element: xml.Element) -> dict[str, Any]:
    """What a list in XML holds, as the program writes it."""
    tree: dict[str, Any] = {}
    for child in element:
        name = child.get("name", "")
        tree[name] = (tree_of(child) if child.tag == "ParameterList"
                      else _value(child.get("type", "string"), child.get("value", "")))
    return tree


def _pieces(text: str) -> list[str]:
    """Splits "a, f(b, c), {d, e}" at commas outside of parentheses and braces."""
    pieces, depth = [""], 0
    for sign in text:
        depth += (sign in "({") - (sign in ")}")
        if sign == "," and depth == 0:
            pieces.append("")
        else:
            pieces[-1] += sign
    return pieces


def _value(kind: str, text: str) -> Any:
    read: dict[str, Callable[[str], Any]] = {
        "double": float, "int": int, "string": str, "bool": lambda word: word.strip() == "true"}
    if kind in read:
        return read[kind](text)
    inner = kind[kind.index("(") + 1:-1]
    body = text[text.index("{") + 1:text.rindex("}")]
    entries = [read[inner](text.strip()) for text in _pieces(body)] if body.strip() else []
    if not kind.startswith("TwoD"):
        return entries
    columns = int(text[:text.index(":")].split("x")[1])
    return [entries[k:k + columns] for k in range(0, len(entries), columns)]
